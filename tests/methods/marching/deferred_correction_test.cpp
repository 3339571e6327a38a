#include "methods/marching/deferred_correction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/structure_scenes.hpp"

namespace signorini::deferred_correction_test {
namespace {

constexpr int kSamples = 1024;
constexpr double kRounding = 1e-9;  // ten times what a march is solved to, of max |x|

/// A scene's whole structure as its contacts see it on the grid, and its motion there.
struct Truth {
  Problem problem;
  MarchGrid grid;
  ContactReceptance receptance;
  Eigen::MatrixXd motion;
};

/// With so many vectors that no more make a difference.
Truth truth_of(const Problem& problem, const ReductionSettings& whole) {
  const ContactReduction reduction = reduce_to_contacts(problem, whole);
  Truth truth{problem, march_grid(problem, kSamples), {}, {}};
  truth.receptance = contact_receptance(reduction, problem.period(), kSamples / 2, [&](int n) {
    return scheme_weights(HatScheme::bdf2, 2.0 * std::numbers::pi * n / kSamples,
                          problem.period() / kSamples);
  });
  ContactMarch march(reduction, truth.grid);
  truth.motion = march_to_periodic_motion(march, {.tolerance = 1e-12}).motion;
  return truth;
}

CorrectedMarch corrected(const Truth& truth, const ReductionSettings& settings, int corrections) {
  const ContactReduction reduction = reduce_to_contacts(truth.problem, settings);
  ContactMarch march(reduction, truth.grid);
  return march_with_corrections(
      march, truth.grid, truth.receptance,
      {.march = {.tolerance = 1e-11}, .corrections = corrections, .tolerance = 1e-11});
}

double error_of(const CorrectedMarch& answer, const Truth& truth) {
  return (answer.answer.motion - truth.motion).cwiseAbs().maxCoeff() / truth.motion.cwiseAbs().maxCoeff();
}

// Rows of the table in docs/decisions/0040, twice what was measured.
TEST(MarchWithCorrections, ConvergesToTheWholeStructure) {
  const Truth nine = truth_of(test::padded_block_problem({}), {ReductionBasis::krylov, 300});
  const std::vector<double> most{2e-4, 3e-5, 8e-6, 2e-6, 5e-7};
  for (int corrections = 1; corrections <= 5; ++corrections) {
    const CorrectedMarch answer = corrected(nine, {ReductionBasis::modes, 48}, corrections);
    EXPECT_LE(error_of(answer, nine), most[static_cast<std::size_t>(corrections - 1)]);
    EXPECT_EQ(answer.defects.size(), static_cast<std::size_t>(corrections + 1));
  }
  const CorrectedMarch krylov = corrected(nine, {ReductionBasis::krylov, 40}, 3);
  EXPECT_LE(error_of(krylov, nine), 1e-8);
  EXPECT_TRUE(krylov.bar);
}

// What the answer is: the whole structure's response to its own forces, against stops moved by the defect.
TEST(MarchWithCorrections, StatesTheBackwardErrorOfItsForces) {
  const Truth nine = truth_of(test::padded_block_problem({}), {ReductionBasis::krylov, 300});
  const CorrectedMarch answer = corrected(nine, {ReductionBasis::modes, 24}, 2);
  const Eigen::MatrixXd x = nodal_response(nine.receptance, answer.answer.force);
  const double defect =
      (x - answer.answer.motion).cwiseAbs().maxCoeff() / answer.answer.motion.cwiseAbs().maxCoeff();
  EXPECT_NEAR(answer.defects.back(), defect, 1e-15);
  EXPECT_LE(answer.answer.force.maxCoeff(), 0.0);
}

struct BarCase {
  const char* name;
  Problem problem;
  ReductionSettings whole;
  ReductionBasis basis;
  std::vector<int> vectors;
};
void PrintTo(const BarCase& scene, std::ostream* out) { *out << scene.name; }

class ErrorBars : public testing::TestWithParam<BarCase> {};

// Wherever a bar is given it holds, and it is not a hundred times too long.
TEST_P(ErrorBars, HoldWhereTheyAreGiven) {
  const Truth truth = truth_of(GetParam().problem, GetParam().whole);
  int given = 0;
  for (const int vectors : GetParam().vectors) {
    for (const int corrections : {1, 2, 4}) {
      const CorrectedMarch answer = corrected(truth, {GetParam().basis, vectors}, corrections);
      EXPECT_EQ(answer.bar.has_value(), answer.refusal.empty());
      if (!answer.bar) continue;
      ++given;
      const double error = error_of(answer, truth);
      EXPECT_LE(error, *answer.bar) << vectors << " vectors, " << corrections << " corrections";
      EXPECT_GE(error + kRounding, 0.01 * *answer.bar) << vectors << " vectors, " << corrections;
    }
  }
  EXPECT_GE(given, 2);
}

Problem corner() {
  test::PaddedBlock block;
  block.patch = {{{2.0, 2.0}, {0.2, 0.2}}};
  return test::padded_block_problem(block);
}

Problem undamped_waves() {
  test::PaddedBlock block;
  block.damping = {.alpha = 0.05};
  return test::padded_block_problem(block);
}

constexpr ProportionalDamping kStiff{.alpha = 0.2, .beta = 0.005};

INSTANTIATE_TEST_SUITE_P(Scenes, ErrorBars,
                         testing::Values(BarCase{"bar",
                                                 test::massless_bar(kStiff),
                                                 {ReductionBasis::modes, 400},
                                                 ReductionBasis::modes,
                                                 {4, 8, 16, 32}},
                                         BarCase{"bar, waves",
                                                 test::massless_bar({.alpha = 0.3}),
                                                 {ReductionBasis::modes, 400},
                                                 ReductionBasis::modes,
                                                 {16, 32, 64}},
                                         BarCase{"beam",
                                                 test::massless_beam(kStiff, 1),
                                                 {ReductionBasis::krylov, 200},
                                                 ReductionBasis::modes,
                                                 {4, 8, 16}},
                                         BarCase{"corner of a block",
                                                 corner(),
                                                 {ReductionBasis::krylov, 160},
                                                 ReductionBasis::modes,
                                                 {4, 8, 16, 32}},
                                         BarCase{"nine contacts",
                                                 test::padded_block_problem({}),
                                                 {ReductionBasis::krylov, 300},
                                                 ReductionBasis::modes,
                                                 {6, 12, 24, 48}},
                                         BarCase{"nine contacts, Krylov",
                                                 test::padded_block_problem({}),
                                                 {ReductionBasis::krylov, 300},
                                                 ReductionBasis::krylov,
                                                 {10, 20, 30, 40}},
                                         BarCase{"nine contacts, waves",
                                                 undamped_waves(),
                                                 {ReductionBasis::krylov, 300},
                                                 ReductionBasis::modes,
                                                 {6, 12, 24, 48}}));

// Four vectors of this beam miss a contact: linear theory would promise a sixth of the true error.
TEST(MarchWithCorrections, RefusesABarWhereContactsAreMissing) {
  const Truth beam = truth_of(test::massless_beam(kStiff, 1), {ReductionBasis::krylov, 200});
  const CorrectedMarch answer = corrected(beam, {ReductionBasis::modes, 4}, 1);
  EXPECT_FALSE(answer.bar);
  EXPECT_EQ(answer.refusal, "the last correction did not do what linear theory says");
}

TEST(MarchWithCorrections, RefusesABarWhereCorrectionsDiverge) {
  const Truth bar = truth_of(test::massless_bar(kStiff), {ReductionBasis::modes, 400});
  const CorrectedMarch answer = corrected(bar, {ReductionBasis::modes, 8}, 4);
  EXPECT_FALSE(answer.bar);
  EXPECT_EQ(answer.refusal, "the corrections do not converge: more vectors are needed");
}

TEST(MarchWithCorrections, NeedsNoneWithAllVectors) {
  const Truth bar = truth_of(test::massless_bar(kStiff, 40), {ReductionBasis::modes, 40});
  const ContactReduction reduction = reduce_to_contacts(bar.problem, {.vectors = 40});
  ContactMarch march(reduction, bar.grid);
  const CorrectedMarch answer = march_with_corrections(march, bar.grid, bar.receptance);
  EXPECT_EQ(answer.defects.size(), 1U);
  ASSERT_TRUE(answer.bar);
  EXPECT_LE(*answer.bar, 1e-8);
}

}  // namespace
}  // namespace signorini::deferred_correction_test
