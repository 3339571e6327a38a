#include "methods/structure/contact_reduction.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "methods/structure/block_lanczos.hpp"
#include "methods/structure/massless_elimination.hpp"

namespace signorini {

namespace {

// Powers of K^-1 M that make a Krylov space better than as many modes, and its largest size with them.
constexpr int kPowers = 6;
constexpr int kMostOfPowers = 300;
constexpr int kLeastVectors = 60;
constexpr int kModes = 100;
// Random columns beside the loads: blocks of 16 solve several times faster than single columns.
constexpr int kRandomColumns = 15;
// Solved for at a time.
constexpr int kColumnsAtOnce = 32;
// 1 / omega^2 relative to the largest, below which a Ritz value is rounding: its vector moves statically.
constexpr double kStatic = 1e-13;

/// Real columns F of the load and what they stand for: f_h is the sum of weight * column.
struct LoadColumns {
  Eigen::MatrixXd columns;  // |i| x Nf
  Eigen::MatrixXcd weight;  // Nf x Nh
};

LoadColumns load_columns(const Eigen::MatrixXcd& load) {
  LoadColumns result;
  std::vector<std::pair<Eigen::Index, bool>> parts;  // harmonic; whether the imaginary part
  for (Eigen::Index h = 0; h < load.cols(); ++h) {
    if (load.col(h).real().squaredNorm() > 0.0) parts.emplace_back(h, false);
    if (load.col(h).imag().squaredNorm() > 0.0) parts.emplace_back(h, true);
  }
  const auto count = static_cast<Eigen::Index>(parts.size());
  result.columns.resize(load.rows(), count);
  result.weight = Eigen::MatrixXcd::Zero(count, load.cols());
  for (Eigen::Index c = 0; c < count; ++c) {
    const auto& [h, imaginary] = parts[static_cast<std::size_t>(c)];
    if (imaginary) {
      result.columns.col(c) = load.col(h).imag();
    } else {
      result.columns.col(c) = load.col(h).real();
    }
    result.weight(c, h) = imaginary ? std::complex<double>(0.0, 1.0) : std::complex<double>(1.0, 0.0);
  }
  return result;
}

SparseMatrix side_by_side(const SparseMatrix& A, const SparseMatrix& B) {
  SparseMatrix both(A.rows(), A.cols() + B.cols());
  both.reserve(A.nonZeros() + B.nonZeros());
  for (const SparseMatrix* part : {&A, &B}) {
    const int first = part == &A ? 0 : static_cast<int>(A.cols());
    for (int column = 0; column < part->outerSize(); ++column) {
      both.startVec(first + column);
      for (SparseMatrix::InnerIterator it(*part, column); it; ++it)
        both.insertBackByOuterInner(first + column, static_cast<int>(it.row())) = it.value();
    }
  }
  both.finalize();
  return both;
}

/// M times columns of uniform numbers: nothing at massless coordinates. The same numbers at every call.
SparseMatrix random_columns(const SparseMatrix& mass) {
  std::mt19937 random(1);
  Eigen::MatrixXd columns(mass.rows(), kRandomColumns);
  constexpr double kRange = 4294967296.0;
  for (double& value : columns.reshaped()) value = static_cast<double>(random()) / kRange - 0.5;
  return Eigen::MatrixXd(mass * columns).sparseView();
}

/// B^T P^-1 B, a few columns of B at a time.
Eigen::MatrixXd static_compliance(BlockLanczos& space, const SparseMatrix& B) {
  Eigen::MatrixXd result(B.cols(), B.cols());
  for (Eigen::Index first = 0; first < B.cols(); first += kColumnsAtOnce) {
    const Eigen::Index count = std::min<Eigen::Index>(kColumnsAtOnce, B.cols() - first);
    result.middleCols(first, count) =
        B.transpose() * space.solve(Eigen::MatrixXd(B.middleCols(first, count)));
  }
  return 0.5 * (result + result.transpose());
}

/// Basis and size, none left open.
ReductionSettings chosen(ReductionSettings settings, Eigen::Index contacts, Eigen::Index loads) {
  const auto columns = static_cast<int>(contacts + loads);
  if (settings.basis == ReductionBasis::automatic) {
    settings.basis = kPowers * columns <= kMostOfPowers ? ReductionBasis::krylov : ReductionBasis::modes;
  }
  if (settings.vectors <= 0) {
    settings.vectors =
        settings.basis == ReductionBasis::krylov ? std::max(kPowers * columns, kLeastVectors) : kModes;
  }
  return settings;
}

/// A space, and in its coordinates, V^T K V = 1, the contact directions and the columns of the load.
struct Projection {
  RitzPairs pairs;
  Eigen::MatrixXd contacts;  // V^T N, k x Nc
  Eigen::MatrixXd loads;     // V^T F, k x Nf
  Eigen::MatrixXd outside;   // of N^T K^-1 N, what the space does not hold, Nc x Nc
};

/// Keeps the lowest `most` Ritz vectors and leaves the others to the static residual.
void keep_lowest(const Projection& space, const LoadColumns& loads, Eigen::Index most,
                 ContactReduction& result) {
  const Eigen::VectorXd& theta = space.pairs.values;  // rising
  const Eigen::Index count = theta.size();
  Eigen::Index kept = 0;
  while (kept < std::min(most, count) && theta[count - 1 - kept] > kStatic * theta[count - 1]) ++kept;
  const Eigen::MatrixXd vectors = space.pairs.vectors.rightCols(kept).rowwise().reverse();
  const Eigen::VectorXd omega = theta.tail(kept).reverse().cwiseSqrt().cwiseInverse();
  result.squares = omega.cwiseAbs2();
  result.rows = omega.asDiagonal() * (vectors.transpose() * space.contacts);
  const Eigen::MatrixXd modal = omega.asDiagonal() * (vectors.transpose() * space.loads);
  result.load = modal.cast<std::complex<double>>() * loads.weight;
  const auto rest = space.pairs.vectors.leftCols(count - kept);
  const Eigen::MatrixXd left = rest.transpose() * space.contacts;
  const Eigen::MatrixXd pushed = left.transpose() * (rest.transpose() * space.loads);
  result.compliance += space.outside + left.transpose() * left;
  result.shift += pushed.cast<std::complex<double>>() * loads.weight;
}

}  // namespace

ContactReduction reduce_to_contacts(const Problem& problem, const ReductionSettings& settings) {
  ContactReduction result;
  const auto damping = proportional_damping(problem.mass(), problem.stiffness(), problem.damping());
  if (!damping) {
    result.obstacle = "the damping is not a combination of mass and stiffness";
    return result;
  }
  MasslessElimination seen = eliminate_massless(problem);
  result.obstacle = seen.obstacle;
  if (!result.obstacle.empty()) return result;
  const LoadColumns loads = load_columns(seen.load);
  const ReductionSettings asked = chosen(settings, seen.normals.cols(), loads.columns.cols());
  const SparseMatrix i = coordinate_selection(seen.kept, problem.size());
  const SparseMatrix normals = i * seen.normals;
  const SparseMatrix pushes = i * SparseMatrix(loads.columns.sparseView());
  if (normals.cols() + pushes.cols() == 0) {
    result.obstacle = "nothing acts on the structure";
    return result;
  }
  const bool krylov = asked.basis == ReductionBasis::krylov;
  const SparseMatrix start =
      krylov ? side_by_side(normals, pushes) : side_by_side(pushes, random_columns(problem.mass()));
  BlockLanczos space(problem.stiffness(), problem.mass(), start);
  if (!space.definite()) {
    result.obstacle = "the stiffness is not positive definite";
    return result;
  }
  // Of a Krylov space from random columns the upper half has not converged to modes, nor have the lowest
  // before some powers.
  const Eigen::Index enough = krylov ? asked.vectors : 2 * asked.vectors + kPowers * (kRandomColumns + 1);
  // More vectors than coordinates with mass would be rounding.
  const auto most = static_cast<Eigen::Index>(seen.kept.size());
  while (space.size() < enough && !space.exhausted() && space.size() + space.width() <= most) space.grow();

  Projection projection{.pairs = ritz_pairs(space), .contacts = {}, .loads = {}, .outside = {}};
  const Eigen::Index contacts = normals.cols();
  if (krylov) {
    const Eigen::MatrixXd rows = space.projected_start();
    projection.contacts = rows.leftCols(contacts);
    projection.loads = rows.rightCols(pushes.cols());
    projection.outside = Eigen::MatrixXd::Zero(contacts, contacts);
  } else {
    projection.contacts = space.projected(normals);
    projection.loads = space.projected(pushes);
    projection.outside =
        static_compliance(space, normals) - projection.contacts.transpose() * projection.contacts;
  }
  result.damping = *damping;
  result.compliance = std::move(seen.compliance);
  result.shift = std::move(seen.shift);
  result.rates = std::move(seen.rates);
  const bool whole = space.exhausted() || space.size() >= most;
  result.complete = whole && (krylov || space.size() <= asked.vectors);
  keep_lowest(projection, loads, krylov ? space.size() : asked.vectors, result);
  return result;
}

CondensedStructure condensed(const ContactReduction& reduction) {
  const auto diagonal = [](const Eigen::VectorXd& entries) {
    return SparseMatrix(Eigen::MatrixXd(entries.asDiagonal()).sparseView());
  };
  const auto [alpha, beta] = reduction.damping;
  CondensedStructure result;
  result.obstacle = reduction.obstacle;
  if (!result.obstacle.empty()) return result;
  result.mass = diagonal(Eigen::VectorXd::Ones(reduction.vectors()));
  result.damping = diagonal((alpha + beta * reduction.squares.array()).matrix());
  result.stiffness = diagonal(reduction.squares);
  result.normals = reduction.rows.sparseView();
  result.massless_compliance = reduction.compliance;
  result.relaxation = reduction.compliance.isZero(0.0) ? 0.0 : beta;
  result.rates = reduction.rates;
  result.load = reduction.load;
  result.shift = reduction.shift;
  return result;
}

ContactReceptance contact_receptance(const ContactReduction& reduction, double period, int harmonics,
                                     const WeightsOfHarmonic& weights) {
  using Complex = std::complex<double>;
  const auto [alpha, beta] = reduction.damping;
  const double base = 2.0 * std::numbers::pi / period;
  const Eigen::VectorXd& squares = reduction.squares;
  const Eigen::MatrixXcd rows = reduction.rows.cast<Complex>();
  ContactReceptance result;
  result.period = period;
  result.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, reduction.contacts());
  for (int n = 0; n <= harmonics; ++n) {
    const HarmonicWeights w = weights(n);
    const Complex kappa = w.stiffness + beta * w.damping;
    const Eigen::VectorXcd z = (kappa * squares.cast<Complex>()).array() + (w.mass + alpha * w.damping);
    const double scale = std::abs(w.mass) + std::abs(kappa) * squares.maxCoeff();
    if (!(z.cwiseAbs().minCoeff() > std::numeric_limits<double>::epsilon() * scale))
      throw SingularStiffness();
    const Eigen::MatrixXcd response = z.cwiseInverse().asDiagonal() * rows;
    result.receptance.emplace_back(rows.transpose() * response +
                                   reduction.compliance.cast<Complex>() / kappa);
    for (std::size_t h = 0; h < reduction.rates.size(); ++h) {
      if (std::lround(reduction.rates[h] / base) != n) continue;
      const auto column = static_cast<Eigen::Index>(h);
      const double half = n == 0 ? 1.0 : 0.5;
      result.free_response.row(n) +=
          half * w.load *
          (response.transpose() * reduction.load.col(column) + reduction.shift.col(column) / kappa)
              .transpose();
    }
  }
  return result;
}

}  // namespace signorini
