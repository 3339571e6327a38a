#pragma once
// Steps along a curve of harmonic balance, and where contacts begin and cease on them.

#include <Eigen/Core>
#include <optional>

#include "methods/continuation/arc_length.hpp"
#include "methods/continuation/curve_tracer.hpp"
#include "methods/curve.hpp"
#include "methods/harmonic_balance/continuation/series_events.hpp"

namespace signorini {

/// A step that may be taken.
struct SeriesStep {
  SeriesStation next;                          ///< its end
  double length = 0.0;                         ///< along the tangent at its beginning
  int iterations = 0;                          ///< of Newton's method
  double turn = 0.0;                           ///< of the tangent [rad]
  bool leaves = false;                         ///< it ends at an end of the interval
  std::optional<ContactDepth> beginning = {};  ///< of a contact that begins at its end
};

/// Takes steps by pseudo-arclength from station to station, the depths of short contacts among the unknowns.
///
/// A step is refused, and the next one shorter, as StepRules have it. Before that, and where a contact is
/// gained on a step, the step is led to where an extremum of y becomes zero, if one does within twice its
/// length. From there the curve goes on along the depth of that contact. A contact whose depth falls to zero
/// has ceased: the step ends there, and the curve goes on along that on which it is open. With a sampled
/// contact integral, which is not smooth, no depths are followed.
class SeriesSteps {
 public:
  /// \param family, limits  kept by the caller
  /// \param doublings  whether motions of twice the period are looked for \throws as SeriesCurve
  SeriesSteps(const SeriesFamily& family, int multiple, const CurveLimits& limits, bool doublings)
      : limits_(limits), doublings_(doublings), curve_(family, multiple), series_(curve_.series()) {}

  /// Goes to a start. False where the structure resonates undamped.
  bool begin(const SeriesStart& start);
  /// One attempt; empty where it is refused. The curve is left evaluated at its end.
  std::optional<SeriesStep> attempt();
  /// Goes on from the end of a step, at which the curve is left evaluated. False as begin().
  bool take(SeriesStep step);
  /// The next attempt is this share as long.
  void shorten(double factor) { length_ *= factor; }

  [[nodiscard]] DepthCurve& curve() { return curve_; }
  [[nodiscard]] SeriesCurve& series() { return series_; }
  [[nodiscard]] const SeriesStation& here() const { return here_; }
  [[nodiscard]] double length() const { return length_; }  ///< of the next attempt
  /// Whether the last attempt began at an end of the interval and led out of it.
  [[nodiscard]] bool outside() const { return outside_; }
  /// Whether the motion at which the curve is evaluated has 1 / p of the period: its force to 1e-7 of the
  /// units, and its short contacts, of which forces tell little.
  [[nodiscard]] bool repeats(int p) const;

 private:
  [[nodiscard]] CurveStep whole_step() const;
  std::optional<int> try_step();
  std::optional<SeriesStep> refuse(double factor);
  [[nodiscard]] bool gains_contact() const;
  bool stop_where_contact_ceases();
  bool shorten_to(const StepTarget& target);
  [[nodiscard]] std::optional<StepTarget> target() const;
  [[nodiscard]] bool moves_too_far() const;
  std::optional<SeriesStep> arrive(int iterations);
  std::optional<Eigen::VectorXd> next_slope(double& turn);
  std::optional<SeriesStep> begin_contact();
  std::optional<SeriesStep> begin_contact(const NascentContact& nascent, double distance);
  void turn_along_depths(const ContactDepth& first);

  const CurveLimits& limits_;
  bool doublings_;
  DepthCurve curve_;
  SeriesCurve& series_;  // of curve_
  SeriesStation here_;
  double length_ = kMethodSteps.first,
         planned_ = 0.0;                 // the latter of a step that ended at a frequency asked for
  std::optional<ContactDepth> ceasing_;  // at the end of the step at hand
  bool outside_ = false;
};

}  // namespace signorini
