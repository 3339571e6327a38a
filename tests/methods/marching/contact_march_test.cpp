#include "methods/marching/contact_march.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "problems/linear_algebra/lu.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/massless_scenes.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::contact_march_test {
namespace {

/// The whole structure stepped by backward differences of second order, displacement and velocity of every
/// coordinate, the forces of a step by trying all sets of closed contacts. Dense; shares no code with the
/// library's march.
class WholeStructure {
 public:
  WholeStructure(const Problem& problem, int samples)
      : problem_(problem),
        step_(problem.period() / samples),
        sigma_(1.5 / step_),
        M_(problem.mass()),
        D_(problem.damping()),
        W_(contact_directions(problem)),
        factors_(Eigen::MatrixXd(sigma_ * sigma_ * M_ + sigma_ * D_ + Eigen::MatrixXd(problem.stiffness()))),
        u_(Eigen::VectorXd::Zero(problem.size())),
        u_before_(u_),
        v_(u_),
        v_before_(u_) {
    G_ = W_.transpose() * factors_.solve(W_);
    if (const Law law_of_all = problem.law(); const auto* springs = std::get_if<Penalty>(&law_of_all)) {
      for (Eigen::Index c = 0; c < G_.rows(); ++c)
        G_(c, c) += 1.0 / springs->stiffness[static_cast<std::size_t>(c)];
    }
  }

  /// The next node. \return x and lambda, Nc each
  std::pair<Eigen::VectorXd, Eigen::VectorXd> advance() {
    ++node_;
    const Eigen::VectorXd h_u = (4.0 * u_ - u_before_) / (2.0 * step_);
    const Eigen::VectorXd h_v = (4.0 * v_ - v_before_) / (2.0 * step_);
    const Eigen::VectorXd rhs = load_at(problem_, node_ * step_) + M_ * (h_v + sigma_ * h_u) + D_ * h_u;
    Eigen::VectorXd u = factors_.solve(rhs);
    const Eigen::VectorXd lambda = forces(contact_gaps(problem_) - W_.transpose() * u);
    u += factors_.solve(Eigen::VectorXd(W_ * lambda));
    u_before_ = u_;
    v_before_ = v_;
    u_ = u;
    v_ = sigma_ * u - h_u;
    return {W_.transpose() * u_, lambda};
  }

 private:
  [[nodiscard]] Eigen::VectorXd forces(const Eigen::VectorXd& room) const {
    const auto contacts = static_cast<int>(room.size());
    for (int mask = 0; mask < 1 << contacts; ++mask) {
      Eigen::VectorXd lambda = Eigen::VectorXd::Zero(contacts);
      std::vector<int> set;
      for (int c = 0; c < contacts; ++c) {
        if ((mask >> c & 1) != 0) set.push_back(c);
      }
      if (!set.empty()) {
        const Eigen::MatrixXd block = G_(set, set);
        const Eigen::VectorXd part = CompleteLuFactors(block).solve(room(set));
        for (std::size_t k = 0; k < set.size(); ++k) lambda[set[k]] = part[static_cast<Eigen::Index>(k)];
      }
      Eigen::VectorXd rest = room - G_ * lambda;
      for (const int c : set) rest[c] = 0.0;
      if (lambda.maxCoeff() <= 0.0 && rest.minCoeff() >= 0.0) return lambda;
    }
    return Eigen::VectorXd::Constant(contacts, std::numeric_limits<double>::quiet_NaN());
  }

  const Problem& problem_;
  double step_, sigma_;
  Eigen::MatrixXd M_, D_, W_, G_;
  LuFactors factors_;
  Eigen::VectorXd u_, u_before_, v_, v_before_;
  int node_ = 0;
};

Problem three_contacts(unsigned seed, const ProportionalDamping& damping) {
  Problem problem = test::coupled_massless_scene(seed);
  problem.edit_structure([&](Structure& s) { s.damping = combination(damping, s.mass, s.stiffness); });
  return problem;
}

Problem sprung_chain() {
  Problem problem = test::stopped_chain(6, 0.5, 1);
  problem.set_law(Penalty{{30.0}});
  problem.edit_structure(
      [&](Structure& s) { s.damping = combination({.alpha = 0.05, .beta = 0.02}, s.mass, s.stiffness); });
  return problem;
}

struct MarchCase {
  const char* name;
  Problem problem;
};
void PrintTo(const MarchCase& scene, std::ostream* out) { *out << scene.name; }

class MarchOfAWholeStructure : public testing::TestWithParam<MarchCase> {};

// With all vectors the reduced structure is the whole one in other coordinates, so is its scheme: from rest
// the same motion and forces, step by step, also where the contacts relax.
TEST_P(MarchOfAWholeStructure, IsThatOfItsCoordinates) {
  constexpr int kSamples = 80;
  constexpr int kPeriods = 3;
  const Problem& problem = GetParam().problem;
  const ContactReduction reduction = reduce_to_contacts(problem, {.vectors = problem.size()});
  ASSERT_EQ(reduction.obstacle, "");
  ContactMarch march(reduction, march_grid(problem, kSamples));
  WholeStructure whole(problem, kSamples);
  Eigen::VectorXd state = Eigen::VectorXd::Zero(march.size());
  double pressed = 0.0, largest = contact_gaps(problem).cwiseAbs().maxCoeff();
  for (int period = 0; period < kPeriods; ++period) {
    state = march.period(state);
    for (int k = 1; k <= kSamples; ++k) {
      const auto [x, lambda] = whole.advance();
      ASSERT_TRUE(lambda.allFinite());
      largest = std::max(largest, x.cwiseAbs().maxCoeff());
      pressed = std::min(pressed, lambda.minCoeff());
      ASSERT_LE((march.motion().row(k % kSamples).transpose() - x).norm(), 1e-10 * largest)
          << "period " << period << ", step " << k;
      ASSERT_LE((march.force().row(k % kSamples).transpose() - lambda).norm(), 1e-9 * (1.0 - pressed));
    }
  }
  EXPECT_LT(pressed, 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, MarchOfAWholeStructure,
    testing::Values(
        MarchCase{"a massless bar that relaxes", test::massless_bar({.alpha = 0.2, .beta = 0.005}, 12)},
        MarchCase{"a massless bar without damping of its stiffness", test::massless_bar({.alpha = 0.3}, 12)},
        MarchCase{"three coupled contacts that relax", three_contacts(3, {.alpha = 0.1, .beta = 0.05})},
        MarchCase{"three coupled contacts", three_contacts(5, {.alpha = 0.1})},
        MarchCase{"a spring stop", sprung_chain()}));

class MarchOfTheBlock : public testing::Test {
 protected:
  MarchOfTheBlock()
      : problem_(test::padded_block_problem({})),
        reduction_(reduce_to_contacts(problem_, {.vectors = 40})),
        march_(reduction_, march_grid(problem_, 128)) {}

  Problem problem_;
  ContactReduction reduction_;
  ContactMarch march_;
};

TEST_F(MarchOfTheBlock, HasTheDifferenceQuotientAsItsTangent) {
  Eigen::VectorXd state = Eigen::VectorXd::Zero(march_.size());
  for (int period = 0; period < 12; ++period) state = march_.period(state);
  const Eigen::VectorXd image = march_.period(state);
  double pressing = 0.0;
  for (const std::vector<int>& set : march_.sets()) pressing += static_cast<double>(set.size());
  ASSERT_GT(pressing, 10.0);
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::srand(seed);
    const Eigen::VectorXd change = Eigen::VectorXd::Random(march_.size()).normalized();
    (void)march_.period(state);
    const auto sets = march_.sets();
    const Eigen::VectorXd tangent = march_.tangent(change);
    const double length = 1e-6 * state.norm();
    const Eigen::VectorXd there = march_.period(state + length * change);
    ASSERT_EQ(march_.sets(), sets);  // as long as they are the same, the map is affine
    EXPECT_LE(((there - image) / length - tangent).norm(), 1e-6);
    EXPECT_GT(tangent.norm(), 0.05);
  }
}

// Displacements added to x: their linear effect is the difference of two marches, on the sets of one.
TEST_F(MarchOfTheBlock, ChangesWithDisplacementsAsTheDifferenceQuotient) {
  Eigen::VectorXd state = Eigen::VectorXd::Zero(march_.size());
  for (int period = 0; period < 12; ++period) state = march_.period(state);
  const Eigen::VectorXd image = march_.period(state);
  const Eigen::MatrixXd motion = march_.motion(), force = march_.force();
  const auto sets = march_.sets();
  std::srand(7);
  const Eigen::MatrixXd shape = Eigen::MatrixXd::Random(128, 9);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(march_.size());
  const ContactMarch::Change change = march_.change(none, shape);
  const double length = 1e-7 * motion.cwiseAbs().maxCoeff();
  march_.move(length * shape);
  const Eigen::VectorXd there = march_.period(state);
  ASSERT_EQ(march_.sets(), sets);
  EXPECT_LE(((there - image) / length - change.state).norm(), 1e-5 * change.state.norm());
  EXPECT_LE(((march_.motion() - motion) / length - change.motion).norm(), 1e-5 * change.motion.norm());
  EXPECT_LE(((march_.force() - force) / length - change.force).norm(), 1e-5 * change.force.norm());
  for (int k = 1; k <= 128; ++k) {
    for (const int c : sets[static_cast<std::size_t>(k - 1)])
      EXPECT_NEAR(change.motion(k % 128, c), 0.0, 1e-10);
  }
}

TEST_F(MarchOfTheBlock, LeavesTheFreeMotionAloneWithoutContact) {
  MarchGrid far = march_grid(problem_, 128);
  far.gap.setConstant(1e3);
  ContactMarch march(reduction_, far);
  const Eigen::VectorXd state = march.free_state();
  EXPECT_GT(state.norm(), 0.0);
  EXPECT_LE((march.period(state) - state).norm(), 1e-11 * state.norm());
  EXPECT_TRUE(march.force().isZero(0.0));
  // Of order two in the step: the amplitude is that of the receptance.
  const ContactReceptance exact = contact_receptance(
      reduction_, problem_.period(), 1, [&](int n) { return exact_weights(n * problem_.frequency); });
  const double amplitude = 2.0 * exact.free_response.row(1).cwiseAbs().maxCoeff();
  EXPECT_NEAR(march.motion().maxCoeff() / amplitude, 1.0, 2e-2);
}

TEST_F(MarchOfTheBlock, CountsWhatItDoes) {
  Eigen::VectorXd state = march_.free_state();
  state = march_.period(state);
  (void)march_.tangent(state);
  const MarchWork work = march_.work();
  EXPECT_EQ(work.steps, 128);
  EXPECT_EQ(work.tangent_steps, 128);
  EXPECT_GE(work.sets, 128);
  EXPECT_LE(work.sets, 3 * 128);
  EXPECT_GT(work.factorisations, 0);
  EXPECT_EQ(work.fallbacks, 0);
}

TEST(MarchObstacle, IsAnImpactLaw) {
  Problem problem = test::stopped_chain(3, 0.5, 1);
  ASSERT_TRUE(std::holds_alternative<Restitution>(problem.law()));
  EXPECT_EQ(march_obstacle(problem),
            "a contact with mass and an impact law is another one in a reduced structure");
  EXPECT_EQ(march_obstacle(test::massless_node()), "");
}

}  // namespace
}  // namespace signorini::contact_march_test
