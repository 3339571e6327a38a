#include "methods/structure/condensation.hpp"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <complex>
#include <limits>
#include <map>
#include <optional>

#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

struct Split {
  std::vector<int> kept, massless;  // coordinates
};

Split split_by_mass(const SparseMatrix& mass) {
  std::vector<bool> heavy(static_cast<std::size_t>(mass.rows()), false);
  for (int column = 0; column < mass.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator it(mass, column); it; ++it) {
      if (it.value() != 0.0) heavy[static_cast<std::size_t>(it.row())] = true;
    }
  }
  Split split;
  for (int dof = 0; dof < mass.rows(); ++dof) {
    (heavy[static_cast<std::size_t>(dof)] ? split.kept : split.massless).push_back(dof);
  }
  return split;
}

// The 0/1 matrix that picks coordinates, Nd x |picked|.
SparseMatrix picking(const std::vector<int>& picked, Eigen::Index size) {
  SparseMatrix P(size, static_cast<Eigen::Index>(picked.size()));
  for (std::size_t i = 0; i < picked.size(); ++i) P.insert(picked[i], static_cast<Eigen::Index>(i)) = 1.0;
  P.makeCompressed();
  return P;
}

// Whether rows or columns of A at the picked coordinates hold more than the rounding of an assembly, in which
// element contributions that should cancel do so only to precision: that of a matrix with entries up to
// `scale`.
bool touches(const SparseMatrix& A, const SparseMatrix& picked, double scale) {
  constexpr double kRoundOff = 64.0 * std::numeric_limits<double>::epsilon();
  return largest_entry(SparseMatrix(A * picked)) > kRoundOff * scale ||
         largest_entry(SparseMatrix(picked.transpose() * A)) > kRoundOff * scale;
}

// beta of D_b. = beta K_b., D_.b = beta K_.b; empty where the damping at b is of another form.
std::optional<double> relaxation_at(const Problem& problem, const SparseMatrix& b) {
  const SparseMatrix &D = problem.damping(), &K = problem.stiffness();
  const double scale = largest_entry(D);
  if (!touches(D, b, scale)) return 0.0;
  const SparseMatrix D_b = D * b, K_b = K * b;
  const double beta = D_b.cwiseProduct(K_b).sum() / K_b.squaredNorm();
  if (!(beta > 0.0) || touches(SparseMatrix(D - beta * K), b, scale)) return std::nullopt;
  return beta;
}

// Fills in h omega of the load's harmonics and their amplitudes on all coordinates.
void take_load(const Problem& problem, CondensedStructure& result) {
  std::map<double, Eigen::VectorXcd> amplitudes{{0.0, Eigen::VectorXcd::Zero(problem.size())}};
  for (const ForceTerm& term : problem.force) {
    const double rate = term.harmonic * problem.frequency;
    Eigen::VectorXcd& load =
        amplitudes.try_emplace(rate, Eigen::VectorXcd::Zero(problem.size())).first->second;
    load[term.dof] += std::complex<double>(term.cos, term.harmonic == 0 ? 0.0 : -term.sin);
  }
  result.load.resize(problem.size(), std::ssize(amplitudes));
  for (const auto& [rate, load] : amplitudes) {
    result.load.col(std::ssize(result.rates)) = load;
    result.rates.push_back(rate);
  }
}

// Static elimination of the massless coordinates picked by `b`.
void eliminate(const Problem& problem, const SparseMatrix& i, const SparseMatrix& b,
               CondensedStructure& result) {
  const SparseMatrix K_bb = b.transpose() * problem.stiffness() * b;
  const SparseMatrix K_bi = b.transpose() * problem.stiffness() * i;
  if (!is_definite(K_bb)) {
    result.obstacle = "coordinates without mass have no stiffness of their own";
    return;
  }
  const Eigen::SimplicialLDLT<SparseMatrix> stiffness(K_bb);
  const SparseMatrix W_b = b.transpose() * contact_directions(problem);
  const SparseMatrix follows = stiffness.solve(K_bi);  // u_b = -follows u_i
  const SparseMatrix moved = stiffness.solve(W_b);     // u_b = moved lambda
  const Eigen::MatrixXcd loaded = b.transpose().cast<std::complex<double>>() * result.load;
  const Eigen::MatrixXd real = stiffness.solve(Eigen::MatrixXd(loaded.real()));
  const Eigen::MatrixXd imag = stiffness.solve(Eigen::MatrixXd(loaded.imag()));
  const Eigen::MatrixXcd carried =
      real.cast<std::complex<double>>() + std::complex<double>(0.0, 1.0) * imag.cast<std::complex<double>>();
  // K_ib K_bb^-1 K_bi is symmetric but for the rounding of the solves; methods rely on exact symmetry.
  const SparseMatrix pulled = K_bi.transpose() * follows;
  const SparseMatrix softened = 0.5 * (pulled + SparseMatrix(pulled.transpose()));
  result.stiffness -= softened;
  if (result.relaxation > 0.0) result.damping -= result.relaxation * softened;
  result.normals -= SparseMatrix(K_bi.transpose() * moved);
  result.massless_compliance = Eigen::MatrixXd(W_b.transpose() * moved);
  result.shift = W_b.transpose().cast<std::complex<double>>() * carried;
  if (result.massless_compliance.isZero(0.0)) result.relaxation = 0.0;  // no contact acts there
  result.load = (i.transpose().cast<std::complex<double>>() * result.load -
                 K_bi.transpose().cast<std::complex<double>>() * carried)
                    .eval();
}

}  // namespace

CondensedStructure condense(const Problem& problem, int most) {
  CondensedStructure result;
  if (problem.size() > most) {
    result.obstacle =
        fmt::format("{} coordinates: at most {} are followed through time", problem.size(), most);
    return result;
  }
  const Split split = split_by_mass(problem.mass());
  const SparseMatrix i = picking(split.kept, problem.size()), b = picking(split.massless, problem.size());
  const std::optional<double> relaxation = relaxation_at(problem, b);
  if (!relaxation) {
    result.obstacle = "the damping of coordinates without mass is not proportional to their stiffness";
    return result;
  }
  result.relaxation = *relaxation;
  result.kept = split.kept;
  result.mass = i.transpose() * problem.mass() * i;
  result.damping = i.transpose() * problem.damping() * i;
  result.stiffness = i.transpose() * problem.stiffness() * i;
  result.normals = i.transpose() * contact_directions(problem);
  result.massless_compliance = Eigen::MatrixXd::Zero(problem.contact_count(), problem.contact_count());
  take_load(problem, result);
  result.shift = Eigen::MatrixXcd::Zero(problem.contact_count(), result.load.cols());
  if (!split.massless.empty()) eliminate(problem, i, b, result);
  return result;
}

std::string flow_obstacle(const Problem& problem) {
  const CondensedStructure structure = condense(problem);
  if (!structure.obstacle.empty()) return structure.obstacle;
  if (structure.relaxation > 0.0)
    return "a coordinate without mass is damped: its equation is of first order";
  const Eigen::SimplicialLLT<SparseMatrix> mass(structure.mass);
  return mass.info() == Eigen::Success ? "" : "the mass matrix is singular on the coordinates with mass";
}

}  // namespace signorini
