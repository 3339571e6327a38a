#include "methods/harmonic_balance/harmonic_options.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::harmonic_options_test {
namespace {

template <class Method>
std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const OptionEcho& option : Method({}).options()) result.push_back(option.name);
  return result;
}

// Records and users know the options by these names, in this order.
TEST(HarmonicOptions, AreEchoedInTheirOrderWithTheMethodsOwnAmongThem) {
  EXPECT_EQ(names<FourierLipschitz>(),
            (std::vector<std::string>{"harmonics", "samples", "c", "quadrature", "compensate", "restitution",
                                      "solver", "continuation", "tolerance", "max_iterations", "plain"}));
  EXPECT_EQ(
      names<PenaltyHbm>(),
      (std::vector<std::string>{"harmonics", "samples", "penalty", "quadrature", "compensate", "restitution",
                                "solver", "continuation", "tolerance", "max_iterations", "plain"}));
  EXPECT_EQ(names<AftHbm>(),
            (std::vector<std::string>{"harmonics", "samples", "law", "c", "penalty", "quadrature",
                                      "compensate", "restitution", "homotopy", "continuation", "tolerance",
                                      "max_iterations", "plain"}));
}

TEST(HarmonicOptions, PlainSetsWhatIsLeftOpen) {
  const HarmonicOptions open;
  EXPECT_EQ(open.contact_integral(), Quadrature::exact);
  EXPECT_TRUE(open.closes_impacts());
  EXPECT_FALSE(open.fixed_samples(10));
  EXPECT_TRUE(open.grid_is_open(10));
  const HarmonicOptions plain{.plain = true};
  EXPECT_EQ(plain.contact_integral(), Quadrature::sampled);
  EXPECT_FALSE(plain.closes_impacts());
  EXPECT_EQ(plain.fixed_samples(10), 320);
  EXPECT_FALSE(plain.grid_is_open(10));
  const HarmonicOptions asked{
      .samples = 64, .quadrature = Quadrature::exact, .compensate = true, .plain = true};
  EXPECT_EQ(asked.contact_integral(), Quadrature::exact);
  EXPECT_TRUE(asked.closes_impacts());
  EXPECT_EQ(asked.fixed_samples(10), 64);
}

TEST(HarmonicOptions, PlainTakesTheLiteraturesConstantsUnlessOneIsGiven) {
  Problem rigid = test::to_problem({.frequency = 2.2, .gap = 0.2});
  Problem spring = rigid;
  spring.law = Penalty{{300.0}};
  const HarmonicOptions ours;
  EXPECT_FALSE(ours.lipschitz_constant({}));
  EXPECT_FALSE(ours.penalty({}, rigid));
  const HarmonicOptions plain{.plain = true};
  EXPECT_EQ(plain.lipschitz_constant({}), 1.0);
  EXPECT_EQ(plain.lipschitz_constant(7.0), 7.0);
  EXPECT_EQ(plain.penalty({}, rigid), (Scaled{100.0, true}));
  EXPECT_EQ(plain.penalty(Scaled{1e6, false}, rigid), (Scaled{1e6, false}));
  EXPECT_FALSE(plain.penalty({}, spring)) << "the spring's own stiffness";
}

TEST(HarmonicOptions, CloseImpactsOnlyWhereTheContactIntegralIsExact) {
  EXPECT_FALSE((HarmonicOptions{.quadrature = Quadrature::sampled, .compensate = true}.closes_impacts()));
}

TEST(HarmonicOptions, CloseImpactsAtTheRestitutionOfRigidStops) {
  Problem problem = test::to_problem({.frequency = 2.2, .gap = 0.2, .restitution = 0.5});
  const HarmonicOptions left_open, asked{.restitution = ClosedRestitution::scene},
      plain{.quadrature = Quadrature::exact, .compensate = true, .plain = true},
      none{.restitution = ClosedRestitution::none};
  EXPECT_EQ(left_open.closed_restitution(problem), 0.5);
  EXPECT_EQ(asked.closed_restitution(problem), 0.5);
  EXPECT_TRUE(law_matches(left_open.represented(problem, Restitution{1.0}), problem.law));
  EXPECT_EQ(plain.closed_restitution(problem), 1.0);
  EXPECT_EQ(none.closed_restitution(problem), 1.0);
  EXPECT_FALSE((HarmonicOptions{.compensate = false}.closed_restitution(problem)));
  for (const HarmonicOptions& elastic : {plain, none, HarmonicOptions{.compensate = false}})
    EXPECT_FALSE(law_matches(elastic.represented(problem, Restitution{1.0}), problem.law));
  problem.law = Penalty{{300.0}};
  EXPECT_FALSE(left_open.closed_restitution(problem));
  EXPECT_TRUE(law_matches(left_open.represented(problem, as_represented(problem.law)), problem.law));
}

TEST(HarmonicOptions, AGridIsFixedByEachOfItsOptions) {
  EXPECT_FALSE((HarmonicOptions{.samples = 640}.grid_is_open(20)));
  EXPECT_FALSE((HarmonicOptions{.quadrature = Quadrature::sampled}.grid_is_open(20)));
  EXPECT_FALSE((HarmonicOptions{.max_iterations = 10}.grid_is_open(20)));
  EXPECT_TRUE((HarmonicOptions{.harmonics = 40}.grid_is_open(40)));
}

TEST(HarmonicOptions, BeginWithTheHarmonicsOfTheLoad) {
  Problem problem = test::to_problem({.frequency = 2.2, .gap = 0.2});
  EXPECT_EQ(HarmonicOptions{}.first_harmonics(problem), 20);
  problem.force.push_back({.dof = 0, .harmonic = 50, .cos = 0.1, .sin = 0.0});
  EXPECT_EQ(HarmonicOptions{}.first_harmonics(problem), 80);
  problem.force.back().harmonic = 5000;
  EXPECT_EQ(HarmonicOptions{}.first_harmonics(problem), kMostHarmonics);
  EXPECT_EQ((HarmonicOptions{.harmonics = 7}.first_harmonics(problem)), 7);
}

/// What `validate` refuses, empty if nothing.
std::string refusal(const HarmonicOptions& options) {
  try {
    validate(options);
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return {};
}

TEST(HarmonicOptions, AreRefusedOutOfTheirRanges) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({.harmonics = 0}), "harmonics = 0 (must be from 1 to 100000, or auto)");
  EXPECT_EQ(refusal({.harmonics = 10, .samples = 20}),
            "samples = 20 (must be at least 2 * harmonics + 1, or auto)");
  EXPECT_EQ(refusal({.samples = 20000000}), "samples = 20000000 (must be at most 10000000)");
  EXPECT_EQ(refusal({.continuation = Continuation::frequency}),
            "continuation = frequency (must be none unless plain = true)");
  EXPECT_EQ(refusal({.continuation = Continuation::frequency, .plain = true}), "");
  const auto closed = ClosedRestitution::scene;
  const std::string needs_exact =
      "restitution = scene (must be none if plain = true, compensate = false or "
      "quadrature = sampled)";
  EXPECT_EQ(refusal({.restitution = closed}), "");
  EXPECT_EQ(refusal({.restitution = closed, .plain = true}), needs_exact);
  EXPECT_EQ(refusal({.compensate = false, .restitution = closed}), needs_exact);
  EXPECT_EQ(refusal({.quadrature = Quadrature::sampled, .restitution = closed}), needs_exact);
  EXPECT_EQ(refusal({.tolerance = 1.0}), "tolerance = 1 (must be in (0, 1e-2])");
  EXPECT_EQ(refusal({.max_iterations = -1}), "max_iterations = -1 (must be 0 or more)");
}

TEST(HarmonicOptions, RefuseALoadBeyondTheHarmonics) {
  Problem problem = test::to_problem({.frequency = 2.2, .gap = 0.2});
  problem.force.push_back({.dof = 0, .harmonic = 4, .cos = 1.0, .sin = 0.0});
  problem.subharmonic = 2;
  EXPECT_TRUE(supports_harmonics(problem, {.harmonics = 8}).ok);
  EXPECT_EQ(supports_harmonics(problem, {.harmonics = 7}).reason,
            "the load reaches harmonic 8 of the motion's base frequency, beyond harmonics = 7");
}

}  // namespace
}  // namespace signorini::harmonic_options_test
