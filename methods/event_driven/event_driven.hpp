#pragma once
// Event-driven time marching by CVODE: the time-domain reference.

#include <array>
#include <string_view>

#include "methods/flow/flow.hpp"
#include "methods/method.hpp"

namespace signorini {

/// Integrates M u'' + D u' + K u = f(t) + W lambda between events with CVODE, applies the scene's law at
/// impacts, closings and openings (EventFlow, RigidEvents), and looks for a periodic motion either by
/// marching until it repeats (`march`: the attractor reached from rest or from the guess, of any order up to
/// `max_order` forcing periods; "not periodic after n periods" otherwise) or by Newton's method on the
/// stroboscopic map (`shoot`: of period Problem::period(), unstable motions too).
///
/// Guarantee: a converged motion repeats itself within ten tolerances of the scales of motion; against closed
/// forms its error is about `tolerance`, down to a few 1e-12. With flow = modal the motion between events is
/// closed-form (at most 300 coordinates), `tolerance` that of the events and of the periodicity. Measured
/// cost with flow = adams: 300 right-hand sides per flight, and about omega_max T / 1.2 per period: a beam
/// with omega_max T = 1e4 takes 1e5. flow = bdf does without the latter where the fastest modes only decay.
/// Coordinates without mass follow the others statically (`condense`); damped ones are not supported.
class EventDriven final : public Method {
 public:
  enum class Steady { marching, shooting };

  static constexpr MethodText kText{
      .name = "event-driven",
      .title = "CVODE or closed-form flow between events, impact law at events, to the steady state",
      .laws = "restitution 0..1, penalty, massless",
      .ladder = "flow=cvode|modal,tolerance=1e-6|1e-9",
      .limits =
          "Finds the stable motion that the start leads to (with steady=shooting others too); light damping "
          "takes thousands of periods. flow=modal: at most 300 coordinates."};

  struct Options {
    double tolerance = 1e-9;  ///< relative error aimed at, in [1e-13, 1e-3] [-]
    Steady steady = Steady::marching;
    Integrator flow = Integrator::cvode;
    int max_iterations = 5000;  ///< periods marched, or Newton steps of the shooting [-]
    int max_order = 8;          ///< highest period order detected by marching [-]

    void visit(auto&& field) {
      field("tolerance", tolerance, "[-]",
            "relative error aimed at (local errors are held to 1 % of it), in [1e-13, 1e-3]");
      field("steady", steady, "[-]", "marching | shooting: how the periodic motion is reached");
      field(
          "flow", flow, "[-]",
          "cvode (bdf if stiff, else adams) | adams | bdf | modal (closed form): the motion between events");
      field("max_iterations", max_iterations, "[-]",
            "periods marched, or Newton steps of the shooting, >= 1");
      field("max_order", max_order, "[-]", "highest period order that marching detects, 1..64");
    }
  };

  explicit EventDriven(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }
  [[nodiscard]] Support supports(const Problem& problem) const override;
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override;

 private:
  Options options_;
};

template <>
struct EnumNames<EventDriven::Steady> {
  static constexpr std::array<std::string_view, 2> values{"marching", "shooting"};
};

template <>
struct EnumNames<Integrator> {
  static constexpr std::array<std::string_view, 4> values{"cvode", "adams", "bdf", "modal"};
};

}  // namespace signorini
