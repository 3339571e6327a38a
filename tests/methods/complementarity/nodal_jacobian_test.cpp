#include "methods/complementarity/nodal_jacobian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/discretisation/fourier_series.hpp"

namespace signorini::nodal_jacobian_test {
namespace {

using Complex = std::complex<double>;
using Intervals = std::vector<std::vector<ContactInterval>>;

/// Three masses, the middle one coupled to the others, their stops rigid.
ContactSymbol three_masses(int harmonics) {
  ContactReceptance receptance;
  receptance.period = 1.0;
  for (int n = 0; n <= harmonics; ++n) {
    const double w = 1.3 * n;
    const Complex own(2.5 - w * w, 0.1 * w);
    Eigen::Matrix3cd Z;
    Z << own, -0.5, 0.0, -0.5, 2.0 * own, -0.7, 0.0, -0.7, own;
    receptance.receptance.emplace_back(Z.inverse());
  }
  receptance.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, 3);
  const double c = 4.0 * std::pow(1.3 * harmonics, 2);
  return {receptance, {Eigen::Vector3d(c, 2.0 * c, 0.5 * c), Eigen::Vector3d(1.0, 1.0, 0.3)}};
}

Eigen::VectorXd some_vector(int size) {
  Eigen::VectorXd v(size);
  for (int i = 0; i < size; ++i) v[i] = std::sin(1.0 + i * i);
  return v;
}

/// v + P chi B v by the spectrum of the indicator function.
Eigen::VectorXd product(const ContactSymbol& symbol, const Intervals& intervals, const Eigen::VectorXd& v) {
  Eigen::MatrixXcd rate = symbol.rate(v);
  for (Eigen::Index c = 0; c < rate.cols(); ++c) {
    rate.col(c) =
        ContactIndicator(intervals[static_cast<std::size_t>(c)], symbol.harmonics()).restrict(rate.col(c));
  }
  return v + pack_harmonics(rate);
}

TEST(NodalJacobian, InvertsTheJacobianOfShortLongAndPermanentContact) {
  for (const int harmonics : {3, 40, 160}) {
    const ContactSymbol symbol = three_masses(harmonics);
    const double impact = 0.8 / harmonics;
    for (const Intervals& intervals :
         {Intervals{{{0.1, 0.1 + impact}}, {}, {}},
          Intervals{{{0.1, 0.1 + impact}}, {{0.3, 0.6}}, {{0.6, 0.65}, {0.9, 1.2}}},
          Intervals{{}, {{0.0, 1.0}}, {{0.2, 0.2 + impact}}}}) {
      std::vector<ContactNodes> nodes;
      for (const auto& of_contact : intervals) nodes.push_back(nodes_on(of_contact, harmonics));
      const Eigen::VectorXd r = some_vector(symbol.unknowns());
      const KrylovSolve solve = NodalJacobian(symbol, nodes).solve(r);
      ASSERT_EQ(solve.x.size(), r.size());
      // What rounding leaves of the parts that cancel.
      const double scale = r.norm() + pack_harmonics(symbol.rate(solve.x)).norm();
      EXPECT_LT((product(symbol, intervals, solve.x) - r).norm(), 1e-12 * scale) << harmonics;
      ASSERT_TRUE(solve.condition);
      EXPECT_GE(*solve.condition, 1.0);
    }
  }
}

TEST(NodalJacobian, InvertsASumOverSamplesThatFoldsProducts) {
  constexpr int kHarmonics = 4;
  constexpr int kSamples = 2 * kHarmonics + 1;
  const ContactSymbol symbol = three_masses(kHarmonics);
  const Intervals intervals{{{0.5 / kSamples, 3.5 / kSamples}}, {}, {{4.5 / kSamples, 5.5 / kSamples}}};
  std::vector<ContactNodes> nodes;
  for (const auto& of_contact : intervals) nodes.push_back(samples_on(of_contact, kSamples));
  const Eigen::VectorXd r = some_vector(symbol.unknowns());
  const Eigen::VectorXd v = NodalJacobian(symbol, nodes).solve(r).x;
  Eigen::MatrixXd signal = sample_series(symbol.rate(v), kSamples);
  for (int i = 0; i < kSamples; ++i) {
    if (i < 1 || i > 3) signal(i, 0) = 0.0;
    signal(i, 1) = 0.0;
    if (i != 5) signal(i, 2) = 0.0;
  }
  Eigen::MatrixXcd pressed = Eigen::MatrixXcd::Zero(kHarmonics + 1, 3);
  for (int n = 0; n <= kHarmonics; ++n) {
    for (int i = 0; i < kSamples; ++i)
      pressed.row(n) +=
          signal.row(i) / kSamples * std::polar(1.0, -2.0 * std::numbers::pi * n * i / kSamples);
  }
  EXPECT_LT((v + pack_harmonics(pressed) - r).norm(), 1e-12 * r.norm());
}

TEST(NodalJacobian, IsOneWhereNothingTouches) {
  const ContactSymbol symbol = three_masses(5);
  const Eigen::VectorXd r = some_vector(symbol.unknowns());
  const KrylovSolve solve = NodalJacobian(symbol, std::vector<ContactNodes>(3)).solve(r);
  EXPECT_EQ(solve.x, r);
  EXPECT_FALSE(solve.condition);
}

TEST(NodalJacobian, HasNoSolutionForWhatIsNoNumber) {
  const ContactSymbol symbol = three_masses(5);
  Eigen::VectorXd r = some_vector(symbol.unknowns());
  r[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(NodalJacobian(symbol, {nodes_on(0.2, 0.4, 5), {}, {}}).solve(r).x.size(), 0);
}

}  // namespace
}  // namespace signorini::nodal_jacobian_test
