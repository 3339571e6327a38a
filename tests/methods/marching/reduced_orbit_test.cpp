#include <gtest/gtest.h>

#include <Eigen/Core>

#include "methods/marching/periodic_march.hpp"
#include "methods/structure/bases/massless_elimination.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::reduced_orbit_test {
namespace {

constexpr int kSamples = 1024;

/// All modes of a scene with one harmonic of load, by a dense eigenvalue problem in the whole matrices:
/// shares no code with the Lanczos method.
ContactReduction all_modes(const Problem& problem) {
  const Eigen::MatrixXd K(problem.stiffness()), M(problem.mass()), W(contact_directions(problem));
  const Eigen::VectorXd f = load_harmonic(problem, 1).real();
  const SymmetricEigen modes = generalised_eigen(M, K);
  const Eigen::VectorXd& theta = modes.values;
  Eigen::Index count = 0;
  while (count < theta.size() && theta[theta.size() - 1 - count] > 1e-13 * theta[theta.size() - 1]) ++count;
  const Eigen::VectorXd omega = theta.tail(count).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd Phi = modes.vectors.rightCols(count) * omega.asDiagonal();
  ContactReduction all;
  all.squares = omega.cwiseAbs2();
  all.damp(*proportional_damping(problem.mass(), problem.stiffness(), problem.damping()));
  all.rows = Phi.transpose() * W;
  all.rates = {0.0, problem.frequency};
  all.load = Eigen::MatrixXcd::Zero(count, 2);
  all.load.col(1) = (Phi.transpose() * f).cast<std::complex<double>>();
  all.compliance = eliminate_massless(problem).massless_compliance;
  all.shift = Eigen::MatrixXcd::Zero(W.cols(), 2);
  return all;
}

PeriodicMarch orbit_of(const Problem& problem, const ContactReduction& reduction) {
  ContactMarch march(reduction, march_grid(problem, kSamples));
  return march_to_periodic_motion(march, {.tolerance = 1e-11});
}

/// max |x_m - x| / max |x| of the periodic motions on one grid.
double orbit_error(const Problem& problem, const ContactReduction& reduction, const PeriodicMarch& truth) {
  const PeriodicMarch answer = orbit_of(problem, reduction);
  EXPECT_TRUE(answer.found());
  return (answer.motion - truth.motion).cwiseAbs().maxCoeff() / truth.motion.cwiseAbs().maxCoeff();
}

/// A row of the table: m and the error of the orbit that it may leave.
struct OrbitRow {
  int vectors;
  double most;
};

void expect_rows(const Problem& problem, const PeriodicMarch& truth, ReductionBasis basis,
                 const std::vector<OrbitRow>& rows) {
  ASSERT_TRUE(truth.found());
  ASSERT_LT(truth.force.minCoeff(), 0.0);
  for (const OrbitRow& row : rows) {
    const ContactReduction reduction = reduce_to_contacts(problem, {.basis = basis, .vectors = row.vectors});
    EXPECT_LE(orbit_error(problem, reduction, truth), row.most) << problem.name << ", m = " << row.vectors;
  }
}

// The rows are those of docs/decisions/0040; each bound is twice what was measured there.
TEST(ReducedOrbits, OfABarConvergeToTheWholeBar) {
  const Problem damped = test::massless_bar({.alpha = 0.2, .beta = 0.005});
  const PeriodicMarch truth = orbit_of(damped, all_modes(damped));
  expect_rows(damped, truth, ReductionBasis::modes,
              {{4, 0.1}, {8, 6e-3}, {16, 4e-4}, {32, 4e-5}, {64, 1e-7}, {128, 1e-8}, {199, 1e-9}});
  expect_rows(damped, truth, ReductionBasis::krylov, {{16, 1e-3}, {32, 1e-7}, {64, 1e-10}, {199, 1e-9}});
  const Problem waves = test::massless_bar({.alpha = 0.3});
  expect_rows(waves, orbit_of(waves, all_modes(waves)), ReductionBasis::modes,
              {{16, 4e-2}, {32, 2e-3}, {64, 4e-7}, {128, 6e-8}});
}

TEST(ReducedOrbits, OfABeamConvergeToTheRoundingOfItsStiffness) {
  const Problem beam = test::massless_beam({.alpha = 0.2, .beta = 0.005}, 1);
  const PeriodicMarch truth = orbit_of(beam, all_modes(beam));
  expect_rows(beam, truth, ReductionBasis::modes,
              {{4, 4e-3}, {8, 2e-4}, {16, 2e-6}, {32, 1e-7}, {64, 1e-7}, {200, 1e-7}});
  expect_rows(beam, truth, ReductionBasis::krylov, {{8, 1e-4}, {16, 1e-7}, {200, 1e-7}});
}

// The truth is a Krylov space of 300 vectors, whose receptances tests/methods/structure measures.
TEST(ReducedOrbits, OfABlockAreBetterFromKrylovVectorsThanFromModes) {
  test::PaddedBlock corner;
  corner.patch = {{{2.0, 2.0}, {0.2, 0.2}}};
  const Problem one = test::padded_block_problem(corner);
  const PeriodicMarch truth =
      orbit_of(one, reduce_to_contacts(one, {.basis = ReductionBasis::krylov, .vectors = 160}));
  expect_rows(one, truth, ReductionBasis::krylov, {{16, 5e-5}, {40, 1e-8}});
  expect_rows(one, truth, ReductionBasis::modes, {{4, 1.2e-2}, {8, 1.5e-3}, {16, 8e-4}, {64, 2e-4}});
}

TEST(ReducedOrbits, OfNineContactsConverge) {
  const Problem nine = test::padded_block_problem({});
  const PeriodicMarch truth =
      orbit_of(nine, reduce_to_contacts(nine, {.basis = ReductionBasis::krylov, .vectors = 300}));
  expect_rows(nine, truth, ReductionBasis::krylov, {{30, 2e-3}, {60, 2e-5}});
  expect_rows(nine, truth, ReductionBasis::modes, {{8, 1.3e-2}, {32, 5e-3}, {128, 3e-4}});
}

}  // namespace
}  // namespace signorini::reduced_orbit_test
