#include "methods/solvers/anderson_acceleration.hpp"

#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

Eigen::VectorXd AndersonAcceleration::next(const Eigen::VectorXd& x, const Eigen::VectorXd& image) {
  const Eigen::VectorXd change = image - x;
  if (last_x_.size() > 0 && depth_ > 0) {
    x_differences_.push_front(x - last_x_);
    change_differences_.push_front(change - last_change_);
    if (static_cast<int>(x_differences_.size()) > depth_) {
      x_differences_.pop_back();
      change_differences_.pop_back();
    }
  }
  last_x_ = x;
  last_change_ = change;
  const auto columns = static_cast<Eigen::Index>(x_differences_.size());
  if (columns == 0) return image;
  Eigen::MatrixXd dX(x.size(), columns), dF(x.size(), columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    dX.col(k) = x_differences_[static_cast<std::size_t>(k)];
    dF.col(k) = change_differences_[static_cast<std::size_t>(k)];
  }
  const Eigen::VectorXd c = pivoted_least_squares(dF, change);
  return image - (dX + dF) * c;
}

}  // namespace signorini
