// Rigid motions that no contact feels: two bodies tied by a contact alone are one body on the relative
// coordinate.

#include "methods/structure/unfelt_motions.hpp"

#include <gtest/gtest.h>

#include <string>

#include "problems/scene/scene_file.hpp"

namespace signorini::unfelt_motions_test {
namespace {

Problem scene(const std::string& rest) { return parse_scene("schema = 1\nname = \"one\"\n" + rest, "one"); }

const std::string kPair =
    R"(system = { kind = "chain", masses = [1.0, 3.0], dampers = [0.0, 0.0], springs = [0.0, 0.0] }
forcing = { frequency = 2.2, term = [{ dof = 0, cos = 1.0 }, { dof = 0, harmonic = 0, cos = 0.3 }, { dof = 1, harmonic = 0, cos = )";

TEST(WithoutUnfeltMotions, LeavesThePairItsRelativeMotion) {
  const auto found = without_unfelt_motions(
      scene(kPair + "-0.3 }] }\ncontact = [{ between = [0, 1], gap = 0.2, restitution = 0.5 }]\n"));
  ASSERT_TRUE(found);
  ASSERT_EQ(found->problem.size(), 1);
  // x = w q, of the reduced mass m1 m2 / (m1 + m2) = 0.75 and the forces by their shares m2 / (m1 + m2), -m1
  // / ...
  const Contact& contact = found->problem.contacts.front();
  ASSERT_EQ(contact.normal.size(), 1U);
  const double w = contact.normal.front().second;
  EXPECT_NEAR(found->problem.mass().coeff(0, 0), 0.75 * w * w, 1e-14);
  double mean = 0.0, load = 0.0;
  for (const ForceTerm& term : found->problem.force) (term.harmonic == 0 ? mean : load) += term.cos;
  EXPECT_NEAR(load, 0.75 * w, 1e-14);
  EXPECT_NEAR(mean, 0.3 * w, 1e-14);
  EXPECT_EQ(contact.gap, 0.2);
  EXPECT_TRUE(found->driven);
  // States: what moves both alike is nothing, what moves the first alone moves x by it.
  EXPECT_NEAR((found->of * Eigen::Vector2d(1.0, 1.0))[0], 0.0, 1e-15);
  EXPECT_NEAR(w * (found->of * Eigen::Vector2d(1.0, 0.0))[0], 1.0, 1e-14);
}

TEST(WithoutUnfeltMotions, KeepsWhatIsHeldDampedFeltOrFliesAway) {
  const std::string between = "contact = [{ between = [0, 1], gap = 0.2, restitution = 0.5 }]\n";
  EXPECT_FALSE(without_unfelt_motions(scene(kPair + "0.1 }] }\n" + between)))
      << "the mean load drives both away";
  EXPECT_FALSE(
      without_unfelt_motions(scene(kPair + "-0.3 }] }\ncontact = [{ dof = 0, gap = 0.2, restitution = 0.5 }, "
                                           "{ between = [0, 1], gap = 0.2, restitution = 0.5 }]\n")))
      << "the first stop feels both";
  std::string damped = kPair + "-0.3 }] }\n" + between;
  damped.replace(damped.find("dampers = [0.0"), 14, "dampers = [0.2");
  EXPECT_FALSE(without_unfelt_motions(scene(damped)));
  std::string held = kPair + "-0.3 }] }\n" + between;
  held.replace(held.find("springs = [0.0"), 14, "springs = [0.2");
  EXPECT_FALSE(without_unfelt_motions(scene(held)));
}

}  // namespace
}  // namespace signorini::unfelt_motions_test
