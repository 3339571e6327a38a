#pragma once
// A structure as its contacts feel it twice, few vectors to solve on and many to check with, and what is
// still outside.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "methods/structure/contact_reduction.hpp"
#include "methods/structure/ritz_reduction.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// How large a ContactSpace is.
struct ContactSpaceSettings {
  /// Vectors to solve on, at most; 0: 90, or six powers of up to 20 columns, or 100 of more columns [-]
  int small = 0;
  /// Vectors to check with, at least; 0: all of up to 300, else twice as many and two powers [-]
  int whole = 0;
};

/// Two reductions of one structure from one factorisation of K and one block Krylov space of K^-1 M from
/// K^-1 [N, F] (`BlockLanczos`, V^T K V = 1): `whole` is the structure projected on all of it; `small` on its
/// first powers or, where contacts are so many that these would be large, on its lowest Ritz vectors with the
/// static residual of the others. Both have the same statics, those of the structure; but `small` has no
/// residual under springs where damping grows with the stiffness, for a spring on a part that relaxes is not
/// followed (`flow_obstacle`).
///
/// With kappa = 1 + i beta w, mu = -w^2 + i alpha w, b = N lambda_n + F phi_n, and y the projected response,
/// the response outside the space is by energy orthogonal to it, and since Z_n is symmetric
///
///     |x_j - x_j^whole| <= rho(e_j) rho(b) / d,   rho(b) = |b - Z_n V y|_{K^-1},   d = min |kappa + mu
///     theta|,
///
/// theta over the spectrum of K^-1 M, 0 to the largest met (`reduced_receptance` has the same bound for
/// matrices). Without damping at w, d is taken over the Ritz values, which is an estimate.
class ContactSpace {
 public:
  /// \param problem  of proportional damping; contacts of any law
  explicit ContactSpace(const Problem& problem, const ContactSpaceSettings& settings = {});

  /// The same space under another law or at another frequency of the load: what it holds of structure,
  /// directions of contact and shapes of the load depends on neither.
  /// \param problem  with the same structure, the same directions and loads that differ in frequency alone
  [[nodiscard]] ContactSpace of(const Problem& problem) const;

  [[nodiscard]] const std::string& obstacle() const { return small_.obstacle; }  ///< one clause; empty: none
  [[nodiscard]] const ContactReduction& small() const { return small_; }         ///< m vectors
  [[nodiscard]] const ContactReduction& whole() const { return whole_; }         ///< k vectors
  [[nodiscard]] const ProportionalDamping& damping() const { return damping_; }  ///< of both
  /// Motion where forces act, n = 0..H.
  struct PortMotion {
    Eigen::MatrixXcd contacts;  ///< x_n, (H+1) x Nc [m]
    Eigen::MatrixXcd loads;     ///< q_n = F^T u_n, (H+1) x Nf [m]
  };
  /// The motion of `whole` under load and contact force, at the contacts and at the columns of the load.
  /// \throws SingularStiffness where an undamped vector resonates to rounding
  [[nodiscard]] PortMotion motion(double base, const Eigen::MatrixXcd& force) const;
  /// The size of the field u of all coordinates, root of the mean over time and coordinates of |u|^2, from
  /// harmonic `first` on; of the first order in what the space leaves out [m].
  /// \param force  of the contacts, n = 0..H, (H+1) x Nc [N]
  /// \param load   of the load's columns likewise, (H+1) x Nf [N]
  [[nodiscard]] double field_size(double base, const Eigen::MatrixXcd& force, const Eigen::MatrixXcd& load,
                                  int first) const;
  /// F and its rates.
  [[nodiscard]] const LoadColumns& load() const { return load_; }
  /// x_n - x_n^small under load and contact force as far as `whole` knows it, (H+1) x Nc [m].
  /// \param base   rate of harmonic 1, a whole part of the load's [rad/s]
  /// \param force  lambda_n, n = 0..H, (H+1) x Nc [N]
  [[nodiscard]] Eigen::MatrixXcd missing(double base, const Eigen::MatrixXcd& force) const;
  /// The bound of |x_j - x_j^whole| at harmonics 0..H, the largest over contacts, H+1 [m]. rho(e_j) is
  /// evaluated at harmonics that grow by a tenth, the larger of the two neighbours taken between them.
  [[nodiscard]] Eigen::VectorXd bound(double base, const Eigen::MatrixXcd& force) const;
  /// Rounding of the factors of K, relative to K, that `refine_lowest` leaves: measured. In theory it is eps
  /// times the condition of K, three digits more for slender structures [-].
  [[nodiscard]] double rounding() const { return rounding_; }
  /// Forces whose response is to be known.
  struct Wanted {
    Eigen::MatrixXcd force;  ///< lambda_n, n = 0..H, (H+1) x Nc [N]
    double tolerance = 0.0;  ///< > 0, on the root mean square over time of the bound [m]
  };
  /// The same space with more vectors in `whole`, so many that the bounds under load and each of these forces
  /// are as wanted, where that can be had: of all that K^-1 M makes of its vectors those directions are added
  /// in which the residuals under load and force are longest, until the space is exhausted, has as many
  /// vectors as 8 powers would (but 400 to 1500), or two steps do not halve the bound. `small` stays.
  /// Contacts may be many: a space of several powers of all of them would be large, and most of it of no use
  /// to the forces of one motion. Vectors that a space above 0.5 GB was given for other forces before are not
  /// among them.
  [[nodiscard]] ContactSpace grown_for(double base, const std::vector<Wanted>& all) const;
  /// The same space with as many vectors in `small`, the lowest of `whole`: where it has grown these are
  /// nearer to modes, which is better about resonances, and worse far above the highest.
  [[nodiscard]] ContactSpace solved_on_lowest() const;
  /// The root mean square over time of `bound` [m].
  [[nodiscard]] double bound_size(double base, const Eigen::MatrixXcd& force) const;
  /// The least d over harmonics 0..harmonics: the response to a change of K relative to K is no more than its
  /// inverse times the response [-].
  [[nodiscard]] double distance_from_resonance(double base, int harmonics) const;

 private:
  struct Pencil;
  struct Source;

  [[nodiscard]] Eigen::MatrixXcd columns_of(double base, const Eigen::MatrixXcd& force) const;
  [[nodiscard]] double contact_residual(const Pencil& pencil) const;
  /// rho(e_j) at harmonics 0..harmonics, the largest over contacts.
  [[nodiscard]] Eigen::VectorXd contact_residuals(double base, int harmonics) const;
  /// What a bound under load and force consists of, n = 0..H: the residuals rho(b) in the vectors that would
  /// come next and in those left out, and rho(e_j) / d.
  struct Residuals {
    Eigen::MatrixXcd acting = {};      ///< f x (H+1)
    Eigen::RowVectorXd left_out = {};  ///< lengths, H+1
    Eigen::VectorXd factor = {};
  };
  [[nodiscard]] Residuals residuals(double base, const Eigen::MatrixXcd& force) const;
  [[nodiscard]] Eigen::VectorXd bound(const Residuals& residuals, double base,
                                      const Eigen::MatrixXcd& force) const;
  /// Directions of the vectors that would come next in which the residuals of all harmonics are longest.
  [[nodiscard]] static Eigen::MatrixXd longest(const Residuals& residuals, double tolerance);
  /// Takes from the vectors made so far what `bound` needs.
  SpaceProjection take_residuals();
  void take_small(ContactReduction small);
  /// Everything that depends on them, `small` excepted.
  SpaceProjection take_whole();
  [[nodiscard]] Pencil pencil(double rate) const;
  /// Amplitudes of the Ritz vectors, k rows, and of what follows statically, Nc + Nf rows, n = 0..H.
  struct Amplitudes {
    Eigen::MatrixXcd modal, direct;
  };
  [[nodiscard]] Amplitudes amplitudes(double base, const Eigen::MatrixXcd& acting) const;
  void take_law();

  std::shared_ptr<Source> source_;  // what the vectors are made of, and they
  ContactReduction small_, whole_;
  ProportionalDamping damping_;
  Eigen::MatrixXd residual_;  // static, of small_ whatever the law
  Eigen::MatrixXcd residual_shift_;
  LoadColumns load_;
  Eigen::VectorXd theta_;               // of the whole space, k
  Eigen::MatrixXd contacts_;            // U^T V^T N, k x Nc
  Eigen::MatrixXd loads_;               // U^T V^T F, k x Nf
  Eigen::MatrixXd ports_;               // both, k x (Nc + Nf)
  Eigen::MatrixXd direct_;              // of the massless coordinates, (Nc + Nf) x (Nc + Nf)
  Eigen::MatrixXd gram_;                // of Ritz vectors and of what follows, over all coordinates
  Eigen::MatrixXd outside_, left_out_;  // |K^-1 M V y - V t y|_K <= |outside y| + |left_out y|
  int coordinates_ = 0;
  bool sprung_ = false;
  double left_out_of_start_ = 0.0, rounding_ = 0.0;
};

}  // namespace signorini
