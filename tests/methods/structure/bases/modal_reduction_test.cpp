#include "methods/structure/bases/modal_reduction.hpp"

#include <gtest/gtest.h>

#include "methods/structure/contact_reduction.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/assembly/damping.hpp"
#include "tests/support/elastic_block.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::modal_reduction_test {
namespace {

using test::harmonics_of;

/// A block with a damping ratio of its own for each of its lowest modes.
Problem damped_block() {
  Problem problem = test::elastic_block_problem({.nx = 3, .ny = 2, .nz = 3, .frequency = 0.2});
  problem.edit_structure([&](Structure& s) {
    s.damping = damping_matrix(ModalDamping{{0.01, 0.03, 0.1}}, s.mass, s.stiffness);
  });
  return problem;
}

// The oracle: a dense factorisation of every Z_n.
void expect_receptance_of(const Problem& problem, double tolerance = 1e-11) {
  const ContactReduction modes = modal_reduction(problem);
  ASSERT_EQ(modes.obstacle, "");
  EXPECT_TRUE(modes.complete);
  const auto weights = harmonics_of(problem);
  constexpr int kHarmonics = 20;
  const ContactReceptance found = contact_receptance(modes, problem.period(), kHarmonics, weights);
  const ContactReceptance whole = factorised_receptance(problem, kHarmonics, weights, true);
  for (std::size_t n = 0; n <= kHarmonics; ++n)
    EXPECT_LT((found.receptance[n] - whole.receptance[n]).norm(), tolerance * whole.receptance[n].norm())
        << n;
  EXPECT_LT((found.free_response - whole.free_response).norm(), tolerance * whole.free_response.norm());
}

TEST(ModalReduction, IsTheStructureWithDampingRatiosOfItsModes) { expect_receptance_of(damped_block()); }

TEST(ModalReduction, KeepsWhatMasslessCoordinatesDo) {
  expect_receptance_of(test::massless_bar({.alpha = 0.2, .beta = 0.005}, 40));
}

TEST(ModalReduction, TakesMoreCoordinatesUnderAFullDampingMatrix) {
  Problem problem = test::massless_bar({}, 450);
  problem.edit_structure([](Structure& s) {
    s.damping = damping_matrix(ModalDamping{{0.05, 0.01}}, s.mass, s.stiffness);
  });
  expect_receptance_of(problem, 1e-10);
}

TEST(ModalReduction, IsWhatReceptancesOfAFullDampingMatrixComeFrom) {
  const Problem problem = damped_block();
  const ReducedReceptance found = reduced_contact_receptance(problem, 32, harmonics_of(problem));
  EXPECT_TRUE(found.reduction.complete);
  EXPECT_EQ(found.reduction.obstacle, "");
}

TEST(ModalReduction, SaysWhatItDoesNotTake) {
  const auto changed = [](const std::function<void(Structure&)>& change) {
    Problem problem = damped_block();
    problem.edit_structure(change);
    return modal_reduction(problem).obstacle;
  };
  EXPECT_EQ(changed([](Structure& s) { s.damping.coeffRef(0, 0) += 1.0; }), "the damping couples modes");
  EXPECT_EQ(changed([](Structure& s) { s.damping.coeffRef(0, 1) += 0.1; }), "the matrices are not symmetric");
  EXPECT_EQ(changed([](Structure& s) { s.stiffness *= 0.0; }), "the stiffness is not positive definite");
  EXPECT_NE(modal_reduction(test::massless_bar({.alpha = 0.2, .beta = 0.005}, 500)).obstacle, "");
}

}  // namespace
}  // namespace signorini::modal_reduction_test
