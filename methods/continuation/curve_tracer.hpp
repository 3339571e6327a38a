#pragma once
// What tracers of a method's curves have in common, whatever the unknowns.

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "methods/continuation/arc_length.hpp"
#include "methods/continuation/curve_points.hpp"
#include "methods/curve.hpp"

namespace signorini {

/// A branch and its unknowns, and where others begin.
template <class Start>
struct TracedBranch {
  Branch branch = {};
  CurvePoints points = {};         ///< its unknowns and tangents
  std::string rejected = {};       ///< why it is no branch of its own, one clause; else empty
  std::vector<Start> others = {};  ///< of curves that begin on it
};

/// Follows a curve by steps until it ends. Start has the period of the curve in periods of the scene
/// (`periods`) and says where it begins (`origin`).
template <class Start>
class CurveTracer {
 public:
  virtual ~CurveTracer() = default;

  /// Ends of its own: the time is up, steps below the shortest, the limit of points, a curve met.
  TracedBranch<Start> run() {
    result_.branch.began = start_.origin;
    begin();
    while (!done_) {
      if (limits_.expired())
        finish("the time is up");
      else if (length() < kMethodSteps.shortest)
        end_broken();
      else
        advance();
    }
    if (result_.branch.points.size() < 2 && result_.rejected.empty()) result_.rejected = result_.branch.ended;
    return std::move(result_);
  }

 protected:
  /// All are kept by the caller.
  CurveTracer(const Start& start, const CurveLimits& limits, const FollowedCurves& followed)
      : start_(start), limits_(limits), followed_(followed) {}

  void finish(std::string reason) {
    result_.branch.ended = std::move(reason);
    done_ = true;
  }
  void end_broken() { finish(fmt::format("the curve breaks at {:.10g} rad/s", here().parameter)); }
  /// The next point of the branch. \param label  as of CurvePoints
  void append(SolutionPoint point, Eigen::VectorXd x, Eigen::VectorXd tangent,
              std::optional<std::size_t> label = {}) {
    result_.branch.points.push_back(std::move(point));
    result_.points.x.push_back(std::move(x));
    result_.points.tangents.push_back(std::move(tangent));
    if (label) result_.points.labels.push_back(*label);
  }
  /// A special point after the last one.
  void add(SpecialPoint special) {
    special.after = result_.points.x.size();
    result_.branch.special.push_back(std::move(special));
  }
  /// Ends it at its last point where that is one too many, or where the curve comes to itself or another one.
  void end_if_over() {
    if (static_cast<int>(result_.points.x.size()) >= limits_.max_points)
      return finish(fmt::format("limit of {} points", limits_.max_points));
    const auto& labels = result_.points.labels;
    std::string meeting = followed_.meeting(start_.periods(), result_.points,
                                            labels.empty() ? std::optional<std::size_t>() : labels.back());
    if (!meeting.empty()) finish(std::move(meeting));
  }
  [[nodiscard]] bool is_done() const { return done_; }
  [[nodiscard]] bool has_one_point() const { return result_.points.x.size() == 1; }
  [[nodiscard]] const SolutionPoint& here() const { return result_.branch.points.back(); }
  [[nodiscard]] const Start& start() const { return start_; }
  [[nodiscard]] const CurveLimits& limits() const { return limits_; }
  [[nodiscard]] TracedBranch<Start>& result() { return result_; }

 private:
  /// Goes to the start.
  virtual void begin() = 0;
  /// One attempt at a step.
  virtual void advance() = 0;
  /// Of the next step.
  [[nodiscard]] virtual double length() const = 0;

  const Start& start_;
  const CurveLimits& limits_;
  const FollowedCurves& followed_;
  bool done_ = false;
  TracedBranch<Start> result_;
};

}  // namespace signorini
