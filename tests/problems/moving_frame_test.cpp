#include "problems/moving_frame.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>

#include "problems/validation.hpp"
#include "tests/problems/chain_problems.hpp"

namespace signorini::moving_frame_test {
namespace {

using test::three_masses;

// r(t) and its derivatives, by hand.
Eigen::VectorXd frame_at(const Problem& problem, double time, int derivative) {
  Eigen::VectorXd r = Eigen::VectorXd::Zero(problem.size());
  for (const FrameTerm& term : problem.frame) {
    const double w = term.harmonic * problem.frequency;
    const std::complex<double> turned =
        std::pow(std::complex<double>(0.0, w), derivative) * std::polar(1.0, w * time);
    r[term.dof] += (std::complex<double>(term.cos, -term.sin) * turned).real();
  }
  return r;
}

std::string refusal(Problem problem, const std::vector<StopTerm>& terms) {
  try {
    move_stops(problem, terms);
    return "";
  } catch (const InvalidProblem& error) {
    return error.what();
  }
}

void expect_load_of_the_frame(const Problem& resting) {
  Problem moving = resting;
  move_stops(moving, {{.contact = 0, .harmonic = 1, .cos = 0.3, .sin = -0.1},
                      {.contact = 0, .harmonic = 3, .sin = 0.02}});
  EXPECT_NO_THROW(validate(moving));
  for (const double frequency : {0.4, resting.frequency, 5.0}) {
    moving = at_frequency(moving, frequency);
    const Problem plain = at_frequency(resting, frequency);
    for (const double time : {0.0, 0.7, 2.9}) {
      const double a = frequency * time;
      const double gamma = 0.3 * std::cos(a) - 0.1 * std::sin(a) + 0.02 * std::sin(3.0 * a);
      const Eigen::VectorXd r = frame_at(moving, time, 0);
      EXPECT_NEAR((contact_directions(moving).transpose() * r)[0], gamma, 1e-14)
          << "the stop is carried along";
      const Eigen::VectorXd expected = load_at(plain, time) - plain.stiffness() * r -
                                       plain.damping() * frame_at(moving, time, 1) -
                                       plain.mass() * frame_at(moving, time, 2);
      EXPECT_LE((load_at(moving, time) - expected).norm(), 1e-13 * expected.norm());
    }
  }
}

TEST(MoveStops, AddsTheLoadOfTheFrameAtEveryFrequency) {
  Problem resting = three_masses();
  expect_load_of_the_frame(resting);
  resting.edit_structure([](Structure& s) {
    SparseMatrix skew(3, 3);
    skew.insert(0, 1) = 0.7;
    skew.insert(1, 0) = -0.7;
    follow_speed(s, skew, 0.3 * skew);
  });
  expect_load_of_the_frame(resting);
}

TEST(MoveStops, LeavesStopsInPlaceThatShareCoordinatesButRest) {
  Problem problem = three_masses();
  problem.contacts = {{.normal = {{0, 1.0}, {2, -1.0}}, .gap = 0.1}, {.normal = {{2, 1.0}}, .gap = 0.3}};
  move_stops(problem, {{.contact = 0, .cos = 0.5}});
  EXPECT_NEAR(std::abs(stop_motion(problem, 0)[1] - 0.5), 0.0, 1e-15);
  EXPECT_NEAR(std::abs(stop_motion(problem, 1)[1]), 0.0, 1e-15);
}

TEST(MoveStops, TakesOppositeStopsThatMoveAsOneBodyAndRefusesOthers) {
  Problem problem = three_masses();
  problem.contacts = {{.normal = {{2, 1.0}}, .gap = 0.3}, {.normal = {{2, -1.0}}, .gap = 0.3}};
  EXPECT_EQ(refusal(problem, {{.contact = 0, .cos = 0.1}, {.contact = 1, .cos = -0.1}}), "");
  EXPECT_EQ(refusal(problem, {{.contact = 0, .cos = 0.1}, {.contact = 1, .cos = 0.1}}),
            "contact[0].gap_term = a motion of its own (stops on the same coordinates must move as one body: "
            "none may approach another)");
}

TEST(MoveStops, WithoutMotionChangesNothing) {
  Problem problem = three_masses();
  const std::size_t terms = problem.force.size();
  move_stops(problem, {{.contact = 0, .harmonic = 2}});
  EXPECT_EQ(problem.force.size(), terms);
  EXPECT_TRUE(problem.frame.empty());
}

TEST(MoveBase, AddsTheInertiaOfItsMotion) {
  const Problem resting = three_masses();
  Problem moving = resting;
  const Eigen::Vector3d direction(1.0, 1.0, 0.5);
  move_base(moving, direction,
            {{.harmonic = 2, .cos = 0.1, .sin = 0.3}, {.harmonic = 0, .cos = 9.81, .acceleration = true}});
  moving.frequency = 1.7;
  Problem plain = resting;
  plain.frequency = 1.7;
  const double time = 0.6, w = 3.4;
  const double acceleration = -w * w * (0.1 * std::cos(w * time) + 0.3 * std::sin(w * time)) + 9.81;
  const Eigen::VectorXd expected = load_at(plain, time) - resting.mass() * direction * acceleration;
  EXPECT_LE((load_at(moving, time) - expected).norm(), 1e-13 * expected.norm());
  EXPECT_TRUE(moving.frame.empty()) << "coordinates are told from the base";
}

}  // namespace
}  // namespace signorini::moving_frame_test
