#pragma once
// Fixed points of a map by Anderson's acceleration.

#include <Eigen/Core>
#include <deque>

namespace signorini {

/// The next iterate of x = g(x) from the last few [walker2011]: with f_k = g(x_k) - x_k and differences dX,
/// dF of the last m iterates and of their f,
///
///     x_{k+1} = g(x_k) - (dX + dF) c,   c = argmin |f_k - dF c|.
///
/// On an affine map this is GMRES on its residual: n iterates more than the depth allows for are enough
/// wherever 1 is no eigenvalue, also where the map itself diverges. Differences that depend on newer ones to
/// rounding are left out.
class AndersonAcceleration {
 public:
  /// \param depth  m >= 0 differences at most; with 0 the next iterate is g(x)
  explicit AndersonAcceleration(int depth) : depth_(depth) {}

  /// \param x, image  an iterate and g of it, of one size
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);

 private:
  int depth_;
  Eigen::VectorXd last_x_, last_change_;
  std::deque<Eigen::VectorXd> x_differences_, change_differences_;  // newest first
};

}  // namespace signorini
