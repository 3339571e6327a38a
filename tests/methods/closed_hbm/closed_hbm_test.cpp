#include "methods/closed_hbm/closed_hbm.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini::closed_hbm_test {
namespace {

using test::solve;

// The oscillator "S-A" with restitution 1: one impact per period, stable.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

TEST(ClosedHbm, ConvergesAtTheRateOfWhatTheHarmonicsCutOff) {
  const auto orbit = test::single_impact_orbits(kStop).front();
  std::vector<double> steps, errors;
  for (const int harmonics : {10, 20, 40, 80, 160}) {
    const Solution solution = solve<ClosedHbm>(test::to_problem(kStop), {.harmonics = harmonics});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    steps.push_back(1.0 / harmonics);
    errors.push_back(test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); }));
  }
  EXPECT_NEAR(test::observed_order(steps, errors), 1.5, 0.1);
}

TEST(ClosedHbm, IsNearerTheOrbitThanTheSeriesOfTheProjectedEquations) {
  const auto orbit = test::single_impact_orbits(kStop).front();
  const auto error = [&](const Solution& found) {
    return test::relative_error(*found.trajectory, [&](double t) { return orbit.x(t); });
  };
  const Problem problem = test::to_problem(kStop);
  EXPECT_LT(8.0 * error(solve<ClosedHbm>(problem, {})), error(solve<FourierLipschitz>(problem, {})));
}

// An answer, not an exception: the search for orbits asks every method.
TEST(ClosedHbm, SaysThatImpactsOfALoosePartAreNotClosed) {
  Problem ball = test::loose_mass(1.0, 0.1);
  ball.force = {{.dof = 0, .harmonic = 0, .cos = 1.0}, {.dof = 0, .cos = 2.0}};
  ball.contacts = {{.normal = {{0, 1.0}}, .gap = 0.0}};
  ball.set_law(Restitution{0.8});
  const Solution solution = solve<ClosedHbm>(ball, {});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_NE(solution.message.find("a part that no spring holds"), std::string::npos) << solution.message;
}

TEST(ClosedHbm, RepresentsTheScenesLawUnlessRestitutionOneIsAsked) {
  Problem problem = test::to_problem({.frequency = 2.2, .gap = 0.2, .restitution = 0.5});
  EXPECT_TRUE(law_matches(ClosedHbm({}).law(problem), problem.law()));
  const ClosedHbm elastic({.restitution = ClosedHbm::ImpactLaw::none});
  EXPECT_EQ(std::get<Restitution>(elastic.law(problem)).e, 1.0);
  problem.set_law(Penalty{{3.0}});
  EXPECT_TRUE(law_matches(ClosedHbm({}).law(problem), problem.law()));
}

// No law of impact is asked there: bit for bit the series of the projected equations.
TEST(ClosedHbm, IsTheSeriesOfTheProjectedEquationsOnSpringsAndMasslessContacts) {
  Problem spring = test::to_problem(kStop);
  spring.set_law(Penalty{{50.0}});
  for (const Problem& problem : {spring, test::massless_node()}) {
    for (const int harmonics : {15, 40}) {
      const Solution closed = solve<ClosedHbm>(problem, {.harmonics = harmonics});
      const Solution series = solve<FourierLipschitz>(problem, {{.harmonics = harmonics}});
      ASSERT_EQ(closed.verdict, Verdict::converged) << closed.message;
      EXPECT_EQ(closed.message, series.message);
      EXPECT_EQ(closed.trajectory->sample(100).x, series.trajectory->sample(100).x);
    }
  }
}

// Under so soft a law a contact of the series lasts for too long to be an impact.
TEST(ClosedHbm, RefusesToCloseImpactsUnderAConstantThatIsTooSoft) {
  const Solution solution = solve<ClosedHbm>(test::to_problem(kStop), {.harmonics = 80, .c = 1.0});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_EQ(solution.message, "impacts not closed: a contact of the series lasts");
}

// Whether a contact lasts is not a matter of harmonics.
TEST(ClosedHbm, DoublesNoHarmonicsWhereAContactLasts) {
  const Problem problem =
      test::to_problem({.damping = 0.1, .frequency = 0.4, .gap = -0.3, .restitution = 0.0});
  const Solution found = solve<ClosedHbm>(problem, {});
  EXPECT_EQ(found.verdict, Verdict::not_converged);
  EXPECT_EQ(found.message, "impacts not closed: a contact lasts: only separate impacts are closed; H = 20");
}

TEST(ClosedHbm, IsTheLinearResponseWithoutContacts) {
  Problem free = test::to_problem(kStop);
  free.contacts.clear();
  const Solution linear = solve<ClosedHbm>(free, {});
  EXPECT_EQ(linear.message.find("no contact in the scene"), 0U) << linear.message;
}

// Records and users know the options by these names, in this order.
TEST(ClosedHbm, HasFewOptions) {
  std::vector<std::string> names;
  for (const OptionEcho& option : ClosedHbm({}).options()) names.push_back(option.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"harmonics", "c", "restitution", "tolerance", "max_iterations"}));
}

TEST(ClosedHbm, RefusesOptionsOutOfRange) {
  EXPECT_THROW(ClosedHbm({.harmonics = 0}), InvalidOption);
  EXPECT_THROW(ClosedHbm({.c = 0.0}), InvalidOption);
  EXPECT_THROW(ClosedHbm({.tolerance = 1.0}), InvalidOption);
  EXPECT_THROW(ClosedHbm({.max_iterations = -1}), InvalidOption);
}

TEST(ClosedHbm, SaysWhichHarmonicOfTheLoadIsBeyondIt) {
  Problem problem = test::to_problem(kStop);
  problem.force.push_back({0, 4, 1.0, 0.0});
  EXPECT_FALSE(ClosedHbm({.harmonics = 3}).supports(problem).ok);
  EXPECT_TRUE(ClosedHbm({.harmonics = 4}).supports(problem).ok);
}

}  // namespace
}  // namespace signorini::closed_hbm_test
