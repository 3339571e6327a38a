#pragma once
// Lyapunov exponents of a map from its derivatives.

#include <Eigen/Core>
#include <vector>

#include "harness/statistics.hpp"

namespace signorini {

/// The growth of small deviations under a map whose derivative is known at each of its steps: an orthonormal
/// frame is carried along and made orthonormal again after each step, D_n Q_(n-1) = Q_n R_n, and the exponent
/// number i is the mean of log |R_n(i, i)| per step [benettin1980].
class LyapunovSum {
 public:
  /// \param size   of the state; the frame has at most as many directions
  /// \param count  exponents that are wanted, the largest ones
  LyapunovSum(Eigen::Index size, Eigen::Index count);

  /// Q, size x count.
  [[nodiscard]] const Eigen::MatrixXd& frame() const { return frame_; }
  /// One step of the map. \param image  D Q, of the step's derivative and the frame; one that is not finite,
  /// as at a grazing impact, is left out
  void take(const Eigen::MatrixXd& image);
  /// Steps taken.
  [[nodiscard]] std::size_t steps() const { return logs_.front().size(); }
  /// The exponents per step, largest first, by batch means over all steps after the first tenth (of fewer
  /// than a hundred ten, but not more than half), in which the frame turns into the directions of growth;
  /// minus infinity where a step takes a direction to zero.
  [[nodiscard]] std::vector<Estimate> exponents() const;
  /// Logarithm of the largest growth of the first direction from one of these steps to a later one: bounded
  /// where the exponent is 0, as the logarithm of the steps where neighbours drift apart evenly.
  [[nodiscard]] double largest_growth() const;

 private:
  Eigen::MatrixXd frame_;
  std::vector<std::vector<double>> logs_;  // exponent by exponent
};

}  // namespace signorini
