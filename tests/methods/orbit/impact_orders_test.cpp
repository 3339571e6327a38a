// Multipliers of orbits whose impacts happen at one instant, against differences of an independent flow.

#include "methods/orbit/impact_orders.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <complex>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "methods/orbit/exact_orbit.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "tests/methods/orbit/newton_flow.hpp"
#include "tests/methods/orbit/symmetric_scenes.hpp"

namespace signorini::impact_orders_test {
namespace {

using test::bar;
using test::mirrored_chain;
using test::NewtonFlow;
using test::scene_of;
using test::twins;

// The symmetric motions u = E y of a scene, as a scene for y: its stops are one.
Problem folded(const Problem& whole, const Eigen::MatrixXd& E) {
  const auto fold = [&E](const SparseMatrix& A) {
    return Eigen::MatrixXd(E.transpose() * Eigen::MatrixXd(A) * E);
  };
  Problem problem =
      scene_of(fold(whole.mass()), fold(whole.damping()), fold(whole.stiffness()), whole.frequency);
  for (const ForceTerm& term : whole.force) {
    for (int i = 0; i < E.cols(); ++i) {
      if (E(term.dof, i) != 0.0) problem.force.push_back({.dof = i, .cos = term.cos * E(term.dof, i)});
    }
  }
  Contact contact{.normal = {}, .gap = whole.contacts.front().gap, .law = whole.contacts.front().law};
  for (int i = 0; i < E.cols(); ++i) {
    double along = 0.0;
    for (const auto& [dof, coefficient] : whole.contacts.front().normal) along += coefficient * E(dof, i);
    if (along != 0.0) contact.normal.emplace_back(i, along);
  }
  problem.contacts = {contact};
  return problem;
}

struct SymmetricScene {
  std::string name = {};
  Problem problem = {};
  Eigen::MatrixXd motions = {};  // E
};

ExactOrbit found_from(const Problem& problem, FlowState start) {
  OrbitFinder finder(problem);
  if (start.state.u.size() == 0) start.state = finder.model()->dynamics.at_rest();
  start.closed.assign(static_cast<std::size_t>(problem.contact_count()), false);
  return finder
      .find(OrbitGuess{.start = std::move(start), .events = {}, .origin = "a state"},
            {.followed = 200, .shootings = 25, .expired = [] { return false; }})
      .orbit;
}

// The orbit of y that marching leads to, as one of the whole scene, where it need not be stable.
ExactOrbit symmetric_orbit(const SymmetricScene& scene) {
  const ExactOrbit half = found_from(folded(scene.problem, scene.motions), {});
  if (!half.certified()) return half;
  const FlowState& start = half.trajectory->orbit().start;
  return found_from(scene.problem,
                    {.time = start.time,
                     .state = {.u = scene.motions * start.state.u, .v = scene.motions * start.state.v},
                     .closed = {}});
}

const Eigen::MatrixXd kTogether = Eigen::Vector2d(1.0, 1.0), kHeave = Eigen::Vector2d(1.0, 0.0);

// The derivative of the flow over a period on the side where it strikes in an order, by one-sided differences
// about a state well inside that side; empty where no state tried is.
std::optional<Eigen::MatrixXd> difference(const NewtonFlow& flow, const ExactTrajectory& orbit,
                                          const std::vector<int>& order) {
  constexpr double kInside = 1e-5, kStep = 1e-7;
  const FlowState& start = orbit.orbit().start;
  Eigen::VectorXd y(2 * start.state.u.size());
  y << start.state.u, start.state.v;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 40; ++trial) {
    Eigen::VectorXd inside = y;
    for (double& value : inside) value += kInside * normal(random);
    std::vector<int> met;
    const Eigen::VectorXd base = flow.period(start.time, inside, &met);
    if (met != order) continue;
    Eigen::MatrixXd P(y.size(), y.size());
    bool kept = true;
    for (Eigen::Index i = 0; i < y.size() && kept; ++i) {
      std::vector<int> ahead, behind;
      const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(y.size(), i);
      P.col(i) =
          (flow.period(start.time, inside + step, &ahead) - flow.period(start.time, inside - step, &behind)) /
          (2.0 * kStep);
      kept = ahead == order && behind == order;
    }
    if (kept) return P;
  }
  return std::nullopt;
}

// The largest distance of an eigenvalue of a matrix from its partner among others.
double apart(const Eigen::MatrixXd& P, Eigen::VectorXcd others) {
  const Eigen::VectorXcd own = P.eigenvalues();
  double largest = 0.0;
  for (const std::complex<double>& mu : own) {
    Eigen::Index nearest = 0;
    largest = std::max(largest, (others.array() - mu).abs().minCoeff(&nearest));
    others[nearest] = 1e9;
  }
  return largest;
}

constexpr double kDifference = 2e-3;  // what curvature over the inside state leaves of eigenvalues

std::vector<int> contacts_of(const ExactTrajectory& orbit) {
  std::vector<int> contacts;
  for (const SequenceEvent& event : orbit.orbit().events) contacts.push_back(event.contact);
  return contacts;
}

TEST(ImpactOrders, OfTwinsThatDoNotFeelEachOtherAreThoseOfEither) {
  const ExactOrbit orbit = symmetric_orbit({.problem = twins({}), .motions = kTogether});
  ASSERT_TRUE(orbit.certified()) << orbit.reason;
  ASSERT_EQ(orbit.trajectory->orbit().events.size(), 2U);
  EXPECT_EQ(orbit.multipliers.undefined, "");
  EXPECT_TRUE(orbit.multipliers.orders.empty());
  ASSERT_EQ(orbit.multipliers.values.size(), 4);
  for (const auto& mu :
       orbit.multipliers.values) {  // the closed form of one impact: trace 0.1426933, det 0.4810008
    EXPECT_NEAR(mu.real(), 0.07134665, 1e-7);
    EXPECT_NEAR(std::norm(mu), 0.4810008, 1e-7);
  }
}

TEST(ImpactOrders, OfTwinsThatFeelEachOtherByDampersExpand) {
  const ExactOrbit orbit =
      symmetric_orbit({.problem = twins({.spring = 0.5, .damper = 0.05}), .motions = kTogether});
  ASSERT_TRUE(orbit.certified()) << orbit.reason;
  EXPECT_EQ(orbit.multipliers.undefined, "");
  ASSERT_EQ(orbit.multipliers.orders.size(), 2U);
  EXPECT_EQ(orbit.multipliers.orders[0].contacts, (std::vector<std::vector<int>>{{0, 1}}));
  EXPECT_EQ(orbit.multipliers.orders[1].contacts, (std::vector<std::vector<int>>{{1, 0}}));
  for (const ImpactOrder& order : orbit.multipliers.orders) EXPECT_NEAR(order.largest, 2.593212, 1e-5);
  EXPECT_NEAR(largest_magnitude(orbit.multipliers.values), 2.593212, 1e-5);
}

TEST(ImpactOrders, AreUndefinedWhereTheMassCouplesThem) {
  const ExactOrbit orbit = symmetric_orbit({.problem = bar(0.4, 0.4, 0.1, 0.8), .motions = kHeave});
  ASSERT_TRUE(orbit.certified()) << orbit.reason;
  EXPECT_EQ(orbit.multipliers.undefined, kDependsOnOrder);
  EXPECT_TRUE(orbit.multipliers.orders.empty());
  EXPECT_EQ(orbit.multipliers.values.size(), 0);
  EXPECT_EQ(orbit.trajectory->impulses().size(), 2U);
}

TEST(ImpactOrders, ExchangeTheEventsThatCloseContacts) {
  const std::vector<SequenceEvent> events{
      {.kind = ContactEvent::Kind::close, .contact = 0, .closed = {true, false, false}},
      {.kind = ContactEvent::Kind::close, .contact = 1, .closed = {true, true, false}},
      {.kind = ContactEvent::Kind::open, .contact = 0, .closed = {false, true, false}}};
  const auto moved = reordered(events, {false, false, false}, {1, 0, 2});
  EXPECT_EQ(moved[0].closed, (std::vector<bool>{false, true, false}));
  EXPECT_EQ(moved[1].closed, (std::vector<bool>{true, true, false}));
  EXPECT_EQ(moved[2].closed, (std::vector<bool>{false, true, false}));
}

// Of three in a row only neighbours feel each other: four of six orders differ. One that feels none drops
// out.
TEST(ImpactOrders, OfThreeAreThoseOfTheContactsThatFeelEachOther) {
  const Eigen::MatrixXd together = Eigen::VectorXd::Ones(3);
  const Problem three = test::row_of_oscillators(3, 0.3, 0.05);
  const ExactOrbit orbit = symmetric_orbit({.problem = three, .motions = together});
  ASSERT_TRUE(orbit.certified()) << orbit.reason;
  ASSERT_EQ(orbit.multipliers.orders.size(), 4U);
  int compared = 0;
  for (const ImpactOrder& order : orbit.multipliers.orders) {
    ASSERT_EQ(order.contacts.size(), 1U);
    const auto P = difference(NewtonFlow(three), *orbit.trajectory, order.contacts[0]);
    if (!P) continue;
    ++compared;
    const double largest = P->eigenvalues().cwiseAbs().maxCoeff();
    EXPECT_NEAR(largest, order.largest, kDifference * (1.0 + largest));
  }
  EXPECT_GE(compared, 3);
  const ExactOrbit two =
      symmetric_orbit({.problem = test::row_of_oscillators(3, 0.3, 0.05, true), .motions = together});
  ASSERT_EQ(two.multipliers.orders.size(), 2U);
  EXPECT_EQ(two.multipliers.orders[0].contacts, (std::vector<std::vector<int>>{{1, 2}}));
}

// What became of the scenes.
struct Tally {
  int defined = 0, unstable_by_order = 0, undefined_by_order = 0, by_mass = 0;
  int compared = 0, no_orbit = 0;
};

bool impacts_alone(const ExactTrajectory& orbit) {
  return std::ranges::all_of(orbit.orbit().events, [](const SequenceEvent& event) {
    return event.kind == ContactEvent::Kind::impact;
  });
}

void compare(const SymmetricScene& scene, Tally& tally) {
  const ExactOrbit orbit = symmetric_orbit(scene);
  if (!orbit.certified() || orbit.trajectory->impulses().empty() || !impacts_alone(*orbit.trajectory)) {
    ++tally.no_orbit;
    return;
  }
  ASSERT_EQ(orbit.trajectory->impulses().size() % 2, 0U) << scene.name;
  const bool coupled = scene.name.find("by mass") != std::string::npos;
  EXPECT_EQ(coupled, !orbit.multipliers.undefined.empty() && orbit.multipliers.orders.empty()) << scene.name;
  if (coupled) {
    ++tally.by_mass;
    return;
  }
  const NewtonFlow flow(scene.problem);
  EXPECT_EQ(orbit.multipliers.orders.empty(), scene.name.find("by dampers") == std::string::npos)
      << scene.name;
  if (orbit.multipliers.orders.empty()) {
    ++tally.defined;
    const auto P = difference(flow, *orbit.trajectory, contacts_of(*orbit.trajectory));
    if (!P) return;
    ++tally.compared;
    EXPECT_LT(apart(*P, orbit.multipliers.values),
              kDifference * (1.0 + largest_magnitude(orbit.multipliers.values)))
        << scene.name;
    return;
  }
  ++(orbit.multipliers.undefined.empty() ? tally.unstable_by_order : tally.undefined_by_order);
  bool expands_as_told = !orbit.multipliers.undefined.empty();
  for (const ImpactOrder& order : orbit.multipliers.orders) {
    std::vector<int> met;
    for (const auto& instant : order.contacts) met.insert(met.end(), instant.begin(), instant.end());
    const auto P = difference(flow, *orbit.trajectory, met);
    if (!P) continue;
    ++tally.compared;
    const double largest = P->eigenvalues().cwiseAbs().maxCoeff();
    EXPECT_NEAR(largest, order.largest, kDifference * (1.0 + largest)) << scene.name;
    expands_as_told |= orbit.multipliers.undefined.empty() &&
                       apart(*P, orbit.multipliers.values) < kDifference * (1.0 + largest);
  }
  EXPECT_TRUE(expands_as_told) << scene.name;
}

// Twins, equal and unequal, bars on two stops and mirrored chains, of e = .5, .8 and 1.
SymmetricScene drawn(int index, std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double e = std::array{0.5, 0.8, 1.0}[static_cast<std::size_t>(index % 3)];
  const double frequency = between(1.9, 2.9), damper = between(0.02, 0.2), spring = between(0.1, 0.8);
  Eigen::MatrixXd mirrored(4, 2);
  mirrored << 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0;
  const double a = between(0.3, 1.2);  // arm
  SymmetricScene scene;
  switch (index % 8) {
    case 0:
      scene = {"springs", twins({.spring = spring, .e = e, .frequency = frequency}), kTogether};
      break;
    case 1:
      scene = {"by dampers", twins({.spring = spring, .damper = damper, .e = e, .frequency = frequency}),
               kTogether};
      break;
    case 2:
      scene = {"unequal, by dampers",
               twins({.spring = spring, .damper = damper, .e = e, .frequency = frequency, .heavier = 3.0}),
               kTogether};
      break;
    case 3:
      scene = {"bar", bar(a * a, a, 0.1 * a * a, e, frequency), kHeave};
      break;
    case 4:
      scene = {"bar, by dampers", bar(a * a, a, (0.1 + damper) * a * a, e, frequency), kHeave};
      break;
    case 5:
      scene = {"bar, by mass", bar(between(1.5, 3.0) * a * a, a, damper, e, frequency), kHeave};
      break;
    case 6:
      scene = {"chain", mirrored_chain(e, frequency, 0.0), mirrored};
      break;
    default:
      scene = {"chain, by dampers", mirrored_chain(e, frequency, damper), mirrored};
  }
  for (Contact& contact : scene.problem.contacts) contact.gap = 0.1;
  scene.name += " " + std::to_string(index);
  return scene;
}

TEST(ImpactOrders, AgreeWithDifferencesOfAnIndependentFlow) {
  constexpr unsigned kSeed = 28112026;
  constexpr int kScenes = 40;
  std::mt19937 random(kSeed);
  Tally tally;
  for (int i = 0; i < kScenes; ++i) compare(drawn(i, random), tally);
  const std::string text = fmt::format(
      "seed {}, {} scenes: {} with multipliers, {} unstable in an order, {} undefined by order, {} by mass, "
      "{} "
      "without such an orbit; {} parts compared",
      kSeed, kScenes, tally.defined, tally.unstable_by_order, tally.undefined_by_order, tally.by_mass,
      tally.no_orbit, tally.compared);
  RecordProperty("tally", text);
  EXPECT_LE(tally.no_orbit, 10) << text;
  EXPECT_GE(tally.compared, 30) << text;
  EXPECT_GE(tally.unstable_by_order, 3) << text;
  EXPECT_GE(tally.undefined_by_order, 3) << text;
}

}  // namespace
}  // namespace signorini::impact_orders_test
