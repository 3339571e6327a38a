#include "problems/linear_algebra/singular_values.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <limits>
#include <vector>

#include "problems/linear_algebra/lapack.hpp"

namespace signorini {

namespace {

// Of a matrix that is not finite, on which LAPACK may loop for ever and Eigen leaves its arrays unwritten.
SingularValues without_answer(Eigen::Index values, Eigen::Index rows, Eigen::Index left, Eigen::Index right) {
  return {.values = Eigen::VectorXd::Constant(values, std::numeric_limits<double>::quiet_NaN()),
          .U = Eigen::MatrixXd::Constant(rows, left, std::numeric_limits<double>::quiet_NaN()),
          .V = Eigen::MatrixXd::Constant(right, right, std::numeric_limits<double>::quiet_NaN())};
}

// Of a matrix without rows or columns, which Eigen does not take: all of space is its null space.
SingularValues of_nothing(Eigen::Index rows, Eigen::Index left, Eigen::Index right) {
  return {
      .values = {}, .U = Eigen::MatrixXd::Identity(rows, left), .V = Eigen::MatrixXd::Identity(right, right)};
}

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
  if (info != 0) result.values.setConstant(std::numeric_limits<double>::quiet_NaN());
  result.V = transposed.transpose();
  return result;
}

}  // namespace

SingularValues singular_vectors(const Eigen::MatrixXd& A) {
  if (A.size() == 0) return of_nothing(A.rows(), A.rows(), A.cols());
  if (!A.allFinite()) return without_answer(std::min(A.rows(), A.cols()), A.rows(), A.rows(), A.cols());
  if (is_for_lapack(A)) return singular_by_lapack(A, 'A');
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {.values = svd.singularValues(), .U = svd.matrixU(), .V = svd.matrixV()};
}

SingularValues left_singular_vectors(const Eigen::MatrixXd& A) {
  if (A.size() == 0) return of_nothing(A.rows(), 0, 0);
  const Eigen::Index least = std::min(A.rows(), A.cols());
  if (!A.allFinite()) return without_answer(least, A.rows(), least, 0);
  if (is_for_lapack(A)) {
    SingularValues found = singular_by_lapack(A, 'S');
    found.V.resize(0, 0);
    return found;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU);
  return {.values = svd.singularValues(), .U = svd.matrixU(), .V = {}};
}

Eigen::MatrixXd right_singular_vectors(const Eigen::MatrixXd& A) {
  if (A.size() == 0) return of_nothing(0, 0, A.cols()).V;
  if (!A.allFinite()) return without_answer(0, 0, 0, A.cols()).V;
  if (is_for_lapack(A)) return singular_by_lapack(A, 'A').V;
  return Eigen::JacobiSVD<Eigen::MatrixXd>(A, Eigen::ComputeFullV).matrixV();
}

double least_singular_value(const Eigen::MatrixXd& A) {
  if (A.size() == 0) return std::numeric_limits<double>::infinity();
  if (!A.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const Eigen::VectorXd values = is_for_lapack(A) ? singular_by_lapack(A, 'N').values
                                                  : Eigen::JacobiSVD<Eigen::MatrixXd>(A).singularValues();
  return values[values.size() - 1];
}

}  // namespace signorini
