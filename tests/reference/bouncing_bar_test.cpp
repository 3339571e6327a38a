// A free bar that bounces under its weight: no clamp, so that a rigid motion meets no stiffness.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "methods/flow/event_trajectory.hpp"
#include "methods/flow/flow.hpp"
#include "problems/assembly/beam.hpp"
#include "problems/validation.hpp"

namespace signorini::bouncing_bar_test {
namespace {

// [doyen2011], in closed form: E = 900, rho = 1, L = 10, gravity 10, dropped from 5 above the stop.
constexpr double kYoung = 900.0, kLength = 10.0, kGravity = 10.0, kHeight = 5.0;
constexpr double kWave = 1.0 / 3.0;        // time of a wave along the bar
constexpr double kPeriod = 16.0 * kWave;   // drop, contact, flight, contact, rise
constexpr double kFall = 3.0 * kWave;      // from the height to the stop
constexpr double kImpulse = 1600.0 / 3.0;  // weight times period

// Height of the lower end.
double lower_end(double t) {
  const double w = kWave;
  if (t < 3 * w) return kHeight - kGravity * t * t / 2.0;
  if (t < 5 * w || (t >= 11 * w && t < 13 * w)) return 0.0;
  if (t < 11 * w) {
    const double s = t - 5 * w, sigma = std::fmod(s, 2 * w);
    return kHeight - kGravity / 2.0 * (s - kFall) * (s - kFall) + kGravity * sigma * (sigma - 2 * w);
  }
  return kHeight - kGravity / 2.0 * (t - 13 * w - kFall) * (t - 13 * w - kFall);
}

// Node 0 is the upper end, the last one the lower; displacements are heights above rest on the stop.
Problem free_bar(int elements) {
  const Bar bar{.elements = elements,
                .length = kLength,
                .young = kYoung,
                .contact_mass = ContactMass::massless,
                .contacts = {elements - 1}};
  const double h = kLength / elements;
  Problem problem;
  problem.name = "bouncing-bar";
  problem.edit_structure([&](Structure& s) {
    s.mass = unclamped_mass(bar);
    s.damping = SparseMatrix(elements + 1, elements + 1);
    s.stiffness = SparseMatrix(elements + 1, elements + 1);
    for (int i = 0; i < elements; ++i) {
      s.stiffness.coeffRef(i, i) += kYoung / h;
      s.stiffness.coeffRef(i + 1, i + 1) += kYoung / h;
      s.stiffness.coeffRef(i, i + 1) -= kYoung / h;
      s.stiffness.coeffRef(i + 1, i) -= kYoung / h;
    }
  });
  problem.frequency = 2.0 * std::numbers::pi / kPeriod;
  for (int i = 0; i <= elements; ++i) {
    const double share = i == 0 || i == elements ? 0.5 : 1.0;
    problem.force.push_back({.dof = i, .harmonic = 0, .cos = -share * h * kGravity, .sin = 0.0});
  }
  problem.contacts = {{.normal = {{elements, -1.0}}, .gap = 0.0}};
  problem.set_law(Massless{});
  return problem;
}

struct Bounce {
  double first_error =
      0.0;  // of the displacement up to a wave after the first take-off, relative to the height
  double displacement_error = 0.0;  // largest, relative to the height
  double return_error = 0.0;        // of the mean height, relative
  double impulse = 0.0;
};

Bounce bounce(int elements) {
  const Problem problem = free_bar(elements);
  validate(problem);
  const ContactDynamics dynamics(problem);
  EventFlow flow(dynamics, 1e-9, [] { return false; });
  FlowState state = flow.place(0.0, {.u = Eigen::VectorXd::Constant(dynamics.size(), kHeight),
                                     .v = Eigen::VectorXd::Zero(dynamics.size())});
  const FlowState start = state;
  FlowRecord record;
  record.dense = true;
  flow.advance(state, kPeriod, record);
  const EventTrajectory motion(kPeriod, start, record.nodes, record.events);
  constexpr int kInstants = 4000;
  const Samples samples = motion.sample(kInstants);
  Bounce result;
  for (int i = 0; i < kInstants; ++i) {
    const double t = kPeriod * i / kInstants;
    const double error = std::abs(-samples.x(i, 0) - lower_end(t)) / kHeight;
    result.displacement_error = std::max(result.displacement_error, error);
    if (t < 6.0 * kWave) result.first_error = std::max(result.first_error, error);
  }
  result.impulse = -samples.force.col(0).mean() * kPeriod;
  result.return_error = std::abs(state.state.u.mean() / kHeight - 1.0);
  return result;
}

// Undamped waves that the mesh cannot resolve are left by the first contact, and the second meets them: the
// period's end is near the series, but not ever nearer.
TEST(BouncingBar, FiniteElementsFollowTheSeries) {
  std::vector<double> first;
  for (const int elements : {10, 20, 40, 80}) {
    const Bounce found = bounce(elements);
    first.push_back(found.first_error);
    EXPECT_LT(found.displacement_error, 0.1) << elements;
    EXPECT_LT(found.return_error, 0.1) << elements;
    EXPECT_NEAR(found.impulse, kImpulse, 0.01 * kImpulse) << elements;
  }
  EXPECT_LT(first.back(), 0.5 * first.front());
}

}  // namespace
}  // namespace signorini::bouncing_bar_test
