#include "problems/linear_algebra/general_eigen.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "problems/linear_algebra/lapack.hpp"
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

// The eigenvalues alone.
GeneralEigen found_by_lapack(Eigen::MatrixXd A) {
  constexpr char kNone = 'N';
  const auto n = static_cast<int>(A.rows());
  Eigen::VectorXd re(n), im(n);
  int info = 0;
  const auto solve = [&](double* work, int size) {
    dgeev_(&kNone, &kNone, &n, A.data(), &n, re.data(), im.data(), nullptr, &n, nullptr, &n, work, &size,
           &info, 1, 1);
  };
  double best = 0.0;
  solve(&best, -1);
  std::vector<double> work(static_cast<std::size_t>(best));
  solve(work.data(), static_cast<int>(work.size()));
  return {.converged = info == 0, .values = re + Complex(0.0, 1.0) * im, .vectors = {}};
}

// Orthonormal columns Q, and A Q.
struct Images {
  Eigen::MatrixXd Q, of_Q;
};

// Appends what the columns of V add to the first `count` of Q, orthonormal, as far as there is room.
void append_new(const Eigen::MatrixXd& V, Eigen::MatrixXd& Q, Eigen::Index& count) {
  constexpr double kNothingNew = 1e-13;  // of a column
  for (Eigen::Index c = 0; c < V.cols() && count < Q.cols(); ++c) {
    Eigen::VectorXd next = V.col(c);
    const double size = next.norm();
    for (int twice = 0; twice < 2; ++twice) {
      const Eigen::VectorXd known = image_by_transposed(Q.leftCols(count), next);
      next -= image(Q.leftCols(count), known);
    }
    const double added = next.norm();
    if (added > kNothingNew * size) Q.col(count++) = next / added;
  }
}

// Columns in which the largest eigenvalues have most: images under a power of A of some that know nothing.
Eigen::MatrixXd filtered_block(const Eigen::MatrixXd& A) {
  constexpr Eigen::Index kStarts = 4;
  constexpr int kPower = 24, kTogether = 4;  // images of one column are soon those of all
  std::mt19937 random(1);
  Eigen::MatrixXd block(A.rows(), std::min(kStarts, A.rows()));
  for (double& entry : block.reshaped()) entry = static_cast<double>(random()) / 4294967296.0 - 0.5;
  for (int k = 1; k <= kPower; ++k) {
    block = product(A, block);
    const double size = block.size() == 0 ? 0.0 : block.cwiseAbs().maxCoeff();
    if (size > 0.0) block /= size;
    if (k % kTogether != 0) continue;
    Eigen::MatrixXd Q(block.rows(), block.cols());
    Eigen::Index count = 0;
    append_new(block, Q, count);
    block = Q.leftCols(count);
  }
  return block;
}

// The Krylov space of A from a block, of so many columns at most.
Images krylov_space(const Eigen::MatrixXd& A, const Eigen::MatrixXd& block, Eigen::Index columns) {
  Images space{.Q = Eigen::MatrixXd(A.rows(), std::min(columns, A.rows())), .of_Q = {}};
  space.of_Q.resize(space.Q.rows(), space.Q.cols());
  Eigen::Index count = 0, before = 0;
  append_new(block, space.Q, count);
  while (count > before) {
    const Eigen::MatrixXd images = product(A, space.Q.middleCols(before, count - before));
    space.of_Q.middleCols(before, images.cols()) = images;
    before = count;
    append_new(images, space.Q, count);
  }
  return {.Q = space.Q.leftCols(count), .of_Q = space.of_Q.leftCols(count)};
}

// Those of Q^T A Q, falling in magnitude, and |A x - mu x| of each.
struct RitzPairs {
  Eigen::VectorXcd values;
  Eigen::VectorXd residuals;
};
RitzPairs ritz_pairs(const Images& space) {
  const GeneralEigen small = general_pairs(product_of_transposed(space.Q, space.of_Q), true);
  if (!small.converged) return {};
  std::vector<Eigen::Index> order(static_cast<std::size_t>(small.values.size()));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Eigen::Index>(k);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    const double first = std::abs(small.values[a]), second = std::abs(small.values[b]);
    return first > second || (first == second && a < b);
  });
  const Eigen::MatrixXcd images = product_of_complex(space.of_Q, small.vectors);
  const Eigen::MatrixXcd vectors = product_of_complex(space.Q, small.vectors);
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
  const GeneralEigen found = is_for_lapack(A) ? found_by_lapack(A) : general_pairs(A, false);
  return found.converged ? found.values : Eigen::VectorXcd::Constant(A.rows(), Complex(kNone, kNone));
}

Eigen::VectorXcd leading_eigenvalues(const Eigen::MatrixXd& A, double tolerance) {
  constexpr Eigen::Index kColumns = 32, kMore = 56, kFew = 4;
  if (A.rows() == 0 || !A.allFinite()) return {};
  const Eigen::MatrixXd block = filtered_block(A);
  RitzPairs pairs;
  Eigen::Index known = 0;
  for (const Eigen::Index columns : {kColumns, kMore}) {
    pairs = ritz_pairs(krylov_space(A, block, columns));
    known = 0;
    while (known < pairs.values.size() &&
           pairs.residuals[known] <= tolerance * std::max(1.0, std::abs(pairs.values[0])))
      ++known;
    if (known >= std::min(kFew, A.rows())) break;
  }
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
