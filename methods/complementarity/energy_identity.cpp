#include "methods/complementarity/energy_identity.hpp"

#include <cmath>
#include <complex>

namespace signorini {

double net_work_ratio(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& lambda) {
  double net = 0.0;
  double exchanged = 0.0;
  for (Eigen::Index n = 1; n < x.rows(); ++n) {
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      // Re(conj(lambda) i x) = Im(conj(x) lambda); 2 T w is common to both sums.
      const double order = static_cast<double>(n);
      net += order * std::imag(std::conj(x(n, c)) * lambda(n, c));
      exchanged += order * std::abs(x(n, c)) * std::abs(lambda(n, c));
    }
  }
  return exchanged > 0.0 ? std::abs(net) / exchanged : 0.0;
}

}  // namespace signorini
