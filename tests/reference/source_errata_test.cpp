// Equations of the source paper [shi2015], as printed and corrected: the misprints of docs/source-paper.md.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "tests/reference/source_basis.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::source_errata_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::gram;
using test::phi;

// (2) is zero exactly where (1) holds with the gap in it, whatever c; without the gap only for g = 0. All
// numbers are multiples of 1/8: the comparisons are exact.
TEST(SourceErrata, Equation1HoldsWithTheGapThatEquation2Has) {
  const auto signorini = [](double clearance, double lambda) {
    return clearance <= 0.0 && lambda <= 0.0 && clearance * lambda == 0.0;
  };
  for (const double gap : {-0.25, 0.0, 0.25}) {
    int told_apart = 0;
    for (int i = -8; i <= 8; ++i) {
      for (int j = -8; j <= 8; ++j) {
        const double u = i / 8.0, lambda = j / 8.0;
        for (const double c : {0.25, 1.0, 64.0}) {
          const double s = lambda + std::max(0.0, c * (u - gap) - lambda);
          EXPECT_EQ(s == 0.0, signorini(u - gap, lambda)) << u << ' ' << lambda << ' ' << c;
        }
        told_apart += signorini(u, lambda) != signorini(u - gap, lambda) ? 1 : 0;
      }
    }
    EXPECT_EQ(told_apart == 0, gap == 0.0);
  }
}

TEST(SourceErrata, Equations17To19AreTheGramMatrices) {
  constexpr int kOrder = 4;
  const double w = 1.7;
  VectorXd order(2 * kOrder + 1);  // 0, 1..M, 1..M
  order << 0.0, VectorXd::LinSpaced(kOrder, 1.0, kOrder), VectorXd::LinSpaced(kOrder, 1.0, kOrder);
  const MatrixXd l_k = std::numbers::pi / w * MatrixXd::Identity(2 * kOrder + 1, 2 * kOrder + 1);
  const MatrixXd l_m = -std::numbers::pi * w * MatrixXd(order.cwiseAbs2().asDiagonal());
  MatrixXd l_d = MatrixXd::Zero(2 * kOrder + 1, 2 * kOrder + 1);
  for (int n = 1; n <= kOrder; ++n) {
    l_d(n, kOrder + n) = std::numbers::pi * n;
    l_d(kOrder + n, n) = -std::numbers::pi * n;
  }
  EXPECT_LE((gram(kOrder, w, 0) - l_k).norm(), 1e-13 * l_k.norm());
  EXPECT_LE((gram(kOrder, w, 1) - l_d).norm(), 1e-13 * l_d.norm());
  EXPECT_LE((gram(kOrder, w, 2) - l_m).norm(), 1e-13 * l_m.norm());
}

// N + 1 instants from 0 to the period weigh its beginning twice: their sum is L_K and a matrix of rank one.
TEST(SourceErrata, Equation35AsPrintedCountsOneInstantTwice) {
  constexpr int kOrder = 4, kSamples = 16;
  const double w = 1.7, step = 2.0 * std::numbers::pi / w / kSamples;
  MatrixXd printed = MatrixXd::Zero(2 * kOrder + 1, 2 * kOrder + 1);
  for (int n = 0; n <= kSamples; ++n) {
    printed += step * phi(kOrder, w, n * step).transpose() * phi(kOrder, w, n * step);
  }
  const MatrixXd l_k = gram(kOrder, w, 0);
  const MatrixXd twice = step * phi(kOrder, w, 0.0).transpose() * phi(kOrder, w, 0.0);
  EXPECT_LE((printed - twice - l_k).norm(), 1e-13 * l_k.norm());
  EXPECT_GE((printed - l_k).norm(), 0.1 * l_k.norm());
}

// Hat functions on N nodes, (5)-(8).
class SourceHatEquations : public testing::Test {
 protected:
  static constexpr int kNodes = 64;
  const test::ImpactOscillator oscillator_{.damping = 0.1, .frequency = 2.2, .gap = 0.2};
  const double step_ = 2.0 * std::numbers::pi / oscillator_.frequency / kNodes;

  // dt / 6 circ(1, 4, 1), the Gram matrix of the hats.
  [[nodiscard]] MatrixXd weight() const { return circulant(step_ / 6.0, 4.0 * step_ / 6.0, step_ / 6.0); }
  // What Galerkin's method makes of (3), integrated by parts: the matrix in front of the nodal values of u.
  [[nodiscard]] MatrixXd structure() const {
    const auto& o = oscillator_;
    return o.mass * circulant(1.0 / step_, -2.0 / step_, 1.0 / step_) +
           o.damping * circulant(-0.5, 0.0, 0.5) + o.stiffness * weight();
  }
  [[nodiscard]] VectorXd load() const {
    VectorXd f(kNodes);
    for (int i = 0; i < kNodes; ++i) f[i] = oscillator_.load * std::cos(oscillator_.frequency * i * step_);
    return f;
  }
  [[nodiscard]] Samples solved(double gap, HatScheme scheme = HatScheme::galerkin) const {
    auto oscillator = oscillator_;
    oscillator.gap = gap;
    const Solution solution =
        test::solve<HatLcp>(test::to_problem(oscillator),
                            {.samples = kNodes, .scheme = scheme, .restitution = HatLcp::ImpactLaw::none});
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    return solution.trajectory->sample(kNodes);
  }

 private:
  static MatrixXd circulant(double before, double here, double after) {
    MatrixXd matrix = MatrixXd::Zero(kNodes, kNodes);
    for (int i = 0; i < kNodes; ++i) {
      matrix(i, (i + kNodes - 1) % kNodes) += before;
      matrix(i, i) += here;
      matrix(i, (i + 1) % kNodes) += after;
    }
    return matrix;
  }
};

TEST_F(SourceHatEquations, Equation7IsAlgebraicAndWeighsTheLoad) {
  const VectorXd u = solved(0.2 + 10.0).x.col(0);  // nothing touches
  EXPECT_LE((structure() * u - weight() * load()).norm(), 1e-10 * load().norm());
  EXPECT_GE((structure() * u - step_ * load()).norm(), 1e-5 * load().norm());
}

// A u = B (f + lambda): with scheme=consistent the contact force has the Gram matrix before it as the load
// has.
TEST_F(SourceHatEquations, Equation7HoldsWithTheContactForceInHatFunctions) {
  const Samples motion = solved(0.2, HatScheme::consistent);
  const VectorXd u = motion.x.col(0), lambda = motion.force.col(0);
  ASSERT_LT(lambda.minCoeff(), 0.0);
  EXPECT_LE((structure() * u - weight() * (load() + lambda)).norm(), 1e-10 * load().norm());
  for (int i = 0; i < kNodes; ++i) {
    EXPECT_LE(u[i], 0.2 + 1e-10);
    EXPECT_LE(lambda[i], 0.0);
    EXPECT_NEAR(lambda[i] * (u[i] - 0.2), 0.0, 1e-9);
  }
}

// A force with the displacement's coefficients pulls wherever u < 0, and holds no balance.
TEST_F(SourceHatEquations, Equation6AsPrintedIsNotTheContactForce) {
  const Samples motion = solved(0.2);
  const VectorXd u = motion.x.col(0), lambda = motion.force.col(0);
  ASSERT_LT(lambda.minCoeff(), 0.0);
  const VectorXd free = structure() * u - weight() * load();
  EXPECT_LE((free - step_ * lambda).norm(), 1e-9 * free.norm());  // lambda at the nodes
  EXPECT_GE((free - step_ * u).norm(), 0.1 * free.norm());
}

TEST_F(SourceHatEquations, Equation8NeedsTheGap) {
  for (const double gap : {0.0, 0.2}) {
    const Samples motion = solved(gap);
    const auto s = [&](double g) {
      const Eigen::ArrayXd u = motion.x.col(0).array(), lambda = motion.force.col(0).array();
      return (lambda + (u - g - lambda).max(0.0)).matrix().norm() / lambda.matrix().norm();
    };
    EXPECT_LE(s(gap), 1e-9);
    EXPECT_EQ(s(0.0) <= 1e-9, gap == 0.0);
  }
}

// One mass, one stop; residuals of the projected equations, summed over the grid.
class SourceContactEquation : public testing::Test {
 protected:
  static constexpr int kHarmonics = 12;
  static constexpr int kSamples = 384;
  static constexpr double kConstant = 10.0;
  const test::ImpactOscillator oscillator_{.damping = 0.1, .frequency = 2.2, .gap = 0.2};

  // What is printed in (22) and (23), and what is meant.
  struct Form {
    bool first_term_is_u = false;
    double gap = 0.2;
  };

  [[nodiscard]] double step() const { return 2.0 * std::numbers::pi / oscillator_.frequency / kSamples; }

  // dt sum phi^T (phi lambda + max(0, c (phi u - g) - phi lambda)), (22).
  [[nodiscard]] VectorXd sum(const VectorXd& u, const VectorXd& lambda, const Form& form) const {
    VectorXd total = VectorXd::Zero(u.size());
    for (int i = 1; i <= kSamples; ++i) {
      const Eigen::RowVectorXd row = phi(kHarmonics, oscillator_.frequency, i * step());
      const double y = kConstant * (row.dot(u) - form.gap) - row.dot(lambda);
      total += step() * row.transpose() * (row.dot(form.first_term_is_u ? u : lambda) + std::max(0.0, y));
    }
    return total;
  }
  [[nodiscard]] double residual(const VectorXd& u, const VectorXd& lambda, const Form& form) const {
    return sum(u, lambda, form).norm();
  }

  // A of (54).
  [[nodiscard]] MatrixXd structure() const {
    const double w = oscillator_.frequency;
    return gram(kHarmonics, w, 2) + oscillator_.damping * gram(kHarmonics, w, 1) + gram(kHarmonics, w, 0);
  }
  // f of (20).
  [[nodiscard]] VectorXd load() const { return VectorXd::Unit(2 * kHarmonics + 1, 1) * oscillator_.load; }

  // (21): m L_M u + d L_D u + k L_K u - L_K (lambda + f).
  [[nodiscard]] double balance(const VectorXd& u, const VectorXd& lambda) const {
    return (structure() * u - gram(kHarmonics, oscillator_.frequency, 0) * (lambda + load())).norm();
  }

  // Complex coefficients in the real basis.
  static VectorXd in_basis(const Eigen::VectorXcd& spectrum) {
    VectorXd real(2 * kHarmonics + 1);
    real[0] = std::numbers::sqrt2 * spectrum[0].real();
    for (int n = 1; n <= kHarmonics; ++n) {
      real[n] = 2.0 * spectrum[n].real();
      real[kHarmonics + n] = -2.0 * spectrum[n].imag();
    }
    return real;
  }

  struct Answer {
    VectorXd u, lambda;
  };
  [[nodiscard]] Answer solved(double gap) const {
    auto oscillator = oscillator_;
    oscillator.gap = gap;
    const Solution solution = test::solve<FourierLipschitz>(
        test::to_problem(oscillator),
        {.common = {.harmonics = kHarmonics, .samples = kSamples, .quadrature = Quadrature::sampled},
         .c = kConstant});
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const auto& data = dynamic_cast<const FourierTrajectory&>(*solution.trajectory).data();
    return {in_basis(data.x.col(0)), in_basis(data.lambda.col(0))};
  }
};

// With c g >= |f| the mass that never moves, held by lambda = -f of both signs, solves (21) and (22) as
// printed but for the gap: an adhesive stop at zero. The corrected equation refuses it.
TEST_F(SourceContactEquation, Equation22AsPrintedIsSolvedByAMassHeldInPlace) {
  const VectorXd rest = VectorXd::Zero(2 * kHarmonics + 1);
  const VectorXd hold = -load();
  ASSERT_GE(kConstant * oscillator_.gap, oscillator_.load);
  EXPECT_LE(balance(rest, hold), 1e-13);
  EXPECT_EQ(residual(rest, hold, {.first_term_is_u = true}), 0.0);
  EXPECT_GE(residual(rest, hold, {}), 1.0);
}

// A motion that nothing touches is the answer wherever the stop is far: the printed equation refuses it.
TEST_F(SourceContactEquation, Equation22AsPrintedRefusesAMotionWithoutContact) {
  const VectorXd free = lu_solve(structure(), VectorXd(gram(kHarmonics, oscillator_.frequency, 0) * load()));
  const VectorXd none = VectorXd::Zero(2 * kHarmonics + 1);
  const double far = 2.0 * free.norm();
  EXPECT_LE(balance(free, none), 1e-13);
  EXPECT_EQ(residual(free, none, {.gap = far}), 0.0);
  EXPECT_GE(residual(free, none, {.first_term_is_u = true, .gap = far}), 0.1 * free.norm());
}

TEST_F(SourceContactEquation, Equation22AsPrintedIsNotSolvedByTheContactMotion) {
  const Answer answer = solved(oscillator_.gap);
  const double scale = answer.lambda.norm();
  EXPECT_LE(balance(answer.u, answer.lambda), 1e-10 * scale);
  EXPECT_LE(residual(answer.u, answer.lambda, {}), 1e-9 * scale);
  EXPECT_GE(residual(answer.u, answer.lambda, {.first_term_is_u = true}), 0.1 * scale);
}

// The zero in (15), (22), (23) and (26) is the gap of a scene whose stop touches at rest.
TEST_F(SourceContactEquation, EquationsWithAZeroNeedTheGap) {
  for (const double gap : {0.0, 0.2}) {
    const Answer answer = solved(gap);
    const double scale = answer.lambda.norm();
    EXPECT_LE(residual(answer.u, answer.lambda, {.gap = gap}), 1e-9 * scale);
    EXPECT_EQ(residual(answer.u, answer.lambda, {.gap = 0.0}) <= 1e-9 * scale, gap == 0.0);
  }
}

TEST_F(SourceContactEquation, Equation23IsEquation22WithBothItsMisprints) {
  const VectorXd u = VectorXd::LinSpaced(2 * kHarmonics + 1, -1.0, 2.0);
  const VectorXd lambda = VectorXd::LinSpaced(2 * kHarmonics + 1, 1.5, -1.0);
  MatrixXd rows(kSamples, 2 * kHarmonics + 1);  // (24)
  for (int i = 0; i < kSamples; ++i) rows.row(i) = phi(kHarmonics, oscillator_.frequency, (i + 1) * step());
  const Eigen::ArrayXd y = kConstant * (rows * u).array() - (rows * lambda).array();
  const VectorXd printed = step() * rows.transpose() * (rows * u + y.max(0.0).matrix());
  EXPECT_LE((printed - sum(u, lambda, {.first_term_is_u = true, .gap = 0.0})).norm(), 1e-12 * printed.norm());
}

// (55) in the Fourier functions that (49), (51) and (52) name; (48) and (50) print hat functions.
TEST_F(SourceContactEquation, Equations48And50MeanFourierFunctions) {
  const double penalty = 50.0;
  const Solution solution = test::solve<PenaltyHbm>(
      test::to_problem(oscillator_),
      {.common = {.harmonics = kHarmonics, .samples = kSamples, .quadrature = Quadrature::sampled},
       .penalty = Scaled{penalty, false}});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const VectorXd u = in_basis(dynamic_cast<const FourierTrajectory&>(*solution.trajectory).data().x.col(0));
  const auto fourier = [&](double t) { return phi(kHarmonics, oscillator_.frequency, t).dot(u); };
  // The hat functions with as many coefficients: the nodal values of the same motion, joined by lines.
  const double spacing = kSamples * step() / static_cast<double>(u.size());
  const auto hats = [&](double t) {
    const double before = std::floor(t / spacing);
    const double share = t / spacing - before;
    return (1.0 - share) * fourier(before * spacing) + share * fourier((before + 1.0) * spacing);
  };
  const auto equation55 = [&](const auto& displacement) {
    VectorXd total = structure() * u - gram(kHarmonics, oscillator_.frequency, 0) * load();
    for (int i = 1; i <= kSamples; ++i) {
      const double t = i * step();
      total += step() * phi(kHarmonics, oscillator_.frequency, t).transpose() * penalty *
               std::max(0.0, displacement(t) - oscillator_.gap);
    }
    return total.norm();
  };
  EXPECT_LE(equation55(fourier), 1e-9 * load().norm());
  EXPECT_GE(equation55(hats), 1e-2 * load().norm());
}

}  // namespace
}  // namespace signorini::source_errata_test
