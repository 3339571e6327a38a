#include "methods/complementarity/nodal_jacobian.hpp"

#include <cstddef>
#include <numbers>
#include <utility>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/solvers/condition_estimate.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

/// sqrt(w_q) (sqrt e_n cos 2 pi n t_q | sqrt e_n sin 2 pi n t_q), nodes x 2 (H+1).
Eigen::MatrixXd weighted_waves(const ContactNodes& nodes, int harmonics) {
  const Eigen::MatrixXcd phases = phases_at(nodes.time, harmonics);
  const Eigen::ArrayXd root = nodes.weight.array().sqrt();
  Eigen::MatrixXd waves(phases.rows(), 2 * phases.cols());
  for (Eigen::Index n = 0; n < phases.cols(); ++n) {
    const double both = n == 0 ? 1.0 : std::numbers::sqrt2;  // n and -n
    waves.col(n) = both * root * phases.col(n).real().array();
    waves.col(phases.cols() + n) = both * root * phases.col(n).imag().array();
  }
  return waves;
}

/// Coefficients n = 0..H as factors of the waves, whose sum with them is the function at the nodes; 2 (H+1).
Eigen::VectorXd scaled_parts(const Eigen::VectorXcd& coefficients) {
  const Eigen::Index count = coefficients.size();
  Eigen::VectorXd parts(2 * count);
  parts.head(count) = coefficients.real();
  parts.tail(count) = -coefficients.imag();
  parts.segment(1, count - 1) *= std::numbers::sqrt2;
  parts.tail(count - 1) *= std::numbers::sqrt2;
  parts[count] = 0.0;  // a constant is real
  return parts;
}

}  // namespace

NodalJacobian::NodalJacobian(const ContactSymbol& symbol, const std::vector<ContactNodes>& nodes)
    : symbol_(symbol), touching_(touching(nodes, symbol.harmonics())), factors_(matrix()), lu_(factors_) {}

std::vector<NodalJacobian::Touching> NodalJacobian::touching(const std::vector<ContactNodes>& nodes,
                                                             int harmonics) {
  std::vector<Touching> all;
  Eigen::Index first = 0;
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    if (nodes[c].time.size() == 0) continue;
    all.push_back({static_cast<Eigen::Index>(c), first, weighted_waves(nodes[c], harmonics)});
    first += nodes[c].time.size();
  }
  return all;
}

Eigen::Index NodalJacobian::count() const {
  return touching_.empty() ? 0 : touching_.back().first + touching_.back().waves.rows();
}

// A force at node p that pushes with e^{-2 pi i n t_p} answers at node q with B_n e^{2 pi i n (t_q - t_p)}:
// its real part is (cos_q, sin_q) times the vector below.
Eigen::MatrixXd NodalJacobian::answers_of(const Touching& row) const {
  const Eigen::Index harmonics = symbol_.harmonics() + 1;
  Eigen::MatrixXd answers(count(), 2 * harmonics);
  for (const Touching& column : touching_) {
    auto block = answers.middleRows(column.first, column.waves.rows());
    for (Eigen::Index n = 0; n < harmonics; ++n) {
      const std::complex<double> b = symbol_.block(n)(row.contact, column.contact);
      const auto cosine = column.waves.col(n);
      const auto sine = column.waves.col(harmonics + n);
      block.col(n) = b.real() * cosine + b.imag() * sine;
      block.col(harmonics + n) = b.real() * sine - b.imag() * cosine;
    }
  }
  return answers;
}

Eigen::MatrixXd NodalJacobian::matrix() const {
  Eigen::MatrixXd matrix(count(), count());
  for (const Touching& row : touching_)
    set_product_by_transposed(matrix.middleRows(row.first, row.waves.rows()), row.waves, answers_of(row));
  matrix.diagonal().array() += 1.0;
  return matrix;
}

KrylovSolve NodalJacobian::solve(const Eigen::VectorXd& r) const {
  if (!r.allFinite()) return {};
  if (touching_.empty()) return {.x = r, .condition = std::nullopt};
  const Eigen::MatrixXcd rate = symbol_.rate(r);
  Eigen::VectorXd load(count());
  for (const Touching& one : touching_)
    load.segment(one.first, one.waves.rows()) =
        negative_image(one.waves, scaled_parts(rate.col(one.contact)));
  const Eigen::VectorXd pressed = lu_.solve(load);
  Eigen::VectorXd v = r;
  const Eigen::Index harmonics = symbol_.harmonics();
  for (const Touching& one : touching_) {
    // The force of the nodes, packed: its imaginary parts are those of e^{-2 pi i n t}.
    const Eigen::VectorXd waves =
        image_by_transposed(one.waves, pressed.segment(one.first, one.waves.rows()));
    auto packed = v.segment(one.contact * (2 * harmonics + 1), 2 * harmonics + 1);
    packed[0] += waves[0];
    for (Eigen::Index n = 1; n <= harmonics; ++n) {
      packed[2 * n - 1] += waves[n];
      packed[2 * n] -= waves[harmonics + 1 + n];
    }
  }
  if (!v.allFinite()) return {};
  return {.x = std::move(v), .condition = condition_from(lu_.reciprocal_condition())};
}

}  // namespace signorini
