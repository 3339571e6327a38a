#pragma once
// Harmonic balance with the contact force projected on the Fourier space: the core that the
// Fourier Lipschitz and the penalty method share.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/harmonic_balance/compensated_solve.hpp"
#include "methods/harmonic_balance/harmonic_climb.hpp"
#include "methods/method.hpp"
#include "methods/solvers/complementarity_solver.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// Harmonics for which the coarsest grid of samples is made, however few there are.
inline constexpr int kFewestOnGrid = 8;

/// How the projected equations are solved.
struct ProjectedOptions {
  std::optional<int> samples = {};                     ///< N; empty: see SampleLadder
  Quadrature quadrature = Quadrature::exact;           ///< of the contact integral
  SolverSettings solver = {};                          ///< of the complementarity problem
  std::shared_ptr<CompensatedSolve> compensated = {};  ///< null: impacts stay as the series has them
};

/// w = q + A z with A = 1 + B_n (contact_symbol.hpp) for |n| <= H, 1 above, q = sqrt(c) (g - x_f): rows and
/// columns scaled by sqrt(c) per contact, z_scaled = z / sqrt(c).
Lcp projected_lcp(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
                  int samples);

/// Coefficients n = 0..H of lambda = -P z behind a solution of projected_lcp, (H+1) x Nc [N].
Eigen::MatrixXcd force_coefficients(const ProjectedLaw& law, const Eigen::VectorXd& z_scaled, int samples,
                                    int harmonics);

/// Net work of the contact force over a period, relative to the work exchanged,
/// |2 T sum_n Re(conj(lambda_n) i n w x_n)| / (2 T sum_n n w |lambda_n| |x_n|), summed over contacts.
/// Zero for exact quadrature (docs/theory.md): what is left measures how well N resolves the contact.
double net_work_ratio(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& lambda);

/// Samples per period as the harmonic-balance methods choose them: what the user fixed; else from 8 H up
/// where the exact contact integral follows and from 32 H up where it does not, doubled up to 128 H until
/// the solve converges and either its contact integral is exact or, from 32 H, the energy identity holds
/// to 1e-3.
class SampleLadder {
 public:
  /// \param fixed  what the user set
  SampleLadder(int harmonics, std::optional<int> fixed, Quadrature quadrature);
  /// N of the present rung.
  [[nodiscard]] int samples() const { return samples_; }
  /// Whether an answer is one: its contact integral exact, or sampled because that was asked for, or so well
  /// that the energy identity holds to 1e-3.
  [[nodiscard]] bool accepts(bool exact, double net_work) const;
  /// Doubles N unless the outcome contents; false if there is nothing left to try.
  bool climb(bool converged, bool exact, double net_work);

 private:
  Quadrature quadrature_;
  int samples_;
  int trusted_;
  int finest_;
};

/// The trajectory behind the coefficients of lambda, (H+1) x Nc [N]: x_n = x_f,n + C_n lambda_n.
FourierTrajectory::Data fourier_data(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                     const ProjectedLaw& law, Eigen::MatrixXcd lambda);

/// Replaces the sampled contact integral of `data` by the exact one (project_exactly). Where that does not
/// converge, because a contact is born or lost on the way, `data` is left as it is.
ExactProjection refine_quadrature(const ContactReceptance& receptance, const ProjectedLaw& law, int samples,
                                  double tolerance, FourierTrajectory::Data& data);

/// The answer behind a solution of the exactly projected equations, found as `how` says.
Solution exact_solution(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                        const ProjectedLaw& law, const ExactProjection& solved, const std::string& how);

/// Solves the problem at the foot of a climb: the first harmonics alone, the law softened.
using FootSolver = std::function<Solution(const ContactReceptance& few, double softness)>;

/// Permanent contact, or all harmonics from few (climb_foot, climb_harmonics); nothing where neither serves.
/// Adds what it spent to `work`.
std::optional<Solution> solve_by_climbing(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                          const LawAt& law_at, double tolerance, const Start& start,
                                          Work& work, const FootSolver& solve_foot);

/// The answer where the scene has no contact.
Solution contact_free_response(const ContactReceptance& receptance);

/// What a method with these options does beside its law. \param receptance  of the scene, n = 0..H
template <class Options>
ProjectedOptions projected_options(const Problem& problem, const ContactReceptance& receptance,
                                   const Options& options) {
  ProjectedOptions chosen{samples_of(options, receptance.harmonics()),
                          quadrature_of(options),
                          {options.solver, options.tolerance, options.max_iterations}};
  if (options.plain && options.solver == ComplementaritySolver::automatic)
    chosen.solver.solver = ComplementaritySolver::newton;
  const bool left_to_us = !options.plain && options.solver == ComplementaritySolver::automatic;
  if (compensates(options))
    chosen.compensated = compensated_solve(problem, receptance, {left_to_us, hardening_of(options)});
  return chosen;
}

/// A scene prepared for one projected law.
///
/// With solver = auto and the exact contact integral, a guess is taken up by Newton's method at once
/// (project_exactly), permanent contact is recognised, and many harmonics are reached from few
/// (solve_by_climbing); where none of these serves, as with the other settings, the complementarity problem
/// is solved on the grids of SampleLadder and its integral refined. Impacts are then compensated.
class ProjectedContact final : public PreparedMethod {
 public:
  /// \param softness  of the law where a climb begins [-]
  ProjectedContact(Eigen::VectorXd gap, ContactReceptance receptance, LawAt law_at, ProjectedOptions options,
                   double softness = 1.0);
  Solution solve(const Start& start) override;

 private:
  /// What needs no grid: Newton's method from the guess, permanent contact, the climb. Null if none serves.
  std::optional<Solution> solve_without_grid(const Start& start, Work& work) const;
  /// On the grids of SampleLadder.
  Solution solve_on_grids(const Start& start, Work& work) const;

  Eigen::VectorXd gap_;
  ContactReceptance receptance_;
  LawAt law_at_;
  ProjectedLaw law_;
  ProjectedOptions options_;
};

/// A scene prepared with H harmonics of a projected method. \throws std::runtime_error if the structure
/// cannot be factorised
template <class Options>
std::unique_ptr<PreparedMethod> projected_contact(const Problem& problem, int harmonics, LawAt law_at,
                                                  const Options& options) {
  ContactReceptance receptance = fourier_receptance(problem, harmonics);
  ProjectedOptions chosen = projected_options(problem, receptance, options);
  return std::make_unique<ProjectedContact>(contact_gaps(problem), std::move(receptance), std::move(law_at),
                                            std::move(chosen));
}

}  // namespace signorini
