#include "harness/judge/measures/contact_agreement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/harness/fake_method.hpp"

namespace signorini::contact_agreement_test {
namespace {

constexpr double kPeriod = std::numbers::pi;  // of one_mass(): omega = 2

/// size cos 2 t, and impulses that are given by shares of the period and sizes.
Motion motion(const std::vector<std::pair<double, double>>& impulses, int order = 1, double size = 1.0) {
  std::vector<Impulse> list;
  for (const auto& [share, value] : impulses) list.push_back({0, share * order * kPeriod, -value});
  return sample_motion(
      test::one_mass(),
      test::FormulaMotion(
          order * kPeriod, [=](double t) { return size * std::cos(2.0 * t); },
          [=](double t) { return -2.0 * size * std::sin(2.0 * t); }, [](double) { return 0.0; }, list));
}

/// cos 2 t and a push over a share of the period that a series of so many harmonics resolves.
Motion smooth(double begin, double end, double force, int bandwidth) {
  return sample_motion(
      test::one_mass(),
      test::FormulaMotion(
          kPeriod, [](double t) { return std::cos(2.0 * t); },
          [](double t) { return -2.0 * std::sin(2.0 * t); },
          [=](double t) { return t > begin * kPeriod && t < end * kPeriod ? -force : 0.0; }, {}, bandwidth));
}

ContactDifference compared(const Motion& answer, const Motion& orbit) {
  Problem problem = test::one_mass();
  problem.set_law(Massless{});  // these impulses go with no jumps of x'
  return contact_difference(problem, answer, orbit);
}

TEST(ContactDifference, IsNoneOfEqualContacts) {
  EXPECT_EQ(compared(motion({}), motion({})).text, "");
  EXPECT_EQ(compared(motion({{0.2, 1.0}, {0.7, 0.5}}), motion({{0.2, 1.0}, {0.7, 0.5}})).text, "");
}

TEST(ContactDifference, ContradictsWhereOnlyOneOfTheTwoHits) {
  const ContactDifference missed = compared(motion({}), motion({{0.2, 1.0}}));
  EXPECT_TRUE(missed.contradicts);
  EXPECT_EQ(missed.text, "it has no contact force, and the orbit has");
  EXPECT_TRUE(compared(motion({{0.2, 1.0}}), motion({})).contradicts);
}

TEST(ContactDifference, OfAGrazeIsNoContradiction) {
  // The unit is k X T = pi: a graze of 1e-4 of it is more than nothing, and less than a hit.
  const ContactDifference graze = compared(motion({}), motion({{0.2, 1e-4 * kPeriod}}));
  EXPECT_FALSE(graze.contradicts);
  EXPECT_NE(graze.text, "");
  EXPECT_EQ(compared(motion({}), motion({{0.2, 1e-7 * kPeriod}})).text, "") << "round-off";
}

TEST(ContactDifference, AsksForTheForceOfTheOrbit) {
  EXPECT_EQ(compared(motion({{0.2, 1.05}}), motion({{0.2, 1.0}})).text, "");
  EXPECT_EQ(compared(motion({{0.2, 0.8}}), motion({{0.2, 1.0}})).text,
            "the contact force, its instants included, is off by 0.2");
  EXPECT_EQ(compared(motion({{0.2, 0.51}}), motion({{0.2, 1.0}})).text,
            "the force of contact 0 is off by 0.49 of its own");
  EXPECT_NE(compared(motion({{0.24, 1.0}}), motion({{0.2, 1.0}})).text, "") << "late";
  EXPECT_NE(compared(motion({{0.2, 1.0}, {0.7, 0.24}}), motion({{0.2, 1.0}})).text, "") << "a second one";
}

TEST(ContactDifference, AsksForABreakThatTheOrbitHas) {
  const Motion orbit = smooth(0.1, 0.95, 1.0, 400), rests = smooth(-1.0, 2.0, 0.85, 400);
  EXPECT_EQ(compared(rests, orbit).text, "contact 0 opens on the orbit only");
  EXPECT_EQ(compared(orbit, rests).text, "contact 0 opens on it only");
}

/// |sin| with impacts at both ends of a half wave: x' goes from v to -ratio v.
Motion bouncing(double ratio, bool listed = true) {
  const double jump = 1.0 + ratio;
  return sample_motion(
      test::one_mass(0.0, 0.8),
      test::FormulaMotion(
          kPeriod, [=](double t) { return -std::sin(t) * (1.0 - (1.0 - ratio) * (1.0 - t / kPeriod)); },
          [=](double t) {
            return -std::cos(t) * (1.0 - (1.0 - ratio) * (1.0 - t / kPeriod)) -
                   std::sin(t) * (1.0 - ratio) / kPeriod;
          },
          [](double) { return 0.0; },
          listed ? std::vector<Impulse>{{0, 0.0, -jump}} : std::vector<Impulse>{}));
}

TEST(ContactDifference, AsksForTheRestitutionOfTheLaw) {
  const Problem problem = test::one_mass(0.0, 0.8);
  const auto text = [&](double ratio) {
    return contact_difference(problem, bouncing(ratio), bouncing(0.8)).text;
  };
  EXPECT_EQ(text(0.8), "");
  EXPECT_EQ(text(0.85), "");
  EXPECT_EQ(text(0.95), "its impacts have a restitution of 0.95, where the law has 0.8");
  // As in a chatter of a stiff structure, whose samples miss the speeds beside the impacts.
  EXPECT_EQ(contact_difference(problem, bouncing(0.95), bouncing(0.95)).text, "");
}

TEST(ContactDifference, CountsImpactsPerCommonPeriod) {
  const ContactDifference one = compared(motion({{0.2, 1.0}}), motion({{0.2, 0.5}, {0.7, 0.5}}));
  EXPECT_EQ(one.text, "contact 0 pushes 1 times in 1 forcing periods, on the orbit 2 times");
  // Once in each of two forcing periods is once per forcing period.
  EXPECT_EQ(compared(motion({{0.2, 1.0}}), motion({{0.1, 1.0}, {0.6, 1.0}}, 2)).text, "");
  EXPECT_NE(compared(motion({{0.2, 1.0}}), motion({{0.1, 2.0}}, 2)).text, "");
}

TEST(ContactDifference, AsksForNoImpactsThatTheAnswerCannotShow) {
  // Sixteen harmonics show 1/32 of the period.
  const Motion chatter = motion({{0.20, 0.5}, {0.22, 0.3}, {0.235, 0.2}});
  EXPECT_EQ(compared(smooth(0.19, 0.25, 1.0 / (0.06 * kPeriod), 16), chatter).text, "");
  EXPECT_NE(compared(smooth(0.19, 0.25, 1.0 / (0.06 * kPeriod), 400), chatter).text, "");
  // A bounce of a twentieth of the largest impulse may be missed, and one of a half may not.
  EXPECT_EQ(compared(motion({{0.2, 1.0}}), motion({{0.2, 1.0}, {0.7, 0.05}})).text, "");
  EXPECT_NE(compared(motion({{0.2, 1.0}}), motion({{0.2, 1.0}, {0.7, 0.5}})).text, "");
}

TEST(ContactDifference, AsksForImpactsAtTheirTimes) {
  EXPECT_EQ(compared(motion({{0.2, 1.0}}), motion({{0.2004, 1.0}})).text, "");
  EXPECT_EQ(compared(motion({{0.2, 1.0}}), motion({{0.3, 1.0}})).text,
            "contact 0 pushes at other times than on the orbit");
  EXPECT_EQ(compared(motion({{0.9998, 1.0}}), motion({{0.0002, 1.0}})).text, "")
      << "across the end of the period";
  // Once in each of two forcing periods, the second time a quarter of a period late.
  EXPECT_NE(compared(motion({{0.2, 1.0}}), motion({{0.1, 1.0}, {0.725, 1.0}}, 2)).text, "");
  // Both impacts of the answer beside the same one of the orbit.
  EXPECT_NE(compared(motion({{0.2, 1.0}, {0.23, 1.0}}), motion({{0.21, 1.0}, {0.7, 1.0}})).text, "");
}

TEST(ContactDifference, AsksForWeakImpactsAtTheirTimesWhereXIsOff) {
  // Another orbit that strikes again, 0.045 away: within what such an x allows of the force in the mean.
  const Motion orbit = motion({{0.2, 1.0}, {0.5, 0.13}});
  const auto text = [&](double share, double impulse) {
    return compared(motion({{0.2, 1.0}, {share, impulse}}, 1, 0.955), orbit).text;
  };
  EXPECT_EQ(text(0.7, 0.1), "contact 0 has a weak push that is none of the orbit's, or misses one");
  EXPECT_EQ(text(0.56, 0.1), "") << "as late as a slow approach is";
  EXPECT_NE(text(0.5, 0.005), "") << "none";
}

TEST(ContactDifference, JoinsPhasesAcrossTheEndOfThePeriod) {
  EXPECT_EQ(compared(motion({{0.99995, 0.5}, {0.00005, 0.5}}), motion({{0.0, 1.0}})).text, "");
}

}  // namespace
}  // namespace signorini::contact_agreement_test
