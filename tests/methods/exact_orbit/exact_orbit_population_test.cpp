// exact-orbit from cold starts on seeded populations; every certificate re-checked twice from outside.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "methods/orbit/return_check.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/orbit_check.hpp"
#include "tests/support/population.hpp"

namespace signorini::exact_orbit_population_test {
namespace {

constexpr double kResidual = 1e-11;
constexpr double kWanted = 0.98;

void expect_population(const std::string& name, const std::vector<Problem>& scenes) {
  int certified = 0, index = 0, chatters = 0, unstable = 0, lasting = 0;
  double worst_return = 0.0;
  for (const Problem& problem : scenes) {
    const int scene = index++;
    SCOPED_TRACE(testing::Message() << name << " scene " << scene);
    const auto found = test::cold_orbit(problem);
    if (!found.orbit) {
      std::printf("%s %d, e = %g, w = %g: %s\n", name.c_str(), scene, std::get<Restitution>(problem.law()).e,
                  problem.frequency, found.solution.message.c_str());
      continue;
    }
    ++certified;
    EXPECT_LE(*found.solution.residual, kResidual);
    const auto check = test::check_orbit(problem, *found.orbit, 1e-8);
    EXPECT_TRUE(check.ok) << check.reason << "; " << found.solution.message;
    EXPECT_LT(check.return_distance, 1e-10) << found.solution.message;
    const ReturnCheck cvode = cvode_return(ContactDynamics(problem), *found.orbit, [] { return false; });
    EXPECT_LE(cvode.distance, cvode.allowed) << found.solution.message;
    worst_return = std::max(worst_return, cvode.distance / cvode.allowed);
    chatters += found.solution.message.find("complete chattering") != std::string::npos ? 1 : 0;
    unstable += found.orbit->quality().multipliers.cwiseAbs().maxCoeff() > 1.0 ? 1 : 0;
    for (const SequenceEvent& event : found.orbit->orbit().events) {
      if (event.kind != ContactEvent::Kind::close) continue;
      ++lasting;
      break;
    }
  }
  std::printf(
      "%s: %d of %zu certified; %d chatter, %d with lasting contact, %d unstable; CVODE returns within %.2f "
      "of what is allowed\n",
      name.c_str(), certified, scenes.size(), chatters, lasting, unstable, worst_return);
  testing::Test::RecordProperty("certified_" + name, certified);
  EXPECT_GE(certified, kWanted * static_cast<double>(scenes.size()));
}

TEST(ExactOrbitPopulation, CertifiesOneMassScenesOfEveryRestitution) {
  expect_population("one-mass", test::restitution_population(500));
}

TEST(ExactOrbitPopulation, CertifiesChainsOfTwoToFiveMasses) {
  expect_population("chains", test::chain_population(200));
}

}  // namespace
}  // namespace signorini::exact_orbit_population_test
