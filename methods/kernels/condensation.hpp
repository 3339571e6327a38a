#pragma once
// Scenes whose contact coordinates carry no mass, as the scenes with spring stops that they are.

#include <memory>
#include <optional>
#include <string>

#include "methods/solution.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// A contact coordinate c without mass and damping follows the others statically:
/// u_c = y = -K_cr u_r / K_cc while open, and while closed u_c = g takes the force lambda = -K_cc (y - g). So
/// the others move exactly as with a spring stop of stiffness K_cc on y, and their stiffness is K_rr - K_rc
/// K_cr / K_cc.
struct CondensedScene {
  std::optional<Problem> problem;  ///< in u_r, law Penalty; absent if this cannot be done
  std::string reason;              ///< why not
};

/// Requires a scene with the law Massless. Not done: contacts that act on several coordinates or share one,
/// damping, loads or coupling between them at the contact coordinates.
CondensedScene condense(const Problem& problem);

/// The motion of the massless contacts behind a motion of the condensed scene: x = min(y, g), the force the
/// same.
class CondensedMotion final : public Trajectory {
 public:
  CondensedMotion(std::shared_ptr<const Trajectory> inner, Eigen::VectorXd gaps)
      : inner_(std::move(inner)), gaps_(std::move(gaps)) {}

  [[nodiscard]] int contact_count() const override { return inner_->contact_count(); }
  [[nodiscard]] double period() const override { return inner_->period(); }
  [[nodiscard]] Samples sample(int count) const override;
  [[nodiscard]] std::optional<int> bandwidth() const override { return inner_->bandwidth(); }
  [[nodiscard]] const std::shared_ptr<const Trajectory>& inner() const { return inner_; }

 private:
  std::shared_ptr<const Trajectory> inner_;
  Eigen::VectorXd gaps_;
};

}  // namespace signorini
