// Exact orbits of structures by closed-form flows, against a peer's piecewise-linear shooting.

#include <gtest/gtest.h>

#include "methods/discretisation/real_fft.hpp"
#include "methods/orbit/exact_orbit.hpp"
#include "tests/reference/reference_data.hpp"

namespace signorini::exact_structures_test {
namespace {

using test::ReferenceMotion;
using test::ReferenceStructure;

// Harmonics 0..`harmonics` of a motion, (H+1) x Nc. Its coefficients fall like n^-4.
Eigen::MatrixXcd harmonics_of(const Trajectory& motion, Eigen::Index harmonics) {
  constexpr int kSamples = 16384;
  const Samples samples = motion.sample(kSamples);
  RealFft fft(kSamples);
  Eigen::VectorXcd spectrum(fft.coefficients());
  Eigen::MatrixXcd x(harmonics + 1, samples.x.cols());
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    fft.forward(samples.x.col(c), spectrum);
    x.col(c) = spectrum.head(harmonics + 1);
  }
  return x;
}

class ExactStructure : public testing::TestWithParam<const char*> {};

TEST_P(ExactStructure, HasThePeersOrbitsStableOrNot) {
  ReferenceStructure structure = test::load_structure(GetParam());
  ASSERT_FALSE(structure.exact.empty());
  for (const ReferenceMotion& motion : structure.exact) {
    SCOPED_TRACE(testing::Message() << "omega " << motion.omega);
    structure.problem.frequency = motion.omega;
    const OrbitSearch found =
        OrbitFinder(structure.problem).find(*test::start_from(motion, structure.problem));
    ASSERT_TRUE(found.orbit.certified()) << describe(found.orbit.outcome) << ": " << found.orbit.reason;
    EXPECT_LE(test::relative_l2(harmonics_of(*found.orbit.trajectory, motion.harmonics()), motion.x,
                                motion.harmonics()),
              1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(Peer, ExactStructure, testing::Values("nlvib_ex03_2dof", "rod_tip", "beam_tip"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace signorini::exact_structures_test
