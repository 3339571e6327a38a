#include "methods/orbit/arc_scan.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include "methods/linear_flow/linear_flow.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::arc_scan_test {
namespace {

constexpr double kStrict = 1e-13;

/// A beam of ten contacts, whose modes are found once.
struct Beam {
  Problem problem = test::massless_beam({.alpha = 0.02, .beta = 1e-4}, 10);
  ContactDynamics dynamics{problem};
  LinearFlows flows{dynamics};
};

Beam& beam() {
  static Beam one;
  return one;
}

/// Its contacts, none closed, a period after a state of many modes.
class OpenBeam : public testing::TestWithParam<double> {
 protected:
  OpenBeam() {
    const double X = dynamics_.scales().displacement, V = dynamics_.scales().velocity;
    State state = dynamics_.at_rest();
    std::mt19937 random(20261127);
    std::normal_distribution<double> normal;
    for (double& u : state.u) u = 0.1 * X * normal(random);
    for (double& v : state.v) v = 0.1 * V * normal(random);
    arc_->start(0.3, state);
    for (int j = 0; j < dynamics_.contact_count(); ++j)
      outputs_.push_back({.arc = *arc_, .contact = j, .of_force = false, .offset = 0.0, .unit = X});
    begin_ = 0.3 + problem_.period();
    end_ = begin_ + GetParam() * problem_.period();
    terms_ = arc_->fading_rates(kStrict);
    peaks_ = largest(outputs_, begin_, end_, terms_);
  }

  /// The outputs with limits so that each one's largest value is `above` zero.
  [[nodiscard]] std::vector<LimitedOutput> limited(double above) const {
    std::vector<LimitedOutput> result;
    for (const LimitedOutput& f : outputs_) {
      const double peak = peaks_[result.size()].value;
      result.push_back({.arc = f.arc,
                        .contact = f.contact,
                        .of_force = false,
                        .offset = f.unit * (peak - above),
                        .unit = f.unit});
    }
    return result;
  }

  const Problem& problem_ = beam().problem;
  const ContactDynamics& dynamics_ = beam().dynamics;
  std::unique_ptr<LinearArc> arc_ = beam().flows.of(std::vector<bool>(10, false)).arc();
  std::vector<LimitedOutput> outputs_;
  double begin_ = 0.0, end_ = 0.0;
  std::vector<FadingRate> terms_;
  std::vector<LimitedSample> peaks_;
};

TEST_P(OpenBeam, NothingThatReachesItsLimitIsLeftOut) {
  for (const double above : {1e-11, 1e-6, 1e-3, 0.1})
    EXPECT_EQ(near_limit(limited(above), begin_, end_, terms_).size(), outputs_.size()) << above;
}

TEST_P(OpenBeam, WhatStaysFarFromItsLimitIsLeftOut) {
  std::vector<LimitedOutput> mixed = limited(-2.0);
  mixed.push_back(limited(1e-6)[3]);
  const std::vector<LimitedOutput> near = near_limit(mixed, begin_, end_, terms_);
  if (GetParam() < 0.005) {  // as many instants as to look closely
    EXPECT_EQ(near.size(), mixed.size());
    return;
  }
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].contact, 3);
}

// A wave of 8.2 rad/s on slow ones, at both ends and in the middle of a short arc on a line below the limit,
// is 2e-4 above it in between: by second differences of three samples nothing would be known of it.
TEST(NearLimit, KnowsOfAMaximumBetweenSamplesOnALine) {
  constexpr double kFar = 1.91363, kEnd = 0.09;
  Problem waves = test::to_problem({.frequency = 1.0});
  waves.edit_structure([](Structure& s) {
    s.mass = SparseMatrix(Eigen::MatrixXd(Eigen::Matrix2d::Identity()).sparseView());
    s.stiffness =
        SparseMatrix(Eigen::MatrixXd(Eigen::Vector2d(0.5 * 0.5, 8.2 * 8.2).asDiagonal()).sparseView());
    s.damping = SparseMatrix(2, 2);
  });
  waves.force = {{.dof = 0, .harmonic = 1, .cos = -0.75, .sin = 0.75}};  // its response is cos t - sin t
  waves.contacts = {{.normal = {{0, 1.0}, {1, 1.0}}, .gap = kFar, .law = Restitution{1.0}}};
  const ContactDynamics dynamics(waves);
  LinearFlows flows(dynamics);
  const std::unique_ptr<LinearArc> arc = flows.of({false}).arc();
  arc->start(0.0, {.u = Eigen::Vector2d(2.0, -0.086771), .v = Eigen::Vector2d(-1.5, 8.2 * 0.174413)});
  const std::vector<LimitedOutput> x{
      {.arc = *arc, .contact = 0, .of_force = false, .offset = kFar, .unit = 1.0}};
  for (const double t : {0.0, 0.5 * kEnd, kEnd}) EXPECT_NEAR(x[0].value(t, 0), -4.01e-4, 1e-6);
  EXPECT_NEAR(x[0].value(0.071, 0), 2.1e-4, 1e-5);
  const std::vector<FadingRate> fine{{.rate = 1e3, .until = 1.0}};  // as if there were faster waves, unseen
  EXPECT_EQ(near_limit(x, 0.0, kEnd, fine).size(), 1U);
}

TEST(NearLimit, EndsOnAnArcThatNoListOfInstantsResolves) {
  const Problem problem = test::to_problem({.damping = 0.0, .frequency = 1.0});
  const ContactDynamics dynamics(problem);
  LinearFlows flows(dynamics);
  const std::unique_ptr<LinearArc> arc = flows.of({false}).arc();
  arc->start(0.0, dynamics.at_rest());
  const std::vector<LimitedOutput> x{
      {.arc = *arc, .contact = 0, .of_force = false, .offset = 1e3, .unit = 1.0}};
  const std::vector<FadingRate> endless{{.rate = 1.0, .until = std::numeric_limits<double>::infinity()}};
  EXPECT_NO_THROW((void)near_limit(x, 0.0, 1e4, endless));
  EXPECT_THROW((void)near_limit(x, 0.0, 1e9, endless), std::runtime_error);
  EXPECT_THROW((void)largest(x, 0.0, 1e9, endless), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(ArcScan, OpenBeam, testing::Values(1e-6, 0.003, 0.01, 0.15, 1.0));

}  // namespace
}  // namespace signorini::arc_scan_test
