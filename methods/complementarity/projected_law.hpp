#pragma once
// The contact law as the harmonic-balance methods impose it.

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "methods/method.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// The contact law in projected form, per contact:
///
///     lambda = -P z,   z = max(0, y),   y = c (x - g) - alpha lambda,
///
/// P the projection on harmonics |n| <= H, y the augmented multiplier [alart1991]. Weight alpha = 1 is
/// Signorini's condition [shi2015, eq. 4], alpha = 1 - c / k_p a stop of stiffness k_p; alpha = 0 with
/// c = k_p is the penalty law [shi2015, eq. 47].
struct ProjectedLaw {
  Eigen::VectorXd constant;           ///< c, Nc, > 0 [N/m]
  Eigen::VectorXd multiplier_weight;  ///< alpha, Nc, <= 1 [-]
};

/// The law that a method imposes on a structure of so many harmonics: its constant may grow with them.
using LawAt = std::function<ProjectedLaw(const ContactReceptance&)>;

/// The projected equations of a scene, x = x_f + C lambda with the law above. Refers to its parts, which must
/// outlive it.
struct ProjectedEquations {
  const ContactReceptance& receptance;  ///< C_n and x_f for n = 0..H
  const Eigen::VectorXd& gap;           ///< g, Nc [m]
  const ProjectedLaw& law;              ///< of each contact
};

/// The law with `factor` times its constant that is the same in continuous time:
/// y = s c (x - g) - (1 - s (1 - alpha)) lambda. After projection a contact is s^{-1/2} times as long, and
/// fewer samples resolve it.
ProjectedLaw with_stiffness_factor(const ProjectedLaw& law, double factor);

/// Size of the dynamic stiffness at the highest harmonics kept, per contact: the harmonic mean of
/// 1 / |C_n| over H/2 <= n <= H, Nc [N/m]. For one mass about m (3 H w / 4)^2.
Eigen::VectorXd highest_dynamic_stiffness(const ContactReceptance& receptance);

/// Signorini's condition, or the scene's spring stop behind it, with the constant c asked for (times
/// contact_stiffness_scale), else 4 times the highest dynamic stiffness kept.
ProjectedLaw lipschitz_law(const Problem& problem, const std::optional<double>& c,
                           const ContactReceptance& receptance);

/// The penalty law: the stiffness asked for; else the scene's; else, for a rigid stop, 8 times the highest
/// dynamic stiffness kept, on massless contacts growing as H^1.5 beyond ten harmonics, where penalty error
/// and truncation error are of one size.
ProjectedLaw penalty_law(const Problem& problem, const std::optional<Scaled>& penalty,
                         const ContactReceptance& receptance);

/// The law that every projected method represents: the scene's if it is conservative, restitution 1
/// where the scene is rigid, for the projected force does no net work (docs/theory.md). On a scene whose
/// stop is a spring, a penalty asked for replaces the spring's stiffness.
RepresentedLaw projected_method_law(const Problem& problem, const std::optional<Scaled>& penalty = {});

}  // namespace signorini
