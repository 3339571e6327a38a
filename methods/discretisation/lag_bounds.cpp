#include "methods/discretisation/lag_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace signorini {

namespace {

/// A power of two near sqrt(N), so that there are as many segments as rows in one.
int segment_length(int samples) {
  constexpr int kShortest = 16;
  int length = kShortest;
  while (4L * length * length <= samples) length *= 2;
  return length;
}

std::vector<int> segment_starts(int samples, int contacts) {
  std::vector<int> starts;
  for (int c = 0; c < contacts; ++c) {
    for (int first = 0; first < samples; first += segment_length(samples))
      starts.push_back(c * samples + first);
  }
  starts.push_back(contacts * samples);
  return starts;
}

/// Row p: the largest of `count` rows from p on, as far as there are any.
Eigen::MatrixXd largest_of_next(const Eigen::MatrixXd& rows, int count) {
  Eigen::MatrixXd result = rows;
  for (int k = 1; k < count && k < rows.rows(); ++k) {
    const Eigen::Index kept = rows.rows() - k;
    result.topRows(kept) = result.topRows(kept).cwiseMax(rows.bottomRows(kept));
  }
  return result;
}

}  // namespace

LagBounds::LagBounds(int samples, int contacts, const Eigen::MatrixXd& lags)
    : ColumnBounds(segment_starts(samples, contacts)),
      samples_(samples),
      contacts_(contacts),
      length_(segment_length(samples)),
      segments_((samples + length_ - 1) / length_) {
  // Pieces of both periods of the lags, and two beyond, which differences may reach.
  const Eigen::Index pieces = (lags.rows() + length_ - 1) / length_ + 2;
  largest_.setZero(pieces, lags.cols());
  steepest_.setZero(pieces, lags.cols());
  for (Eigen::Index pair = 0; pair < lags.cols(); ++pair) {
    const auto period = lags.col(pair).head(samples);
    for (Eigen::Index piece = 0; piece < pieces; ++piece) {
      double& entry = largest_(piece, pair);
      double& step = steepest_(piece, pair);
      Eigen::Index lag = piece * length_ % samples;
      for (int k = 0; k < length_; ++k) {
        const Eigen::Index next = lag + 1 == samples ? 0 : lag + 1;
        entry = std::max(entry, std::abs(period[lag]));
        step = std::max(step, std::abs(period[next] - period[lag]));
        lag = next;
      }
    }
  }
  largest_ = largest_of_next(largest_, 2);
  steepest_ = largest_of_next(steepest_, 3);
}

void LagBounds::add(std::span<const int> columns, const double* weights, Eigen::VectorXd& out) const {
  std::vector<std::size_t> order(columns.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return columns[k]; });
  double tail = 0.0;  // V_k
  for (std::size_t k = order.size(); k-- > 0;) {
    const int column = columns[order[k]];
    tail += weights[order[k]];
    const int before = k > 0 ? columns[order[k - 1]] : -1;
    if (k > 0 && before / samples_ == column / samples_ && column - before <= length_) {
      add_difference(column, before, std::abs(tail), out);
    } else {
      add_column(column, std::abs(tail), out);
      tail = 0.0;
    }
  }
}

void LagBounds::add_column(int column, double weight, Eigen::VectorXd& out) const {
  const int piece = first_piece(column);
  for (int row = 0; row < contacts_; ++row) {
    const auto bound = largest_.col(row * contacts_ + column / samples_);
    out.segment(row * segments_, segments_) += weight * bound.segment(piece, segments_);
  }
}

/// Of A_column - A_before.
void LagBounds::add_difference(int column, int before, double weight, Eigen::VectorXd& out) const {
  const double distance = column - before;
  const int here = first_piece(column);
  const int there = first_piece(before);
  for (int row = 0; row < contacts_; ++row) {
    const Eigen::Index pair = row * contacts_ + column / samples_;
    const auto steps = steepest_.col(pair).segment(here, segments_);
    const auto both =
        largest_.col(pair).segment(here, segments_) + largest_.col(pair).segment(there, segments_);
    out.segment(row * segments_, segments_) += weight * (distance * steps).cwiseMin(both);
  }
}

}  // namespace signorini
