#pragma once
// The contact law as the harmonic-balance methods impose it, its linear part harmonic by harmonic, and a
// preconditioner.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

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

/// The law with a spring of stiffness r c behind each stop: 1 / c grows to (1 + 1 / r) / c and c / alpha
/// stays, so that y = c (x - g) - alpha lambda is multiplied by r / (1 + r).
ProjectedLaw on_springs(const ProjectedLaw& law, double r);

/// Size of the dynamic stiffness at the highest harmonics kept, per contact: the harmonic mean of
/// 1 / |C_n| over H/2 <= n <= H, Nc [N/m]. For one mass about m (3 H w / 4)^2.
Eigen::VectorXd highest_dynamic_stiffness(const ContactReceptance& receptance);

/// Signorini's condition, or a spring stop of the scene behind it, with the constant c asked for (times
/// contact_stiffness_scale), else 4 times the highest dynamic stiffness kept, in series with the spring's:
/// 0 < alpha <= 1 then, and for a soft spring c is nearly its stiffness and alpha nearly 0. A contact without
/// mass is to what has mass as a spring stop is: 1 / c = mean |C_n - C_m| / 4 + C_m, C_m its compliance while
/// all else stands, |w|^4 / w^T K w, alpha = 1.
ProjectedLaw lipschitz_law(const Problem& problem, const std::optional<double>& c,
                           const ContactReceptance& receptance);

/// Stiffnesses that take the place of stops in the penalty law.
struct StopPenalty {
  std::optional<Scaled> asked = {};  ///< of all stops, springs too
  std::optional<Scaled> rigid = {};  ///< else of those that are no springs
};

/// The penalty law: of each contact the stiffness asked for; else the scene's; else, for a rigid stop, 8
/// times the highest dynamic stiffness kept, on massless contacts growing as H^1.5 beyond ten harmonics,
/// where penalty error and truncation error are of one size.
ProjectedLaw penalty_law(const Problem& problem, const StopPenalty& penalty,
                         const ContactReceptance& receptance);

/// The law that every projected method represents: of each contact the scene's if it is conservative,
/// restitution 1 where it is rigid, for the projected force of no contact does net work (docs/theory.md). A
/// penalty asked for replaces the stiffness of stops that are springs.
RepresentedLaw projected_method_law(const Problem& problem, const std::optional<Scaled>& penalty = {});

/// B_n = sqrt(c) C_n sqrt(c) - alpha, n = 0..H: how y = c (x - g) - alpha lambda answers to lambda, both per
/// contact in units of sqrt(c). The projected equations lambda + P max(0, y) = 0 have the Jacobian 1 + P chi
/// B, chi the indicator of contact.
class ContactSymbol {
 public:
  /// B_n of these C_n under this law; B_0 of a structure with rigid motions answers to mu_0 (MeanBalance).
  ContactSymbol(const ContactReceptance& receptance, const ProjectedLaw& law);

  /// H.
  [[nodiscard]] int harmonics() const { return static_cast<int>(blocks_.size()) - 1; }
  /// Nc.
  [[nodiscard]] int contacts() const { return static_cast<int>(root_.size()); }
  /// (2 H + 1) Nc, the size of a packed vector (fourier_series.hpp).
  [[nodiscard]] int unknowns() const { return (2 * harmonics() + 1) * contacts(); }
  /// sqrt(c), Nc: lambda [N] is this times the scaled one.
  [[nodiscard]] const Eigen::VectorXd& root() const { return root_; }
  /// B_n, Nc x Nc.
  [[nodiscard]] const Eigen::MatrixXcd& block(Eigen::Index n) const {
    return blocks_[static_cast<std::size_t>(n)];
  }

  /// B_n s_n for every harmonic of a packed vector; (H+1) x Nc.
  [[nodiscard]] Eigen::MatrixXcd rate(const Eigen::VectorXd& packed) const;

 private:
  Eigen::VectorXd root_;
  std::vector<Eigen::MatrixXcd> blocks_;
};

/// The inverse of the Jacobian, harmonic by harmonic, as if every contact that is closed for more than half
/// of the period were closed throughout, and the others open: exact for permanent contact, the identity for
/// short ones. What is left is of low rank, a few dimensions per interval of contact: GMRES takes 6 to 8
/// steps for impacts, whatever H, and 18 for 40 contacts. Spreading each contact evenly over the period
/// instead, (1 + mean(chi) B_n)^{-1}, takes five times as many (docs/decisions/0010).
class LastingContactInverse {
 public:
  /// \param duty  share of the period that each contact is closed, Nc, in [0, 1] [-]
  LastingContactInverse(const ContactSymbol& symbol, const Eigen::VectorXd& duty);

  /// The inverse times a packed vector.
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& packed) const;

 private:
  std::vector<Eigen::MatrixXcd> inverses_;
};

}  // namespace signorini
