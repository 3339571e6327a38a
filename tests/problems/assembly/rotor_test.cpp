#include "problems/assembly/rotor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "problems/scene/scene_file.hpp"

namespace signorini::rotor_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(AssembleRotor, IsTheSameInBothDirections) {
  const Structure rotor = assemble(Rotor{.mass = 2.0, .damping = 0.3, .stiffness = 50.0});
  EXPECT_EQ(Eigen::Matrix2d(rotor.mass), 2.0 * Eigen::Matrix2d::Identity());
  EXPECT_EQ(Eigen::Matrix2d(rotor.damping), 0.3 * Eigen::Matrix2d::Identity());
  EXPECT_EQ(Eigen::Matrix2d(rotor.stiffness), 50.0 * Eigen::Matrix2d::Identity());
}

TEST(RingOfContacts, LooksInAllDirectionsAlike) {
  for (const int facets : {3, 4, 12, 47}) {
    const std::vector<Contact> ring = ring_of_contacts(3, 1, facets, 0.2);
    ASSERT_EQ(ring.size(), static_cast<std::size_t>(facets));
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (int j = 0; j < facets; ++j) {
      const Contact& contact = ring[static_cast<std::size_t>(j)];
      ASSERT_EQ(contact.normal.size(), 2U);
      EXPECT_EQ(contact.normal[0].first, 3);
      EXPECT_EQ(contact.normal[1].first, 1);
      EXPECT_EQ(contact.gap, 0.2);
      const Eigen::Vector2d normal(contact.normal[0].second, contact.normal[1].second);
      EXPECT_NEAR(std::remainder(std::atan2(normal(1), normal(0)) - 2.0 * kPi * j / facets, 2.0 * kPi), 0.0,
                  1e-14);
      sum += normal * normal.transpose();
    }
    EXPECT_LT((sum - facets / 2.0 * Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff(), 1e-13 * facets);
  }
}

TEST(RingOfContacts, HasExactZerosAtRightAngles) {
  const std::vector<Contact> ring = ring_of_contacts(0, 1, 4, 1.0);
  EXPECT_EQ(ring[1].normal[0].second, 0.0);
  EXPECT_EQ(ring[2].normal[1].second, 0.0);
  EXPECT_EQ(ring[3].normal[0].second, 0.0);
}

// The disc may go as far as the polygon: gap at the middle of a facet, gap / cos(pi / F) at a corner.
TEST(RingOfContacts, EnclosesTheCircle) {
  constexpr int kFacets = 12;
  const std::vector<Contact> ring = ring_of_contacts(0, 1, kFacets, 0.5);
  double nearest = INFINITY;
  double farthest = 0.0;
  for (int i = 0; i < 240; ++i) {
    const double angle = 2.0 * kPi * i / 240;
    double most = 0.0;
    for (const Contact& contact : ring) {
      most = std::max(
          most, contact.normal[0].second * std::cos(angle) + contact.normal[1].second * std::sin(angle));
    }
    nearest = std::min(nearest, 0.5 / most);
    farthest = std::max(farthest, 0.5 / most);
  }
  EXPECT_NEAR(nearest, 0.5, 1e-14);
  EXPECT_NEAR(farthest, 0.5 / std::cos(kPi / kFacets), 1e-14);
}

TEST(ParseScene, MakesARingOfContactsFromOneTable) {
  const Problem rotor = parse_scene(R"(
    schema = 1
    name = "rotor"
    [system]
    kind = "rotor"
    mass = 1.0
    damping = 0.1
    stiffness = 1.0
    [forcing]
    frequency = 1.2
    [[forcing.term]]
    dof = 0
    cos = 0.1
    [[forcing.term]]
    dof = 1
    sin = 0.1
    [[contact]]
    normal = [[0, 0.8], [1, 0.6]]
    gap = 1.0
    [[contact]]
    dofs = [0, 1]
    facets = 6
    gap = 0.3
    [law]
    penalty = 20.0
  )",
                                    "rotor.toml");
  EXPECT_EQ(rotor.size(), 2);
  ASSERT_EQ(rotor.contact_count(), 7);
  EXPECT_EQ(rotor.contacts[0].gap, 1.0);
  EXPECT_EQ(rotor.contacts[1].normal, (std::vector<std::pair<int, double>>{{0, 1.0}, {1, 0.0}}));
  EXPECT_EQ(rotor.contacts[6].gap, 0.3);
  EXPECT_EQ(std::get<Penalty>(rotor.law()).stiffness.size(), 7U);
}

}  // namespace
}  // namespace signorini::rotor_test
