#include "problems/linear_algebra/general_eigen.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "problems/linear_algebra/products.hpp"

namespace signorini {

using Complex = std::complex<double>;

namespace {

GeneralEigen general_pairs(const Eigen::MatrixXd& A, bool with_vectors) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!A.allFinite()) return {};
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A, with_vectors);
  if (solver.info() != Eigen::Success) return {};
  GeneralEigen found{.converged = true, .values = solver.eigenvalues(), .vectors = {}};
  if (with_vectors) found.vectors = solver.eigenvectors();
  return found;
}

// Orthonormal columns Q of the Krylov space of P from its images of columns that know nothing of it.
Eigen::MatrixXd krylov_basis(const Eigen::MatrixXd& P, Eigen::Index starts, Eigen::Index columns) {
  constexpr double kNothingNew = 1e-13;  // of a column
  std::mt19937 random(1);
  Eigen::MatrixXd Q(P.rows(), std::min(columns, P.rows()));
  Eigen::Index count = 0;
  for (Eigen::Index from = -starts; from < count && count < Q.cols(); ++from) {
    Eigen::VectorXd next(P.rows());
    if (from < 0) {
      for (double& entry : next) entry = static_cast<double>(random()) / 4294967296.0 - 0.5;
      next = image(P, next);  // what fades is no part of it
    } else {
      next = image(P, Q.col(from));
    }
    const double size = next.norm();
    for (int twice = 0; twice < 2; ++twice) {
      const Eigen::VectorXd known = image_by_transposed(Q.leftCols(count), next);
      next -= image(Q.leftCols(count), known);
    }
    const double added = next.norm();
    if (added > kNothingNew * size) Q.col(count++) = next / added;
  }
  return Q.leftCols(count);
}

// Those of Q^T A Q, falling in magnitude, and |A x - mu x| of each.
struct RitzPairs {
  Eigen::VectorXcd values;
  Eigen::VectorXd residuals;
};
RitzPairs ritz_pairs(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q) {
  const Eigen::MatrixXd image_of_Q = product(A, Q);
  const GeneralEigen small = general_pairs(product_of_transposed(Q, image_of_Q), true);
  if (!small.converged) return {};
  std::vector<Eigen::Index> order(static_cast<std::size_t>(small.values.size()));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Eigen::Index>(k);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    const double first = std::abs(small.values[a]), second = std::abs(small.values[b]);
    return first > second || (first == second && a < b);
  });
  const Eigen::MatrixXcd images = product_of_complex(image_of_Q, small.vectors);
  const Eigen::MatrixXcd vectors = product_of_complex(Q, small.vectors);
  RitzPairs pairs{.values = Eigen::VectorXcd(small.values.size()),
                  .residuals = Eigen::VectorXd(small.values.size())};
  for (Eigen::Index k = 0; k < pairs.values.size(); ++k) {
    const Eigen::Index from = order[static_cast<std::size_t>(k)];
    pairs.values[k] = small.values[from];
    pairs.residuals[k] = (images.col(from) - small.values[from] * vectors.col(from)).norm();
  }
  return pairs;
}

}  // namespace

GeneralEigen general_eigen(const Eigen::MatrixXd& A) { return general_pairs(A, true); }

Eigen::VectorXcd general_eigenvalues(const Eigen::MatrixXd& A) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const GeneralEigen found = general_pairs(A, false);
  return found.converged ? found.values : Eigen::VectorXcd::Constant(A.rows(), Complex(kNone, kNone));
}

Eigen::VectorXcd leading_eigenvalues(const Eigen::MatrixXd& A, double tolerance) {
  constexpr int kSquared = 3;
  constexpr Eigen::Index kStarts = 4, kColumns = 40;
  if (A.rows() == 0 || !A.allFinite()) return {};
  Eigen::MatrixXd power = A;
  for (int k = 0; k < kSquared; ++k) {
    const double size = power.cwiseAbs().maxCoeff();  // whose eighth power may overflow
    if (size > 0.0) power /= size;
    power = product(power, power);
  }
  const RitzPairs pairs = ritz_pairs(A, krylov_basis(power, kStarts, kColumns));
  Eigen::Index known = 0;
  while (known < pairs.values.size() &&
         pairs.residuals[known] <= tolerance * std::max(1.0, std::abs(pairs.values[0])))
    ++known;
  // Residuals of a pair may differ in their last digit.
  if (known > 0 && known < pairs.values.size() && pairs.values[known] == std::conj(pairs.values[known - 1]) &&
      pairs.values[known].imag() != 0.0)
    --known;
  return pairs.values.head(known);
}

double largest_magnitude(const Eigen::VectorXcd& values) {
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

}  // namespace signorini
