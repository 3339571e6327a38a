// A disc whose gyroscopic moment couples the two planes of its shaft, against a flow in all coordinates.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/curve.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/orbit_check.hpp"

namespace signorini::gyroscopic_test {
namespace {

Problem gyroscopic_shaft() { return load_scene(find_scene("shaft-gyroscopic")); }

TEST(GyroscopicShaft, ItsOrbitIsOneOfTheFlowInAllCoordinates) {
  const Problem problem = gyroscopic_shaft();
  const Eigen::MatrixXd D = problem.damping();
  ASSERT_GT((D - D.transpose()).norm(), 0.1 * D.norm()) << "the planes are coupled by a skew matrix";
  const auto cold = test::cold_orbit(problem);
  ASSERT_TRUE(cold.orbit) << cold.solution.message;
  ASSERT_FALSE(cold.orbit->impulses().empty());
  const test::OrbitCheck check = test::check_orbit(problem, *cold.orbit, 1e-8);
  EXPECT_TRUE(check.ok) << check.reason;
}

TEST(GyroscopicShaft, SeriesApproachTheOrbit) {
  const Problem problem = gyroscopic_shaft();
  const auto cold = test::cold_orbit(problem);
  ASSERT_TRUE(cold.orbit) << cold.solution.message;
  std::vector<double> errors;
  for (const int harmonics : {20, 80}) {
    const Solution series = test::solve<ClosedHbm>(problem, {.harmonics = harmonics});
    ASSERT_EQ(series.verdict, Verdict::converged) << series.message;
    errors.push_back(test::relative_distance(*cold.orbit, *series.trajectory));
  }
  EXPECT_LT(errors[0], 0.05);
  EXPECT_LT(errors[1], 0.5 * errors[0]) << "harmonics up to 320 rad/s, beyond all modes of the shaft";
}

/// The shaft of the catalogue with this spin and frequency.
Problem shaft_with(const std::string& spin, double frequency) {
  std::ifstream file(find_scene("shaft-gyroscopic").file);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto put = [&text](const std::string& old, const std::string& other) {
    text.replace(text.find(old), old.size(), other);
  };
  put("spin = 4.0", "spin = " + spin);
  put("frequency = 4.0", "frequency = " + std::to_string(frequency));
  return parse_scene(text, "shaft-gyroscopic.toml");
}

TEST(SynchronousShaft, HasAtEachFrequencyTheMatricesOfThatSpin) {
  const Problem synchronous = shaft_with("\"synchronous\"", 4.0);
  for (const double frequency : {4.0, 2.5, 6.25}) {
    const Problem expected = shaft_with(std::to_string(frequency), frequency);
    const Problem found = at_frequency(synchronous, frequency);
    const Eigen::MatrixXd D = expected.damping();
    EXPECT_LT((Eigen::MatrixXd(found.damping()) - D).norm(), 1e-15 * D.norm());
    EXPECT_EQ((Eigen::MatrixXd(found.stiffness()) - Eigen::MatrixXd(expected.stiffness())).norm(), 0.0);
  }
}

Eigen::MatrixXd matrix_of(std::initializer_list<std::array<double, 4>> rows) {
  Eigen::MatrixXd A(std::ssize(rows), 4);
  Eigen::Index i = 0;
  for (const auto& row : rows) A.row(i++) = Eigen::Map<const Eigen::RowVector4d>(row.data());
  return A;
}

/// An unbalanced disc at the end of its shaft: deflection and rotation in two planes, of which one is softer,
/// coupled by its gyroscopic moment and by a seal, both of which grow with its speed.
Problem overhung_rotor(double frequency) {
  Problem rotor;
  rotor.edit_structure([](Structure& s) {
    s.mass = Eigen::Vector4d(2.0, 0.3, 2.0, 0.3).asDiagonal().toDenseMatrix().sparseView();
    s.damping = Eigen::Vector4d(0.4, 0.02, 0.4, 0.02).asDiagonal().toDenseMatrix().sparseView();
    s.stiffness = matrix_of({{500.0, -120.0, 0.0, 0.0},
                             {-120.0, 90.0, 0.0, 0.0},
                             {0.0, 0.0, 420.0, -120.0},
                             {0.0, 0.0, -120.0, 80.0}})
                      .sparseView();
    SparseMatrix gyroscopic(4, 4), circulatory(4, 4);
    gyroscopic.insert(1, 3) = 0.4;
    gyroscopic.insert(3, 1) = -0.4;
    circulatory.insert(0, 2) = 0.01;
    circulatory.insert(2, 0) = -0.01;
    follow_speed(s, gyroscopic, circulatory);
  });
  rotor.force = {{.dof = 0, .cos = 0.05, .omega_power = 2}, {.dof = 2, .sin = 0.05, .omega_power = 2}};
  return at_frequency(rotor, frequency);
}

/// The same with the matrices of this one speed written out.
Problem written_out(Problem rotor) {
  rotor.edit_structure([](Structure& s) { s.speed = nullptr; });
  return rotor;
}

/// The stop beside the disc, rigid.
Problem beside_a_stop(Problem rotor, double gap) {
  rotor.contacts = {{.normal = {{0, 1.0}}, .gap = gap, .law = Restitution{0.6}}};
  return rotor;
}

double first_harmonic(const Trajectory& motion) {
  constexpr int kSamples = 64;
  const Eigen::VectorXd x = motion.sample(kSamples).x.col(0);
  std::complex<double> sum = 0.0;
  for (int i = 0; i < kSamples; ++i)
    sum += x[i] * std::polar(2.0 / kSamples, -2.0 * std::numbers::pi * i / kSamples);
  return std::abs(sum);
}

// Values of numpy: the speeds are the square roots of eigenvalues of K - w^2 (M - i G_1), of which the least
// and the largest belong to backward whirl, the other one to forward whirl; the amplitudes are |u_0| of
// (K + w N_1 + i w (D + w G_1) - w^2 M) u = 0.05 w^2 (1, 0, -i, 0).
TEST(OverhungRotor, ResonatesInBackwardAndForwardWhirl) {
  struct Whirl {
    double speed, amplitude;
  };
  const auto amplitude = [](double speed) {
    const Problem rotor = beside_a_stop(overhung_rotor(speed), 9.0);
    const Solution solution = test::solve<FourierLipschitz>(rotor, {.common = {.harmonics = 4}});
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    return first_harmonic(*solution.trajectory);
  };
  for (const auto& [speed, expected] :
       {Whirl{7.610787722365427, 0.13567560390859032}, Whirl{12.617012410991848, 1.4740911592053032},
        Whirl{17.100969743789943, 0.3132240984290141}}) {
    EXPECT_NEAR(amplitude(speed), expected, 1e-11 * expected) << speed;
    EXPECT_LT(amplitude(0.99 * speed), expected) << speed;
    EXPECT_LT(amplitude(1.01 * speed), expected) << speed;
  }
}

/// The amplitude of the contact where a method's curve over 0.99 to 1.01 times the frequency passes it.
double followed_amplitude(const Method& method, const Problem& problem) {
  const double at = problem.frequency;
  const BranchDiagram diagram =
      method.curve()->follow(over_frequency(problem, 0.99 * at, 1.01 * at), {.max_order = 1, .at = {at}});
  for (const Branch& branch : diagram.branches)
    for (const SolutionPoint& point : branch.points)
      if (std::abs(point.parameter - at) < 1e-12 * at) return point.amplitude.front();
  ADD_FAILURE() << "no point at " << at << ": " << diagram.unfinished;
  return std::numeric_limits<double>::quiet_NaN();
}

// A point of an unbalance response is that of the rotor with the matrices of its speed written out.
TEST(OverhungRotor, IsFollowedWithTheMatricesOfEachSpeed) {
  const Problem rotor = beside_a_stop(overhung_rotor(12.0), 0.2);
  const auto expect_same = [&](const Method& method) {
    const double expected = followed_amplitude(method, written_out(rotor));
    EXPECT_NEAR(followed_amplitude(method, rotor), expected, 1e-10 * expected);
  };
  expect_same(ExactOrbitMethod({}));
  expect_same(HatLcp({.samples = 64}));
  expect_same(AftHbm({.common = {.harmonics = 10}}));
}

// Of which the first natural step is the solve itself: all of it, at another frequency than that of the file.
TEST(OverhungRotor, IsSolvedWithTheMatricesOfItsSpeed) {
  const Problem rotor = beside_a_stop(at_frequency(overhung_rotor(3.0), 12.0), 0.2);
  const Problem written = written_out(beside_a_stop(overhung_rotor(12.0), 0.2));
  const auto expect_same = [&](const Method& method) {
    const Solution found = method.prepare(rotor)->solve({}), expected = method.prepare(written)->solve({});
    ASSERT_EQ(expected.verdict, Verdict::converged) << expected.message;
    ASSERT_EQ(found.verdict, Verdict::converged) << found.message;
    EXPECT_LT(test::relative_distance(*expected.trajectory, *found.trajectory), 1e-10);
  };
  expect_same(ExactOrbitMethod({}));
  expect_same(HatLcp({.samples = 256}));
  expect_same(AftHbm({.common = {.harmonics = 10}}));
}

}  // namespace
}  // namespace signorini::gyroscopic_test
