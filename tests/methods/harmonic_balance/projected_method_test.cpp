#include "methods/harmonic_balance/projected_method.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <variant>
#include <vector>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/augmented_lagrangian/augmented_lagrangian.hpp"
#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::projected_method_test {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};

std::vector<std::unique_ptr<Method>> presets() {
  std::vector<std::unique_ptr<Method>> all;
  all.push_back(std::make_unique<FourierLipschitz>(FourierLipschitz::Options{}));
  all.push_back(std::make_unique<PenaltyHbm>(PenaltyHbm::Options{}));
  all.push_back(std::make_unique<AftHbm>(AftHbm::Options{}));
  all.push_back(std::make_unique<AugmentedLagrangian>(AugmentedLagrangian::Options{}));
  return all;
}

TEST(ProjectedMethod, RepresentsRestitutionOneOnARigidStopWhateverThePreset) {
  const Problem problem = test::to_problem(kStop);
  for (const auto& method : presets()) EXPECT_EQ(std::get<Restitution>(method->law(problem)).e, 1.0);
  EXPECT_EQ(std::get<Restitution>(ClosedHbm({}).law(problem)).e, 0.8) << "has impacts of its own";
}

TEST(ProjectedMethod, RefusesALoadBeyondItsHarmonicsWhateverThePreset) {
  Problem problem = test::to_problem(kStop);
  for (const auto& method : presets()) EXPECT_TRUE(method->supports(problem).ok);
  problem.force.push_back({.dof = 0, .harmonic = 700, .cos = 1.0});
  for (const auto& method : presets()) EXPECT_FALSE(method->supports(problem).ok);
}

TEST(ProjectedMethod, APenaltyAskedForReplacesASpringOfTheScene) {
  Problem problem = test::to_problem(kStop);
  problem.set_law(Penalty{{50.0}});
  const auto stiffness_of = [&](const Method& method) {
    return std::get<Penalty>(method.law(problem)).stiffness.front();
  };
  EXPECT_EQ(stiffness_of(PenaltyHbm({.penalty = Scaled{70.0, false}})), 70.0);
  EXPECT_EQ(stiffness_of(PenaltyHbm({})), 50.0);
  EXPECT_EQ(stiffness_of(AugmentedLagrangian({.penalty = Scaled{70.0, false}})), 50.0)
      << "updates take it back";
}

TEST(FollowedMethod, FollowsWithAsManyHarmonicsAsItsAnswersHaveWhereThatIsLeftOpen) {
  constexpr double kFrom = 2.15, kTo = 2.2;
  const FourierLipschitz open_method({});
  constexpr int kMostFollowed = 40;
  int most = 20;
  for (const double frequency : {kFrom, kTo}) {
    const Problem problem =
        test::to_problem({.damping = kStop.damping, .frequency = frequency, .gap = kStop.gap});
    const Solution answer = open_method.prepare(problem)->solve({});
    ASSERT_NE(answer.trajectory, nullptr) << answer.message;
    most = std::max(most, answer.trajectory->bandwidth().value_or(0));
  }
  most = std::min(most, kMostFollowed);
  const ParametrisedScene scene =
      over_frequency(test::to_problem({.damping = kStop.damping, .gap = kStop.gap}), kFrom, kTo);
  const BranchDiagram open = open_method.follow(scene, {.max_order = 1});
  const BranchDiagram asked =
      FourierLipschitz({.common = {.harmonics = most}}).follow(scene, {.max_order = 1});
  ASSERT_FALSE(open.branches.empty()) << open.unfinished;
  ASSERT_EQ(open.branches.size(), asked.branches.size());
  EXPECT_EQ(open.branches.front().sequence, asked.branches.front().sequence);
  EXPECT_EQ(open.branches.front().points.size(), asked.branches.front().points.size());
}

}  // namespace
}  // namespace signorini::projected_method_test
