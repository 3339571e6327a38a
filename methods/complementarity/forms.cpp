#include "methods/complementarity/forms.hpp"

#include <cmath>
#include <vector>

#include "methods/complementarity/contact_symbol.hpp"
#include "methods/discretisation/block_circulant.hpp"
#include "methods/discretisation/free_penetration.hpp"
#include "methods/discretisation/real_fft.hpp"

namespace signorini {

Lcp projected_lcp(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
                  int samples) {
  const ContactSymbol rate(receptance, law);
  std::vector<Eigen::MatrixXcd> symbol;
  symbol.reserve(receptance.receptance.size());
  // w = z - y, and y answers to lambda = -P z by B_n: w_n = (1 + B_n) z_n, but w_n = z_n beyond H, where P
  // leaves nothing of z.
  for (int n = 0; n <= rate.harmonics(); ++n) {
    symbol.push_back(rate.block(n));
    symbol.back().diagonal().array() += 1.0;
  }
  return periodic_lcp(BlockCirculant(samples, symbol, 1.0),
                      -free_penetration(receptance.free_response, gap, rate.root(), samples));
}

Eigen::MatrixXcd force_coefficients(const ProjectedLaw& law, const Eigen::VectorXd& z_scaled, int samples,
                                    int harmonics) {
  RealFft fft(samples);
  Eigen::VectorXcd spectrum(fft.coefficients());
  Eigen::MatrixXcd lambda(harmonics + 1, law.constant.size());
  for (Eigen::Index c = 0; c < lambda.cols(); ++c) {
    fft.forward(z_scaled.segment(c * samples, samples), spectrum);
    lambda.col(c) = -std::sqrt(law.constant[c]) * spectrum.head(lambda.rows());
  }
  return lambda;
}

}  // namespace signorini
