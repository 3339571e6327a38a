#include "methods/discretisation/free_penetration.hpp"

#include "methods/discretisation/real_fft.hpp"

namespace signorini {

Eigen::VectorXd free_penetration(const Eigen::MatrixXcd& free_response, const Eigen::VectorXd& gap,
                                 const Eigen::VectorXd& scale, int samples) {
  Eigen::VectorXd overlap(samples * free_response.cols());
  RealFft fft(samples);
  for (Eigen::Index c = 0; c < free_response.cols(); ++c) {
    auto part = overlap.segment(c * samples, samples);
    fft.inverse(free_response.col(c), part);
    part = scale[c] * (part.array() - gap[c]);
  }
  return overlap;
}

}  // namespace signorini
