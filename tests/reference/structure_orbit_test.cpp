// Penalty harmonic balance against exact orbits of structures, ten stops at once included.

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <memory>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "tests/reference/reference_data.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::structure_orbit_test {
namespace {

using test::ReferenceMotion;
using test::ReferenceStructure;
using test::solve;

// Newton alone: stays on the branch of its guess where motions coexist. A fine grid keeps the sampled
// equations it begins with close to smooth.
Solution solve_nearby(const Problem& problem, int harmonics, std::shared_ptr<const Trajectory> guess) {
  return solve<AftHbm>(problem,
                       {.common = {.harmonics = harmonics, .samples = 4096},
                        .law = AftHbm::ContactLaw::penalty,
                        .homotopy = false},
                       std::move(guess));
}

// |first harmonic| of coordinate `dof`, from the harmonics of the contact force by a dense solve.
double first_harmonic(const Problem& problem, const Solution& solution, int dof) {
  const auto& data = dynamic_cast<const FourierTrajectory&>(*solution.trajectory).data();
  const double w = problem.frequency;
  const Eigen::MatrixXcd stiffness =
      Eigen::MatrixXd(problem.stiffness() - w * w * problem.mass()).cast<std::complex<double>>() +
      std::complex<double>(0.0, w) * Eigen::MatrixXd(problem.damping()).cast<std::complex<double>>();
  const Eigen::VectorXcd force =
      load_harmonic(problem, 1) + contact_directions(problem) * (2.0 * data.lambda.row(1).transpose());
  return std::abs(lu_solve(stiffness, force)[dof]);
}

// Amplitude of the second mass, which bears no stop, at w = 0.65: 0.69311176 exactly.
TEST(TwoMassesOneStop, AmplitudeIsTheKnownOneAtEachNumberOfHarmonics) {
  Problem problem = test::load_structure("nlvib_ex03_2dof").problem;
  problem.frequency = 0.65;
  const struct {
    int harmonics;
    int samples;  // 0: exact quadrature
    double amplitude;
  } known[] = {{7, 1024, 0.70408033}, {21, 1024, 0.69376537}, {60, 0, 0.69311365}};
  for (const auto& [harmonics, samples, amplitude] : known) {
    PenaltyHbm::Options options{{.harmonics = harmonics}};
    if (samples > 0) options.common.samples = samples;
    if (samples > 0) options.common.quadrature = Quadrature::sampled;
    const Solution solution = solve<PenaltyHbm>(problem, options);
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    EXPECT_NEAR(first_harmonic(problem, solution, 1), amplitude, 2e-8) << "H = " << harmonics;
  }
}

// At these frequencies the contact-free motion exists as well: the branch is followed from NLvib's row.
TEST(TwoMassesOneStop, AmplitudeOnTheImpactingBranchIsTheKnownOne) {
  const ReferenceStructure structure = test::load_structure("nlvib_ex03_2dof");
  const struct {
    double omega;
    double at_7, at_21, at_60;  // harmonics
    double exact;
  } known[] = {{0.70, 0.79659971, 0.77922049, 0.77839616, 0.77839474},
               {0.73, 0.89295517, 0.86992006, 0.86899863, 0.86899730}};
  for (const auto& [omega, at_7, at_21, at_60, exact] : known) {
    for (const auto& [harmonics, amplitude] : {std::pair{7, at_7}, {21, at_21}, {60, at_60}}) {
      SCOPED_TRACE(testing::Message() << "omega " << omega << ", H " << harmonics);
      Problem problem = structure.problem;
      std::shared_ptr<const Trajectory> guess;
      double frequency = 0.0;
      for (const ReferenceMotion& row : structure.nlvib) {
        if (row.harmonics() != (harmonics == 60 ? 50 : harmonics) || row.omega < 0.72 || row.omega > 0.73)
          continue;
        frequency = row.omega;
        problem.frequency = frequency;
        guess = test::start_from(row, problem);
      }
      ASSERT_NE(guess, nullptr);
      while (frequency != omega) {
        frequency += std::clamp(omega - frequency, -1e-3, 1e-3);
        problem.frequency = frequency;
        const Solution solution = solve_nearby(problem, harmonics, guess);
        ASSERT_EQ(solution.verdict, Verdict::converged) << "at " << frequency << ": " << solution.message;
        guess = solution.trajectory;
        if (frequency != omega) continue;
        if (harmonics == 60) {
          EXPECT_NEAR(first_harmonic(problem, solution, 1), amplitude, 1e-6);
          EXPECT_NEAR(first_harmonic(problem, solution, 1), exact, 3e-6);
          continue;
        }
        // These were computed on a grid of 1024.
        const Solution sampled = solve<AftHbm>(
            problem,
            {.common = {.harmonics = harmonics, .samples = 1024, .quadrature = Quadrature::sampled},
             .law = AftHbm::ContactLaw::penalty,
             .homotopy = false},
            guess);
        ASSERT_EQ(sampled.verdict, Verdict::converged) << sampled.message;
        EXPECT_NEAR(first_harmonic(problem, sampled, 1), amplitude, 1e-6);
      }
    }
  }
}

TEST(TwoMassesOneStop, TendsToTheExactMotionsOnEveryBranch) {
  ReferenceStructure structure = test::load_structure("nlvib_ex03_2dof");
  ASSERT_EQ(structure.exact.size(), 13U);
  for (const ReferenceMotion& motion : structure.exact) {
    SCOPED_TRACE(testing::Message() << "omega " << motion.omega);
    structure.problem.frequency = motion.omega;
    for (const auto& [harmonics, bound] : {std::pair{40, 6e-5}, {60, 4e-6}}) {
      const Solution solution =
          solve_nearby(structure.problem, harmonics, test::start_from(motion, structure.problem));
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      // Relative L2 over harmonics 0..60; measured at most 5.8e-5 and 2.9e-6.
      EXPECT_LE(test::relative_l2(test::coefficients_of(solution), motion.x, 60), bound);
    }
  }
}

struct Level {
  int harmonics;
  double bound;  // relative L2 at the contacts, over the harmonics known exactly
};

struct Branch {
  const char* structure;
  double omega;
  std::vector<Level> levels;  // bounds a few percent above what was measured
};

void PrintTo(const Branch& branch, std::ostream* out) { *out << branch.structure << " at " << branch.omega; }

class StructureOrbit : public testing::TestWithParam<Branch> {};

TEST_P(StructureOrbit, IsApproachedAsHarmonicsAreAdded) {
  ReferenceStructure structure = test::load_structure(GetParam().structure);
  int found = 0;
  for (const ReferenceMotion& motion : structure.exact) {
    if (std::abs(motion.omega - GetParam().omega) > 1e-5 * motion.omega) continue;
    ++found;
    structure.problem.frequency = motion.omega;
    const auto exact = test::start_from(motion, structure.problem);
    for (const auto& [harmonics, bound] : GetParam().levels) {
      // A coarser grid to start from may lead to a neighbouring branch.
      const Solution solution =
          solve<PenaltyHbm>(structure.problem, {{.harmonics = harmonics, .samples = 32 * harmonics}}, exact);
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      EXPECT_LE(test::relative_l2(test::coefficients_of(solution), motion.x, motion.harmonics()), bound)
          << "H = " << harmonics;
    }
  }
  EXPECT_EQ(found, 1);
}

// The rod's stop is a thousand times as stiff as the rod and excites its modes up to the mesh's last: slow.
INSTANTIATE_TEST_SUITE_P(Beam, StructureOrbit,
                         testing::Values(Branch{"beam_tip",
                                                21.582477594955,
                                                {{7, 3.4e-2}, {15, 4e-3}, {40, 9e-5}, {60, 3.3e-5}}}));
INSTANTIATE_TEST_SUITE_P(Rod, StructureOrbit,
                         testing::Values(Branch{"rod_tip", 1.50179620432781, {{7, 1.3e-2}, {60, 2.6e-3}}},
                                         Branch{"rod_tip", 1.601376078181, {{15, 3.2e-2}, {60, 1.4e-3}}},
                                         Branch{"rod_tip", 1.62974673019113, {{15, 7e-2}, {60, 3.8e-3}}}));
INSTANTIATE_TEST_SUITE_P(
    TenStops, StructureOrbit,
    testing::Values(Branch{"chain10_multi", 0.142433810682736, {{7, 8.5e-3}, {21, 1.6e-3}, {60, 1.3e-4}}},
                    Branch{"chain10_multi", 0.146949621932449, {{7, 2.1e-2}, {21, 4e-3}, {60, 3.4e-4}}},
                    Branch{"chain10_multi", 0.149236086580312, {{7, 9.5e-2}, {21, 3.7e-2}, {60, 3.1e-3}}},
                    Branch{"chain10_multi", 0.150807877656641, {{15, 3.7e-2}, {60, 1.7e-3}}},
                    Branch{"chain10_multi", 0.150393361362492, {{7, 5.6e-2}, {21, 5.3e-3}, {60, 4.5e-4}}}));

}  // namespace
}  // namespace signorini::structure_orbit_test
