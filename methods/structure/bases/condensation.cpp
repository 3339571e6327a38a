#include "methods/structure/bases/condensation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "problems/linear_algebra/sparse/sparse_factors.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

// Whether rows or columns of A at the picked coordinates hold more than the rounding of an assembly, in which
// element contributions that should cancel do so only to precision: that of a matrix with entries up to
// `scale`.
bool touches(const SparseMatrix& A, const SparseMatrix& picked, double scale) {
  return largest_entry(SparseMatrix(A * picked)) > kSumRounding * scale ||
         largest_entry(SparseMatrix(picked.transpose() * A)) > kSumRounding * scale;
}

// beta of each massless coordinate, D_b. = beta K_b., D_.b = K_.b beta: that of all where there is one. Empty
// where the damping at b is of another form.
std::optional<Eigen::VectorXd> relaxation_at(const Problem& problem, const SparseMatrix& b) {
  const SparseMatrix &D = problem.damping(), &K = problem.stiffness();
  const double scale = largest_entry(D);
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(b.cols());
  if (!touches(D, b, scale)) return beta;
  const SparseMatrix D_b = D * b, K_b = K * b;
  beta.setConstant(D_b.cwiseProduct(K_b).sum() / K_b.squaredNorm());
  if (beta[0] > 0.0 && !touches(SparseMatrix(D - beta[0] * K), b, scale)) return beta;
  for (Eigen::Index k = 0; k < beta.size(); ++k) {
    const bool damped = D_b.col(k).norm() > kSumRounding * scale;
    beta[k] = damped ? D_b.col(k).dot(K_b.col(k)) / K_b.col(k).squaredNorm() : 0.0;
  }
  const SparseMatrix of_columns = D_b - SparseMatrix(K_b * beta.asDiagonal());
  const SparseMatrix of_rows =
      SparseMatrix(b.transpose() * D) - SparseMatrix(beta.asDiagonal() * SparseMatrix(b.transpose() * K));
  const double off = std::max(largest_entry(of_columns), largest_entry(of_rows));
  if (!(beta.minCoeff() >= 0.0) || off > kSumRounding * scale) return std::nullopt;
  return beta;
}

// beta of each contact from those of the massless coordinates b that it moves, K_bb^-1 W_b; in `obstacle` why
// it has none.
Eigen::VectorXd relaxation_of_contacts(const MasslessElimination& seen, const Eigen::VectorXd& beta,
                                       std::string& obstacle) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(seen.normals.cols());
  const double most = beta.size() > 0 ? beta.maxCoeff() : 0.0;
  if (!(most > 0.0)) return result;
  for (int j = 0; j < seen.following.outerSize(); ++j) {
    double least = most;
    bool moves = false;
    for (SparseMatrix::InnerIterator it(seen.following, j); it; ++it) {
      if (it.value() == 0.0) continue;
      moves = true;
      least = std::min(least, beta[it.row()]);
      result[j] = std::max(result[j], beta[it.row()]);
    }
    if (moves && least < (1.0 - kMatrixRounding) * result[j])
      obstacle = fmt::format("contact {} is on coordinates without mass that relax in different times", j);
    if (moves && result[j] == 0.0)
      obstacle = fmt::format(
          "contact {} is on a coordinate without mass or damping, beside others without mass that are damped",
          j);
  }
  return result;
}

// Whether the rows of K at b are its columns there, to the rounding of an assembly.
bool pulls_back(const SparseMatrix& K, const SparseMatrix& b) {
  return is_symmetric(K) || !touches(SparseMatrix(K - SparseMatrix(K.transpose())), b, largest_entry(K));
}

// By what the massless coordinates soften the others, K_ib K_bb^-1 K_bi, and the same of their damping, K_ib
// K_bb^-1 beta K_bi.
struct Softening {
  SparseMatrix stiffness, damping;
};

Softening softening(const SparseMatrix& K, const SparseMatrix& i, const SparseMatrix& b,
                    const Eigen::VectorXd& beta) {
  const SparseMatrix K_bi = b.transpose() * K * i;
  const SparseLdlt stiffness(SparseMatrix(b.transpose() * K * b));
  const SparseMatrix follows = stiffness.solve(K_bi);  // u_b = -follows u_i
  // Symmetric but for the rounding of the solves; methods rely on exact symmetry.
  const auto symmetric = [](const SparseMatrix& A) -> SparseMatrix {
    return 0.5 * (A + SparseMatrix(A.transpose()));
  };
  const SparseMatrix relaxing = beta.asDiagonal() * follows;
  return {.stiffness = symmetric(SparseMatrix(K_bi.transpose() * follows)),
          .damping = symmetric(SparseMatrix(K_bi.transpose() * relaxing))};
}

// Fills in mass, damping and stiffness of the coordinates with mass, beside others, and the relaxation times
// of the contacts on those. Returns the obstacle.
std::string condense_massless(const Problem& problem, CondensedStructure& result) {
  const SparseMatrix i = coordinate_selection(result.kept, problem.size());
  const SparseMatrix b = coordinate_selection(result.massless, problem.size());
  if (!pulls_back(problem.stiffness(), b)) return "a circulatory force acts on coordinates without mass";
  const std::optional<Eigen::VectorXd> relaxation = relaxation_at(problem, b);
  if (!relaxation) return "the damping of coordinates without mass is not proportional to their stiffness";
  std::string obstacle = result.obstacle;  // their stiffness is singular
  if (!obstacle.empty()) return obstacle;
  result.relaxation = relaxation_of_contacts(result, *relaxation, obstacle);
  if (!obstacle.empty()) return obstacle;
  const Softening softened = softening(problem.stiffness(), i, b, *relaxation);
  result.mass = i.transpose() * problem.mass() * i;
  result.damping = i.transpose() * problem.damping() * i;
  result.stiffness = SparseMatrix(i.transpose() * problem.stiffness() * i) - softened.stiffness;
  if (relaxation->maxCoeff() > 0.0) result.damping -= softened.damping;
  return {};
}

CondensedStructure refused(std::string obstacle) {
  CondensedStructure result;
  result.obstacle = std::move(obstacle);
  return result;
}

}  // namespace

CondensedStructure condense(const Problem& problem, int most) {
  if (problem.size() > most)
    return refused(fmt::format("{} coordinates: at most {} are followed through time", problem.size(), most));
  CondensedStructure result;
  static_cast<MasslessElimination&>(result) = eliminate_massless(problem);
  if (!result.massless.empty()) {
    std::string obstacle = condense_massless(problem, result);
    if (!obstacle.empty()) return refused(std::move(obstacle));
    return result;
  }
  result.mass = problem.mass();
  result.damping = problem.damping();
  result.stiffness = problem.stiffness();
  result.relaxation = Eigen::VectorXd::Zero(result.normals.cols());
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
              .shift = all.shift(open, Eigen::all),
              .relaxation = all.relaxation(open)};
  all.acting = acting;
  all.normals = Eigen::MatrixXd(normals(Eigen::all, acting)).sparseView();
  all.following = {};
  all.massless_compliance = all.massless_compliance(acting, acting).eval();
  all.shift = all.shift(acting, Eigen::all).eval();
  all.relaxation = all.relaxation(acting).eval();
  return all;
}

std::string spring_on_relaxing(int contact) {
  return fmt::format("contact {} is a spring on a coordinate without mass that is damped", contact);
}

std::string flow_obstacle(const Problem& problem) {
  const CondensedStructure structure = condense(problem);
  if (!structure.obstacle.empty()) return structure.obstacle;
  const Eigen::VectorXd springs = stop_compliance(problem);
  for (int j = 0; j < problem.contact_count(); ++j) {
    if (springs[j] > 0.0 && structure.relaxation[j] > 0.0) return spring_on_relaxing(j);
  }
  if (!structure.relaxation.isZero(0.0) && problem.size() > kMostRelaxing)
    return fmt::format("{} coordinates: at most {} are followed through time where massless ones are damped",
                       problem.size(), kMostRelaxing);
  const SparseLlt mass(structure.mass);
  return mass.definite() ? "" : "the mass matrix is singular on the coordinates with mass";
}

}  // namespace signorini
