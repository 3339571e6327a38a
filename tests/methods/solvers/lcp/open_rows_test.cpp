#include "methods/solvers/lcp/open_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "methods/discretisation/block_circulant.hpp"
#include "tests/support/random_lcp.hpp"

namespace signorini::open_rows_test {
namespace {

constexpr int kNodes = 190;  // no power of two: the last segment of a contact is shorter
constexpr int kContacts = 3;
constexpr int kSize = kNodes * kContacts;

/// A problem whose columns fall with distance in time, as receptances do, and large offsets but on a few
/// rows.
Lcp problem_with_few_near_rows(std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Eigen::MatrixXcd> symbol;
  for (int n = 0; n <= 20; ++n) {
    Eigen::MatrixXcd block(kContacts, kContacts);
    for (auto& entry : block.reshaped()) entry = {normal(random), n == 0 ? 0.0 : normal(random)};
    symbol.emplace_back(block / (1.0 + n * n));
  }
  Eigen::VectorXd offset = 30.0 * Eigen::VectorXd::Ones(kSize) + test::random_vector(kSize, random);
  for (int k = 0; k < 6; ++k) offset[static_cast<Eigen::Index>(random() % kSize)] *= 0.01;
  return periodic_lcp(BlockCirculant(kNodes, symbol, 1.0), offset);
}

/// A matrix that counts the rows which are asked of it.
class CountedRows final : public LcpMatrix {
 public:
  CountedRows(std::shared_ptr<const LcpMatrix> matrix, long& rows)
      : matrix_(std::move(matrix)), rows_(rows) {}

  [[nodiscard]] int size() const override { return matrix_->size(); }
  void add_columns(std::span<const int> columns, const double* weights, int first,
                   Eigen::Ref<Eigen::VectorXd> out) const override {
    rows_ += out.size();
    matrix_->add_columns(columns, weights, first, out);
  }
  [[nodiscard]] std::unique_ptr<const ColumnBounds> column_bounds() const override {
    return matrix_->column_bounds();
  }
  [[nodiscard]] Eigen::MatrixXd submatrix(std::span<const int> rows,
                                          std::span<const int> columns) const override {
    return matrix_->submatrix(rows, columns);
  }
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& z) const override { return *matrix_ * z; }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const override { return matrix_->solve(b); }

 private:
  std::shared_ptr<const LcpMatrix> matrix_;
  long& rows_;
};

/// Open rows beside what they stand for: all of w and its rate, computed from the whole matrix at each
/// vertex.
class BesideAllRows {
 public:
  explicit BesideAllRows(unsigned seed)
      : random(seed),
        lcp(problem_with_few_near_rows(random)),
        cover(Eigen::VectorXd::Ones(kSize) + 0.1 * test::random_vector(kSize, random)),
        rows(counted(), cover) {}

  const Lcp& counted() {
    lcp.matrix = std::make_shared<CountedRows>(lcp.matrix, asked);
    return lcp;
  }

  [[nodiscard]] Eigen::VectorXd whole(const Combination& terms) const {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(kSize);
    for (std::size_t k = 0; k < terms.columns.size(); ++k) z[terms.columns[k]] += terms.weights[k];
    return terms.cover * cover + *lcp.matrix * z;
  }

  /// A search at this vertex, and a step as long as the rows allow.
  void walk(const Combination& rate, int rising, double longest) {
    const Eigen::VectorXd w = lcp.offset + whole(value);
    Eigen::VectorXd w_rate = whole(rate);
    for (const int row : held) w_rate[row] = row == rising ? 1.0 : 0.0;
    double first = longest;
    for (int row = 0; row < kSize; ++row) {
      if (w_rate[row] < 0.0) first = std::min(first, std::max(w[row], 0.0) / -w_rate[row]);
    }
    rows.find_falling(value, rate, rising, longest);
    const std::vector<int>& falling = rows.falling();
    for (std::size_t k = 0; k < falling.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      EXPECT_NEAR(rows.value()[at], w[falling[k]], 1e-10 * w.norm());
      EXPECT_NEAR(rows.rate()[at], w_rate[falling[k]], 1e-10 * w_rate.norm());
      EXPECT_LT(rows.rate()[at], 0.0);
    }
    ++searches;
    for (int row = 0; row < kSize; ++row) {
      const bool closes_first = w_rate[row] < 0.0 && std::max(w[row], 0.0) <= first * -w_rate[row];
      EXPECT_TRUE(!closes_first || std::count(falling.begin(), falling.end(), row) == 1) << "row " << row;
    }
    const double step = std::min(first, longest);
    rows.advance(step);
    add(rate, step);
  }

  /// The basic variables are others: a jump of all w.
  void correct(int column) {
    const Combination jump{{column}, {-2.0}, 0.05};
    rows.correct_values(jump);
    add(jump, 1.0);
  }

  /// The basic variables a step further.
  void add(const Combination& rate, double step) {
    value.cover += step * rate.cover;
    for (std::size_t k = 0; k < rate.columns.size(); ++k) {
      value.columns.push_back(rate.columns[k]);
      value.weights.push_back(step * rate.weights[k]);
    }
  }

  long asked = 0, searches = 0;
  std::mt19937 random;
  Lcp lcp;
  Eigen::VectorXd cover;
  OpenRows rows;
  Combination value;
  std::vector<int> held;
};

class OpenRowsPerUnit : public testing::TestWithParam<double> {};

// Whatever the unit of the path: rates so much larger, steps so much shorter.
TEST_P(OpenRowsPerUnit, MissNoRowThatClosesFirst) {
  const double unit = GetParam();
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    BesideAllRows beside(seed);
    for (int step = 0; step < 60; ++step) {
      // Rows come and go, as on a path.
      const int row = static_cast<int>(beside.random() % kSize);
      const auto place = std::find(beside.held.begin(), beside.held.end(), row);
      if (place == beside.held.end() && beside.held.size() < 5) {
        beside.held.push_back(row);
        beside.rows.hold(row);
      } else if (!beside.held.empty() && step % 3 == 0) {
        const int first = beside.held.front();
        beside.rows.release(first, (beside.lcp.offset + beside.whole(beside.value))[first]);
        beside.held.erase(beside.held.begin());
      }
      const Eigen::VectorXd weights = test::random_vector(3, beside.random);
      const Combination rate{{row, (row + 200) % kSize, (row + 400) % kSize},
                             {unit * weights[0], unit * weights[1], unit * weights[2]},
                             unit * (step % 2 == 0 ? -0.2 : 0.1)};
      const int rising = step % 5 == 0 && !beside.held.empty() ? beside.held.back() : -1;
      if (step % 7 == 0) beside.correct(row);
      if (step % 20 == 19) beside.rows.forget_values();
      beside.walk(rate, rising, 2.0 / unit);
    }
    // What the bounds are for: most rows are seldom asked.
    EXPECT_LE(beside.asked, beside.searches * kSize / 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Units, OpenRowsPerUnit, testing::Values(1.0, 1024.0));

TEST(OpenRows, AskAllRowsOnceBeforeAnythingIsKnown) {
  BesideAllRows beside(5);
  beside.rows.find_falling({}, {{}, {}, -1.0}, -1, kInfinity);
  EXPECT_GE(beside.asked, kSize);
  Eigen::Index first = 0;
  (beside.lcp.offset.array() / beside.cover.array()).minCoeff(&first);
  EXPECT_EQ(beside.rows.falling(), std::vector<int>{static_cast<int>(first)});
}

TEST(OpenRows, FindNoneWhereNothingFalls) {
  BesideAllRows beside(6);
  beside.rows.find_falling({}, {{}, {}, 1.0}, -1, kInfinity);
  EXPECT_TRUE(beside.rows.falling().empty());
  beside.rows.find_falling({}, {}, -1, kInfinity);
  EXPECT_TRUE(beside.rows.falling().empty());
}

// Row 1 falls by what rounding leaves of its rate, beside row 2; its exchange would be of a pivot of rounding
// size.
TEST(OpenRows, LeaveOutWhatHardlyFallsBesideTheFastest) {
  const Eigen::Matrix3d matrix{{1.0, 0.0, 0.0}, {0.0, 1.0, -1e-9}, {0.0, 0.0, -1e9}};
  const Lcp lcp = dense_lcp(matrix, Eigen::Vector3d(1.0, 0.0, 1.0));
  OpenRows rows(lcp, Eigen::Vector3d::Ones());
  rows.find_falling({{2}, {-1e-4}, 0.0}, {{2}, {1.0}, 0.0}, -1, 1.0);
  EXPECT_EQ(rows.falling(), std::vector<int>{2});
}

TEST(OpenRows, ComeBackFromASegmentThatWasHeldAltogether) {
  BesideAllRows beside(8);
  const std::vector<int> starts = beside.lcp.matrix->column_bounds()->starts();
  for (int row = starts[1]; row < starts[2]; ++row) {
    beside.held.push_back(row);
    beside.rows.hold(row);
  }
  for (int step = 0; step < 5; ++step) beside.walk({{step}, {1.0}, -0.1}, -1, 1.0);
  const int row = starts[1] + 3;
  beside.held.erase(std::ranges::find(beside.held, row));
  beside.rows.release(row, (beside.lcp.offset + beside.whole(beside.value))[row]);
  for (int step = 0; step < 5; ++step) beside.walk({{300 + step}, {1.0}, -0.5}, -1, 5.0);
}

TEST(OpenRows, GiveARisingRowTheRateOne) {
  BesideAllRows beside(7);
  beside.rows.hold(11);
  beside.held = {11};
  beside.walk({{11}, {1.0}, -1.0}, 11, 1.0);
  beside.rows.release(11, (beside.lcp.offset + beside.whole(beside.value))[11]);
  beside.held.clear();
  beside.walk({{40}, {-1.0}, -1.0}, -1, 1.0);
}

}  // namespace
}  // namespace signorini::open_rows_test
