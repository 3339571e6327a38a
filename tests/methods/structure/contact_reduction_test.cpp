#include "methods/structure/contact_reduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "methods/structure/bases/massless_elimination.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "tests/support/elastic_block.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::contact_reduction_test {
namespace {

constexpr ProportionalDamping kStiff{.alpha = 0.2, .beta = 0.005};

using test::harmonics_of;

/// |C_n - C_n of the whole structure| / |C_n| at harmonic n, by a factorisation of Z_n.
class ReceptanceError {
 public:
  ReceptanceError(const Problem& problem, std::vector<int> harmonics)
      : problem_(problem), harmonics_(std::move(harmonics)) {
    for (const int n : harmonics_) {
      const auto one = [&](int) { return exact_weights(n * problem.base_frequency()); };
      exact_.push_back(factorised_receptance(problem, 0, one, false).receptance.front());
    }
  }

  [[nodiscard]] std::vector<double> of(const ContactReduction& reduction) const {
    std::vector<double> errors;
    const int most = *std::max_element(harmonics_.begin(), harmonics_.end());
    const ContactReceptance receptance =
        contact_receptance(reduction, problem_.period(), most, harmonics_of(problem_));
    for (std::size_t i = 0; i < exact_.size(); ++i) {
      const auto& C = receptance.receptance[static_cast<std::size_t>(harmonics_[i])];
      errors.push_back((C - exact_[i]).norm() / exact_[i].norm());
    }
    return errors;
  }

 private:
  const Problem& problem_;
  std::vector<int> harmonics_;
  std::vector<Eigen::MatrixXcd> exact_;
};

double least_eigenvalue(const Eigen::MatrixXd& A) { return symmetric_eigenvalues(A)[0]; }

// All vectors: another basis of the same structure. Loads of several harmonics, some on massless coordinates.
TEST(ReduceToContacts, WithAllVectorsIsTheWholeStructure) {
  Problem problem = test::massless_bar(kStiff, 40);
  problem.force = {{39, 0, -0.4, 0.0}, {39, 1, 0.3, 0.2}, {20, 1, 0.5, -0.1}, {5, 3, 0.0, 0.7}};
  const auto weights = harmonics_of(problem);
  const ContactReceptance whole = factorised_receptance(problem, 8, weights, true);
  for (const ReductionBasis basis : {ReductionBasis::krylov, ReductionBasis::modes}) {
    const ContactReduction reduction = reduce_to_contacts(problem, {.basis = basis, .vectors = 40});
    ASSERT_EQ(reduction.obstacle, "");
    EXPECT_TRUE(reduction.complete);
    EXPECT_EQ(reduction.vectors(), 39);
    const ContactReceptance reduced = contact_receptance(reduction, problem.period(), 8, weights);
    for (std::size_t n = 0; n <= 8; ++n) {
      EXPECT_LT((reduced.receptance[n] - whole.receptance[n]).norm(), 1e-11 * whole.receptance[n].norm());
    }
    EXPECT_LT((reduced.free_response - whole.free_response).norm(), 1e-11 * whole.free_response.norm());
  }
}

// Other discretisations of time, whose stiffness has a weight too, and a motion of twice the load's period.
TEST(ReduceToContacts, ServesAnyDiscretisationOfTime) {
  Problem problem = test::massless_bar(kStiff, 40);
  problem.subharmonic = 2;
  const auto weights = [&](int n) {
    return scheme_weights(HatScheme::galerkin, 0.1 * n, problem.period() / 60.0);
  };
  const ContactReduction reduction = reduce_to_contacts(problem);
  const ContactReceptance reduced = contact_receptance(reduction, problem.period(), 6, weights);
  const ContactReceptance whole = factorised_receptance(problem, 6, weights, true);
  for (std::size_t n = 0; n <= 6; ++n)
    EXPECT_LT((reduced.receptance[n] - whole.receptance[n]).norm(), 1e-11 * whole.receptance[n].norm());
  EXPECT_LT((reduced.free_response - whole.free_response).norm(), 1e-11 * whole.free_response.norm());
  EXPECT_EQ(whole.free_response.row(1).norm(), 0.0);
  EXPECT_GT(whole.free_response.row(2).norm(), 0.0);
}

// The residual flexibility makes statics exact however few the vectors: C_0 = W^T K^-1 W.
TEST(ReduceToContacts, KeepsStaticsExactAndItsResidualDefinite) {
  const Problem problem = test::padded_block_problem({});
  const Eigen::MatrixXd massless = eliminate_massless(problem).massless_compliance;
  const ReceptanceError error(problem, {0});
  for (const ReductionBasis basis : {ReductionBasis::krylov, ReductionBasis::modes}) {
    for (const int vectors : {4, 30}) {
      const ContactReduction reduction = reduce_to_contacts(problem, {.basis = basis, .vectors = vectors});
      EXPECT_LT(error.of(reduction).front(), 1e-11);
      EXPECT_GT(least_eigenvalue(reduction.compliance), 0.0);
      EXPECT_GE(least_eigenvalue(reduction.compliance - massless), -1e-12 * reduction.compliance.norm());
      if (basis == ReductionBasis::modes) {
        EXPECT_EQ(reduction.vectors(), vectors);
      } else {
        EXPECT_GE(reduction.vectors(), vectors);
        EXPECT_LT((reduction.compliance - massless).norm(), 1e-12 * massless.norm());
      }
      EXPECT_FALSE(reduction.complete);
    }
  }
}

/// A row of the table: m, and what |C_n| may be wrong by at harmonics 1, 20 and 200.
struct Row {
  int vectors;
  std::array<double, 3> most;
};

struct ErrorTable {
  const char* name;
  Problem problem;
  ReductionBasis basis;
  std::vector<Row> rows;
};
void PrintTo(const ErrorTable& table, std::ostream* out) { *out << table.name; }

class ReductionErrors : public testing::TestWithParam<ErrorTable> {};

TEST_P(ReductionErrors, FallWithTheVectors) {
  const ErrorTable& table = GetParam();
  const ReceptanceError error(table.problem, {1, 20, 200});
  for (const Row& row : table.rows) {
    const ContactReduction reduction =
        reduce_to_contacts(table.problem, {.basis = table.basis, .vectors = row.vectors});
    ASSERT_EQ(reduction.obstacle, "");
    const std::vector<double> errors = error.of(reduction);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      EXPECT_LE(errors[i], row.most[i]) << "m = " << row.vectors << ", harmonic " << i;
    }
  }
}

Problem corner_block() {
  test::PaddedBlock block;
  block.patch = {{{2.0, 2.0}, {0.2, 0.2}}};
  return test::padded_block_problem(block);
}

// Twice what was measured. The floor is the rounding of K, eps times its condition (1e11 of the beam).
INSTANTIATE_TEST_SUITE_P(
    Structures, ReductionErrors,
    testing::Values(
        ErrorTable{"bar, modes",
                   test::massless_bar(kStiff),
                   ReductionBasis::modes,
                   {{8, {2e-5, 1.0, 10.0}}, {32, {2e-7, 2e-3, 1.0}}, {128, {4e-11, 6e-7, 4e-4}}}},
        ErrorTable{"bar, Krylov",
                   test::massless_bar(kStiff),
                   ReductionBasis::krylov,
                   {{16, {1e-11, 4e-3, 0.1}}, {32, {1e-11, 1e-11, 2e-3}}, {64, {1e-11, 1e-11, 1e-10}}}},
        ErrorTable{"beam with ten contacts, Krylov",
                   test::massless_beam(kStiff, 10),
                   ReductionBasis::krylov,
                   {{22, {3e-7, 2e-3, 4e-2}}, {66, {3e-7, 3e-7, 3e-7}}, {200, {3e-7, 3e-7, 3e-7}}}},
        ErrorTable{"beam with ten contacts, modes",
                   test::massless_beam(kStiff, 10),
                   ReductionBasis::modes,
                   {{8, {3e-7, 4e-5, 4e-2}}, {32, {3e-7, 2e-6, 4e-5}}, {200, {3e-7, 2e-6, 4e-5}}}},
        ErrorTable{"corner of a block, Krylov",
                   corner_block(),
                   ReductionBasis::krylov,
                   {{16, {2e-11, 1e-3, 0.2}}, {40, {2e-11, 2e-11, 1e-4}}}},
        ErrorTable{"corner of a block, modes",
                   corner_block(),
                   ReductionBasis::modes,
                   {{16, {2e-6, 6e-2, 0.5}}, {64, {6e-7, 2e-2, 0.3}}}},
        ErrorTable{"nine contacts of a block, Krylov",
                   test::padded_block_problem({}),
                   ReductionBasis::krylov,
                   {{30, {2e-11, 0.2, 0.2}}, {60, {2e-11, 1e-6, 1e-2}}}}));

// Six powers of few contacts, the lowest vectors of many; and the same numbers at every call.
TEST(ReduceToContacts, ChoosesItsBasisByTheContacts) {
  const Problem few = test::padded_block_problem({});
  EXPECT_EQ(reduce_to_contacts(few).vectors(), 60);
  test::PaddedBlock block;
  block.patch = {{{1.2, 2.0}, {0.0, 0.5}}};
  const Problem many = test::padded_block_problem(block);
  ASSERT_EQ(many.contact_count(), 54);
  const ContactReduction reduction = reduce_to_contacts(many), again = reduce_to_contacts(many);
  EXPECT_EQ(reduction.vectors(), 100);
  EXPECT_EQ(reduction.rows, again.rows);
  EXPECT_EQ(reduction.compliance, again.compliance);
  const ReceptanceError error(many, {1});
  EXPECT_LT(error.of(reduction).front(), 1e-5);
}

TEST(ReduceToContacts, TakesContactsWithMassAndNoMasslessCoordinates) {
  const Problem problem = test::elastic_block_problem({.nx = 5, .side = 3, .beta = 0.01, .frequency = 0.2});
  const ContactReduction reduction = reduce_to_contacts(problem, {.vectors = 120});
  const ReceptanceError error(problem, {0, 1, 3});
  for (const double e : error.of(reduction)) EXPECT_LT(e, 1e-9);
  const auto weights = harmonics_of(problem);
  const ContactReceptance reduced = contact_receptance(reduction, problem.period(), 3, weights);
  const ContactReceptance whole = factorised_receptance(problem, 3, weights, true);
  EXPECT_LT((reduced.free_response - whole.free_response).norm(), 1e-9 * whole.free_response.norm());
}

TEST(ReduceToContacts, SaysWhatItCannotReduce) {
  Problem problem = test::massless_bar(kStiff, 10);
  Problem damped = problem;
  damped.edit_structure([](Structure& s) { s.damping.coeffRef(0, 0) += 1.0; });
  EXPECT_EQ(reduce_to_contacts(damped).obstacle, "the damping is not a combination of mass and stiffness");
  Problem loose = problem;
  loose.edit_structure([](Structure& s) {
    s.stiffness.coeffRef(0, 0) *= 0.5;  // one spring less: nothing holds the bar
    s.damping = combination(kStiff, s.mass, s.stiffness);
  });
  EXPECT_EQ(reduce_to_contacts(loose).obstacle, "the stiffness is not positive definite");
  Problem alone = problem;
  alone.contacts.clear();
  alone.set_law(std::monostate{});
  alone.force.clear();
  EXPECT_EQ(reduce_to_contacts(alone).obstacle, "nothing acts on the structure");
}

// The same receptance from the matrices of the condensed form.
TEST(Condensed, HasTheReductionInItsMatrices) {
  const Problem problem = test::padded_block_problem({});
  const ContactReduction reduction = reduce_to_contacts(problem, {.vectors = 30});
  const CondensedStructure structure = condensed(reduction);
  ASSERT_EQ(structure.obstacle, "");
  ASSERT_EQ(structure.relaxation.size(), structure.normals.cols());
  EXPECT_EQ(structure.relaxation[0], 0.1);
  using Complex = std::complex<double>;
  const double w = 3.0 * problem.frequency;
  const Eigen::MatrixXcd N = Eigen::MatrixXd(structure.normals).cast<Complex>();
  const Eigen::MatrixXcd Z = Eigen::MatrixXd(structure.stiffness - w * w * structure.mass).cast<Complex>() +
                             Complex(0.0, w) * Eigen::MatrixXd(structure.damping).cast<Complex>();
  const Eigen::MatrixXcd C =
      N.transpose() * ComplexLuFactors(Z).solve(N) +
      structure.massless_compliance.cast<Complex>() / (1.0 + Complex(0.0, w) * structure.relaxation[0]);
  const ContactReceptance receptance =
      contact_receptance(reduction, problem.period(), 3, harmonics_of(problem));
  EXPECT_LT((C - receptance.receptance[3]).norm(), 1e-12 * C.norm());
}

TEST(ContactReceptanceOfAReduction, RefusesAnUndampedResonance) {
  Problem problem = test::massless_bar({}, 10);
  const ContactReduction reduction = reduce_to_contacts(problem);
  const double period = 2.0 * std::numbers::pi / std::sqrt(reduction.squares[0]);
  EXPECT_THROW(
      (void)contact_receptance(reduction, period, 1,
                               [&](int n) { return exact_weights(n * std::sqrt(reduction.squares[0])); }),
      SingularStiffness);
}

}  // namespace
}  // namespace signorini::contact_reduction_test
