#include "methods/harmonic_balance/harmonic_options.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/augmented_lagrangian/augmented_lagrangian.hpp"
#include "methods/catalogue.hpp"
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
            (std::vector<std::string>{"harmonics", "samples", "c", "quadrature", "solver", "continuation",
                                      "tolerance", "max_iterations", "plain"}));
  EXPECT_EQ(names<PenaltyHbm>(),
            (std::vector<std::string>{"harmonics", "samples", "penalty", "quadrature", "solver",
                                      "continuation", "tolerance", "max_iterations", "plain"}));
  EXPECT_EQ(names<AftHbm>(),
            (std::vector<std::string>{"harmonics", "samples", "law", "c", "penalty", "quadrature", "homotopy",
                                      "continuation", "tolerance", "max_iterations", "plain"}));
}

TEST(HarmonicOptions, PlainSetsWhatIsLeftOpen) {
  const HarmonicOptions open;
  EXPECT_EQ(open.contact_integral(), Quadrature::exact);
  EXPECT_FALSE(open.fixed_samples(10));
  EXPECT_TRUE(open.grid_is_open(10));
  const HarmonicOptions plain{.plain = true};
  EXPECT_EQ(plain.contact_integral(), Quadrature::sampled);
  EXPECT_EQ(plain.fixed_samples(10), 320);
  EXPECT_FALSE(plain.grid_is_open(10));
  const HarmonicOptions asked{.samples = 64, .quadrature = Quadrature::exact, .plain = true};
  EXPECT_EQ(asked.contact_integral(), Quadrature::exact);
  EXPECT_EQ(asked.fixed_samples(10), 64);
}

TEST(HarmonicOptions, PlainTakesTheLiteraturesConstantsUnlessOneIsGiven) {
  const HarmonicOptions ours;
  EXPECT_FALSE(ours.lipschitz_constant({}, false));
  EXPECT_FALSE(ours.penalty({}, true).asked || ours.penalty({}, true).rigid);
  const HarmonicOptions plain{.plain = true};
  EXPECT_EQ(plain.lipschitz_constant({}, false), 1.0);
  EXPECT_EQ(plain.lipschitz_constant(7.0, false), 7.0);
  EXPECT_EQ(plain.penalty({}, false).rigid, (Scaled{100.0, true}));
  EXPECT_EQ(plain.penalty(Scaled{1e6, false}, true).asked, (Scaled{1e6, false}));
  EXPECT_FALSE(plain.penalty({}, true).asked) << "a spring keeps its own stiffness";
}

TEST(HarmonicOptions, PlainIsHardWherePivotsNeedNoStart) {
  const HarmonicOptions plain{.plain = true};
  EXPECT_EQ(plain.lipschitz_constant({}, true), 1e5);
  EXPECT_EQ(plain.lipschitz_constant(1.0, true), 1.0);
  EXPECT_EQ(plain.penalty({}, true).rigid, (Scaled{1e5, true}));
}

/// What a method says of a setting that it does not take.
template <class Method>
std::string said_of(const char* key) {
  const OptionSetting setting{key, "false"};
  try {
    method_entry<Method>().make({&setting, 1});
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return {};
}

TEST(HarmonicOptions, NameTheMethodThatClosesImpacts) {
  const std::string said =
      "compensate = false (unknown option: impacts stay as the series has them; the method closed-hbm "
      "closes them)";
  EXPECT_EQ(said_of<FourierLipschitz>("compensate"), said);
  EXPECT_EQ(said_of<PenaltyHbm>("compensate"), said);
  EXPECT_EQ(said_of<AftHbm>("compensate"), said);
  EXPECT_EQ(said_of<AugmentedLagrangian>("compensate"), said);
  EXPECT_NE(said_of<FourierLipschitz>("restitution").find("closed-hbm"), std::string::npos);
  EXPECT_NE(said_of<FourierLipschitz>("compensated").find("unknown option; known: harmonics, "),
            std::string::npos);
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
