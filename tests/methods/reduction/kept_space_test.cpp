#include "methods/reduction/kept_space.hpp"

#include <gtest/gtest.h>

#include "tests/support/structure_scenes.hpp"

namespace signorini::kept_space_test {
namespace {

constexpr ProportionalDamping kStiff{.alpha = 0.2, .beta = 0.005};

Eigen::MatrixXcd some_force() { return Eigen::MatrixXcd::Constant(9, 1, {-0.3, 0.1}); }

/// What two spaces say of the same force at a rate: their reductions, defects and bounds.
void expect_same(const ContactSpace& a, const ContactSpace& b, double base) {
  const Eigen::MatrixXcd force = some_force();
  EXPECT_EQ(contact_response(a.small(), base, force), contact_response(b.small(), base, force));
  EXPECT_EQ(a.missing(base, force), b.missing(base, force));
  EXPECT_EQ(a.bound(base, force), b.bound(base, force));
  EXPECT_EQ(a.motion(base, force).loads, b.motion(base, force).loads);
}

TEST(KeptSpace, IsMadeOnceForAllGapsFrequenciesAndOrders) {
  Problem bar = test::massless_bar(kStiff, 60);
  KeptSpace kept;
  const auto first = kept.of(bar);
  EXPECT_EQ(kept.of(with_subharmonic(bar, 3)), first);
  bar.contacts.front().gap += 0.01;
  EXPECT_EQ(kept.of(bar), first);
  bar.frequency = 1.7;
  const auto faster = kept.of(bar);
  EXPECT_EQ(kept.made(), 1);
  expect_same(*faster, ContactSpace(bar), 1.7);
}

TEST(KeptSpace, FollowsTheLawThereAndBack) {
  const Problem bar = test::massless_bar(kStiff, 60);
  Problem sprung = bar;
  sprung.set_law(Penalty{{50.0}});
  KeptSpace kept;
  expect_same(*kept.of(bar), ContactSpace(bar), 1.2);
  expect_same(*kept.of(sprung), ContactSpace(sprung), 1.2);
  expect_same(*kept.of(bar), ContactSpace(bar), 1.2);
  EXPECT_EQ(kept.made(), 1);
}

TEST(KeptSpace, IsMadeAnewForAnotherStructureContactOrLoad) {
  Problem bar = test::massless_bar(kStiff, 60);
  KeptSpace kept;
  static_cast<void>(kept.of(bar));
  bar.force.front().cos *= 2.0;
  static_cast<void>(kept.of(bar));
  EXPECT_EQ(kept.made(), 2);
  bar.contacts.front().normal.front().second *= -1.0;
  static_cast<void>(kept.of(bar));
  EXPECT_EQ(kept.made(), 3);
  bar.edit_structure([](Structure& s) { s.mass.coeffRef(0, 0) += 1.0; });
  static_cast<void>(kept.of(bar));
  EXPECT_EQ(kept.made(), 4);
}

}  // namespace
}  // namespace signorini::kept_space_test
