// Exact orbits with damped massless contacts.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <vector>

#include "methods/orbit/family/orbit_family.hpp"
#include "methods/orbit/return_check.hpp"
#include "methods/periodic_motion/period_map.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/relaxing_scenes.hpp"

namespace signorini::relaxing_orbits_test {
namespace {

using test::cold_orbit;
using test::ColdOrbit;

const auto kNever = [] { return false; };

std::vector<std::complex<double>> sorted(const Eigen::VectorXcd& values) {
  std::vector<std::complex<double>> all(values.begin(), values.end());
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::pair(a.real(), a.imag()) < std::pair(b.real(), b.imag());
  });
  return all;
}

// Transitions of the whole structure's flow, and at each closing I + (F+ - F-) n^T / x'_-.
Eigen::MatrixXd descriptor_monodromy(const Problem& problem, const ExactTrajectory& orbit) {
  const test::DescriptorFlow whole(problem);
  const ContactDynamics dynamics(problem);
  const auto active = [&](const std::vector<bool>& closed) { return dynamics.mode(closed).active; };
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(whole.size(), whole.size());
  const OrbitGuess& path = orbit.orbit();
  double begin = path.start.time;
  std::vector<bool> closed = path.start.closed;
  for (const SequenceEvent& event : path.events) {
    M = (whole.transition(active(closed), event.time - begin) * M).eval();
    if (event.kind == ContactEvent::Kind::close) {
      const State state = orbit.at(event.time);
      const Eigen::VectorXd y =
          whole.state(state.u, state.v, dynamics.structure().unloaded(event.time, state.u, 0));
      const Eigen::RowVectorXd n = whole.displacement().row(event.contact);
      const Eigen::VectorXd before = whole.rate(active(closed), event.time, y);
      const Eigen::VectorXd after = whole.rate(active(event.closed), event.time, y);
      M += ((after - before) * (n * M) / n.dot(before)).eval();
    }
    begin = event.time;
    closed = event.closed;
  }
  return whole.transition(active(closed), path.start.time + orbit.period() - begin) * M;
}

TEST(RelaxingOrbits, AreFoundWithTheMultipliersOfTheWholeStructure) {
  for (const Problem& problem :
       {test::damped_tip_chain(0.5), test::damped_tip_chain(0.05), test::rayleigh_chain()}) {
    const ColdOrbit found = cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    EXPECT_LT(found.orbit->quality().error_bar, 1e-11);
    EXPECT_GE(found.orbit->orbit().events.size(), 2U);
    EXPECT_EQ(found.orbit->quality().multipliers.size(), 7);
    const auto own = sorted(found.orbit->quality().multipliers);
    const auto whole = sorted(general_eigenvalues(descriptor_monodromy(problem, *found.orbit)));
    ASSERT_EQ(whole.size(), own.size());
    for (std::size_t k = 0; k < own.size(); ++k) EXPECT_LT(std::abs(own[k] - whole[k]), 1e-8);
    const ReturnCheck check = cvode_return(ContactDynamics(problem), *found.orbit, kNever);
    EXPECT_TRUE(check.returned) << check.distance << " of " << check.allowed;
  }
}

TEST(RelaxingOrbits, AreFixedPointsOfTheFlowWithTheSameMonodromy) {
  const Problem problem = test::damped_coupled_scene(1, 0.2);
  const ColdOrbit found = cold_orbit(problem);
  ASSERT_TRUE(found.orbit) << found.solution.message;
  const ContactDynamics dynamics(problem);
  EventFlow flow(dynamics, 1e-11, kNever, Integrator::modal);
  PeriodMap map(flow);
  const FixedPoint point = find_fixed_point(map, found.orbit->orbit().start, 1, {.accepted = 1e-9}, kNever);
  ASSERT_TRUE(point.converged) << point.message;
  const auto own = sorted(found.orbit->quality().multipliers), mapped = sorted(point.multipliers);
  ASSERT_EQ(own.size(), 11U);  // 2 x 4 and 3 that relax
  EXPECT_GE(found.orbit->orbit().events.size(), 4U);
  for (std::size_t k = 0; k < own.size(); ++k) EXPECT_LT(std::abs(own[k] - mapped[k]), 1e-7);
}

TEST(RelaxingOrbits, AreTheLimitOfImplicitEulerWithoutEvents) {
  for (const double dashpot : {0.5, 0.05}) {
    const Problem problem = test::damped_tip_chain(dashpot);
    const ColdOrbit found = cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    const State start = found.orbit->at(0.0);
    Eigen::Vector4d u, v = Eigen::Vector4d::Zero();
    u << start.u.head(3), start.u[2] + start.u[3];  // N = (0, 0, 1): the tip is at u_3 + xi
    v.head(3) = start.v;
    std::vector<double> errors;
    for (const int steps : {1000, 4000, 16000}) {
      const Eigen::MatrixXd x = test::implicit_euler(problem, u, v, steps);
      const Eigen::MatrixXd exact = found.orbit->sample(steps).x;
      double worst = 0.0;
      for (int k = 1; k < steps; ++k) worst = std::max(worst, std::abs(x(k - 1, 0) - exact(k, 0)));
      errors.push_back(worst / exact.cwiseAbs().maxCoeff());
    }
    for (std::size_t k = 1; k < errors.size(); ++k) {
      EXPECT_GT(errors[k - 1] / errors[k], 3.5);
      EXPECT_LT(errors[k - 1] / errors[k], 4.5);
    }
    EXPECT_LT(errors.back(), 0.01);
  }
}

TEST(RelaxingOrbits, AreContinued) {
  EXPECT_EQ(continuation_obstacle(test::damped_tip_chain(0.5)), "");
  EXPECT_EQ(continuation_obstacle(test::damped_tip_chain(0.0)), "");
}

// With less and less damping of the tip the orbits go to that of the undamped one, at first order.
TEST(RelaxingOrbits, GoToTheOrbitOfTheUndampedContact) {
  constexpr int kInstants = 4096;
  const ColdOrbit undamped = cold_orbit(test::damped_tip_chain(0.0));
  ASSERT_TRUE(undamped.orbit) << undamped.solution.message;
  const Eigen::MatrixXd limit = undamped.orbit->sample(kInstants).x;
  std::vector<double> distances;
  for (const double dashpot : {0.1, 0.05, 0.025, 0.0125, 0.00625}) {
    const ColdOrbit found = cold_orbit(test::damped_tip_chain(dashpot));
    ASSERT_TRUE(found.orbit) << dashpot << ": " << found.solution.message;
    const Eigen::MatrixXd x = found.orbit->sample(kInstants).x;
    distances.push_back((x - limit).cwiseAbs().maxCoeff() / limit.cwiseAbs().maxCoeff());
  }
  for (std::size_t k = 1; k < distances.size(); ++k) {
    EXPECT_GT(distances[k - 1] / distances[k], 1.7) << k;
    EXPECT_LT(distances[k - 1] / distances[k], 2.2) << k;
  }
}

}  // namespace
}  // namespace signorini::relaxing_orbits_test
