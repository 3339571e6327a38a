#include "problems/sparse_cholesky.hpp"

#include <omp.h>

#include <Eigen/CholmodSupport>
#include <algorithm>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

struct SparseCholesky::Handle {
  Handle() {
    // CHOLMOD asks for four threads whatever it is told. They would not outlive a fork, and a child that
    // factorises again would wait for them for ever.
    omp_set_max_active_levels(0);
    cholmod_start(&common);
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    common.final_ll = 1;
  }
  ~Handle() {
    cholmod_free_dense(&workspace, &common);
    cholmod_free_dense(&second_workspace, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  void check() const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
    if (common.status < 0) {
      throw std::runtime_error("sparse Cholesky factorisation failed, status " +
                               std::to_string(common.status));
    }
  }

  // Order and symbolic factor; returns the view of A that CHOLMOD reads, which passes over its upper
  // triangle.
  cholmod_sparse analyse(const SparseMatrix& A) {
    cholmod_sparse view = Eigen::viewAsCholmod(A.selfadjointView<Eigen::Lower>());
    factor = cholmod_analyze(&view, &common);
    check();
    return view;
  }

  // Calls visit(column of A, L_jj) for every column.
  template <class Visit>
  void for_each_diagonal(Visit visit) const {
    const auto* order = static_cast<const int*>(factor->Perm);
    const auto* x = static_cast<const double*>(factor->x);
    if (factor->is_super == 0) {
      const auto* start = static_cast<const int*>(factor->p);
      for (std::size_t j = 0; j < factor->n; ++j) visit(order[j], x[start[j]]);
      return;
    }
    const auto* first = static_cast<const int*>(factor->super);
    const auto* rows = static_cast<const int*>(factor->pi);
    const auto* block = static_cast<const int*>(factor->px);
    for (std::size_t s = 0; s < factor->nsuper; ++s) {
      const std::ptrdiff_t height = rows[s + 1] - rows[s];
      for (int j = first[s]; j < first[s + 1]; ++j) {
        visit(order[j], x[block[s] + (j - first[s]) * (height + 1)]);
      }
    }
  }

  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense* workspace = nullptr;
  cholmod_dense* second_workspace = nullptr;
  double smallest_pivot = 0.0;
};

SparseCholesky::SparseCholesky(const SparseMatrix& A) : handle_(std::make_unique<Handle>()) {
  Handle& h = *handle_;
  cholmod_sparse view = h.analyse(A);
  cholmod_factorize(&view, h.factor, &h.common);
  h.check();
  if (h.common.status == CHOLMOD_NOT_POSDEF || h.factor->minor < h.factor->n) return;
  const Eigen::VectorXd diagonal = A.diagonal();
  h.smallest_pivot = std::numeric_limits<double>::infinity();
  h.for_each_diagonal([&](int column, double pivot) {
    h.smallest_pivot = std::min(h.smallest_pivot, pivot * pivot / diagonal(column));
  });
}

SparseCholesky::Cost SparseCholesky::cost_of(const SparseMatrix& A) {
  Handle handle;
  handle.analyse(A);
  // A symbolic factor without supernodes has no room for its numbers yet.
  const double entries =
      handle.factor->is_super != 0 ? static_cast<double>(handle.factor->xsize) : handle.common.lnz;
  return {.operations = handle.common.fl, .entries = entries};
}

SparseCholesky::~SparseCholesky() = default;

std::unique_ptr<DefiniteSolver> factorise_here(const SparseMatrix& A) {
  return std::make_unique<SparseCholesky>(A);
}

double SparseCholesky::smallest_pivot() const { return handle_->smallest_pivot; }

bool SparseCholesky::definite() const { return smallest_pivot() > kDefinitePivot; }

double SparseCholesky::entries() const {
  const cholmod_factor& factor = *handle_->factor;
  return static_cast<double>(factor.is_super != 0 ? factor.xsize : factor.nzmax);
}

double SparseCholesky::operations() const { return handle_->common.fl; }

// Some columns at a time: CHOLMOD works on a copy of what it is given, which it keeps, and counts its entries
// in 32 bits.
Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& rhs) {
  Handle& h = *handle_;
  Eigen::MatrixXd solution(rhs.rows(), rhs.cols());
  for (Eigen::Index first = 0; first < rhs.cols(); first += kColumnsAtOnce) {
    const Eigen::Index count = std::min(kColumnsAtOnce, rhs.cols() - first);
    // CHOLMOD only reads it.
    Eigen::Map<Eigen::MatrixXd> columns(
        const_cast<double*>(rhs.col(first).data()),  // NOLINT(cppcoreguidelines-pro-type-const-cast)
        rhs.rows(), count);
    Eigen::Map<Eigen::MatrixXd> results(solution.col(first).data(), rhs.rows(), count);
    cholmod_dense given = Eigen::viewAsCholmod(columns), found = Eigen::viewAsCholmod(results);
    cholmod_dense* out = &found;
    cholmod_solve2(CHOLMOD_A, h.factor, &given, nullptr, &out, nullptr, &h.workspace, &h.second_workspace,
                   &h.common);
    h.check();
  }
  return solution;
}

}  // namespace signorini
