#include "methods/structure/bases/massless_elimination.hpp"

#include <complex>
#include <map>

#include "problems/linear_algebra/sparse/sparse_factors.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

void split_by_mass(const SparseMatrix& mass, MasslessElimination& result) {
  std::vector<bool> heavy(static_cast<std::size_t>(mass.rows()), false);
  for (int column = 0; column < mass.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator it(mass, column); it; ++it) {
      if (it.value() != 0.0) heavy[static_cast<std::size_t>(it.row())] = true;
    }
  }
  for (int dof = 0; dof < mass.rows(); ++dof) {
    (heavy[static_cast<std::size_t>(dof)] ? result.kept : result.massless).push_back(dof);
  }
}

// Fills in h omega of the load's harmonics and their amplitudes on all coordinates.
void take_load(const Problem& problem, MasslessElimination& result) {
  std::map<double, Eigen::VectorXcd> amplitudes{{0.0, Eigen::VectorXcd::Zero(problem.size())}};
  for (const ForceTerm& term : problem.force) {
    const double rate = term.harmonic * problem.frequency;
    Eigen::VectorXcd& load =
        amplitudes.try_emplace(rate, Eigen::VectorXcd::Zero(problem.size())).first->second;
    load[term.dof] += force_amplitude(term, problem.frequency);
  }
  result.load.resize(problem.size(), std::ssize(amplitudes));
  for (const auto& [rate, load] : amplitudes) {
    result.load.col(std::ssize(result.rates)) = load;
    result.rates.push_back(rate);
  }
}

}  // namespace

SparseMatrix coordinate_selection(const std::vector<int>& picked, Eigen::Index size) {
  SparseMatrix P(size, static_cast<Eigen::Index>(picked.size()));
  for (std::size_t i = 0; i < picked.size(); ++i) P.insert(picked[i], static_cast<Eigen::Index>(i)) = 1.0;
  P.makeCompressed();
  return P;
}

MasslessElimination eliminate_massless(const Problem& problem) {
  using Complex = std::complex<double>;
  MasslessElimination result;
  split_by_mass(problem.mass(), result);
  const SparseMatrix W = contact_directions(problem);
  SparseMatrix i, b, K_bi, K_bb;
  if (!result.massless.empty()) {
    i = coordinate_selection(result.kept, problem.size());
    b = coordinate_selection(result.massless, problem.size());
    const SparseMatrix K_b = b.transpose() * problem.stiffness();
    K_bb = K_b * b;
    if (!is_definite(K_bb)) {
      result.obstacle = "coordinates without mass have no stiffness of their own";
      return result;
    }
    K_bi = K_b * i;
  }
  result.normals = result.massless.empty() ? W : SparseMatrix(i.transpose() * W);
  result.massless_compliance = Eigen::MatrixXd::Zero(problem.contact_count(), problem.contact_count());
  take_load(problem, result);
  result.shift = Eigen::MatrixXcd::Zero(problem.contact_count(), result.load.cols());
  if (result.massless.empty()) return result;
  const SparseLdlt stiffness(K_bb);
  const SparseMatrix W_b = b.transpose() * W;
  result.following = stiffness.solve(W_b);
  const SparseMatrix& moved = result.following;  // u_b = moved lambda
  const Eigen::MatrixXcd loaded = b.transpose().cast<Complex>() * result.load;
  const Eigen::MatrixXd real = stiffness.solve(Eigen::MatrixXd(loaded.real()));
  const Eigen::MatrixXd imag = stiffness.solve(Eigen::MatrixXd(loaded.imag()));
  const Eigen::MatrixXcd carried = real.cast<Complex>() + Complex(0.0, 1.0) * imag.cast<Complex>();
  result.normals -= SparseMatrix(K_bi.transpose() * moved);
  result.massless_compliance = Eigen::MatrixXd(W_b.transpose() * moved);
  result.shift = W_b.transpose().cast<Complex>() * carried;
  result.load =
      (i.transpose().cast<Complex>() * result.load - K_bi.transpose().cast<Complex>() * carried).eval();
  return result;
}

}  // namespace signorini
