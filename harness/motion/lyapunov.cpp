#include "harness/motion/lyapunov.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

namespace {

/// What follows the first tenth, or of few steps ten, in which directions turn.
std::span<const double> once_turned(std::span<const double> logs) {
  constexpr std::size_t kFew = 10;
  return logs.subspan(std::max(logs.size() / 10, std::min(kFew, logs.size() / 2)));
}

}  // namespace

LyapunovSum::LyapunovSum(Eigen::Index size, Eigen::Index count)
    : frame_(Eigen::MatrixXd::Identity(size, std::min(size, count))),
      logs_(static_cast<std::size_t>(frame_.cols())) {}

void LyapunovSum::take(const Eigen::MatrixXd& image) {
  if (!image.allFinite()) return;
  const QrFactors factors = householder_qr(image);
  for (Eigen::Index i = 0; i < frame_.cols(); ++i)
    logs_[static_cast<std::size_t>(i)].push_back(std::log(std::abs(factors.R(i, i))));
  frame_ = factors.Q.leftCols(frame_.cols());
}

std::vector<Estimate> LyapunovSum::exponents() const {
  std::vector<Estimate> all;
  for (const std::vector<double>& logs : logs_) {
    const std::span<const double> turned = once_turned(logs);
    all.push_back(batch_mean({turned.begin(), turned.end()}));
  }
  std::ranges::sort(all, [](const Estimate& a, const Estimate& b) { return a.value > b.value; });
  return all;
}

double LyapunovSum::largest_growth() const {
  double now = 0.0, largest = 0.0;  // from the step since which the direction is longest
  for (const double log : once_turned(logs_.front())) {
    now = std::max(0.0, now + log);
    largest = std::max(largest, now);
  }
  return largest;
}

}  // namespace signorini
