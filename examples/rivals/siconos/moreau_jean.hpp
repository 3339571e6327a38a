#pragma once
// Siconos' TimeStepping with MoreauJeanOSI, until the motion repeats.

#include "steady_state.hpp"

namespace siconos_rivals {

/// The velocity jumps and the position is kept approximately: first order in the step, and one linear
/// complementarity problem a step, by Lemke's method as Siconos' own examples take it.
class MoreauJean final : public ImpactMethod {
 public:
  static constexpr signorini::MethodText kText{
      .name = "siconos-moreau-jean",
      .title = "Moreau-Jean time stepping of Siconos until the motion repeats",
      .laws = "restitution 0..1",
      .ladder = "steps=250|1000|4000"};

  struct Options {
    int steps = 1000;         ///< per period of the motion [-]
    double theta = 0.5;       ///< [-]
    double tolerance = 1e-6;  ///< on the change over a period [-]
    int max_periods = 2000;   ///< [-]

    void visit(auto&& field) {
      field("steps", steps, "[-]", "time steps per period, 4..1000000; a few more where it circles");
      field("theta", theta, "[-]", "implicitness, 0.5 (keeps energy) to 1 (dissipates)");
      field("tolerance", tolerance, "[-]", "change over a period accepted, relative, in (0, 1e-2]");
      field("max_periods", max_periods, "[-]", "limit on the periods followed, 1..1000000");
    }
  };

  /// \throws signorini::InvalidOption
  explicit MoreauJean(const Options& options);
  [[nodiscard]] std::vector<signorini::OptionEcho> options() const override {
    return signorini::echo_options(options_);
  }
  [[nodiscard]] std::unique_ptr<signorini::PreparedMethod> prepare(
      const signorini::Problem& problem) const override;

 private:
  Options options_;
};

}  // namespace siconos_rivals
