// Nodal complementarity without an impact law: a one-parameter family of solutions, whatever the grid.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <vector>

#include "methods/discretisation/trajectories.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::undetermined_law_test {
namespace {

using Complex = std::complex<double>;

const test::ImpactOscillator kOscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2};

// The member of the family x(t) = x_lin(t) - J G(t - t0), x(t0) = g, that touches at t0, in closed form;
// G is the T-periodic response to a unit impulse.
class FamilyMember {
 public:
  explicit FamilyMember(double impact_time) : time_(impact_time) {
    impulse_ = (linear(time_).real() - kOscillator.gap) / response(0.0);
  }

  [[nodiscard]] double impulse() const { return impulse_; }
  [[nodiscard]] double x(double t) const { return linear(t).real() - impulse_ * response(t - time_); }
  [[nodiscard]] double approach() const { return linear_rate() - impulse_ * response_rate(period()); }
  [[nodiscard]] double departure() const { return linear_rate() - impulse_ * response_rate(0.0); }
  [[nodiscard]] double restitution() const { return -departure() / approach(); }

  /// Impulse inward, and x <= g between impacts.
  [[nodiscard]] bool admissible() const {
    if (!(impulse_ > 0.0 && approach() > 0.0 && departure() < 0.0)) return false;
    constexpr int kInstants = 2000;
    for (int i = 1; i < kInstants; ++i) {
      if (x(time_ + i * period() / kInstants) > kOscillator.gap) return false;
    }
    return true;
  }

  static double period() { return 2.0 * std::numbers::pi / kOscillator.frequency; }

 private:
  static constexpr double kDecay = 0.05;
  static Complex root() { return {-kDecay, std::sqrt(1.0 - kDecay * kDecay)}; }
  static Complex linear(double t) {
    const double w = kOscillator.frequency;
    return std::polar(1.0, w * t) / Complex(1.0 - w * w, 0.1 * w);
  }
  [[nodiscard]] double linear_rate() const {
    return (Complex(0.0, kOscillator.frequency) * linear(time_)).real();
  }
  static double response(double s) {
    const double wrapped = s - period() * std::floor(s / period());
    return (std::exp(root() * wrapped) / (1.0 - std::exp(root() * period()))).imag() / root().imag();
  }
  // s in [0, T], T being the instant before the next impulse.
  static double response_rate(double s) {
    return (root() * std::exp(root() * s) / (1.0 - std::exp(root() * period()))).imag() / root().imag();
  }

  double time_ = 0.0;
  double impulse_ = 0.0;
};

// A nodal solution that presses at one node, or at two neighbours.
struct NodalImpact {
  double time = 0.0;         // centroid of the pressure [s]
  double impulse = 0.0;      // [N s]
  double restitution = 0.0;  // - slope after / slope before [-]
  double distance = 0.0;     // max |x - member at `time`| over the nodes [m]
};

bool describe_single_impact(const Trajectory& trajectory, int samples, NodalImpact& impact) {
  const Samples motion = trajectory.sample(samples);
  const double step = trajectory.period() / samples;
  std::vector<int> pressed;
  for (int i = 0; i < samples; ++i) {
    if (motion.force(i, 0) < 0.0) pressed.push_back(i);
  }
  if (pressed.empty() || pressed.size() > 2 || pressed.back() - pressed.front() > 1) return false;
  double moment = 0.0;
  impact.impulse = 0.0;
  for (const int i : pressed) {
    impact.impulse -= motion.force(i, 0) * step;
    moment -= motion.force(i, 0) * step * i * step;
  }
  impact.time = moment / impact.impulse;
  const auto at = [&](int i) { return motion.x((i + samples) % samples, 0); };
  impact.restitution =
      (at(pressed.back()) - at(pressed.back() + 1)) / (at(pressed.front()) - at(pressed.front() - 1));
  const FamilyMember member(impact.time);
  impact.distance = 0.0;
  for (int i = 0; i < samples; ++i)
    impact.distance = std::max(impact.distance, std::abs(at(i) - member.x(i * step)));
  return true;
}

// One impulse of about the right size on one node, at rest elsewhere.
std::shared_ptr<const Trajectory> impulse_at(int node, int samples) {
  const double step = FamilyMember::period() / samples;
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(samples, 1);
  force(node, 0) = -FamilyMember(node * step).impulse() / step;
  return std::make_shared<NodalTrajectory>(FamilyMember::period(), Eigen::MatrixXd::Zero(samples, 1), force);
}

// Every one-impact solution met from the admissible nodes and from a cold start.
std::vector<NodalImpact> solutions_met(const HatLcp::Options& options) {
  const Problem problem = test::to_problem(kOscillator);
  const int samples = options.samples.value();
  std::vector<std::shared_ptr<const Trajectory>> starts{nullptr};
  for (int node = 0; node < samples; ++node) {
    if (FamilyMember(node * FamilyMember::period() / samples).admissible()) {
      starts.push_back(impulse_at(node, samples));
    }
  }
  std::vector<NodalImpact> met;
  for (const auto& start : starts) {
    const Solution solution = test::solve<HatLcp>(problem, options, start);
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    NodalImpact impact;
    if (describe_single_impact(*solution.trajectory, samples, impact)) met.push_back(impact);
  }
  return met;
}

TEST(OneImpactFamily, ContainsTheOrbitOfEveryRestitution) {
  for (const double restitution : {0.0, 0.5, 0.8, 1.0}) {
    auto oscillator = kOscillator;
    oscillator.restitution = restitution;
    const auto orbit = test::single_impact_orbits(oscillator).front();
    const FamilyMember member(orbit.impact_time);
    EXPECT_NEAR(member.impulse(), orbit.impulse, 1e-10 * orbit.impulse);
    EXPECT_NEAR(member.restitution(), restitution, 1e-9);
    EXPECT_NEAR(member.x(1.0), orbit.x(1.0), 1e-10);
  }
}

class WithoutImpactLaw : public testing::TestWithParam<HatLcp::Scheme> {};

TEST_P(WithoutImpactLaw, EverySolutionLiesOnTheFamilyWithinAStep) {
  for (const int samples : {128, 256, 512}) {
    const auto met =
        solutions_met({.samples = samples, .scheme = GetParam(), .restitution = HatLcp::ImpactLaw::none});
    // Admissible impact times fill a twelfth of the period: as many solutions as nodes in there.
    EXPECT_GE(static_cast<int>(met.size()), samples / 10);
    const double step = FamilyMember::period() / samples;
    for (const NodalImpact& impact : met) {
      const FamilyMember member(impact.time);
      // An impact moved by one step moves x by at most a step times the jump of velocity.
      EXPECT_LE(impact.distance, step * impact.impulse) << "N = " << samples << ", t0 = " << impact.time;
      EXPECT_NEAR(impact.impulse, member.impulse(), step * member.impulse());
    }
  }
}

TEST_P(WithoutImpactLaw, EffectiveRestitutionIsAnOutputAndAnythingButOne) {
  const auto met =
      solutions_met({.samples = 256, .scheme = GetParam(), .restitution = HatLcp::ImpactLaw::none});
  ASSERT_FALSE(met.empty());
  const auto [least, most] = std::minmax_element(
      met.begin(), met.end(), [](const auto& a, const auto& b) { return a.restitution < b.restitution; });
  RecordProperty("least_restitution", std::to_string(least->restitution));
  RecordProperty("most_restitution", std::to_string(most->restitution));
  EXPECT_LE(least->restitution, 0.1);
  EXPECT_GE(most->restitution, 5.0);
  const auto far = std::count_if(met.begin(), met.end(), [](const NodalImpact& impact) {
    return std::abs(impact.restitution - 1.0) > 0.1;
  });
  EXPECT_GE(far, static_cast<long>(3 * met.size() / 4));
}

// The cold path closes the gap where x_lin is largest: e = - G'(0+) / G'(0-) = 1.140, energy out of nothing.
TEST_P(WithoutImpactLaw, AColdStartReturnsMoreEnergyThanItTook) {
  const FamilyMember selected(std::arg(Complex(1.0 - 2.2 * 2.2, 0.22)) / 2.2);
  EXPECT_NEAR(selected.restitution(), 1.140, 1e-3);
  for (const int samples : {256, 800}) {
    const HatLcp::Options options{
        .samples = samples, .scheme = GetParam(), .restitution = HatLcp::ImpactLaw::none};
    const Solution solution = test::solve<HatLcp>(test::to_problem(kOscillator), options);
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    NodalImpact impact;
    ASSERT_TRUE(describe_single_impact(*solution.trajectory, samples, impact));
    EXPECT_NEAR(impact.restitution, selected.restitution(), 15.0 / samples);
    EXPECT_GT(impact.restitution, 1.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Scheme, WithoutImpactLaw,
                         testing::Values(HatLcp::Scheme::galerkin, HatLcp::Scheme::nodal),
                         [](const auto& info) {
                           return std::string(
                               EnumNames<HatLcp::Scheme>::values[static_cast<std::size_t>(info.param)]);
                         });

}  // namespace
}  // namespace signorini::undetermined_law_test
