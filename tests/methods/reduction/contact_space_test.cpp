#include "methods/reduction/contact_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <utility>

#include "methods/reduction/principal_directions.hpp"
#include "methods/structure/bases/ritz_reduction.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::contact_space_test {
namespace {

/// lambda_n of a force that jumps: it falls as 1 / n, contact by contact with another phase.
Eigen::MatrixXcd jumping_force(int harmonics, int contacts) {
  Eigen::MatrixXcd force(harmonics + 1, contacts);
  for (int n = 0; n <= harmonics; ++n) {
    for (int j = 0; j < contacts; ++j) force(n, j) = std::polar(-1.0 / (1.0 + n), 0.7 * n * (j + 1));
  }
  return force;
}

/// x_n of the whole structure by factors of every Z_n.
Eigen::MatrixXcd whole_response(const Problem& problem, const Eigen::MatrixXcd& force) {
  const auto weights = [&](int n) { return exact_weights(n * problem.base_frequency()); };
  const auto harmonics = static_cast<int>(force.rows()) - 1;
  const ContactReceptance exact = factorised_receptance(problem, harmonics, weights, false);
  Eigen::MatrixXcd x = exact.free_response;
  for (int n = 0; n <= harmonics; ++n)
    x.row(n) += (exact.receptance[static_cast<std::size_t>(n)] * force.row(n).transpose()).transpose();
  return x;
}

struct SpaceCase {
  Problem problem;
  ContactSpaceSettings settings;
};

std::vector<SpaceCase> space_cases() {
  const test::PaddedBlock small{.elements = {8, 2, 2}};
  return {{test::massless_bar({.alpha = 0.2, .beta = 0.005}, 100), {.small = 8, .whole = 24}},
          {test::massless_bar({.alpha = 0.2, .beta = 0.005}, 100), {.small = 20, .whole = 60}},
          {test::massless_beam({.alpha = 0.2, .beta = 0.005}, 10), {.small = 11, .whole = 33}},
          {test::padded_block_problem(small), {.small = 10, .whole = 40}},
          {test::massless_bar({.alpha = 0.2, .beta = 0.005}, 400), {}}};
}

// eps times the condition of K: what both factorisations may lose, 2e-5 for the beam.
double rounding_of_factors(const Problem& problem) {
  const Eigen::VectorXd values = symmetric_eigenvalues(Eigen::MatrixXd(problem.stiffness()));
  return std::numeric_limits<double>::epsilon() * values.maxCoeff() / values.minCoeff();
}

// The response of the larger space is as near to that of all coordinates as the bound says, at low harmonics
// and at high ones, for force and load together; where the bound says much it is not idle.
TEST(ContactSpace, BoundsWhatIsOutside) {
  constexpr int kHarmonics = 60;
  for (const auto& [problem, settings] : space_cases()) {
    const ContactSpace space(problem, settings);
    ASSERT_EQ(space.obstacle(), "");
    const Eigen::MatrixXcd force = jumping_force(kHarmonics, problem.contact_count());
    const Eigen::MatrixXcd exact = whole_response(problem, force);
    const double base = problem.base_frequency();
    const Eigen::MatrixXcd projected =
        contact_response(space.small(), base, force) + space.missing(base, force);
    const Eigen::VectorXd bound = space.bound(base, force);
    const double rounding = std::max(1e-9, rounding_of_factors(problem)) * exact.cwiseAbs().maxCoeff();
    double tightest = 1e300;
    for (int n = 0; n <= kHarmonics; ++n) {
      const double error = (projected.row(n) - exact.row(n)).cwiseAbs().maxCoeff();
      EXPECT_LE(error, bound[n] + rounding) << problem.name << " " << settings.whole << " harmonic " << n;
      if (error > 10.0 * rounding) tightest = std::min(tightest, bound[n] / error);
    }
    if (tightest < 1e300) {
      EXPECT_LT(tightest, 1e3) << problem.name;
    }
  }
}

/// |sum_j conj(lambda_nj) (x_nj - x_nj^space)| of each harmonic against factors of every Z_n.
Eigen::VectorXd error_of_work(const ContactSpace& space, const Problem& problem,
                              const Eigen::MatrixXcd& force, const Eigen::MatrixXcd& exact) {
  const Eigen::MatrixXcd error = exact - space.motion(problem.base_frequency(), force).contacts;
  return force.conjugate().cwiseProduct(error).rowwise().sum().cwiseAbs();
}

// The work of all contacts together, which is far nearer to the truth than the displacements are.
TEST(ContactSpace, BoundsTheWorkThatIsOutside) {
  constexpr int kHarmonics = 60;
  for (const auto& [problem, settings] : space_cases()) {
    const ContactSpace space(problem, settings);
    const Eigen::MatrixXcd force = jumping_force(kHarmonics, problem.contact_count());
    const Eigen::MatrixXcd exact = whole_response(problem, force);
    const double base = problem.base_frequency();
    const Eigen::VectorXd error = error_of_work(space, problem, force, exact);
    const Eigen::VectorXd bound = space.work_bound(base, force);
    const Eigen::VectorXd push = force.cwiseAbs().rowwise().sum();
    const Eigen::VectorXd sum = push.cwiseProduct(space.bound(base, force));
    const double rounding = std::max(1e-9, rounding_of_factors(problem)) * exact.cwiseAbs().maxCoeff();
    double tightest = 1e300;
    for (int n = 0; n <= kHarmonics; ++n) {
      EXPECT_LE(error[n], bound[n] + push[n] * rounding)
          << problem.name << " " << settings.whole << " harmonic " << n;
      if (error[n] > 10.0 * push[n] * rounding) tightest = std::min(tightest, bound[n] / error[n]);
    }
    if (tightest < 1e300) {
      EXPECT_LT(tightest, 1e3) << problem.name;
    }
    EXPECT_LE(bound.sum(), (1.0 + 1e-9) * sum.sum()) << problem.name;
  }
}

// Contacts and columns of the load against factors of every Z_n of all coordinates, where load and contacts
// act on massless coordinates too.
TEST(ContactSpace, HasTheMotionWhereForcesAct) {
  constexpr int kHarmonics = 12;
  Problem block = test::padded_block_problem({.elements = {8, 2, 2}});
  const Contact& padded = block.contacts.front();
  block.force.push_back({.dof = padded.normal.front().first, .harmonic = 2, .cos = 1e-5, .sin = 3e-5});
  block.force.push_back({.dof = padded.normal.front().first + 1, .harmonic = 0, .cos = 2e-5});
  const ContactSpace space(block, {.whole = 180});
  const Eigen::MatrixXcd force = jumping_force(kHarmonics, block.contact_count());
  const double base = block.base_frequency();
  const ContactSpace::PortMotion motion = space.motion(base, force);
  const SparseMatrix W = contact_directions(block);
  const SparseMatrix F = contact_directions(space.load().columns, block.size());
  EXPECT_EQ(F.cols(), 4);
  DynamicStiffness stiffness(block, true);
  double squares = 0.0;
  for (int n = 0; n <= kHarmonics; ++n) {
    stiffness.factorise(exact_weights(n * base));
    const Eigen::VectorXcd u = stiffness.solve(load_coefficient(block, n) + W * force.row(n).transpose());
    const Eigen::VectorXcd x = W.transpose() * u, q = F.transpose() * u;
    EXPECT_LT((motion.contacts.row(n).transpose() - x).norm(), 1e-9 * x.norm()) << n;
    EXPECT_LT((motion.loads.row(n).transpose() - q).norm(), 1e-9 * q.norm()) << n;
    if (n > 0) squares += 2.0 * u.squaredNorm();
  }
  const Eigen::MatrixXcd coefficients = space.load().coefficients(base, kHarmonics);
  // The field is of the first order in what the space leaves out.
  const double size = std::sqrt(squares / block.size());
  EXPECT_NEAR(space.field_size(base, force, coefficients, 1), size, 1e-5 * size);
  for (const int n : {0, 1, 2, 3}) {
    EXPECT_LT((F * coefficients.row(n).transpose() - load_coefficient(block, n)).norm(), 1e-18) << n;
  }
}

// Statics are exact in both reductions, however few the vectors.
TEST(ContactSpace, IsExactAtRest) {
  const Problem block = test::padded_block_problem({.elements = {8, 2, 2}});
  const ContactSpace space(block, {.small = 10, .whole = 30});
  const Eigen::MatrixXcd force = jumping_force(0, block.contact_count());
  const Eigen::MatrixXcd exact = whole_response(block, force);
  const double base = block.base_frequency();
  EXPECT_LT((contact_response(space.small(), base, force) - exact).norm(), 1e-10 * exact.norm());
  EXPECT_LT(space.missing(base, force).norm(), 1e-10 * exact.norm());
  EXPECT_LT(space.bound(base, force).norm(), 1e-6 * exact.norm());
}

// With all vectors nothing is outside. A beam's condition is 1e11; its rounding, 1e-7 as the factors leave
// it, is small after the lowest pairs are refined.
TEST(ContactSpace, MeasuresItsRounding) {
  const ContactSpace bar(test::massless_bar({.alpha = 0.2, .beta = 0.005}, 41), {.small = 10, .whole = 40});
  EXPECT_TRUE(bar.whole().complete);
  const Eigen::MatrixXcd force = jumping_force(20, 1);
  EXPECT_EQ(bar.bound(1.2, force).norm(), 0.0);
  const ContactSpace grown = bar.grown_for(1.2, {{.force = force, .tolerance = 1e-300}});
  EXPECT_EQ(grown.whole().vectors(), bar.whole().vectors());
  EXPECT_EQ(grown.bound(1.2, force).norm(), 0.0);
  EXPECT_LT(bar.rounding(), 1e-12);
  const ContactSpace beam(test::massless_beam({.alpha = 0.2, .beta = 0.005}, 1), {});
  EXPECT_GT(beam.rounding(), bar.rounding());
  EXPECT_LT(beam.rounding(), 1e-8);
}

constexpr int kSoft = 30, kStiff = 4;

/// Two chains side by side, the springs of the second a billion times stiffer; its first mode is between
/// harmonics 2 and 3 of the load.
Problem soft_and_stiff_chain() {
  constexpr double kRatio = 1e9;
  SparseMatrix mass(kSoft + kStiff, kSoft + kStiff), stiffness = mass;
  for (int i = 0; i < kSoft + kStiff; ++i) {
    const double spring = i < kSoft ? 1.0 : kRatio;
    mass.insert(i, i) = 1.0 + 0.1 * i;
    stiffness.coeffRef(i, i) += spring;
    if (i == 0 || i == kSoft) continue;
    stiffness.coeffRef(i - 1, i - 1) += spring;
    stiffness.coeffRef(i, i - 1) = stiffness.coeffRef(i - 1, i) = -spring;
  }
  Structure chains;
  chains.mass = mass;
  chains.damping = combination({.alpha = 0.05, .beta = 1e-6}, mass, stiffness);
  chains.stiffness = stiffness;
  Problem problem;
  problem.structure = std::make_shared<const Structure>(std::move(chains));
  problem.frequency = 2000.0;
  problem.force = {{kSoft - 1, 1, 0.3, 0.0}};
  problem.contacts = {{{{kSoft - 1, 1.0}}, 0.1}, {{{kSoft + kStiff - 1, 1.0}}, 0.1}};
  problem.set_law(Penalty{{10.0, 10.0}});
  return problem;
}

// Beside the soft chain the stiff one is next to nothing in any block, and left out of it. The bound knows
// that up to the first mode that it does not know, and no space is complete without the four modes, whose
// rounding is that of the soft ones.
TEST(ContactSpace, HoldsAPartThatIsFarStifferThanAnother) {
  const Problem problem = soft_and_stiff_chain();
  const double base = problem.base_frequency();
  const Eigen::MatrixXcd force = jumping_force(4, 2), exact = whole_response(problem, force);
  const auto error = [&](const ContactSpace& space) {
    const Eigen::MatrixXcd found = contact_response(space.whole(), base, force);
    return Eigen::VectorXd((found - exact).col(1).cwiseAbs());
  };
  const double size = exact.col(1).cwiseAbs().maxCoeff();
  const ContactSpace soft(problem, {.small = 6, .whole = kSoft + 1});
  EXPECT_FALSE(soft.whole().complete);
  EXPECT_GT(error(soft).maxCoeff(), 0.1 * size);
  EXPECT_GE((soft.bound(base, force) - error(soft)).minCoeff(), -1e-12 * size);
  const ContactSpace both(problem, {.small = 6});
  EXPECT_TRUE(both.whole().complete);
  EXPECT_EQ(both.whole().vectors(), kSoft + kStiff);
  EXPECT_LT(error(both).maxCoeff(), 1e-4 * size);
}

TEST(ContactSpace, SaysWhyThereIsNone) {
  Problem other = test::massless_bar({.beta = 0.01}, 10);
  other.edit_structure([](Structure& s) { s.damping.coeffRef(0, 0) += 1.0; });
  EXPECT_EQ(ContactSpace(other).obstacle(), "the damping is not a combination of mass and stiffness");
}

// Forces of few shapes on many contacts: a few vectors make the bound as small as is wanted, where a power of
// all contacts would take many more; the bound holds for these forces and for others.
TEST(ContactSpace, GrowsForTheForcesOfAMotion) {
  constexpr int kHarmonics = 40;
  const Problem block =
      test::padded_block_problem({.elements = {10, 3, 3}, .patch = {{{1.0, 2.0}, {0.0, 0.5}}}});
  const auto contacts = static_cast<int>(block.contact_count());
  const double base = block.base_frequency();
  const ContactSpace space(block, {.small = contacts, .whole = 2 * contacts});
  ASSERT_EQ(space.obstacle(), "");
  const Eigen::RowVectorXcd shape = jumping_force(1, contacts).row(1);
  const Eigen::MatrixXcd force = jumping_force(kHarmonics, contacts).leftCols(1) * shape;
  const Eigen::MatrixXcd exact = whole_response(block, force);
  const double wanted = 1e-7 * exact.norm();
  const double before = root_mean_square(space.bound(base, force));
  ASSERT_GT(before, 10.0 * wanted);
  const ContactSpace grown = space.grown_for(base, {{.force = force, .tolerance = wanted}});
  EXPECT_LE(root_mean_square(grown.bound(base, force)), wanted);
  EXPECT_EQ(root_mean_square(space.bound(base, force)),
            before);  // the space that it grew from is what it was
  EXPECT_GT(grown.whole().vectors(), space.whole().vectors());
  const Eigen::MatrixXcd others = jumping_force(kHarmonics, contacts);
  const double rounding = std::max(1e-9, rounding_of_factors(block));
  for (const Eigen::MatrixXcd& acting : {force, others}) {
    const Eigen::MatrixXcd truth = whole_response(block, acting);
    const Eigen::MatrixXcd found = contact_response(grown.whole(), base, acting);
    const Eigen::VectorXd bound = grown.bound(base, acting);
    for (int n = 0; n <= kHarmonics; ++n) {
      EXPECT_LE((found.row(n) - truth.row(n)).cwiseAbs().maxCoeff(),
                bound[n] + rounding * truth.cwiseAbs().maxCoeff())
          << n;
    }
  }
}

/// 40 contacts and one load, more than a space starts from.
Problem many_contacts() {
  return test::padded_block_problem({.elements = {10, 3, 3}, .patch = {{{0.1, 2.0}, {0.0, 0.5}}}});
}

// Of many contacts a space begins with random combinations: statics, bound and motion where forces act are
// no worse for it, before it has grown for a motion and after.
TEST(ContactSpace, BeginsWithCombinationsOfManyContacts) {
  constexpr int kHarmonics = 40;
  const Problem block = many_contacts();
  const auto contacts = static_cast<int>(block.contact_count());
  ASSERT_GT(contacts, 20);
  const double base = block.base_frequency(), rounding = std::max(1e-9, rounding_of_factors(block));
  const ContactSpace space(block, {.small = 24, .whole = 48});
  ASSERT_LT(space.whole().vectors(), 2 * contacts);
  const Eigen::MatrixXcd at_rest = jumping_force(0, contacts), rest = whole_response(block, at_rest);
  EXPECT_LT((contact_response(space.small(), base, at_rest) - rest).norm(), 1e-9 * rest.norm());
  EXPECT_LT(space.missing(base, at_rest).norm(), 1e-9 * rest.norm());
  const Eigen::MatrixXcd force = jumping_force(kHarmonics, contacts), exact = whole_response(block, force);
  const double wanted = 1e-6 * exact.norm();
  const ContactSpace grown = space.grown_for(base, {{.force = force, .tolerance = wanted}});
  EXPECT_LE(root_mean_square(grown.bound(base, force)), wanted);
  const Eigen::VectorXd push = force.cwiseAbs().rowwise().sum();
  const Eigen::VectorXd turns = Eigen::VectorXd::LinSpaced(kHarmonics + 1, 0.0, kHarmonics);
  for (const ContactSpace* each : {&space, &grown}) {
    const ContactSpace::PortMotion motion = each->motion(base, force);
    const Eigen::VectorXd bound = each->bound(base, force), work = each->work_bound(base, force);
    const Eigen::VectorXd error = error_of_work(*each, block, force, exact);
    EXPECT_LE(turns.dot(work), turns.dot(push.cwiseProduct(bound)));
    for (int n = 0; n <= kHarmonics; ++n) {
      EXPECT_LE(error[n], work[n] + push[n] * rounding * exact.cwiseAbs().maxCoeff())
          << each->whole().vectors() << " vectors, work at harmonic " << n;
      EXPECT_LE((motion.contacts.row(n) - exact.row(n)).cwiseAbs().maxCoeff(),
                bound[n] + rounding * exact.cwiseAbs().maxCoeff())
          << each->whole().vectors() << " vectors, harmonic " << n;
    }
  }
}

// What follows statically is not in the field: less than a hundredth of it here.
TEST(ContactSpace, HasTheFieldOfManyContacts) {
  constexpr int kHarmonics = 12;
  const Problem block = many_contacts();
  const double base = block.base_frequency();
  const ContactSpace space(block, {.whole = 96});
  const Eigen::MatrixXcd force = jumping_force(kHarmonics, block.contact_count());
  const SparseMatrix W = contact_directions(block);
  DynamicStiffness stiffness(block, true);
  double squares = 0.0;
  for (int n = 1; n <= kHarmonics; ++n) {
    stiffness.factorise(exact_weights(n * base));
    const Eigen::VectorXcd u = stiffness.solve(load_coefficient(block, n) + W * force.row(n).transpose());
    squares += 2.0 * u.squaredNorm();
  }
  const double size = std::sqrt(squares / block.size());
  EXPECT_NEAR(space.field_size(base, force, space.load().coefficients(base, kHarmonics), 1), size,
              1e-2 * size);
}

// The vectors to solve on follow from the force: what they leave out falls with the tolerance, and with it
// their number rises; statics are exact whatever they are.
TEST(ContactSpace, SolvesOnWhatAForceNeeds) {
  constexpr int kHarmonics = 40;
  const Problem block = many_contacts();
  const auto contacts = static_cast<int>(block.contact_count());
  const double base = block.base_frequency();
  const Eigen::MatrixXcd force = jumping_force(kHarmonics, contacts);
  const ContactSpace space = ContactSpace(block, {.whole = 200});
  const double size = contact_response(space.whole(), base, force).norm() / std::sqrt(contacts);
  double missing = std::numeric_limits<double>::infinity();
  Eigen::Index vectors = 0;
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const ContactSpace solved = space.solved_for(base, force, tolerance * size);
    EXPECT_GT(solved.small().vectors(), vectors) << tolerance;
    const double left = solved.missing(base, force).norm();
    EXPECT_LT(left, missing) << tolerance;
    EXPECT_LT(left, 30.0 * tolerance * size * std::sqrt(contacts)) << tolerance;
    missing = left;
    vectors = solved.small().vectors();
    const Eigen::MatrixXcd at_rest = jumping_force(0, contacts);
    EXPECT_LT(solved.missing(base, at_rest).norm(),
              1e-10 * contact_response(space.whole(), base, at_rest).norm());
  }
}

}  // namespace
}  // namespace signorini::contact_space_test
