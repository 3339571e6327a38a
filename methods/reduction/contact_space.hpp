#pragma once
// A structure as its contacts feel it twice, few vectors to solve on and many to check with, and what is
// still outside.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "methods/reduction/space_remainder.hpp"
#include "methods/structure/bases/ritz_reduction.hpp"
#include "methods/structure/contact_reduction.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Columns of contacts and load up to which a space starts from all of them [-].
inline constexpr int kFewColumns = 20;

/// How large a ContactSpace is.
struct ContactSpaceSettings {
  /// Vectors to solve on, of up to 20 columns whole powers at least as many, a better space than as many
  /// modes; 0: the lowest 96, or of more columns 48, until `solved_for` chooses them for a motion [-]
  int small = 0;
  /// Vectors to check with, at least; 0: all of up to 300, else 96, or 180 of up to 20,000 coordinates under
  /// up to 20 columns, and twice as many as are given to solve on, before the space has grown for a motion
  /// [-]
  int whole = 0;
  Factorise factorise = factorise_here;  ///< K
};

/// Two reductions of one structure from one factorisation of K and one block Krylov space of K^-1 M
/// (`BlockLanczos`, V^T K V = 1): `whole` is the structure projected on all of it, `small` on few of its
/// vectors with the static residual of the others. The space begins with K^-1 [N, F], all that acts, where
/// these are 20 columns at most, else with F and a few random combinations of N, and what it does not hold of
/// the others follows statically (`StaticCompliance`). Both reductions have the statics of the structure; but
/// `small` has no residual under springs where damping grows with the stiffness, for a spring on a part that
/// relaxes is not followed (`flow_obstacle`).
///
/// A motion asks for two things that no space has beforehand, and its forces, a few shapes in time and place,
/// say which: vectors to check with until a bound is small (`grown_for`), and vectors to solve on
/// (`solved_for`). What is outside has the bound of `SpaceRemainder` at every harmonic.
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
  /// Whether the settings name the size of `small`.
  [[nodiscard]] bool small_is_given() const { return given_small_; }
  /// F and its rates.
  [[nodiscard]] const LoadColumns& load() const { return load_; }
  /// x_n - x_n^small under load and contact force as far as `whole` knows it, (H+1) x Nc [m].
  /// \param base   rate of harmonic 1, a whole part of the load's [rad/s]
  /// \param force  lambda_n, n = 0..H, (H+1) x Nc [N]
  [[nodiscard]] Eigen::MatrixXcd missing(double base, const Eigen::MatrixXcd& force) const;
  /// The bound of |x_j - x_j^whole| at harmonics 0..H, the largest over contacts, H+1 [m]. rho(e_j) is
  /// evaluated at harmonics that grow by a tenth, the larger of the two neighbours taken between them.
  [[nodiscard]] Eigen::VectorXd bound(double base, const Eigen::MatrixXcd& force) const;
  /// The bound of |sum_j conj(lambda_nj) (x_nj - x_nj^whole)| at harmonics 0..H, H+1 [N m]. Of the second
  /// order in what the space leaves out of the response to the force, which sums of `bound` are not.
  [[nodiscard]] Eigen::VectorXd work_bound(double base, const Eigen::MatrixXcd& force) const;
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
  /// to the forces of one motion. Vectors that a space was given for other forces before are among them,
  /// unless they were released.
  [[nodiscard]] ContactSpace grown_for(double base, const std::vector<Wanted>& all) const;
  /// The same space with those vectors in `small` that load and force of a motion need: the 30 lowest, and of
  /// the others the principal directions of what is dynamic in the response of `whole`, in the norm of K over
  /// all harmonics; where `small` has no static residual, of all of it.
  /// \param force      lambda_n, n = 0..H, (H+1) x Nc [N]
  /// \param tolerance  > 0, on what is left out of x, in the root mean square over contacts and time [m]
  /// \throws SingularStiffness where an undamped vector resonates to rounding
  [[nodiscard]] ContactSpace solved_for(double base, const Eigen::MatrixXcd& force, double tolerance) const;
  /// Lets go of vectors and factors where they take more than 1 GB, in all copies of the space: a growth
  /// afterwards makes them anew. Not during a growth. For the end of a solve, after which growths may never
  /// be asked for. \return whether it did
  [[nodiscard]] bool release() const;
  /// The least d over harmonics 0..harmonics: the response to a change of K relative to K is no more than its
  /// inverse times the response [-].
  [[nodiscard]] double distance_from_resonance(double base, int harmonics) const;

 private:
  struct Source;

  /// b_n of contacts and load, (Nc + Nf) x (H+1).
  [[nodiscard]] Eigen::MatrixXcd acting(double base, const Eigen::MatrixXcd& force) const;
  [[nodiscard]] SpaceRemainder::Residuals residuals(double base, const Eigen::MatrixXcd& acting,
                                                    Eigen::Index contacts) const;
  /// Of the vectors made so far, and whether they are all.
  SpaceProjection projection();
  /// What `bound` needs of them.
  void take(const SpaceProjection& projection);
  void take_small(ContactReduction small);
  /// Everything that depends on them, `small` excepted.
  SpaceProjection take_whole();
  /// Amplitudes of the Ritz vectors, k rows, and of what follows statically, Nc + Nf rows, n = 0..H.
  struct Amplitudes {
    Eigen::MatrixXcd modal, direct;
  };
  [[nodiscard]] Amplitudes amplitudes(double base, const Eigen::MatrixXcd& acting) const;
  void take_law();
  /// Whether `small` has one: a spring on a part that relaxes is not followed.
  [[nodiscard]] bool static_residual() const;

  std::shared_ptr<Source> source_;  // what the vectors are made of, and they
  ContactReduction small_, whole_;
  ProportionalDamping damping_;
  Eigen::MatrixXd residual_;  // static, of small_ whatever the law
  Eigen::MatrixXcd residual_shift_;
  LoadColumns load_;
  Eigen::VectorXd theta_;     // of the whole space, k
  Eigen::MatrixXd ports_;     // U^T V^T [N, F], k x (Nc + Nf)
  Eigen::MatrixXd direct_;    // of massless coordinates and what follows, (Nc + Nf) x (Nc + Nf)
  Eigen::MatrixXd gram_;      // of Ritz vectors and of what follows, over all coordinates
  SpaceRemainder remainder_;  // none of a complete space
  int coordinates_ = 0;
  bool sprung_ = false, given_small_ = false;
  double rounding_ = 0.0;
};

}  // namespace signorini
