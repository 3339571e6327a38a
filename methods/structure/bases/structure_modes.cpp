#include "methods/structure/bases/structure_modes.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/dense_products.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

/// Whether D is diagonal on these vectors, as far as rounding lets that be seen: that of its entries; that of
/// the modes, whose masses are known to eps of the largest, which turns vectors into each other by as much
/// over the distance of their masses.
bool are_uncoupled(const Eigen::MatrixXd& coupling, const StructureModes& modes, double largest_damping) {
  constexpr double kCoupling = 1e-9, kRounding = 1e-14;
  constexpr double kMostTurned = 1e-6;  // modes of one frequency and different ratios are not told apart
  const Eigen::VectorXd &m = modes.mass, &d = modes.damping, root = d.cwiseSqrt();
  const Eigen::VectorXd length = modes.vectors.colwise().norm();
  const double blur = kRounding * m.maxCoeff(),
               entry = kEpsilon * static_cast<double>(m.size()) * largest_damping;
  for (Eigen::Index j = 0; j < coupling.cols(); ++j) {
    const double least = entry * length[j];
    for (Eigen::Index k = 0; k < j; ++k) {
      const double turned = std::min(kMostTurned, blur / std::abs(m[j] - m[k])) * std::abs(d[j] - d[k]);
      const double alike = std::min(kMostTurned, blur / std::sqrt(m[j] * m[k])) + kCoupling;
      if (!(std::abs(coupling(k, j)) <= turned + alike * root[j] * root[k] + least * length[k])) return false;
    }
    if (!(coupling(j, j) >= -least * length[j])) return false;
  }
  return true;
}

std::shared_ptr<const StructureModes> modes_of(const Problem& problem) {
  for (const SparseMatrix* A : {&problem.mass(), &problem.damping(), &problem.stiffness()})
    if (!is_symmetric(*A)) return nullptr;
  const Eigen::MatrixXd M(problem.mass());
  Eigen::MatrixXd B(problem.stiffness());
  const double inertia = M.diagonal().sum();
  if (!(inertia > 0.0)) return nullptr;
  const double shift = is_definite(problem.stiffness()) ? 0.0 : B.diagonal().sum() / inertia;
  if (shift > 0.0) B += shift * M;
  SymmetricEigen found = generalised_eigen(M, B);
  if (!found.converged) return nullptr;
  auto modes = std::make_shared<StructureModes>();
  modes->shift = shift;
  modes->vectors = std::move(found.vectors);
  // The values of the solver are known to eps of the largest, these quotients to their own rounding.
  modes->mass = modes->vectors.cwiseProduct(problem.mass() * modes->vectors).colwise().sum().transpose();
  modes->stiffness = (1.0 - shift * modes->mass.array()).matrix();
  const Eigen::MatrixXd coupling =
      transposed_product(modes->vectors, dense_product(Eigen::MatrixXd(problem.damping()), modes->vectors));
  modes->damping = coupling.diagonal().cwiseMax(0.0);
  if (!are_uncoupled(coupling, *modes, largest_entry(problem.damping()))) return nullptr;
  return modes;
}

}  // namespace

std::shared_ptr<const StructureModes> uncoupled_modes(const Problem& problem) {
  static std::mutex guard;
  static std::weak_ptr<const Structure> structure;
  static std::shared_ptr<const StructureModes> modes;
  const std::scoped_lock lock(guard);
  if (structure.lock() != problem.structure) {
    modes.reset();
    modes = modes_of(problem);
    structure = problem.structure;
  }
  return modes;
}

bool has_full_damping(const Problem& problem) {
  constexpr double kFull = 0.25;  // of all places
  const double size = problem.size();
  return static_cast<double>(problem.damping().nonZeros()) > kFull * size * size;
}

}  // namespace signorini
