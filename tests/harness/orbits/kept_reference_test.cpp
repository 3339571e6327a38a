// References taken from results/references.

#include <gtest/gtest.h>

#include "harness/files.hpp"
#include "harness/judge/exact_certificate.hpp"
#include "harness/judge/measures/motion.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::kept_reference_test {
namespace {

Scene scene_of(const std::string& name) { return read_scene(find_scene(name)); }

TEST(KeptReference, IsTheMotionThatMarchingReaches) {
  for (const std::string name : {"sdof-stop", "sdof-stick", "sdof-subharmonic"}) {
    const Scene scene = scene_of(name);
    const auto kept = kept_reference(scene, references_folder(), exact_orbits(), Deadline::max());
    ASSERT_TRUE(kept) << name;
    const Reference marched = compute_reference(scene.problem, orbit_tools(), Deadline::max());
    ASSERT_TRUE(marched.orbit) << marched.reason;
    const Motion a = sample_motion(scene.problem, *kept->orbit);
    const Motion b = sample_motion(scene.problem, *marched.orbit);
    EXPECT_EQ(kept->fingerprint, marched.fingerprint) << name;
    EXPECT_LT(distance(a, b, best_shift(a, b)).x_l2.value(), 1e-9) << name;
    ASSERT_EQ(kept->confirmed.size(), 1U);
    EXPECT_LT(kept->confirmed.front().return_distance.value(), 1e-9);
  }
}

TEST(KeptReference, IsOfTheSceneAsItStandsOnly) {
  Scene scene = scene_of("sdof-stop");
  scene.sha256 = "another";
  EXPECT_FALSE(kept_reference(scene, references_folder(), exact_orbits(), Deadline::max()));
}

TEST(KeptReference, IsNoneWhereTheFileIsNotReadable) {
  const auto folder = test::fresh_folder("kept");
  const Scene scene = scene_of("sdof-stop");
  EXPECT_FALSE(kept_reference(scene, folder, exact_orbits(), Deadline::max()));
  write_whole(folder / "sdof-stop.json", "{");
  EXPECT_FALSE(kept_reference(scene, folder, exact_orbits(), Deadline::max()));
}

}  // namespace
}  // namespace signorini::kept_reference_test
