#include "tests/methods/event_driven/scenes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace signorini::test {

Problem two_masses(double frequency, double restitution) {
  Problem problem;
  problem.name = "two-masses";
  const Eigen::Matrix2d K = (Eigen::Matrix2d() << 2.0, -1.0, -1.0, 1.0).finished();
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::MatrixXd(Eigen::Matrix2d::Identity()).sparseView();
    s.stiffness = Eigen::MatrixXd(K).sparseView();
    s.damping = Eigen::MatrixXd(0.1 * K).sparseView();
  });
  problem.frequency = frequency;
  problem.force = {{.dof = 1, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  problem.contacts = {{.normal = {{1, 1.0}}, .gap = 0.5}};
  problem.set_law(Restitution{restitution});
  return problem;
}

Problem free_chain(int count, double frequency) {
  Problem problem;
  problem.name = "free-chain";
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(count, count);
  for (int i = 0; i < count; ++i) {
    K(i, i) = 2.0;
    if (i > 0) K(i, i - 1) = K(i - 1, i) = -1.0;
  }
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::MatrixXd(Eigen::MatrixXd::Identity(count, count)).sparseView();
    s.stiffness = K.sparseView();
    s.damping = Eigen::MatrixXd(0.05 * K).sparseView();
  });
  problem.frequency = frequency;
  problem.force = {{.dof = count - 1, .harmonic = 1, .cos = 0.7, .sin = 0.4},
                   {.dof = 0, .harmonic = 3, .cos = 0.0, .sin = 0.2},
                   {.dof = 0, .harmonic = 0, .cos = 0.3, .sin = 0.0}};
  return problem;
}

Solution solve(const Problem& problem, const EventDriven::Options& options,
               const std::shared_ptr<const Trajectory>& guess) {
  const EventDriven method(options);
  Start start;
  start.guess = guess;
  return method.prepare(problem)->solve(start);
}

const EventTrajectory& trajectory_of(const Solution& solution) {
  const auto* trajectory = dynamic_cast<const EventTrajectory*>(solution.trajectory.get());
  if (trajectory == nullptr) throw std::runtime_error("no trajectory: " + solution.message);
  return *trajectory;
}

std::vector<ContactEvent> events_of(const Solution& solution) {
  const auto events = solution.trajectory ? solution.trajectory->events() : std::nullopt;
  EXPECT_TRUE(events) << solution.message;
  return events.value_or(std::vector<ContactEvent>{});
}

double approach_speed(const ContactEvent& event, double restitution, double mass) {
  return -event.impulse / ((1.0 + restitution) * mass);
}

std::shared_ptr<const Trajectory> guess_from(const Problem& problem, const Eigen::VectorXd& u,
                                             const Eigen::VectorXd& v) {
  FlowState start{.time = 0.0, .state = {.u = u, .v = v}, .closed = {}};
  start.closed.resize(problem.contacts.size());
  return std::make_shared<EventTrajectory>(problem.period(), start, std::vector<FlowNode>{},
                                           std::vector<ContactEvent>{});
}

double distance(const Trajectory& found, const SingleImpactOrbit& orbit, int count) {
  const Samples samples = found.sample(count);
  const double forcing_period = 2.0 * std::numbers::pi / orbit.oscillator.frequency;
  double best = std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < orbit.oscillator.order; ++shift) {
    double worst = 0.0;
    for (int i = 0; i < count; ++i) {
      const double time = i * found.period() / count + shift * forcing_period;
      worst = std::max(worst, std::abs(samples.x(i, 0) - orbit.x(time)));
    }
    best = std::min(best, worst);
  }
  return best;
}

}  // namespace signorini::test
