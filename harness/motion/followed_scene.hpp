#pragma once
// A scene as its motions are followed through time.

#include <Eigen/Core>
#include <optional>

#include "harness/motion/long_motion.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/structure/unfelt_motions.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Without rigid motions that no contact feels (without_unfelt_motions), along which deviations neither grow
/// nor fade whatever the contacts do.
class FollowedScene {
 public:
  /// \param problem  must outlive this \throws std::runtime_error with flow_obstacle(problem) if there is one
  explicit FollowedScene(const Problem& problem)
      : whole_(problem), felt_(without_unfelt_motions(problem)), dynamics_(this->problem()) {}
  FollowedScene(const FollowedScene&) = delete;
  FollowedScene& operator=(const FollowedScene&) = delete;

  /// The scene on the coordinates that are followed.
  [[nodiscard]] const Problem& problem() const { return felt_ ? felt_->problem : whole_; }
  /// Its motion.
  [[nodiscard]] const ContactDynamics& dynamics() const { return dynamics_; }
  /// Its coordinates, of u or v of the whole scene.
  [[nodiscard]] Eigen::VectorXd coordinates(const Eigen::VectorXd& whole) const {
    return felt_ ? Eigen::VectorXd(felt_->of * whole) : whole;
  }
  /// follow_long_motion, where at rest is what stands still in the whole scene.
  [[nodiscard]] LongMotion follow(const FlowState& start, const LongMotionOptions& options,
                                  const Deadline& deadline) const {
    LongMotion motion = follow_long_motion(dynamics_, start, options, deadline);
    if (motion.verdict == LongRun::at_rest && felt_ && felt_->driven) motion.verdict = LongRun::periodic;
    return motion;
  }

 private:
  const Problem& whole_;
  std::optional<WithoutUnfeltMotions> felt_;
  ContactDynamics dynamics_;
};

}  // namespace signorini
