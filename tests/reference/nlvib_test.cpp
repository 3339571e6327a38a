// Harmonic balance against NLvib 1.3 at its own harmonics and samples: the same equations, solved by others.

#include <gtest/gtest.h>

#include <algorithm>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/validation.hpp"
#include "tests/reference/reference_data.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::nlvib_test {
namespace {

using test::ReferenceMotion;
using test::solve;

// The coefficients are kept with 11 digits; near folds the beam amplifies rounding some hundredfold.
constexpr double kSameOrbit = 1e-8;

PenaltyHbm::Options penalty_options(const ReferenceMotion& row, ComplementaritySolver solver) {
  return {.common = {.harmonics = row.harmonics(), .samples = row.samples, .quadrature = Quadrature::sampled},
          .solver = solver};
}

// Newton alone, so that a warm start stays on the branch it was given.
AftHbm::Options aft_options(const ReferenceMotion& row) {
  return {.common = {.harmonics = row.harmonics(), .samples = row.samples, .quadrature = Quadrature::sampled},
          .law = AftHbm::ContactLaw::penalty,
          .homotopy = false};
}

double distance(const Solution& solution, const ReferenceMotion& row) {
  if (solution.verdict != Verdict::converged) return 1e300;
  return test::relative_l2(test::coefficients_of(solution), row.x, row.harmonics());
}

void expect_same_orbit(const Problem& problem, const ReferenceMotion& row) {
  const auto guess = test::start_from(row, problem);
  if (row.stiffness > 1e5) {
    // 11 digits of x leave the active set of so stiff a stop open; pivoting closes it, Newton need not.
    const Solution pivoted =
        solve<PenaltyHbm>(problem, penalty_options(row, ComplementaritySolver::automatic), guess);
    EXPECT_LE(distance(pivoted, row), kSameOrbit) << pivoted.message;
    return;
  }
  const Solution newton =
      solve<PenaltyHbm>(problem, penalty_options(row, ComplementaritySolver::newton), guess);
  EXPECT_LE(distance(newton, row), kSameOrbit) << newton.message;
  const Solution aft = solve<AftHbm>(problem, aft_options(row), guess);
  EXPECT_LE(distance(aft, row), kSameOrbit) << aft.message;
}

// How many rows a cold start of pivoting ends on; every cold start must converge to something.
int cold_hits(const Problem& problem, const ReferenceMotion& row) {
  const Solution cold = solve<PenaltyHbm>(problem, penalty_options(row, ComplementaritySolver::automatic));
  EXPECT_EQ(cold.verdict, Verdict::converged) << cold.message;
  return distance(cold, row) <= kSameOrbit ? 1 : 0;
}

TEST(NlvibOscillator, EveryRowIsASolutionOfPenaltyHbmAndAftHbm) {
  const auto rows = test::load_oscillator_motions("nlvib_sdof.json");
  ASSERT_EQ(rows.size(), 61U);
  for (const ReferenceMotion& row : rows) {
    SCOPED_TRACE(testing::Message() << "stiffness " << row.stiffness << ", omega " << row.omega << ", H "
                                    << row.harmonics());
    expect_same_orbit(test::reference_oscillator(row.omega, Penalty{{row.stiffness}}), row);
  }
}

TEST(NlvibOscillator, AColdStartFindsTheSameOrbitOnMostRows) {
  int hits = 0;
  for (const ReferenceMotion& row : test::load_oscillator_motions("nlvib_sdof.json")) {
    SCOPED_TRACE(testing::Message() << "stiffness " << row.stiffness << ", omega " << row.omega << ", H "
                                    << row.harmonics());
    hits += cold_hits(test::reference_oscillator(row.omega, Penalty{{row.stiffness}}), row);
  }
  RecordProperty("same_orbit", hits);
  // Of the others, nine coexist with a contact-free motion and three with another impacting one.
  EXPECT_GE(hits, 49);
}

TEST(NlvibOscillator, TheGapHomotopyOfAftHbmFindsWhatPivotingFinds) {
  for (const ReferenceMotion& row : test::load_oscillator_motions("nlvib_sdof.json")) {
    if (row.harmonics() > 7) continue;
    const Problem problem = test::reference_oscillator(row.omega, Penalty{{row.stiffness}});
    AftHbm::Options options = aft_options(row);
    options.homotopy = true;
    const Solution aft = solve<AftHbm>(problem, options);
    const Solution pivoted =
        solve<PenaltyHbm>(problem, penalty_options(row, ComplementaritySolver::automatic));
    ASSERT_EQ(aft.verdict, Verdict::converged) << aft.message;
    ASSERT_EQ(pivoted.verdict, Verdict::converged) << pivoted.message;
    EXPECT_LE(test::relative_l2(test::coefficients_of(aft), test::coefficients_of(pivoted), row.harmonics()),
              kSameOrbit)
        << "stiffness " << row.stiffness << ", omega " << row.omega;
  }
}

struct Structure {
  const char* name;
  int rows;
  int cold_hits;  // measured: the other rows coexist with a contact-free motion or another impacting one
};

void PrintTo(const Structure& structure, std::ostream* out) { *out << structure.name; }

class NlvibStructure : public testing::TestWithParam<Structure> {};

TEST_P(NlvibStructure, EveryRowIsASolutionOfPenaltyHbmAndAftHbm) {
  test::ReferenceStructure structure = test::load_structure(GetParam().name);
  ASSERT_EQ(structure.nlvib.size(), static_cast<std::size_t>(GetParam().rows));
  for (const ReferenceMotion& row : structure.nlvib) {
    SCOPED_TRACE(testing::Message() << "omega " << row.omega << ", H " << row.harmonics());
    structure.problem.frequency = row.omega;
    ASSERT_NO_THROW(validate(structure.problem));
    expect_same_orbit(structure.problem, row);
  }
}

TEST_P(NlvibStructure, AColdStartFindsTheSameOrbitOnSomeRows) {
  test::ReferenceStructure structure = test::load_structure(GetParam().name);
  int hits = 0;
  for (const ReferenceMotion& row : structure.nlvib) {
    SCOPED_TRACE(testing::Message() << "omega " << row.omega << ", H " << row.harmonics());
    structure.problem.frequency = row.omega;
    hits += cold_hits(structure.problem, row);
  }
  RecordProperty("same_orbit", hits);
  EXPECT_GE(hits, GetParam().cold_hits);
}

INSTANTIATE_TEST_SUITE_P(Nlvib, NlvibStructure,
                         testing::Values(Structure{"nlvib_ex03_2dof", 17, 6}, Structure{"rod_tip", 14, 10},
                                         Structure{"beam_tip", 14, 5}, Structure{"chain10_multi", 14, 13}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace signorini::nlvib_test
