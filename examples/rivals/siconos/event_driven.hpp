#pragma once
// Siconos' EventDriven with LsodarOSI, until the motion repeats.

#include "steady_state.hpp"

namespace siconos_rivals {

/// LSODAR between events, which it locates; impacts and accelerations by linear complementarity problems.
class EventDriven final : public ImpactMethod {
 public:
  static constexpr signorini::MethodText kText{
      .name = "siconos-event-driven",
      .title = "Event-driven integration by LSODAR of Siconos until the motion repeats",
      .laws = "restitution 0..1",
      .ladder = "tolerance=1e-4|1e-6|1e-8"};

  struct Options {
    double tolerance = 1e-6;  ///< on the change over a period [-]
    int samples = 256;        ///< per period, at which LSODAR is stopped [-]
    int max_periods = 2000;   ///< [-]

    void visit(auto&& field) {
      field("tolerance", tolerance, "[-]", "change over a period accepted, relative, in (0, 1e-2]");
      field("samples", samples, "[-]", "instants per period besides the events, 16..65536");
      field("max_periods", max_periods, "[-]", "limit on the periods followed, 1..1000000");
    }
  };

  /// \throws signorini::InvalidOption
  explicit EventDriven(const Options& options);
  [[nodiscard]] std::vector<signorini::OptionEcho> options() const override {
    return signorini::echo_options(options_);
  }
  [[nodiscard]] std::unique_ptr<signorini::PreparedMethod> prepare(
      const signorini::Problem& problem) const override;

 private:
  Options options_;
};

}  // namespace siconos_rivals
