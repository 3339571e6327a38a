#include "methods/harmonic_balance/continuation/series_symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "methods/structure/receptance.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

namespace {

// How near what is the same by symmetry has to be, of the largest entry.
constexpr double kSame = 1e-9;

double sign_of_harmonic(Eigen::Index n) { return n % 2 == 0 ? 1.0 : -1.0; }

// (-1)^n of a packed coefficient 0, 1c, 1s, 2c, ...
double sign_of_coefficient(Eigen::Index i) { return sign_of_harmonic((i + 1) / 2); }

bool same_receptance(const ContactReceptance& receptance, const std::vector<Eigen::Index>& opposite) {
  for (const Eigen::MatrixXcd& C : receptance.receptance) {
    const Eigen::MatrixXcd exchanged = C(opposite, opposite);
    if ((exchanged - C).cwiseAbs().maxCoeff() > kSame * C.cwiseAbs().maxCoeff()) return false;
  }
  return true;
}

bool opposite_response(const Eigen::MatrixXcd& free, Eigen::Index j, Eigen::Index k) {
  double difference = 0.0;
  for (Eigen::Index n = 0; n < free.rows(); ++n)
    difference = std::max(difference, std::abs(free(n, k) - sign_of_harmonic(n) * free(n, j)));
  return difference <= kSame * free.cwiseAbs().maxCoeff();
}

}  // namespace

std::vector<Eigen::Index> opposite_contacts(const Problem& problem) {
  int harmonics = 4;  // at least
  for (const auto& term : problem.force) harmonics = std::max(harmonics, term.harmonic * problem.subharmonic);
  const auto count = static_cast<Eigen::Index>(problem.contacts.size());
  if (count == 0 || count % 2 != 0) return {};
  const ContactReceptance receptance = fourier_receptance(problem, harmonics);
  std::vector<Eigen::Index> opposite(problem.contacts.size(), -1);
  for (std::size_t j = 0; j < opposite.size(); ++j) {
    for (std::size_t k = j + 1; k < opposite.size() && opposite[j] < 0; ++k) {
      const bool alike = problem.contacts[j].gap == problem.contacts[k].gap &&
                         problem.contacts[j].law == problem.contacts[k].law;
      if (opposite[k] >= 0 || !alike ||
          !opposite_response(receptance.free_response, static_cast<Eigen::Index>(j),
                             static_cast<Eigen::Index>(k)))
        continue;
      opposite[j] = static_cast<Eigen::Index>(k);
      opposite[k] = static_cast<Eigen::Index>(j);
    }
    if (opposite[j] < 0) return {};
  }
  return same_receptance(receptance, opposite) ? opposite : std::vector<Eigen::Index>{};
}

bool half_period_symmetry(const SeriesCurve& curve) {
  return !curve.family().opposite.empty() && curve.multiple() % 2 == 1;
}

Eigen::VectorXd mirrored(const SeriesCurve& curve, const Eigen::VectorXd& x) {
  const std::vector<Eigen::Index>& opposite = curve.family().opposite;
  const Eigen::Index stride = 2 * curve.harmonics() + 1;
  Eigen::VectorXd result = x;
  for (std::size_t j = 0; j < opposite.size(); ++j) {
    for (Eigen::Index i = 0; i < stride; ++i)
      result[static_cast<Eigen::Index>(j) * stride + i] =
          sign_of_coefficient(i) * x[opposite[j] * stride + i];
  }
  return result;
}

bool is_symmetric(const SeriesCurve& curve, const Eigen::VectorXd& x) {
  return half_period_symmetry(curve) && (mirrored(curve, x) - x).norm() <= kSame * x.norm();
}

namespace {

// The rows of each pair (j, j'), j < j', first those of j: an orthonormal basis of S v = -v is
// (e_ji - (-1)^n e_j'i) / sqrt(2).
struct PairedRows {
  std::vector<Eigen::Index> first = {}, second = {};
  Eigen::VectorXd sign = {};
};

PairedRows paired_rows(const SeriesCurve& curve) {
  const std::vector<Eigen::Index>& opposite = curve.family().opposite;
  const Eigen::Index stride = 2 * curve.harmonics() + 1;
  PairedRows rows{.sign = Eigen::VectorXd(stride * static_cast<Eigen::Index>(opposite.size() / 2))};
  for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(opposite.size()); ++j) {
    const Eigen::Index other = opposite[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < stride && j < other; ++i) {
      rows.sign[std::ssize(rows.first)] = sign_of_coefficient(i);
      rows.first.push_back(j * stride + i);
      rows.second.push_back(other * stride + i);
    }
  }
  return rows;
}

}  // namespace

Eigen::MatrixXd antisymmetric_block(const SeriesCurve& curve) {
  const auto [first, second, sign] = paired_rows(curve);
  const auto S = sign.asDiagonal();
  const Eigen::MatrixXd J = curve.jacobian();
  return 0.5 * (J(first, first) - J(first, second) * S - S * J(second, first) + S * J(second, second) * S);
}

double pitchfork_test(const SeriesCurve& curve) {
  const Eigen::MatrixXd block = antisymmetric_block(curve);
  return std::copysign(least_singular_value(block), signed_pivots(block));
}

std::vector<SeriesStart> pitchfork_branches(const SeriesCurve& curve, const Eigen::VectorXd& tangent) {
  const Eigen::VectorXd null = right_singular_vectors(antisymmetric_block(curve)).rightCols(1);
  const auto [first, second, sign] = paired_rows(curve);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(curve.size() + 1);
  direction(first) = null / std::numbers::sqrt2;
  direction(second) = -sign.cwiseProduct(direction(first));
  return both_ways(curve, direction, tangent);
}

AnyEquations symmetric_motions(SeriesCurve& curve) {
  AnyEquations equations(curve);
  equations.settle = [&curve](Eigen::VectorXd& x) { x = (0.5 * (x + mirrored(curve, x))).eval(); };
  return equations;
}

}  // namespace signorini
