#include "methods/structure/bases/condensation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "methods/structure/bases/massless_elimination.hpp"
#include "problems/linear_algebra/sparse/sparse_factors.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

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

// Whether the rows of K at b are its columns there, to the rounding of an assembly.
bool pulls_back(const SparseMatrix& K, const SparseMatrix& b) {
  return is_symmetric(K) || !touches(SparseMatrix(K - SparseMatrix(K.transpose())), b, largest_entry(K));
}

// K_ib K_bb^-1 K_bi: by what the massless coordinates soften the others.
SparseMatrix softening(const SparseMatrix& K, const SparseMatrix& i, const SparseMatrix& b) {
  const SparseMatrix K_bi = b.transpose() * K * i;
  const SparseLdlt stiffness(SparseMatrix(b.transpose() * K * b));
  const SparseMatrix follows = stiffness.solve(K_bi);  // u_b = -follows u_i
  const SparseMatrix pulled = K_bi.transpose() * follows;
  // Symmetric but for the rounding of the solves; methods rely on exact symmetry.
  return 0.5 * (pulled + SparseMatrix(pulled.transpose()));
}

// Mass, damping and stiffness of the coordinates with mass and the relaxation time of the others, or the
// obstacle.
void condense_massless(const Problem& problem, const MasslessElimination& seen, CondensedStructure& result) {
  const SparseMatrix i = coordinate_selection(seen.kept, problem.size());
  const SparseMatrix b = coordinate_selection(seen.massless, problem.size());
  if (!pulls_back(problem.stiffness(), b)) {
    result.obstacle = "a circulatory force acts on coordinates without mass";
    return;
  }
  const std::optional<double> relaxation = relaxation_at(problem, b);
  if (!relaxation) {
    result.obstacle =
        "the damping of coordinates without mass, as faces of damped stops are, is not the same multiple of "
        "their stiffness";
    return;
  }
  result.obstacle = seen.obstacle;  // their stiffness is singular
  if (!result.obstacle.empty()) return;
  result.relaxation = *relaxation;
  result.mass = i.transpose() * problem.mass() * i;
  result.damping = i.transpose() * problem.damping() * i;
  result.stiffness = i.transpose() * problem.stiffness() * i;
  const SparseMatrix softened = softening(problem.stiffness(), i, b);
  result.stiffness -= softened;
  if (*relaxation > 0.0) result.damping -= *relaxation * softened;
}

}  // namespace

CondensedStructure condense(const Problem& problem, int most) {
  CondensedStructure result;
  if (problem.size() > most) {
    result.obstacle =
        fmt::format("{} coordinates: at most {} are followed through time", problem.size(), most);
    return result;
  }
  MasslessElimination seen = eliminate_massless(problem);
  if (seen.massless.empty()) {
    result.mass = problem.mass();
    result.damping = problem.damping();
    result.stiffness = problem.stiffness();
  } else {
    condense_massless(problem, seen, result);
  }
  if (!result.obstacle.empty()) return result;
  result.kept = std::move(seen.kept);
  result.normals = std::move(seen.normals);
  result.massless_compliance = std::move(seen.compliance);
  // Where no contact acts on massless coordinates, nothing relaxes.
  if (result.massless_compliance.isZero(0.0)) result.relaxation = 0.0;
  result.rates = std::move(seen.rates);
  result.load = std::move(seen.load);
  result.shift = std::move(seen.shift);
  return result;
}

CondensedStructure with_open_contacts(CondensedStructure all, const std::vector<int>& acting) {
  const Eigen::MatrixXd normals = all.normals;
  std::vector<int> open;
  for (int j = 0; j < static_cast<int>(normals.cols()); ++j) {
    if (!std::ranges::binary_search(acting, j)) open.push_back(j);
  }
  if (open.empty()) return all;
  all.open = {.contacts = open,
              .normals = normals(Eigen::all, open),
              .compliance = all.massless_compliance(open, acting),
              .shift = all.shift(open, Eigen::all)};
  all.acting = acting;
  all.normals = Eigen::MatrixXd(normals(Eigen::all, acting)).sparseView();
  all.massless_compliance = all.massless_compliance(acting, acting).eval();
  all.shift = all.shift(acting, Eigen::all).eval();
  return all;
}

std::string spring_on_relaxing(int contact) {
  return fmt::format("contact {} is a spring on a coordinate without mass that is damped", contact);
}

std::string flow_obstacle(const Problem& problem) {
  const CondensedStructure structure = condense(problem);
  if (!structure.obstacle.empty()) return structure.obstacle;
  const Eigen::VectorXd springs = stop_compliance(problem);
  for (int j = 0; structure.relaxation > 0.0 && j < problem.contact_count(); ++j) {
    if (springs[j] > 0.0 && structure.massless_compliance(j, j) > 0.0) return spring_on_relaxing(j);
  }
  if (structure.relaxation > 0.0 && problem.size() > kMostRelaxing)
    return fmt::format("{} coordinates: at most {} are followed through time where massless ones are damped",
                       problem.size(), kMostRelaxing);
  const SparseLlt mass(structure.mass);
  return mass.definite() ? "" : "the mass matrix is singular on the coordinates with mass";
}

}  // namespace signorini
