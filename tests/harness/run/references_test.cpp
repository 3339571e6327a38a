#include "harness/run/references.hpp"

#include <gtest/gtest.h>

#include "tests/harness/fake_method.hpp"

namespace signorini::references_test {
namespace {

constexpr Limits kLimits{.memory_mb = 512, .reference_timeout = 5.0};

Applicability method_with(const RepresentedLaw& law) { return {.applies = true, .law = law}; }

/// Finds an orbit under a restitution of 1 only.
Solution elastic_orbits(const Problem& problem, const PeriodicMotionOptions& options, const Start& start) {
  const Law scene_law = problem.law();
  const auto* restitution = std::get_if<Restitution>(&scene_law);
  if (restitution == nullptr || restitution->e != 1.0) return {.message = "not elastic"};
  return test::free_orbits()(problem, options, start);
}

Scene elastic_scene() {
  Scene scene = test::one_mass_scene();
  scene.problem.set_law(Restitution{1.0});
  return scene;
}

TEST(References, AreKeptByLaw) {
  const Scene scene = elastic_scene();
  References references;
  const std::vector methods{method_with(Restitution{1.0}), method_with(Restitution{0.5})};
  references.compute(scene, methods, OrbitTools(elastic_orbits), kLimits);
  EXPECT_NE(references.under(Restitution{1.0}, scene.problem).orbit, nullptr);
  EXPECT_EQ(references.under(Restitution{0.5}, scene.problem).orbit, nullptr);
  EXPECT_EQ(references.under(Restitution{0.5}, scene.problem).reason, "not elastic");
  EXPECT_EQ(references.under(Restitution{0.2}, scene.problem).reason, "not computed");
}

TEST(References, AreThoseOfTheSceneWhereTheLawIsUndetermined) {
  const Scene scene = elastic_scene();
  References references;
  references.compute(scene, std::vector{method_with(Undetermined{})}, OrbitTools(elastic_orbits), kLimits);
  EXPECT_EQ(&references.under(Undetermined{}, scene.problem),
            &references.under(Restitution{1.0}, scene.problem));
  EXPECT_NE(references.under(Undetermined{}, scene.problem).orbit, nullptr);
}

TEST(References, AreNotComputedWhereNoMethodApplies) {
  const Scene scene = elastic_scene();
  References references;
  references.compute(scene, std::vector{Applicability{.reason = "it is Tuesday"}}, OrbitTools(elastic_orbits),
                     kLimits);
  EXPECT_EQ(references.under(Restitution{1.0}, scene.problem).reason, "not computed");
}

TEST(References, SayHowTheirComputationDied) {
  const Scene scene = elastic_scene();
  const OrbitSolver crash = [](const Problem&, const PeriodicMotionOptions&, const Start&) -> Solution {
    std::abort();
  };
  References references;
  references.compute(scene, std::vector{method_with(Restitution{1.0})}, OrbitTools(crash), kLimits);
  const std::string& reason = references.under(Restitution{1.0}, scene.problem).reason;
  EXPECT_NE(reason.find("its computation ended by signal 6"), std::string::npos) << reason;
}

TEST(References, KeepEachConfirmedOrbitOnce) {
  const Scene scene = elastic_scene();
  References references;
  references.compute(scene, std::vector{method_with(Restitution{1.0})}, OrbitTools(elastic_orbits), kLimits);
  const auto confirmed = [&] { return references.under(Restitution{1.0}, scene.problem).confirmed.size(); };
  const std::size_t before = confirmed();
  Record record;
  record.law = Restitution{1.0};
  references.keep_confirmed(scene.problem, record);
  EXPECT_EQ(confirmed(), before) << "CVODE has not followed it";
  record.certificate.return_distance = 1e-12;
  references.keep_confirmed(scene.problem, record);
  references.keep_confirmed(scene.problem, record);
  EXPECT_EQ(confirmed(), before + 1);
  record.certificate.return_distance = 2e-12;
  references.keep_confirmed(scene.problem, record);
  EXPECT_EQ(confirmed(), before + 2);
}

TEST(References, AreForgottenWithTheScene) {
  const Scene scene = elastic_scene();
  References references;
  references.compute(scene, std::vector{method_with(Restitution{1.0})}, OrbitTools(elastic_orbits), kLimits);
  references.clear();
  EXPECT_EQ(references.under(Restitution{1.0}, scene.problem).reason, "not computed");
}

}  // namespace
}  // namespace signorini::references_test
