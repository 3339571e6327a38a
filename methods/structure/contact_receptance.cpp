#include "methods/structure/contact_receptance.hpp"

#include <cstddef>

namespace signorini {

Eigen::MatrixXcd contact_motion(const ContactReceptance& receptance, const Eigen::MatrixXcd& lambda) {
  Eigen::MatrixXcd x = receptance.free_response;
  for (Eigen::Index n = 0; n < x.rows(); ++n)
    x.row(n) += (receptance.receptance[static_cast<std::size_t>(n)] * lambda.row(n).transpose()).transpose();
  return x;
}

}  // namespace signorini
