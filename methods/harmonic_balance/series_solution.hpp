#pragma once
// Solutions of a method made of Fourier coefficients of the contact force: behind given ones, and on finer
// and finer grids of samples.

#include <Eigen/Core>
#include <string>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// Net work of the contact force over a period, relative to the work exchanged, summed over contacts:
///
///     |2 T sum_n Re(conj(lambda_n) i n w x_n)| / (2 T sum_n n w |lambda_n| |x_n|)  [-].
///
/// Zero for exact quadrature (docs/theory.md, section 3): what is left measures how well N samples resolve
/// the contact. Zero also where nothing is exchanged.
///
/// \param x, lambda  n = 0..H, (H+1) x Nc [m], [N]
double net_work_ratio(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& lambda);

/// The trajectory behind the coefficients of lambda, (H+1) x Nc [N]: x_n = x_f,n + C_n lambda_n.
FourierTrajectory::Data series_data(const ProjectedEquations& equations, Eigen::MatrixXcd lambda);

/// The converged answer behind a solution of the exactly projected equations, without its work. The message
/// is `how` it was found and the energy identity.
Solution exact_solution(const ProjectedEquations& equations, const ExactProjection& solved,
                        const std::string& how);

/// The linear response of a scene without contacts.
Solution contact_free_response(const ContactReceptance& receptance);

/// Harmonics for which the coarsest grid of samples is made, however few there are.
inline constexpr int kFewestOnGrid = 8;
/// Samples per harmonic on which an exact contact integral may start.
inline constexpr int kCoarseSampling = 8;

/// Solves the sampled equations by the method's own solver, and where the exact contact integral is asked
/// for, the exactly projected equations from there. Where these have no solution nearby, because a contact is
/// born or lost on the way, the sampled one stays and says so; it is claimed if the energy identity holds to
/// 1e-3, or sampling was asked for.
///
/// The samples per period are what the user fixed; else from 8 H up where the exact contact integral follows
/// and from 32 H up where it does not, doubled up to 128 H until the solve converges and either its contact
/// integral is exact or, from 32 H, the energy identity holds to 1e-3.
///
/// Always gives an answer or the best iterate, its work apart: that is added to `work`.
/// \param near  lambda of a nearby problem, (H+1) x Nc [N], where Newton's method of the first grid begins;
/// may be
///        empty
Solution solve_on_grids(const HarmonicSetup& setup, const Start& start, Work& work,
                        Eigen::MatrixXcd near = {});

}  // namespace signorini
