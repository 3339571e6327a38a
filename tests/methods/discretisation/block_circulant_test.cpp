#include "methods/discretisation/block_circulant.hpp"

#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <numbers>
#include <random>

#include "problems/linear_algebra/singular_values.hpp"

namespace signorini::block_circulant_test {
namespace {

/// Symbol of a real operator: random complex blocks, real where a frequency stands for itself.
std::vector<Eigen::MatrixXcd> random_symbol(int harmonics, int contacts, int samples, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Eigen::MatrixXcd> symbol;
  for (int n = 0; n <= harmonics; ++n) {
    Eigen::MatrixXcd block(contacts, contacts);
    for (auto& entry : block.reshaped()) {
      const bool single = n == 0 || 2 * n == samples;
      entry = {normal(random), single ? 0.0 : normal(random)};
    }
    symbol.push_back(block);
  }
  return symbol;
}

/// The matrix by its definition: symbol of harmonic n for n and -n, `tail` beyond.
Eigen::MatrixXd direct_matrix(const std::vector<Eigen::MatrixXcd>& symbol, double tail, int samples) {
  const auto contacts = static_cast<int>(symbol.front().rows());
  const auto harmonics = static_cast<int>(symbol.size()) - 1;
  Eigen::MatrixXd matrix(samples * contacts, samples * contacts);
  for (int c = 0; c < contacts; ++c) {
    for (int d = 0; d < contacts; ++d) {
      for (int i = 0; i < samples; ++i) {
        for (int j = 0; j < samples; ++j) {
          std::complex<double> sum = 0.0;
          for (int n = -((samples - 1) / 2); n <= samples / 2; ++n) {
            const int order = std::abs(n);
            std::complex<double> value = order <= harmonics ? symbol[static_cast<std::size_t>(order)](c, d)
                                                            : std::complex<double>(c == d ? tail : 0.0);
            if (n < 0) value = std::conj(value);
            sum += value * std::polar(1.0 / samples, 2.0 * std::numbers::pi * n * (i - j) / samples);
          }
          matrix(c * samples + i, d * samples + j) = sum.real();
        }
      }
    }
  }
  return matrix;
}

struct Shape {
  int samples, contacts, harmonics;
  double tail;
};

void PrintTo(const Shape& s, std::ostream* out) {
  *out << s.samples << "x" << s.contacts << " H" << s.harmonics << " tail " << s.tail;
}

class BlockCirculantOfShape : public testing::TestWithParam<Shape> {
 protected:
  BlockCirculantOfShape()
      : symbol_(random_symbol(GetParam().harmonics, GetParam().contacts, GetParam().samples, random_)),
        matrix_(GetParam().samples, symbol_, GetParam().tail),
        direct_(direct_matrix(symbol_, GetParam().tail, GetParam().samples)) {}

  std::mt19937 random_{11};
  std::vector<Eigen::MatrixXcd> symbol_;
  BlockCirculant matrix_;
  Eigen::MatrixXd direct_;
};

TEST_P(BlockCirculantOfShape, EntriesMatchDirectSums) {
  for (int i = 0; i < matrix_.size(); ++i) {
    for (int j = 0; j < matrix_.size(); ++j)
      ASSERT_NEAR(matrix_(i, j), direct_(i, j), 1e-13 * direct_.norm());
  }
}

TEST_P(BlockCirculantOfShape, ProductMatchesDirectSums) {
  const Eigen::VectorXd z = Eigen::VectorXd::Random(matrix_.size());
  EXPECT_NEAR((matrix_ * z - direct_ * z).norm(), 0.0, 1e-12 * direct_.norm());
}

TEST_P(BlockCirculantOfShape, SolveUndoesTheProduct) {
  const Eigen::VectorXd z = Eigen::VectorXd::Random(matrix_.size());
  const Eigen::VectorXd singular = singular_vectors(direct_).values;
  const double condition = singular[0] / singular[matrix_.size() - 1];
  EXPECT_LE((matrix_.solve(direct_ * z) - z).norm(), 1e-13 * condition * z.norm());
}

TEST_P(BlockCirculantOfShape, ColumnsAddUpToTheProduct) {
  const std::array columns{0, matrix_.size() - 1, matrix_.size() / 2};
  const std::array weights{0.5, -2.0, 3.0};
  Eigen::VectorXd sum = Eigen::VectorXd::Ones(matrix_.size());
  matrix_.add_columns(columns, weights.data(), 0, sum);
  Eigen::VectorXd expected = Eigen::VectorXd::Ones(matrix_.size());
  for (std::size_t k = 0; k < columns.size(); ++k) expected += weights[k] * direct_.col(columns[k]);
  EXPECT_NEAR((sum - expected).norm(), 0.0, 1e-12 * direct_.norm());
}

TEST_P(BlockCirculantOfShape, AddsColumnsToSomeRows) {
  const std::array columns{matrix_.size() - 1, 1};
  const std::array weights{0.5, -2.0};
  for (int first = 0; first < matrix_.size(); ++first) {
    const int count = (matrix_.size() - first + 1) / 2;
    Eigen::VectorXd sum = Eigen::VectorXd::Ones(count);
    matrix_.add_columns(columns, weights.data(), first, sum);
    const Eigen::VectorXd expected = Eigen::VectorXd::Ones(count) +
                                     0.5 * direct_.col(columns[0]).segment(first, count) -
                                     2.0 * direct_.col(columns[1]).segment(first, count);
    EXPECT_NEAR((sum - expected).norm(), 0.0, 1e-12 * direct_.norm());
  }
}

TEST_P(BlockCirculantOfShape, SubmatrixPicksRowsAndColumns) {
  const std::array rows{1, 0};
  const std::array columns{matrix_.size() - 2};
  const Eigen::MatrixXd block = matrix_.submatrix(rows, columns);
  EXPECT_NEAR(block(0, 0), direct_(1, columns[0]), 1e-13 * direct_.norm());
  EXPECT_NEAR(block(1, 0), direct_(0, columns[0]), 1e-13 * direct_.norm());
}

INSTANTIATE_TEST_SUITE_P(Shapes, BlockCirculantOfShape,
                         testing::Values(Shape{8, 1, 4, 0.0}, Shape{9, 1, 4, 0.0}, Shape{12, 2, 3, 1.0},
                                         Shape{7, 3, 2, 1.0}, Shape{10, 2, 5, 0.5}, Shape{4, 1, 0, 1.0},
                                         Shape{50, 2, 20, 1.0}, Shape{67, 1, 9, 1.0}));

TEST(BlockCirculant, IsBoundedWhereItHasManyRows) {
  const std::vector<Eigen::MatrixXcd> symbol(3, Eigen::MatrixXcd::Identity(2, 2));
  EXPECT_EQ(BlockCirculant(64, symbol).column_bounds(), nullptr);
  const std::unique_ptr<const ColumnBounds> bounds = BlockCirculant(1000, symbol).column_bounds();
  ASSERT_NE(bounds, nullptr);
  EXPECT_EQ(bounds->starts().back(), 2000);
}

}  // namespace
}  // namespace signorini::block_circulant_test
