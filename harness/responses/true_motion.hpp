#pragma once
// Whether a motion that a method tells, and that is on no exact branch, is one of the scene all the same.

#include <utility>

#include "harness/responses/response_metric.hpp"
#include "methods/curve.hpp"

namespace signorini {

/// Asks the judge (exact_orbits) for the orbit behind points of a response over the frequency of the load.
/// Of a point x at the contacts alone is known: its events are read off where x comes near the stops, and the
/// orbit that the polish finds with them must be confirmed, be of its order and lie within `tolerance`.
class TrueMotions {
 public:
  /// \param scene  over the frequency \param metric  of the comparison \param deadline  after which nothing
  /// is asked any more
  TrueMotions(ParametrisedScene scene, const ResponseMetric& metric, double tolerance, Deadline deadline)
      : scene_(std::move(scene)), metric_(metric), tolerance_(tolerance), deadline_(deadline) {}

  /// Whether there is such an orbit; false where the time is up.
  [[nodiscard]] bool contain(const ResponsePoint& point);
  /// Points so far that have one, and how many were not asked for want of time.
  [[nodiscard]] int confirmed() const { return confirmed_; }
  [[nodiscard]] int unasked() const { return unasked_; }

 private:
  ParametrisedScene scene_;
  const ResponseMetric& metric_;
  double tolerance_;
  Deadline deadline_;
  int confirmed_ = 0, unasked_ = 0;
};

}  // namespace signorini
