#include "problems/linear_algebra/singular_values.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <limits>
#include <vector>

#include "problems/linear_algebra/lapack.hpp"

namespace signorini {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// By divide and conquer; job as of dgesdd.
SingularValues singular_by_lapack(Eigen::MatrixXd A, char job) {
  const int m = static_cast<int>(A.rows()), n = static_cast<int>(A.cols()), least = std::min(m, n);
  const int left = job == 'A' ? m : job == 'S' ? least : 1, right = job == 'A' ? n : job == 'S' ? least : 1;
  SingularValues result{
      .values = Eigen::VectorXd(least), .U = Eigen::MatrixXd(job == 'N' ? 1 : m, left), .V = {}};
  Eigen::MatrixXd transposed(right, job == 'N' ? 1 : n);
  std::vector<int> integers(8 * static_cast<std::size_t>(least));
  const int u_stride = static_cast<int>(result.U.rows()), v_stride = right;
  int info = 0;
  const auto solve = [&](double* work, int size) {
    dgesdd_(&job, &m, &n, A.data(), &m, result.values.data(), result.U.data(), &u_stride, transposed.data(),
            &v_stride, work, &size, integers.data(), &info, 1);
  };
  double best = 0.0;
  solve(&best, -1);
  std::vector<double> work(static_cast<std::size_t>(best));
  solve(work.data(), static_cast<int>(work.size()));
  if (info != 0) result.values.setConstant(kNone);
  result.V = transposed.transpose();
  return result;
}

// With `left` columns of U and `right` of V; job and options say so to dgesdd and to Eigen.
SingularValues singular_parts(const Eigen::MatrixXd& A, char job, unsigned options, Eigen::Index left,
                              Eigen::Index right) {
  using Eigen::MatrixXd;
  // Without rows or columns, which Eigen does not take: all of space is the null space.
  if (A.size() == 0)
    return {.values = {}, .U = MatrixXd::Identity(A.rows(), left), .V = MatrixXd::Identity(right, right)};
  // What is not finite LAPACK may loop on for ever, and Eigen leaves its arrays unwritten.
  if (!A.allFinite())
    return {.values = Eigen::VectorXd::Constant(std::min(A.rows(), A.cols()), kNone),
            .U = MatrixXd::Constant(A.rows(), left, kNone),
            .V = MatrixXd::Constant(right, right, kNone)};
  if (is_for_lapack(A)) return singular_by_lapack(A, job);
  const Eigen::JacobiSVD<MatrixXd> svd(A, options);
  SingularValues result{.values = svd.singularValues(), .U = {}, .V = {}};
  if (svd.computeU()) result.U = svd.matrixU();
  if (svd.computeV()) result.V = svd.matrixV();
  return result;
}

}  // namespace

SingularValues singular_vectors(const Eigen::MatrixXd& A) {
  return singular_parts(A, 'A', Eigen::ComputeFullU | Eigen::ComputeFullV, A.rows(), A.cols());
}

SingularValues left_singular_vectors(const Eigen::MatrixXd& A) {
  SingularValues found = singular_parts(A, 'S', Eigen::ComputeThinU, std::min(A.rows(), A.cols()), 0);
  found.V.resize(0, 0);
  return found;
}

Eigen::MatrixXd right_singular_vectors(const Eigen::MatrixXd& A) {
  return singular_parts(A, 'A', Eigen::ComputeFullV, 0, A.cols()).V;
}

double least_singular_value(const Eigen::MatrixXd& A) {
  if (A.size() == 0) return std::numeric_limits<double>::infinity();
  const Eigen::VectorXd values = singular_parts(A, 'N', 0, 0, 0).values;
  return values[values.size() - 1];
}

}  // namespace signorini
