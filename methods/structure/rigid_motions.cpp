#include "methods/structure/rigid_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "methods/structure/bases/massless_elimination.hpp"
#include "methods/structure/bases/modal_reduction.hpp"
#include "methods/structure/bases/ritz_reduction.hpp"
#include "problems/assembly/penalty_supports.hpp"
#include "problems/definite_solver.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/singular_values.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/skew_parts.hpp"

namespace signorini {

namespace {

constexpr double kBalanced = 1e-9;  // of the load: what is left of it is none

/// S K S of unit diagonal, S diagonal, or less where inertia outweighs springs; 1 on rows without either.
SparseMatrix unit_diagonal(const SparseMatrix& K, const Problem& problem, Eigen::VectorXd& scale) {
  constexpr double kInertia = 1e-2;
  const double square = kInertia * problem.base_frequency() * problem.base_frequency();
  const Eigen::VectorXd largest =
      Eigen::VectorXd(K.diagonal()).cwiseMax(square * Eigen::VectorXd(problem.mass().diagonal()));
  scale = largest.unaryExpr([](double k) { return k > 0.0 ? 1.0 / std::sqrt(k) : 1.0; });
  return scale.asDiagonal() * K * scale.asDiagonal();
}

/// Vectors of the least eigenvalues of A, symmetric and semidefinite of unit diagonal: those below
/// kMatrixRounding.
Eigen::MatrixXd null_space_by_iteration(const SparseMatrix& A) {
  constexpr double kShift = 1e-9;
  constexpr int kColumnsAtFirst = 8, kMostColumns = 64, kIterations = 12;
  SparseMatrix one(A.rows(), A.cols());
  one.setIdentity();
  const SparseMatrix shifted = A + kShift * one;
  const auto solver = factorise_here(shifted);
  if (!solver->definite()) return Eigen::MatrixXd(A.rows(), 0);
  for (int columns = kColumnsAtFirst;; columns *= 2) {
    // None of those that were too few before: rounds of 8, 16, .. columns have used columns - 8.
    Eigen::MatrixXd X = random_columns(A.rows(), 2 * columns - kColumnsAtFirst).rightCols(columns);
    Eigen::VectorXd values;
    for (int k = 0; k < kIterations; ++k) {
      X = solver->solve(X);
      const SymmetricEigen ritz = generalised_eigen(X.transpose() * (A * X), X.transpose() * X);
      if (!ritz.converged) return Eigen::MatrixXd(A.rows(), 0);
      X = X * ritz.vectors;
      values = ritz.values;
    }
    const Eigen::Index count = (values.array() < kMatrixRounding).count();
    if (count < columns || columns >= kMostColumns) return X.leftCols(count);
  }
}

/// The same to any size. A factorisation tells whether there is any.
Eigen::MatrixXd null_space(const SparseMatrix& A) {
  SparseMatrix one(A.rows(), A.cols());
  one.setIdentity();
  if (factorise_here(A - 2.0 * kMatrixRounding * one)->definite()) return Eigen::MatrixXd(A.rows(), 0);
  if (A.rows() > kMostModal) return null_space_by_iteration(A);
  const SymmetricEigen all = symmetric_eigen(Eigen::MatrixXd(A));
  if (!all.converged || all.values[0] < -kMatrixRounding) return Eigen::MatrixXd(A.rows(), 0);
  return all.vectors.leftCols((all.values.array() < kMatrixRounding).count());
}

/// The largest components of a direction, the largest of them 1: "coordinate 0: 1, coordinate 3: -0.5".
std::string direction_text(const Eigen::VectorXd& direction) {
  constexpr std::size_t kMostNamed = 4;
  std::vector<int> order(static_cast<std::size_t>(direction.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order,
                           [&](int i, int j) { return std::abs(direction[i]) > std::abs(direction[j]); });
  std::string text;
  for (std::size_t k = 0; k < std::min(kMostNamed, order.size()); ++k) {
    const double part = direction[order[k]];
    if (std::abs(part) < 1e-6) break;
    text += fmt::format("{}coordinate {}: {:.3g}", k == 0 ? "" : ", ", order[k], part);
  }
  return order.size() > kMostNamed ? text + ", ..." : text;
}

/// Named are coordinates with mass, which the others follow: faces of damped stops are not the user's.
/// \param motions  R  \param rest  of R^T f_0, what nothing balances
NoPeriodicMotion unbalanced(const Problem& problem, const Eigen::MatrixXd& motions,
                            const Eigen::VectorXd& rest) {
  Eigen::VectorXd direction = motions * rest;
  direction = (problem.mass().diagonal().array() > 0.0).select(direction, 0.0);
  const double largest = direction.lpNorm<Eigen::Infinity>();
  direction /= largest;
  return NoPeriodicMotion{
      fmt::format("no periodic motion: neither springs nor contacts balance the mean load of {:.6g} N along "
                  "the free motion "
                  "({})",
                  rest.squaredNorm() / largest, direction_text(direction))};
}

/// Coordinates of parts, joined by entries of M, D and K beyond rounding at the base frequency w, of which
/// none is a contact's: the unit of a coordinate is its spring or w^2 M, whichever is larger.
std::vector<bool> coordinates_apart_from_contacts(const Problem& problem) {
  const double rate = problem.base_frequency();
  const Eigen::VectorXd unit = Eigen::VectorXd(problem.stiffness().diagonal())
                                   .cwiseMax(rate * rate * Eigen::VectorXd(problem.mass().diagonal()))
                                   .cwiseSqrt();
  std::vector<int> part(static_cast<std::size_t>(problem.size()));
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&part](int i) {
    while (part[static_cast<std::size_t>(i)] != i) {
      int& above = part[static_cast<std::size_t>(i)];
      i = above = part[static_cast<std::size_t>(above)];  // halves the way of the next one
    }
    return i;
  };
  double factor = rate * rate;  // w^2 M, w D and K
  for (const SparseMatrix* matrix : {&problem.mass(), &problem.damping(), &problem.stiffness()}) {
    for (int outer = 0; outer < matrix->outerSize(); ++outer) {
      for (SparseMatrix::InnerIterator it(*matrix, outer); it; ++it) {
        if (it.row() == it.col()) continue;
        if (factor * std::abs(it.value()) <= kMatrixRounding * unit[it.row()] * unit[it.col()]) continue;
        const int a = root(static_cast<int>(it.row())), b = root(static_cast<int>(it.col()));
        part[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      }
    }
    factor /= rate;
  }
  std::vector<bool> touched(part.size(), false), apart(part.size(), false);
  for (const Contact& contact : problem.contacts)
    for (const auto& [dof, weight] : contact.normal) touched[static_cast<std::size_t>(root(dof))] = true;
  for (int i = 0; i < problem.size(); ++i)
    apart[static_cast<std::size_t>(i)] = !touched[static_cast<std::size_t>(root(i))];
  return apart;
}

/// Loads that carry what holds idle parts, springs w^2 A and dampers w A, along with the motion that the load
/// gives these parts; none where one of them resonates undamped, and has no such motion.
void move_as_before(const Problem& problem, const std::vector<bool>& idle, const SparseMatrix& A,
                    Problem& held) {
  std::vector<int> coordinates;
  std::set<int> harmonics;
  for (int i = 0; i < problem.size(); ++i)
    if (idle[static_cast<std::size_t>(i)]) coordinates.push_back(i);
  for (const ForceTerm& term : problem.force)
    if (term.harmonic > 0 && idle[static_cast<std::size_t>(term.dof)]) harmonics.insert(term.harmonic);
  if (harmonics.empty()) return;
  const SparseMatrix picked = coordinate_selection(coordinates, problem.size());
  Problem part;
  part.edit_structure([&](Structure& s) {
    s.mass = picked.transpose() * problem.mass() * picked;
    s.damping = picked.transpose() * problem.damping() * picked;
    s.stiffness = picked.transpose() * problem.stiffness() * picked;
  });
  const double rate = problem.base_frequency();
  try {
    DynamicStiffness stiffness(part);
    for (const int harmonic : harmonics) {
      const double w = harmonic * problem.frequency;
      stiffness.factorise(exact_weights(w));
      const Eigen::VectorXcd load = picked.transpose() * load_harmonic(problem, harmonic);
      const Eigen::VectorXcd u = picked * Eigen::VectorXcd(stiffness.solve(load));
      const Eigen::VectorXcd force = std::complex<double>(rate * rate, rate * w) * Eigen::VectorXcd(A * u);
      for (const int i : coordinates)
        held.force.push_back(
            {.dof = i, .harmonic = harmonic, .cos = force[i].real(), .sin = -force[i].imag()});
    }
  } catch (const SingularStiffness&) {
    held.force = problem.force;
  }
}

}  // namespace

std::vector<Eigen::Index> supports(Eigen::MatrixXd R) {
  std::vector<Eigen::Index> held;
  for (Eigen::Index k = 0; k < R.cols(); ++k) {
    Eigen::Index row = 0, column = 0;
    R.rightCols(R.cols() - k).cwiseAbs().maxCoeff(&row, &column);
    R.col(k).swap(R.col(k + column));
    for (Eigen::Index j = k + 1; j < R.cols(); ++j) R.col(j) -= R(row, j) / R(row, k) * R.col(k);
    held.push_back(row);
  }
  return held;
}

Eigen::MatrixXd rigid_motions(const Problem& problem) {
  const SparseMatrix& K = problem.stiffness();
  const bool symmetric = is_symmetric(K);
  Eigen::VectorXd scale;
  const SparseMatrix A = unit_diagonal(symmetric ? K : symmetric_part(K), problem, scale);
  Eigen::MatrixXd R = scale.asDiagonal() * null_space(A);
  const Eigen::MatrixXd none(K.rows(), 0);
  if (R.cols() == 0) return none;
  if (!symmetric) {
    const double bound =
        kMatrixRounding * largest_entry(K) * R.cwiseAbs().maxCoeff() * static_cast<double>(K.rows());
    if (!((K * R).cwiseAbs().maxCoeff() <= bound)) return none;
  }
  for (Eigen::Index k = 0; k < R.cols(); ++k) R.col(k) /= R.col(k).lpNorm<Eigen::Infinity>();
  const CholeskyFactors inertia(R.transpose() * (problem.mass() * R));
  if (!inertia.definite()) return none;
  inertia.normalise_columns(R);
  return R;
}

std::optional<Problem> with_idle_parts_held(const Problem& problem) {
  const std::vector<bool> idle = coordinates_apart_from_contacts(problem);
  if (std::ranges::find(idle, true) == idle.end()) return std::nullopt;
  Eigen::MatrixXd R = rigid_motions(problem);  // R R^T has a block for each part
  for (std::size_t i = 0; i < idle.size(); ++i)
    if (!idle[i]) R.row(static_cast<Eigen::Index>(i)).setZero();
  if (R.isZero(0.0)) return std::nullopt;
  const Eigen::VectorXd mean = load_coefficient(problem, 0).real();
  const double scale = (R.cwiseAbs() * (R.cwiseAbs().transpose() * mean.cwiseAbs())).maxCoeff();
  if ((R * (R.transpose() * mean)).cwiseAbs().maxCoeff() > kBalanced * scale) return std::nullopt;
  const double rate = problem.base_frequency();
  const SparseMatrix moved = Eigen::MatrixXd(problem.mass() * R).sparseView();
  const SparseMatrix inertia = moved * SparseMatrix(moved.transpose());
  Problem held = problem;
  held.edit_structure([&](Structure& s) {
    s.stiffness += rate * rate * inertia;
    s.damping += rate * inertia;
  });
  move_as_before(problem, idle, inertia, held);
  return held;
}

FeltMotions felt_first(const Problem& problem, const Eigen::MatrixXd& motions) {
  constexpr double kUnfelt = 1e-10;  // of the largest entries of W and R, whose products may cancel
  const SparseMatrix directions = contact_directions(problem);
  const double largest = largest_entry(directions) * motions.cwiseAbs().maxCoeff();
  const SingularValues felt = singular_vectors(directions.transpose() * motions);
  return {.motions = motions * felt.V, .felt = (felt.values.array() > kUnfelt * largest).count()};
}

std::string unbalanced_mean_load(const Problem& problem) {
  const Eigen::MatrixXd motions = rigid_motions(problem);
  if (motions.cols() == 0) return {};
  try {
    ContactReceptance still;
    still.receptance.resize(1);
    still.free_response = Eigen::MatrixXcd::Zero(1, problem.contact_count());
    fill_static_receptance(problem, motions, still);
  } catch (const NoPeriodicMotion& error) {
    return error.what();
  } catch (const SingularStiffness&) {  // which motion that leaves open, a march may tell
  }
  return {};
}

HeldStructure::HeldStructure(const Problem& problem, const Eigen::MatrixXd& motions, double rate)
    : motions_(motions), moments_(problem.mass() * motions), compliance_(1.0 / (rate * rate)) {
  SparseMatrix supported = problem.stiffness();
  const double largest = largest_entry(supported);
  for (const Eigen::Index i : supports(motions)) {
    const double own = supported.coeff(i, i);
    supported.coeffRef(i, i) += own > 0.0 ? own : (largest > 0.0 ? largest : 1.0);
  }
  supported.makeCompressed();
  supported_ = SparseLu(supported);
  if (!supported_.regular()) throw SingularStiffness();
}

Eigen::MatrixXd HeldStructure::solve(const Eigen::MatrixXd& load) const {
  const Eigen::MatrixXd moving = motions_.transpose() * load;
  const Eigen::MatrixXd balanced = load - moments_ * moving;
  Eigen::MatrixXd u = supported_.solve(balanced);
  if (!u.allFinite()) throw SingularStiffness();
  u -= motions_ * (moments_.transpose() * u);
  return u + compliance_ * (motions_ * moving);
}

void fill_static_receptance(const Problem& problem, const Eigen::MatrixXd& motions,
                            ContactReceptance& result) {
  const Eigen::MatrixXd directions(contact_directions(problem));
  const Eigen::VectorXd load = load_coefficient(problem, 0).real();
  const HeldStructure held(problem, motions, problem.base_frequency());
  result.receptance.front() = (directions.transpose() * held.solve(directions)).cast<std::complex<double>>();
  result.free_response.row(0) =
      (directions.transpose() * held.solve(load)).transpose().cast<std::complex<double>>();

  const auto [turned, count] = felt_first(problem, motions);
  const Eigen::VectorXd moving = turned.transpose() * load;
  const double scale = (turned.cwiseAbs().transpose() * load.cwiseAbs()).maxCoeff();
  const Eigen::VectorXd unfelt = moving.tail(moving.size() - count);
  if (unfelt.size() > 0 && unfelt.lpNorm<Eigen::Infinity>() > kBalanced * scale)
    throw unbalanced(problem, turned.rightCols(unfelt.size()), unfelt);
  if (count == 0) return;
  result.rigid = directions.transpose() * turned.leftCols(count);
  result.rigid_load = moving.head(count);

  // min |R^T f_0 - E^T z| over z >= 0: what is left is a motion that the load drives and no contact stops.
  const Eigen::MatrixXd& E = result.rigid;
  const std::vector<bool> held_rows(static_cast<std::size_t>(E.rows()), false);
  const auto z = solve_small_lcp(E * E.transpose(), -(E * result.rigid_load), held_rows);
  if (!z) return;
  const Eigen::VectorXd rest = result.rigid_load - E.transpose() * *z;
  if (rest.lpNorm<Eigen::Infinity>() > kBalanced * scale)
    throw unbalanced(problem, turned.leftCols(count), rest);
}

bool factorise_or_hold(const Problem& problem, const HarmonicWeights& weight, DynamicStiffness& stiffness,
                       ContactReceptance& result) {
  try {
    stiffness.factorise(weight);
    return true;
  } catch (const SingularStiffness&) {
    if (weight.mass != 0.0 || weight.damping != 0.0) throw;
    if (const std::string why = penalty_explanation(problem.stiffness()); !why.empty())
      throw SingularStiffness(why);
    const Eigen::MatrixXd motions = rigid_motions(problem);
    if (motions.cols() == 0) throw SingularStiffness();
    fill_static_receptance(problem, motions, result);
    return false;
  }
}

}  // namespace signorini
