#include "methods/solvers/covering_vector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini {

Eigen::VectorXd smooth_cover(int samples, int contacts, double amplitude, double phase) {
  constexpr double kGolden = 0.6180339887498949;  // its multiples fill the unit interval without ties
  constexpr double kTieBreak = 1e-9;  // far above rounding, far below what would lengthen the path
  Eigen::VectorXd cover(samples * contacts);
  for (int i = 0; i < samples * contacts; ++i) {
    const double place = (i + 1) * kGolden;
    cover[i] = 1.0 + amplitude * std::cos(2.0 * std::numbers::pi * (i % samples) / samples + phase) +
               kTieBreak * (place - std::floor(place) - 0.5);
  }
  return cover;
}

Eigen::VectorXd cover_through(const Lcp& lcp, const Eigen::VectorXd& guess) {
  constexpr double kRoom = 1e-3;
  const double scale = lcp.offset.lpNorm<Eigen::Infinity>();
  const Eigen::VectorXd w = lcp.offset + *lcp.matrix * guess.cwiseMax(0.0);
  // d = -w makes w vanish at tau = 1; where the guess is zero, w may be positive and stays so.
  Eigen::VectorXd cover = -w;
  for (Eigen::Index i = 0; i < cover.size(); ++i) {
    if (guess[i] <= 0.0) cover[i] += std::max(w[i], kRoom * scale);
  }
  return cover;
}

}  // namespace signorini
