#pragma once
// The projected equations of a method of harmonic balance with the frequency of the load among the unknowns.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/complementarity/projected_residual.hpp"
#include "methods/continuation/curve_family.hpp"
#include "methods/structure/receptance_rate.hpp"

namespace signorini {

/// What one method of harmonic balance makes of a scene over an interval of frequencies of its load. The unit
/// of displacement is that of the response to the contact force.
struct SeriesFamily : CurveFamily {
  int harmonics = 20;                                 ///< H of the motions of the scene's order [-]
  LawAt law_at = {};                                  ///< the contact law as the method imposes it
  ContactIntegral integral = ContactIntegral::exact;  ///< as the method takes it
  int samples = 0;                          ///< per period of the scene's order, as of ProjectedResidual
  std::vector<Eigen::Index> opposite = {};  ///< opposite_contacts of the scene; empty: none
};

/// lambda + P max(0, y) = 0, y = c (x - g) - alpha lambda, x = x_f + C lambda as a CurveEquations, for
/// motions of `multiple` periods of the scene's order, with as many times its harmonics.
///
/// Unknowns: lambda, packed, each coefficient times |C_n| over the unit of displacement, so that lengths are
/// those of the response to the contact force (|C_n| the largest diagonal entry of its contact from n on, at
/// the middle of the interval); and the frequency over its unit. R is in the units of the unknowns.
///
/// C_n, x_f, c and alpha are those of the frequency of each evaluation. C_n and x_f have exact derivatives; c
/// and alpha a central difference along them over 1e-6 of the frequency. c and alpha are found from the
/// harmonics of the scene's order alone: a motion that repeats its period solves the equations of a multiple
/// too.
class SeriesCurve {
 public:
  /// \param family  kept by the caller \throws SingularStiffness at an undamped resonance in the middle
  SeriesCurve(const SeriesFamily& family, int multiple);

  [[nodiscard]] Eigen::Index size() const { return weight_.size(); }  ///< (2 H + 1) Nc
  /// False where the frequency is not positive, the structure resonates undamped or R is not finite.
  bool evaluate(const Eigen::VectorXd& x);
  [[nodiscard]] const Eigen::VectorXd& residual() const { return residual_; }
  [[nodiscard]] Eigen::MatrixXd jacobian() const;
  [[nodiscard]] double noise() const { return noise_; }

  /// The unknowns of a force at a frequency. \param lambda  n = 0..H, (H+1) x Nc; mu (MeanBalance) wherever
  /// lambda is said, of a structure with rigid motions [N]
  [[nodiscard]] Eigen::VectorXd unknowns(const Eigen::MatrixXcd& lambda, double frequency) const;
  /// lambda of unknowns, (H+1) x Nc [N].
  [[nodiscard]] Eigen::MatrixXcd force(const Eigen::VectorXd& x) const;
  /// Factor of each packed coefficient of lambda in the unknowns [1/N].
  [[nodiscard]] const Eigen::VectorXd& weight() const { return weight_; }

  [[nodiscard]] const SeriesFamily& family() const { return family_; }
  [[nodiscard]] int multiple() const { return multiple_; }          ///< of the scene's order
  [[nodiscard]] int harmonics() const { return harmonics_; }        ///< H of the motions of this multiple
  [[nodiscard]] int order() const { return problem_.subharmonic; }  ///< forcing periods per period
  // Of the last evaluation:
  [[nodiscard]] const Problem& problem() const { return problem_; }  ///< at its frequency and order
  [[nodiscard]] const ContactReceptance& receptance() const { return receptance_.value; }  ///< C_n, x_f
  [[nodiscard]] double frequency() const { return problem_.frequency; }                    ///< [rad/s]
  [[nodiscard]] const Eigen::VectorXd& x() const { return x_; }                            ///< the unknowns
  [[nodiscard]] const Eigen::MatrixXcd& motion() const { return motion_; }  ///< x_n, (H+1) x Nc [m]
  [[nodiscard]] const ProjectedLaw& law() const { return law_; }            ///< c, alpha
  /// When each contact presses, Nc lists.
  [[nodiscard]] const std::vector<std::vector<ContactInterval>>& contacts() const {
    return pressing_->contacts();
  }

  /// y_n of one contact, n = 0..H [N].
  [[nodiscard]] Eigen::VectorXcd pressure(Eigen::Index contact) const;
  /// dy/dx of one contact at an instant, by all unknowns, size() + 1 [N]. \param time  share of the period
  [[nodiscard]] Eigen::VectorXd pressure_gradient(Eigen::Index contact, double time) const;

  /// 1 + P chi B on the harmonics n + 1/2, n = 0..H-1, packed as (Re, Im) contact by contact, in units of
  /// sqrt(c): the derivative of R towards motions of twice the period, of which it is a block of its own. It
  /// is singular exactly where such motions branch off. 2 H Nc square.
  [[nodiscard]] Eigen::MatrixXd doubled_jacobian() const;

 private:
  [[nodiscard]] ContactReceptance of_scenes_order(const ContactReceptance& receptance) const;
  [[nodiscard]] Eigen::MatrixXcd pressure_rate() const;

  const SeriesFamily& family_;
  int multiple_;
  int harmonics_;
  Problem problem_;
  Eigen::VectorXd weight_;  // of the packed lambda
  Eigen::VectorXd gap_;
  Eigen::VectorXd x_, residual_;
  double noise_ = 0.0;
  ReceptanceRate receptance_;
  ProjectedLaw law_, law_rate_;  // and its derivative by the frequency
  Eigen::MatrixXcd lambda_, motion_;
  std::optional<ProjectedResidual> pressing_;
};

/// sign(det A) times the geometric mean of the pivots: zero where A is singular, of moderate size elsewhere.
double signed_pivots(const Eigen::MatrixXd& A);

}  // namespace signorini
