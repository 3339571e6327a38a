#include "harness/motion/lyapunov.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

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
    const std::size_t turning = logs.size() / 10;
    all.push_back(batch_mean({logs.begin() + static_cast<std::ptrdiff_t>(turning), logs.end()}));
  }
  std::ranges::sort(all, [](const Estimate& a, const Estimate& b) { return a.value > b.value; });
  return all;
}

}  // namespace signorini
