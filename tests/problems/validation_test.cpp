#include "problems/validation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "problems/sparse_cholesky.hpp"
#include "tests/problems/chain_problems.hpp"

namespace signorini::validation_test {
namespace {

using test::chain_problem;
using test::massless_tip;
using test::three_masses;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// A change of the matrices alone.
std::function<void(Problem&)> to_structure(const std::function<void(Structure&)>& edit) {
  return [edit](Problem& problem) { problem.edit_structure(edit); };
}

// What validate() says, "" if nothing.
std::string complaint(const Problem& problem) {
  try {
    validate(problem);
    return "";
  } catch (const InvalidProblem& error) {
    return error.what();
  }
}

std::string complaint_after(const std::function<void(Problem&)>& spoil, Problem problem = three_masses()) {
  spoil(problem);
  return complaint(problem);
}

TEST(Validate, AcceptsEveryKindOfLaw) {
  EXPECT_EQ(complaint(three_masses()), "");
  EXPECT_EQ(complaint(massless_tip()), "");
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Penalty{{1e4}}); }), "");
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Penalty{{1e4}}); }, massless_tip()), "");
  EXPECT_EQ(complaint_after([](Problem& p) { p.contacts.clear(), p.set_law({}); }), "");
  EXPECT_EQ(complaint_after([](Problem& p) { p.contacts.front().gap = -0.5; }), "");
  EXPECT_EQ(complaint_after([](Problem& p) { p.force.clear(); }), "") << "no load is a load";
}

TEST(Validate, AcceptsARigidBodyModeAndSkewParts) {
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.stiffness = SparseMatrix(3, 3); })), "");
  EXPECT_EQ(complaint_after(to_structure(
                [](Structure& s) { s.damping.coeffRef(0, 1) = 7.0, s.damping.coeffRef(1, 0) = -7.0; })),
            "")
      << "gyroscopic";
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) {
              s.stiffness.coeffRef(0, 1) += 70.0, s.stiffness.coeffRef(1, 0) -= 70.0;
            })),
            "")
      << "circulatory";
}

TEST(Validate, AcceptsAHundredThousandCoordinates) {
  const std::vector<double> ones(100000, 1.0);
  Problem problem = chain_problem({.masses = ones, .dampers = ones, .springs = ones});
  problem.contacts = {{.normal = {{99999, 1.0}}, .gap = 0.1}};
  problem.set_law(Restitution{1.0});
  EXPECT_EQ(complaint(problem), "");
}

TEST(Validate, RefusesMatricesThatDoNotFit) {
  EXPECT_EQ(complaint(Problem{}), "system.mass = 0 x 0 matrix (must have at least one coordinate)");
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.stiffness = SparseMatrix(2, 2); })),
            "system.stiffness = 2 x 2 matrix (must be 3 x 3)");
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.damping = SparseMatrix(3, 4); })),
            "system.damping = 3 x 4 matrix (must be 3 x 3)");
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.mass.coeffRef(1, 1) = kNaN; })),
            "system.mass = nan (must be a finite number)");
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.damping.coeffRef(0, 1) = INFINITY; })),
            "system.damping = inf (must be a finite number)");
}

TEST(Validate, RefusesMatricesOfNoStructure) {
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.mass = SparseMatrix(3, 3); })),
            "system.mass = 0 (some coordinate must carry mass)");
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.mass.coeffRef(0, 1) = 1e-3; })),
            "system.mass = unsymmetric matrix (must be symmetric to 1e-12 of its largest entry)");
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.stiffness.coeffRef(1, 0) += 200.0; })),
            "system.stiffness = indefinite matrix (its symmetric part must be positive semi-definite)");
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.stiffness.coeffRef(2, 2) = 10.0; })),
            "system.stiffness = indefinite matrix (must be positive semi-definite)");
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.mass.coeffRef(1, 1) = -2.0; })),
            "system.mass = indefinite matrix (must be positive semi-definite)");
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.damping.coeffRef(0, 0) = -0.1; })),
            "system.damping = matrix that feeds energy (its symmetric part must be positive semi-definite)");
  EXPECT_EQ(
      complaint(chain_problem({.masses = {1.0, 0.0}, .dampers = {0.1, 0.0}, .springs = {1.0, 0.0}})),
      "system = structure with a loose coordinate (every motion must meet a mass, a damper or a spring)");
}

// A trusted matrix is not factorised; everything else about it is checked.
TEST(Validate, TakesForGrantedWhatHoldsByConstructionAndNoMore) {
  const auto trusted = [](const std::function<void(Problem&)>& change) {
    Problem problem = three_masses();
    change(problem);
    validate(problem, Definiteness::by_construction);
  };
  EXPECT_NO_THROW(trusted(to_structure([](Structure& s) { s.stiffness.coeffRef(2, 2) = 10.0; })));
  EXPECT_THROW(trusted(to_structure([](Structure& s) { s.mass.coeffRef(1, 0) += 1e-9; })), InvalidProblem);
  EXPECT_THROW(trusted(to_structure([](Structure& s) { s.stiffness.coeffRef(0, 0) = kNaN; })),
               InvalidProblem);
  EXPECT_THROW(trusted(to_structure([](Structure& s) { s.damping.coeffRef(0, 0) = -0.1; })), InvalidProblem);
  EXPECT_THROW(trusted([](Problem& p) { p.frequency = 0.0; }), InvalidProblem);
  EXPECT_THROW(validate(chain_problem({.masses = {1.0, 0.0}, .dampers = {0.1, 0.0}, .springs = {1.0, 0.0}}),
                        Definiteness::by_construction),
               InvalidProblem)
      << "a coordinate that nothing holds";
}

// Springs of 1 N/m to the ground, and springs of -0.3 N/m between eight random pairs for each mass: some
// motion releases energy. Random pairs leave nothing of the pattern sparse: of 12,000 masses the factor takes
// minutes.
Problem randomly_coupled(int size) {
  std::mt19937_64 random(5);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) {
    entries.emplace_back(i, i, 1.0);
    for (int k = 0; k < 8; ++k) {
      const int j = static_cast<int>(random() % static_cast<unsigned>(size));
      if (i == j) continue;
      entries.emplace_back(i, j, -0.3);
      entries.emplace_back(j, i, -0.3);
    }
  }
  Problem problem = three_masses();
  problem.edit_structure([&](Structure& s) {
    s.mass.resize(size, size);
    s.mass.setIdentity();
    s.damping.resize(size, size);
    s.stiffness.resize(size, size);
    s.stiffness.setFromTriplets(entries.begin(), entries.end());
  });
  return problem;
}

TEST(Validate, LeavesDefinitenessToTheSolveWhereAFactorWouldTakeMinutes) {
  EXPECT_THROW(validate(randomly_coupled(400)), InvalidProblem);
  const Problem large = randomly_coupled(12000);
  EXPECT_GT(SparseCholesky::cost_of(large.stiffness()).operations, 5e10);
  EXPECT_NO_THROW(validate(large));
}

TEST(Validate, RefusesForcingOutOfRange) {
  const auto frequency = [](double value) {
    return complaint_after([=](Problem& p) { p.frequency = value; });
  };
  EXPECT_EQ(frequency(0.0), "forcing.frequency = 0 (must be a positive number [rad/s])");
  EXPECT_EQ(frequency(-1.0), "forcing.frequency = -1 (must be a positive number [rad/s])");
  EXPECT_EQ(frequency(kNaN), "forcing.frequency = nan (must be a positive number [rad/s])");
  EXPECT_EQ(frequency(1e-320),
            "forcing.frequency = 9.99989e-321 (must be between 1e-20 and 1e+20 [rad/s]: choose other units)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.subharmonic = 0; }),
            "forcing.subharmonic = 0 (must be a whole number, 1..64)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.subharmonic = 65; }),
            "forcing.subharmonic = 65 (must be a whole number, 1..64)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.force[0].dof = 3; }),
            "forcing.term[0].dof = 3 (must be a coordinate of the system, 0..2)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.force[0].harmonic = -1; }),
            "forcing.term[0].harmonic = -1 (must be a whole number, 0..10000)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.force[0].cos = kNaN; }),
            "forcing.term[0].cos = nan (must be a finite number)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.force[0].harmonic = 0; }),
            "forcing.term[0].sin = 0.5 (must be 0 or absent: at harmonic 0 a sine is nothing)");
}

TEST(Validate, RefusesContactsWithoutDirection) {
  const auto normal = [](const std::vector<std::pair<int, double>>& value) {
    return complaint_after([&](Problem& p) { p.contacts[0].normal = value; });
  };
  EXPECT_EQ(normal({}), "contact[0].normal = [] (needs a nonzero coefficient)");
  EXPECT_EQ(normal({{0, 0.0}, {1, 0.0}}), "contact[0].normal = zero vector (needs a nonzero coefficient)");
  EXPECT_EQ(normal({{0, 1.0}, {3, 1.0}}),
            "contact[0].normal[1][0] = 3 (must be a coordinate of the system, 0..2)");
  EXPECT_EQ(normal({{-1, 1.0}}), "contact[0].normal[0][0] = -1 (must be a coordinate of the system, 0..2)");
  EXPECT_EQ(normal({{1, 1.0}, {1, 2.0}}), "contact[0].normal[1][0] = 1 (must name each coordinate once)");
  EXPECT_EQ(normal({{1, kNaN}}), "contact[0].normal[0][1] = nan (must be a finite number)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.contacts[0].gap = INFINITY; }),
            "contact[0].gap = inf (must be a finite number)");
}

TEST(Validate, WantsAnImpactLawExactlyWhereAContactCarriesMass) {
  const std::string missing =
      "contact[0].restitution = missing (required, in 0..1, unless a penalty is given: the contact "
      "coordinates "
      "carry mass)";
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law({}); }), missing);
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Massless{}); }), missing);
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Restitution{1.1}); }),
            "contact[0].restitution = 1.1 (must be in 0..1)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Restitution{-0.1}); }),
            "contact[0].restitution = -0.1 (must be in 0..1)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Restitution{kNaN}); }),
            "contact[0].restitution = nan (must be in 0..1)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Restitution{0.5}); }, massless_tip()),
            "contact[0].restitution = 0.5 (must be absent: no contact coordinate carries mass)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law({}); }, massless_tip()), "");
}

TEST(Validate, WantsOfEachContactTheLawThatItNeeds) {
  const auto add_massive = [](ContactLaw law) {
    return [law](Problem& p) { p.contacts.push_back({.normal = {{0, 1.0}}, .gap = 0.1, .law = law}); };
  };
  EXPECT_EQ(complaint_after(add_massive(Restitution{0.5}), massless_tip()), "");
  EXPECT_EQ(complaint_after(add_massive(Spring{100.0}), massless_tip()), "");
  EXPECT_EQ(complaint_after(add_massive(Massless{}), massless_tip()),
            "contact[1].restitution = missing (required, in 0..1, unless a penalty is given: the contact "
            "coordinates carry mass)");
  EXPECT_EQ(complaint_after(
                [&](Problem& p) {
                  add_massive({})(p);
                  p.set_law(Restitution{1.0});
                },
                massless_tip()),
            "contact[0] = massless (needs massless = true beside contacts that carry mass: no restitution is "
            "for it)");
  EXPECT_EQ(
      complaint_after(
          [](Problem& p) {
            p.contacts[0].normal = {{0, 1.0}, {2, -1.0}};
            p.set_law(Restitution{1.0});
          },
          massless_tip()),
      "contact[0].normal = partly massless (under a restitution law every coordinate of a normal must carry "
      "mass)");
}

TEST(Validate, WantsPositivePenalties) {
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Penalty{{0.0}}); }),
            "contact[0].penalty = 0 (must be a positive number [N/m])");
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Penalty{{INFINITY}}); }),
            "contact[0].penalty = inf (must be a positive number [N/m])");
}

TEST(Validate, RefusesMagnitudesWhoseSquaresLeaveTheRangeOfDoubles) {
  const std::string bounds = "(must be 0 or between 1e-60 and 1e+60: choose other units)";
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.mass *= 1e-200; })),
            "system.mass = 4e-200 " + bounds);
  EXPECT_EQ(complaint_after(to_structure([](Structure& s) { s.stiffness *= 1e100; })).substr(0, 19),
            "system.stiffness = ");
  EXPECT_EQ(complaint_after([](Problem& p) { p.force[0].cos = 1e-200; }),
            "forcing.term[0].cos = 1e-200 " + bounds);
  EXPECT_EQ(complaint_after([](Problem& p) { p.contacts[0].gap = -1e61; }),
            "contact[0].gap = -1e+61 (must be at most 1e+60)");
  EXPECT_EQ(complaint_after([](Problem& p) { p.set_law(Penalty{{5e-324}}); }),
            "contact[0].penalty = 4.94066e-324 " + bounds);
  EXPECT_EQ(complaint_after([](Problem& p) { p.contacts[0].gap = 1e-300; }), "");
}

std::string complaint_with_stops(const std::vector<Contact>& stops) {
  return complaint_after([&](Problem& p) {
    p.contacts = stops;
    p.set_law(Restitution{0.5});
  });
}

TEST(Validate, RefusesRigidStopsThatLeaveNoRoom) {
  EXPECT_EQ(
      complaint_with_stops({{.normal = {{0, 1.0}}, .gap = -0.1}, {.normal = {{0, -1.0}}, .gap = -0.1}}),
      "contact[1].gap = -0.1 (must leave room: contact 0 holds its coordinate at -0.1 or less, contact 1 at "
      "0.1 or more)");
  // Along a combination of coordinates, in another order and scale; and stops that meet.
  EXPECT_NE(complaint_with_stops({{.normal = {{0, 0.3}, {1, -0.6}}, .gap = 0.3},
                                  {.normal = {{2, 1.0}}, .gap = 0.0},
                                  {.normal = {{1, 2.0}, {0, -1.0}}, .gap = -1.1}}),
            "");
  EXPECT_NE(complaint_with_stops({{.normal = {{0, 1.0}}, .gap = 0.0}, {.normal = {{0, -1.0}}, .gap = 0.0}}),
            "");
  // Along different lines: u_0 <= -0.2, u_1 <= 0.1 and -u_0 - u_1 <= 0.05.
  EXPECT_EQ(complaint_with_stops({{.normal = {{0, 1.0}}, .gap = -0.2},
                                  {.normal = {{1, 1.0}}, .gap = 0.1},
                                  {.normal = {{0, -1.0}, {1, -1.0}}, .gap = 0.05}}),
            "contact[2].gap = 0.05 (must leave room: contacts 0, 1 and 2 exclude each other)");
  EXPECT_EQ(complaint_with_stops({{.normal = {{0, 1.0}}, .gap = 0.1}, {.normal = {{0, -1.0}}, .gap = -0.09}}),
            "");
  EXPECT_EQ(complaint_with_stops({{.normal = {{0, 1.0}}, .gap = 0.1}, {.normal = {{0, 1.0}}, .gap = 0.1}}),
            "");
  EXPECT_EQ(complaint_after([](Problem& p) {
              p.contacts = {{.normal = {{0, 1.0}}, .gap = -0.1}, {.normal = {{0, -1.0}}, .gap = -0.1}};
              p.set_law(Penalty{{100.0, 100.0}});  // springs, both compressed
            }),
            "");
}

}  // namespace
}  // namespace signorini::validation_test
