#include "methods/reduction/reduced_problem.hpp"

#include <gtest/gtest.h>

#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/reduction/contact_space.hpp"
#include "methods/structure/bases/condensation.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/validation.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::reduced_problem_test {
namespace {

constexpr ProportionalDamping kStiff{.alpha = 0.2, .beta = 0.005};

ContactReceptance factorised(const Problem& problem, int harmonics) {
  return factorised_receptance(
      problem, harmonics, [&](int n) { return exact_weights(n * problem.base_frequency()); }, true);
}

// Factors of every Z_n of its matrices say what the reduction's own formula says, loads of several harmonics
// and on massless coordinates included.
TEST(ReducedProblem, HasTheResponseOfTheReduction) {
  Problem block = test::padded_block_problem({.elements = {8, 2, 2}});
  const int padded = block.contacts.front().normal.front().first;
  block.force.push_back({.dof = padded, .harmonic = 2, .cos = 1e-5, .sin = 3e-5});
  block.force.push_back({.dof = padded, .harmonic = 0, .cos = 2e-5});
  const ContactSpace space(block, {.small = 12, .whole = 40});
  const ReducedProblem reduced = reduced_problem(block, space.small());
  ASSERT_EQ(reduced.obstacle, "");
  const Problem& few = reduced.problem;
  EXPECT_NO_THROW(validate(few));
  EXPECT_EQ(few.size(), space.small().vectors() + block.contact_count());
  const ContactReceptance own = factorised(few, 9);
  const ContactReceptance formula = contact_receptance(
      space.small(), block.period(), 9, [&](int n) { return exact_weights(n * block.base_frequency()); });
  for (std::size_t n = 0; n <= 9; ++n) {
    EXPECT_LT((own.receptance[n] - formula.receptance[n]).norm(), 1e-10 * formula.receptance[n].norm()) << n;
  }
  EXPECT_LT((own.free_response - formula.free_response).norm(), 1e-10 * formula.free_response.norm());
}

// Condensing its massless coordinates statically leads back to the residual, which relaxes as it did.
TEST(ReducedProblem, CondensesToTheReduction) {
  const Problem bar = test::massless_bar(kStiff, 60);
  const ContactSpace space(bar, {.small = 10, .whole = 40});
  const CondensedStructure back = condense(reduced_problem(bar, space.small()).problem);
  ASSERT_EQ(back.obstacle, "");
  EXPECT_NEAR(back.massless_compliance(0, 0), space.small().compliance(0, 0),
              1e-10 * space.small().compliance(0, 0));
  EXPECT_NEAR(back.relaxation[0], kStiff.beta, 1e-12);
}

// A spring beside a massless contact, both on coordinates without mass: as many vectors as masses leave
// nothing out.
TEST(ReducedProblem, KeepsTheLawOfEachContact) {
  Problem chain = parse_scene(
      "schema = 1\nname = \"c\"\n[system]\nkind = \"chain\"\nmasses = [1.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0, "
      "0.0]\nsprings = [9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 9.0]\ndampers = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, "
      "0.0, "
      "0.0]\n[forcing]\nfrequency = 0.7\n[[forcing.term]]\ndof = 3\ncos = 1.0\n[[contact]]\ndof = 7\ngap = "
      "0.05\n[[contact]]\ndof = 4\nside = \"below\"\ngap = 0.05\npenalty = 5.0\n",
      "c.toml");
  chain.edit_structure([](Structure& s) { s.damping = 0.05 * s.mass; });
  const ReducedProblem reduced =
      reduced_problem(chain, ContactSpace(chain, {.small = 6, .whole = 6}).small());
  ASSERT_EQ(reduced.obstacle, "");
  const ExactOrbitMethod method({});
  const Solution whole = method.prepare(chain)->solve({}), few = method.prepare(reduced.problem)->solve({});
  ASSERT_TRUE(whole.trajectory && few.trajectory) << whole.message << few.message;
  EXPECT_LT((whole.trajectory->sample(256).x - few.trajectory->sample(256).x).cwiseAbs().maxCoeff(), 1e-9);
  chain.edit_structure([](Structure& s) { s.damping += SparseMatrix(0.01 * s.stiffness); });
  EXPECT_EQ(reduced_problem(chain, ContactSpace(chain, {.small = 6, .whole = 6}).small()).obstacle,
            kMixedRelaxing);
}

// On as many vectors as there are masses, or where the damping grows with the stiffness, a spring has no
// static residual: it acts on the vectors, and all of them are the structure itself.
TEST(ReducedProblem, LetsSpringsWithoutAResidualActOnTheVectors) {
  for (const double beta : {0.0, 0.01}) {
    Problem chain = parse_scene(
        "schema = 1\nname = \"c\"\n[system]\nkind = \"chain\"\nmasses = [1.0, 2.0, 1.5, 1.0]\nsprings = "
        "[9.0, 8.0, 9.0, 7.0]\ndampers = [0.0, 0.0, 0.0, 0.0]\n[forcing]\nfrequency = "
        "0.7\n[[forcing.term]]\ndof = 1\ncos = 1.0\n[[contact]]\ndof = 3\ngap = 0.05\npenalty = "
        "20.0\n[[contact]]\nbetween = [0, 2]\ngap = 0.02\npenalty = 5.0\n",
        "c.toml");
    chain.edit_structure(
        [beta](Structure& s) { s.damping = 0.05 * s.mass + SparseMatrix(beta * s.stiffness); });
    const ReducedProblem reduced = reduced_problem(chain, ContactSpace(chain).small());
    ASSERT_EQ(reduced.obstacle, "");
    EXPECT_NO_THROW(validate(reduced.problem));
    EXPECT_EQ(reduced.problem.size(), 4);
    const ExactOrbitMethod method({});
    const Solution whole = method.prepare(chain)->solve({}), few = method.prepare(reduced.problem)->solve({});
    ASSERT_TRUE(whole.verdict == Verdict::converged && few.verdict == Verdict::converged)
        << whole.message << few.message;
    EXPECT_LT((whole.trajectory->sample(256).x - few.trajectory->sample(256).x).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(ReducedProblem, SaysWhyThereIsNone) {
  Problem chain = test::stopped_chain(12, 0.5, 1);
  chain.edit_structure([](Structure& s) { s.damping = 0.02 * s.stiffness; });
  const ContactSpace space(chain, {.small = 6, .whole = 12});
  EXPECT_EQ(reduced_problem(chain, space.small()).obstacle,
            "a contact with mass and an impact law is another one in a reduced structure");
  const Problem bar = test::massless_bar(kStiff, 30);
  ContactReduction rigid = ContactSpace(bar).small();
  rigid.compliance.setZero();
  EXPECT_EQ(reduced_problem(bar, rigid).obstacle,
            "the static residual at the contacts is not definite: fewer vectors are needed");
}

}  // namespace
}  // namespace signorini::reduced_problem_test
