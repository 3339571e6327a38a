#include "methods/solvers/lcp/lemke_basis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/singular_values.hpp"
#include "tests/support/random_lcp.hpp"

namespace signorini::lemke_basis_test {
namespace {

constexpr int kSize = 9;

/// A basis kept twice: by LemkeBasis, and as lists from which its block is assembled anew.
class TwiceKept {
 public:
  explicit TwiceKept(std::mt19937& random)
      : a(test::random_p_matrix(kSize, random)),
        d(test::random_vector(kSize, random).cwiseAbs() + Eigen::VectorXd::Ones(kSize)),
        lcp(dense_lcp(a, Eigen::VectorXd::Zero(kSize))),
        basis(*lcp.matrix) {
    basis.set_cover(d);
  }

  [[nodiscard]] Eigen::MatrixXd whole_columns() const {
    Eigen::MatrixXd result(kSize, static_cast<Eigen::Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
      result.col(static_cast<Eigen::Index>(k)) = columns[k] < 0 ? d : Eigen::VectorXd(a.col(columns[k]));
    return result;
  }

  void expect_agreement() {
    ASSERT_EQ(basis.rows(), rows);
    const Eigen::MatrixXd g = whole_columns()(rows, Eigen::all);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(g.rows(), -1.0, 2.0);
    Eigen::VectorXd x = b;
    basis.solve(x);
    EXPECT_LE((x - lu_solve(g, b)).norm(), 1e-10 * (1.0 + x.norm()));
    Combination terms;
    basis.combine(x, terms);
    Eigen::VectorXd sum = terms.cover * d;
    for (std::size_t k = 0; k < terms.columns.size(); ++k) sum += terms.weights[k] * a.col(terms.columns[k]);
    EXPECT_LE((sum - whole_columns() * x).norm(), 1e-11 * (1.0 + x.norm()));
    const auto tau = std::find(columns.begin(), columns.end(), -1);
    EXPECT_EQ(basis.position_of_tau(), tau == columns.end() ? -1 : static_cast<int>(tau - columns.begin()));
  }

  Eigen::MatrixXd a;
  Eigen::VectorXd d;
  Lcp lcp;
  LemkeBasis basis;
  std::vector<int> rows, columns;  // -1: tau
};

TEST(LemkeBasis, SolvesWithTheBorderedBlockThroughALongSequenceOfExchanges) {
  std::mt19937 random(41);
  TwiceKept twice(random);
  twice.basis.begin_with_tau(4);
  twice.rows = {4};
  twice.columns = {-1};
  twice.expect_agreement();
  for (int step = 0; step < 200; ++step) {
    std::vector<int> outside;  // indices with neither a row nor a column
    for (int i = 0; i < kSize; ++i) {
      if (std::find(twice.rows.begin(), twice.rows.end(), i) == twice.rows.end()) outside.push_back(i);
    }
    const bool grow = !outside.empty() && (twice.rows.size() < 3 || random() % 2 == 0);
    if (grow) {
      const int index = outside[random() % outside.size()];
      twice.basis.append_z(index);
      twice.basis.append_row(index);
      twice.columns.push_back(index);
      twice.rows.push_back(index);
    } else {
      // The z of a row leaves together with that row.
      const std::size_t at = random() % twice.columns.size();
      const int index = twice.columns[at];
      if (index < 0) continue;
      EXPECT_EQ(twice.basis.remove_column(static_cast<int>(at)), index);
      twice.basis.remove_row(index);
      twice.columns.erase(twice.columns.begin() + static_cast<long>(at));
      twice.rows.erase(std::find(twice.rows.begin(), twice.rows.end(), index));
    }
    twice.expect_agreement();
  }
}

TEST(LemkeBasis, BeginsWithAnActiveSetWithoutTau) {
  std::mt19937 random(42);
  TwiceKept twice(random);
  twice.basis.begin_with({1, 3, 8});
  twice.rows = twice.columns = {1, 3, 8};
  twice.expect_agreement();
  EXPECT_EQ(twice.basis.basic_z(), twice.columns);
  const Eigen::MatrixXd g = twice.a(twice.rows, twice.rows);
  const Eigen::VectorXd singular = singular_vectors(g).values;
  const double exact = singular[0] / singular[2];
  EXPECT_GE(twice.basis.condition(), exact / 9.0);
  EXPECT_LE(twice.basis.condition(), exact * 9.0);
  // tau joins together with a new row.
  twice.basis.append_tau();
  twice.basis.append_row(0);
  twice.columns.push_back(-1);
  twice.rows.push_back(0);
  twice.expect_agreement();
}

TEST(LemkeBasis, KeepsTheOrderOfItsRows) {
  std::mt19937 random(43);
  TwiceKept twice(random);
  twice.basis.begin_with({7, 2});
  EXPECT_EQ(twice.basis.rows(), (std::vector<int>{7, 2}));
  EXPECT_EQ(twice.basis.position_of_row(2), 1);
}

using Kind = Blocking::Kind;

TEST(FindBlocking, TakesTheSmallestRatioWhereNoTwoAreNear) {
  std::mt19937 random(31);
  for (int trial = 0; trial < 500; ++trial) {
    const PathVariables value{test::random_vector(4, random).cwiseAbs(),
                              test::random_vector(6, random).cwiseAbs()};
    const PathVariables rate{test::random_vector(4, random), test::random_vector(6, random)};
    double least = std::numeric_limits<double>::infinity();
    Kind kind = Kind::none;
    int position = 0;
    const auto meet = [&](Kind of, int at, double v, double r) {
      if (r >= 0.0 || v / -r >= least) return;
      least = v / -r;
      kind = of;
      position = at;
    };
    for (int k = 0; k < 4; ++k) meet(k == 2 ? Kind::tau : Kind::z, k, value.basic[k], rate.basic[k]);
    for (int i = 0; i < 6; ++i) meet(Kind::w, i, value.w[i], rate.w[i]);
    const Blocking blocking = find_blocking(value, rate, 2, 1.0);
    ASSERT_EQ(blocking.kind, kind) << "trial " << trial;
    if (kind == Kind::none) continue;
    EXPECT_EQ(blocking.position, position);
    EXPECT_DOUBLE_EQ(blocking.step, least);
  }
}

TEST(FindBlocking, AmongTiesTakesTheLargestPivot) {
  const Eigen::Vector3d basic(1.0, 2.0, 0.5);
  const Eigen::Vector3d rates(-1.0, -2.0, -0.5);
  const Blocking blocking =
      find_blocking({basic, Eigen::Vector2d(3.0, 3.0)}, {rates, Eigen::Vector2d(-3.0, 1.0)}, -1, 1.0);
  EXPECT_EQ(blocking.kind, Kind::w);
  EXPECT_EQ(blocking.position, 0);
}

TEST(FindBlocking, PrefersALargePivotToOneThatRoundingMadeFirst) {
  // The first ratio is smaller by less than rounding, its pivot a billion times smaller.
  const double tiny = 1e-9;
  const PathVariables value{Eigen::Vector2d(tiny * (1.0 - 1e-16), 1.0), Eigen::VectorXd::Ones(1)};
  const PathVariables rate{Eigen::Vector2d(-tiny, -1.0), Eigen::VectorXd::Zero(1)};
  EXPECT_EQ(find_blocking(value, rate, -1, 1.0).position, 1);
}

TEST(FindBlocking, LetsTauGoFirstAmongTies) {
  const PathVariables value{Eigen::Vector2d(1.0, 1.0), Eigen::VectorXd::Ones(1)};
  const PathVariables rate{Eigen::Vector2d(-1.0, -1.0), Eigen::VectorXd::Constant(1, -1.0)};
  EXPECT_EQ(find_blocking(value, rate, 1, 1.0).kind, Kind::tau);
  EXPECT_EQ(find_blocking(value, rate, -1, 1.0).kind, Kind::z);
}

TEST(FindBlocking, CountsAValuePushedBelowZeroByRoundingAsZero) {
  const PathVariables value{Eigen::VectorXd::Constant(1, -1e-16), Eigen::VectorXd::Ones(1)};
  const PathVariables rate{Eigen::VectorXd::Constant(1, -1.0), Eigen::VectorXd::Zero(1)};
  const Blocking blocking = find_blocking(value, rate, -1, 1.0);
  EXPECT_EQ(blocking.kind, Kind::z);
  EXPECT_EQ(blocking.step, 0.0);
}

TEST(FindBlocking, FindsARayWhereNothingFalls) {
  const PathVariables value{Eigen::VectorXd::Ones(2), Eigen::VectorXd::Ones(2)};
  const PathVariables rate{Eigen::VectorXd::Zero(2), Eigen::VectorXd::Constant(2, 1.0)};
  EXPECT_EQ(find_blocking(value, rate, 0, 1.0).kind, Kind::none);
}

}  // namespace
}  // namespace signorini::lemke_basis_test
