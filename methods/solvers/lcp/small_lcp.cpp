#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/lcp/complementarity_solver.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

namespace {

/// A matrix that is an array.
class DenseMatrix final : public LcpMatrix {
 public:
  explicit DenseMatrix(Eigen::MatrixXd matrix) : matrix_(std::move(matrix)) {}

  [[nodiscard]] int size() const override { return static_cast<int>(matrix_.rows()); }
  void add_columns(std::span<const int> columns, const double* weights, int first,
                   Eigen::Ref<Eigen::VectorXd> out) const override {
    for (std::size_t k = 0; k < columns.size(); ++k)
      out += weights[k] * matrix_.col(columns[k]).segment(first, out.size());
  }
  [[nodiscard]] std::unique_ptr<const ColumnBounds> column_bounds() const override { return nullptr; }
  [[nodiscard]] Eigen::MatrixXd submatrix(std::span<const int> rows,
                                          std::span<const int> columns) const override {
    return matrix_(rows, columns);
  }
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& z) const override { return matrix_ * z; }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const override {
    return lu_solve(matrix_, b);
  }

 private:
  Eigen::MatrixXd matrix_;
};

std::vector<int> indices_of(const std::vector<bool>& flags) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i]) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

// Complementary basic solutions, one after the other.
class PrincipalPivoting {
 public:
  PrincipalPivoting(const Eigen::MatrixXd& A, const Eigen::VectorXd& q, const std::vector<bool>& held)
      : A_(A), q_(q), held_(held), basic_(held) {
    const double largest = A.size() == 0 ? 0.0 : A.cwiseAbs().maxCoeff();
    w_noise_ = kSumRounding * (q.size() == 0 ? 0.0 : q.cwiseAbs().maxCoeff());
    z_noise_ = w_noise_ / std::max(largest, std::numeric_limits<double>::min());
  }

  // All infeasible indices are flipped at once as long as there are ever fewer of them, then the least one
  // alone, which ends for a P-matrix.
  std::optional<Eigen::VectorXd> run() {
    constexpr int kPatience = 3;
    const long limit = 100 + 20 * q_.size();
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    int patience = kPatience;
    for (long pivot = 0; pivot < limit; ++pivot) {
      evaluate();
      const std::vector<std::size_t> wrong = infeasible();
      if (wrong.empty()) return accepted();
      if (wrong.size() < fewest) {
        fewest = wrong.size();
        patience = kPatience;
      }
      const bool all = patience-- > 0;
      for (const std::size_t i : wrong) {
        basic_[i] = !basic_[i];
        if (!all) break;
      }
    }
    return std::nullopt;
  }

  // The basic solution of a given active set, if it solves the problem.
  std::optional<Eigen::VectorXd> with_basis(std::vector<bool> basic) {
    basic_ = std::move(basic);
    evaluate();
    return infeasible().empty() ? accepted() : std::nullopt;
  }

 private:
  // z on the basic indices, zero elsewhere, with w = 0 on them: of least norm where their columns are
  // dependent, as those of contacts at one place are.
  void evaluate() {
    const std::vector<int> basis = indices_of(basic_);
    z_.setZero(q_.size());
    if (!basis.empty()) {
      z_(basis) = least_norm_solve(A_(basis, basis), Eigen::VectorXd(-q_(basis)));
    }
    w_ = A_ * z_ + q_;
  }

  [[nodiscard]] std::vector<std::size_t> infeasible() const {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < basic_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (!held_[i] && (basic_[i] ? z_[row] < -z_noise_ : w_[row] < -w_noise_)) wrong.push_back(i);
    }
    return wrong;
  }

  // Empty where a basis with dependent columns leaves some w_i != 0.
  [[nodiscard]] std::optional<Eigen::VectorXd> accepted() const {
    const double rounding = kSumRounding * static_cast<double>(q_.size()) *
                            (A_.cwiseAbs() * z_.cwiseAbs() + q_.cwiseAbs()).maxCoeff();
    Eigen::VectorXd z = z_;
    for (std::size_t i = 0; i < basic_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (basic_[i] && std::abs(w_[row]) > rounding) return std::nullopt;
      if (!held_[i]) z[row] = std::max(z[row], 0.0);
    }
    return z;
  }

  const Eigen::MatrixXd& A_;
  const Eigen::VectorXd& q_;
  const std::vector<bool>& held_;
  std::vector<bool> basic_;
  Eigen::VectorXd z_, w_;
  double w_noise_ = 0.0, z_noise_ = 0.0;
};

// The active set that Lemke's method ends with, `held` eliminated; empty where it fails.
std::optional<std::vector<bool>> lemke_basis(const Eigen::MatrixXd& A, const Eigen::VectorXd& q,
                                             const std::vector<bool>& held) {
  const std::vector<int> equal = indices_of(held);
  std::vector<bool> flags = held;
  flags.flip();
  const std::vector<int> left = indices_of(flags);
  Eigen::MatrixXd reduced = A(left, left);
  Eigen::VectorXd offset = q(left);
  if (!equal.empty()) {
    const Eigen::MatrixXd block = A(equal, equal);
    const Eigen::MatrixXd coupling = A(left, equal);
    reduced -= coupling * least_norm_solve(block, Eigen::MatrixXd(coupling.transpose()));
    offset -= coupling * least_norm_solve(block, Eigen::VectorXd(q(equal)));
  }
  const Eigen::VectorXd scale = A.diagonal()(left).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * reduced * scale.asDiagonal();
  const LcpResult result = solve_by_pivoting(dense_lcp(scaled, scale.cwiseProduct(offset)));
  if (result.status != LcpStatus::solved) return std::nullopt;
  std::vector<bool> basic = held;
  for (std::size_t i = 0; i < left.size(); ++i)
    basic[static_cast<std::size_t>(left[i])] = result.z[static_cast<Eigen::Index>(i)] > 0.0;
  return basic;
}

}  // namespace

Lcp dense_lcp(Eigen::MatrixXd matrix, Eigen::VectorXd offset) {
  return {.matrix = std::make_shared<DenseMatrix>(std::move(matrix)), .offset = std::move(offset)};
}

std::optional<Eigen::VectorXd> solve_small_lcp(const Eigen::MatrixXd& A, const Eigen::VectorXd& q,
                                               const std::vector<bool>& held) {
  if (q.size() == 0) return q;
  PrincipalPivoting pivoting(A, q, held);
  if (auto z = pivoting.run()) return z;
  const auto basis = lemke_basis(A, q, held);
  return basis ? pivoting.with_basis(*basis) : std::nullopt;
}

}  // namespace signorini
