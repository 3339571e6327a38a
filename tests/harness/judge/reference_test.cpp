#include "harness/judge/reference.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/records/record_json.hpp"
#include "tests/harness/judge/fake_orbits.hpp"

namespace signorini::reference_test {
namespace {

TEST(ComputeReference, SaysWhyThereIsNone) {
  const Reference reference = compute_reference(test::one_mass(), test::fails("chaos"), Deadline::max());
  EXPECT_EQ(reference.orbit, nullptr);
  EXPECT_EQ(reference.reason, "chaos");
  EXPECT_EQ(compute_reference(test::one_mass(), test::finds(1.0, 1.1), Deadline::max()).orbit, nullptr);
}

TEST(ReferenceJson, ComesBackAsItWent) {
  const Reference reference =
      compute_reference(test::one_mass(), test::finds(1.0, 1.0 + 1e-12), Deadline::max());
  const Reference back = reference_from_json(nlohmann::ordered_json::parse(to_json(reference).dump()));
  EXPECT_EQ(back.orbit->data().samples.x, reference.orbit->data().samples.x);
  EXPECT_EQ(back.error_bar, reference.error_bar);
  EXPECT_EQ(back.fingerprint, reference.fingerprint);
  Reference none;
  none.reason = "chaos";
  EXPECT_EQ(reference_from_json(to_json(none)).reason, "chaos");
  EXPECT_THROW(reference_from_json(nlohmann::ordered_json::object()), BadRecord);
}

TEST(UnderLaw, ReplacesTheLawUnlessItIsUndetermined) {
  const Problem problem = test::one_mass(1.0, 0.5);
  EXPECT_EQ(std::get<Restitution>(under_law(problem, Restitution{1.0}).law()).e, 1.0);
  EXPECT_EQ(std::get<Restitution>(under_law(problem, Undetermined{}).law()).e, 0.5);
  EXPECT_TRUE(std::holds_alternative<Penalty>(under_law(problem, Penalty{{3.0}}).law()));
}

TEST(ComputeReference, IsNoneWhereMarchingStoppedAwayFromTheExactOrbit) {
  const Reference settled = compute_reference(
      test::one_mass(), {test::free_orbits(), test::polishes_to(1.0, 1e-13)}, Deadline::max());
  EXPECT_NE(settled.orbit, nullptr);
  EXPECT_EQ(settled.error_bar, 1e-13);
  const Reference early = compute_reference(
      test::one_mass(), {test::free_orbits(), test::polishes_to(1.001, 1e-13)}, Deadline::max());
  EXPECT_EQ(early.orbit, nullptr);
  EXPECT_NE(early.reason.find("has not settled"), std::string::npos) << early.reason;
}

}  // namespace
}  // namespace signorini::reference_test
