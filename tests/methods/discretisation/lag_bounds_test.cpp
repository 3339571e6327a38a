#include "methods/discretisation/lag_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace signorini::lag_bounds_test {
namespace {

/// A column of a matrix of lags, by its definition.
class Lags {
 public:
  Lags(int samples, int contacts, std::mt19937& random) : samples_(samples), contacts_(contacts) {
    std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
    table.resize(2 * samples, contacts * contacts);
    for (auto column : table.colwise()) {
      const double shift = phase(random);
      for (Eigen::Index k = 0; k < 2 * samples; ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / samples;
        column[k] = std::cos(angle + shift) + 0.3 * std::sin(3.0 * angle - shift);
      }
      column[0] += 1.0;  // a peak at lag zero, as that of a contact's own force
      column[samples] += 1.0;
    }
  }

  [[nodiscard]] double entry(int row, int column) const {
    const int lag = row % samples_ - column % samples_ + samples_;
    return table(lag, row / samples_ * contacts_ + column / samples_);
  }

  /// The largest |sum_k weights[k] A(row, columns[k])| of the rows first..last-1.
  [[nodiscard]] double largest(const std::vector<int>& columns, const Eigen::VectorXd& weights, int first,
                               int last) const {
    double result = 0.0;
    for (int row = first; row < last; ++row) {
      double sum = 0.0;
      for (std::size_t k = 0; k < columns.size(); ++k)
        sum += weights[static_cast<Eigen::Index>(k)] * entry(row, columns[k]);
      result = std::max(result, std::abs(sum));
    }
    return result;
  }

  Eigen::MatrixXd table;

 private:
  int samples_, contacts_;
};

Eigen::VectorXd bound_of(const LagBounds& bounds, const std::vector<int>& columns,
                         const Eigen::VectorXd& weights) {
  Eigen::VectorXd bound = Eigen::VectorXd::Zero(std::ssize(bounds.starts()) - 1);
  bounds.add(columns, weights.data(), bound);
  return bound;
}

TEST(LagBounds, DivideTheRowsOfEachContact) {
  std::mt19937 random(1);
  const LagBounds bounds(50, 2, Lags(50, 2, random).table);
  EXPECT_EQ(bounds.starts(), (std::vector<int>{0, 16, 32, 48, 50, 66, 82, 98, 100}));
}

TEST(LagBounds, HoldForAnyCombination) {
  std::mt19937 random(20261125);
  std::normal_distribution<double> normal;
  for (const int samples : {16, 17, 31, 50, 64, 67, 190, 1030}) {
    for (const int contacts : {1, 2}) {
      const Lags lags(samples, contacts, random);
      const LagBounds bounds(samples, contacts, lags.table);
      for (int trial = 0; trial < 20; ++trial) {
        std::vector<int> columns;
        // Neighbours, columns apart, and both ends of the period.
        for (int k = 0; k < 1 + trial % 7; ++k) {
          const auto any = static_cast<int>(random() % static_cast<unsigned>(samples * contacts));
          const bool beside = k > 0 && trial % 2 == 0;
          columns.push_back(beside ? (columns.back() + 1 + k) % (samples * contacts) : any);
        }
        std::ranges::sort(columns);
        columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
        std::ranges::shuffle(columns, random);
        Eigen::VectorXd weights(std::ssize(columns));
        for (double& weight : weights) weight = normal(random);
        const Eigen::VectorXd bound = bound_of(bounds, columns, weights);
        for (Eigen::Index s = 0; s < bound.size(); ++s) {
          const auto place = static_cast<std::size_t>(s);
          const double largest =
              lags.largest(columns, weights, bounds.starts()[place], bounds.starts()[place + 1]);
          EXPECT_GE(bound[s], largest * (1.0 - 1e-12)) << samples << " nodes, segment " << s;
        }
      }
    }
  }
}

// What they are for: an impulse that moves to the next node is felt as a difference elsewhere.
TEST(LagBounds, OfNeighboursWithOppositeWeightsAreSmallAwayFromThem) {
  constexpr int kNodes = 4096;
  std::mt19937 random(3);
  const Lags lags(kNodes, 1, random);
  const LagBounds bounds(kNodes, 1, lags.table);
  const Eigen::VectorXd bound = bound_of(bounds, {1000, 1001}, Eigen::Vector2d(1.0, -1.0));
  const double step = 2.0 * std::numbers::pi / kNodes * (1.0 + 3.0 * 0.3);  // of a lag to the next, at most
  int far = 0;
  for (Eigen::Index s = 0; s < bound.size(); ++s) {
    const auto place = static_cast<std::size_t>(s);
    if (std::abs(bounds.starts()[place] - 1000) < 200) continue;
    EXPECT_LE(bound[s], step);
    ++far;
  }
  EXPECT_GE(far, 50);
}

}  // namespace
}  // namespace signorini::lag_bounds_test
