#pragma once
// The contact condition on hat functions with the frequency of the load among the unknowns, for one set of
// nodes that press.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/complementarity/forms.hpp"
#include "methods/continuation/curve_family.hpp"
#include "methods/discretisation/block_circulant.hpp"
#include "methods/structure/receptance_rate.hpp"

namespace signorini {

/// What a method of hat functions makes of a scene over an interval of frequencies of its load. The unit of
/// displacement is that of w, and of the response to the pressure.
struct HatFamily : CurveFamily {
  int samples = 256;                       ///< N of the motions of the scene's order [-]
  HatScheme scheme = HatScheme::galerkin;  ///< the symbol
  NodalRestitution restitution = {};       ///< as of hat_contact
};

/// w_S = 0 of the complementarity problem
///
///     w = q + A p >= 0,   p >= 0,   w^T p = 0,   q = g - S x_f,   A of symbol s_n C_n + compliance
///
/// (hat_form) as a CurveEquations: the nodes S press, the others are open. It is smooth; S changes where a
/// pressure or a gap becomes zero, which is for the caller to see. Unknowns: p_S times the diagonal of A at
/// the middle of the interval over the unit of displacement, then the frequency over its unit. All
/// derivatives by the frequency are exact. On a structure with rigid motions their means E a are unknowns,
/// too, between p_S and the frequency, over the unit of displacement, and their balance is asked for beside
/// w_S = 0.
class HatCurve {
 public:
  /// For motions of `multiple` periods of the scene's order, on as many times its nodes. \param family  kept
  /// by the caller \throws SingularStiffness at an undamped resonance in the middle of the interval
  HatCurve(const HatFamily& family, int multiple);

  /// The nodes that press: unknowns of the complementarity problem, contact c at instant i being c N + i.
  void press(std::vector<int> pressing) { pressing_ = std::move(pressing); }
  [[nodiscard]] const std::vector<int>& pressing() const { return pressing_; }  ///< S

  /// |S|.
  [[nodiscard]] Eigen::Index pressing_count() const { return static_cast<Eigen::Index>(pressing_.size()); }
  /// m, rigid motions that contacts feel.
  [[nodiscard]] Eigen::Index rigid_count() const { return border_.cols(); }
  [[nodiscard]] Eigen::Index size() const { return pressing_count() + rigid_count(); }  ///< |S| + m
  /// False where the frequency is not positive, the structure resonates undamped or w is not finite.
  bool evaluate(const Eigen::VectorXd& x);
  [[nodiscard]] Eigen::VectorXd residual() const;
  [[nodiscard]] Eigen::MatrixXd jacobian() const;
  [[nodiscard]] double noise() const { return noise_; }

  /// Unknowns of all nodes, N Nc + m + 1, from those of S, and back.
  [[nodiscard]] Eigen::VectorXd on_all(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::VectorXd on_pressing(const Eigen::VectorXd& all) const;

  [[nodiscard]] const HatFamily& family() const { return family_; }
  [[nodiscard]] int order() const { return problem_.subharmonic; }  ///< forcing periods per period
  [[nodiscard]] int samples() const { return samples_; }            ///< N of the motions of this multiple
  [[nodiscard]] int nodes() const { return samples_ * problem_.contact_count(); }  ///< N Nc
  /// Factor of a pressure [N] in the unknowns, the same for the nodes of a contact.
  [[nodiscard]] double weight(int node) const { return weight_[node / samples_]; }
  // Of the last evaluation:
  [[nodiscard]] double frequency() const { return problem_.frequency; }  ///< [rad/s]
  [[nodiscard]] const Eigen::VectorXd& x() const { return x_; }          ///< the unknowns
  [[nodiscard]] const Eigen::VectorXd& gaps() const { return gaps_; }    ///< w over its unit, N Nc [-]
  [[nodiscard]] Eigen::MatrixXd motion() const;                          ///< x at the nodes, N x Nc [m]
  /// Derivative of a gap along a tangent of the curve, in the units of gaps and unknowns.
  [[nodiscard]] double gap_rate(int node, const Eigen::VectorXd& tangent) const;

 private:
  [[nodiscard]] BlockCirculant operator_of(const std::vector<Eigen::MatrixXcd>& receptance,
                                           const Eigen::VectorXd& diagonal) const;
  [[nodiscard]] Eigen::VectorXd shifted_samples(const Eigen::MatrixXcd& spectrum) const;

  const HatFamily& family_;
  int samples_;
  Problem problem_;
  NodalStops stops_;
  Eigen::VectorXd weight_;  // per contact
  Eigen::MatrixXd border_;  // E, each column over its largest entry, Nc x m
  std::vector<int> pressing_;
  Eigen::VectorXd balance_;  // sum of E^T p over the nodes less N R^T f_0, in the units of the unknowns
  Eigen::VectorXd x_, pressure_, gaps_, rates_;  // rates_: of the gaps by the frequency, p held
  double noise_ = 0.0;
  ReceptanceRate receptance_;
  std::optional<BlockCirculant> matrix_;
};

}  // namespace signorini
