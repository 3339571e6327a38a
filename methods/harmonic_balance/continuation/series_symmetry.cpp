#include "methods/harmonic_balance/continuation/series_symmetry.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "methods/structure/receptance.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

namespace {

double sign_of_harmonic(Eigen::Index n) { return n % 2 == 0 ? 1.0 : -1.0; }

// (-1)^n of a packed coefficient 0, 1c, 1s, 2c, ...
double sign_of_coefficient(Eigen::Index i) { return sign_of_harmonic((i + 1) / 2); }

bool same_receptance(const ContactReceptance& receptance, const std::vector<Eigen::Index>& opposite) {
  constexpr double kSame = 1e-9;  // of the largest entry
  for (const Eigen::MatrixXcd& C : receptance.receptance) {
    Eigen::MatrixXcd exchanged = C;
    for (Eigen::Index i = 0; i < C.rows(); ++i) {
      for (Eigen::Index j = 0; j < C.cols(); ++j)
        exchanged(i, j) = C(opposite[static_cast<std::size_t>(i)], opposite[static_cast<std::size_t>(j)]);
    }
    if ((exchanged - C).cwiseAbs().maxCoeff() > kSame * C.cwiseAbs().maxCoeff()) return false;
  }
  return true;
}

bool opposite_response(const Eigen::MatrixXcd& free, Eigen::Index j, Eigen::Index k) {
  constexpr double kSame = 1e-9;  // of the largest harmonic
  double difference = 0.0;
  for (Eigen::Index n = 0; n < free.rows(); ++n)
    difference = std::max(difference, std::abs(free(n, k) - sign_of_harmonic(n) * free(n, j)));
  return difference <= kSame * free.cwiseAbs().maxCoeff();
}

}  // namespace

std::vector<Eigen::Index> opposite_contacts(const Problem& problem) {
  constexpr int kHarmonics = 4;
  int harmonics = kHarmonics;
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
  constexpr double kSame = 1e-9;
  return half_period_symmetry(curve) && (mirrored(curve, x) - x).norm() <= kSame * x.norm();
}

namespace {

// The rows of each pair (j, j'), j < j', first those of j: an orthonormal basis of S v = -v is
// (e_ji - (-1)^n e_j'i) / sqrt(2).
struct PairedRow {
  Eigen::Index first, second;
  double sign;
};

std::vector<PairedRow> paired_rows(const SeriesCurve& curve) {
  const std::vector<Eigen::Index>& opposite = curve.family().opposite;
  const Eigen::Index stride = 2 * curve.harmonics() + 1;
  std::vector<PairedRow> rows;
  for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(opposite.size()); ++j) {
    const Eigen::Index other = opposite[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < stride && j < other; ++i)
      rows.push_back({.first = j * stride + i, .second = other * stride + i, .sign = sign_of_coefficient(i)});
  }
  return rows;
}

}  // namespace

Eigen::MatrixXd antisymmetric_block(const SeriesCurve& curve) {
  const std::vector<PairedRow> pairs = paired_rows(curve);
  const Eigen::MatrixXd J = curve.jacobian();
  const auto n = static_cast<Eigen::Index>(pairs.size());
  Eigen::MatrixXd block(n, n);
  for (Eigen::Index r = 0; r < n; ++r) {
    const PairedRow& row = pairs[static_cast<std::size_t>(r)];
    for (Eigen::Index c = 0; c < n; ++c) {
      const PairedRow& column = pairs[static_cast<std::size_t>(c)];
      block(r, c) = 0.5 * (J(row.first, column.first) - column.sign * J(row.first, column.second) -
                           row.sign * J(row.second, column.first) +
                           row.sign * column.sign * J(row.second, column.second));
    }
  }
  return block;
}

double pitchfork_test(const SeriesCurve& curve) {
  const Eigen::MatrixXd block = antisymmetric_block(curve);
  return std::copysign(least_singular_value(block), signed_pivots(block));
}

std::vector<SeriesStart> pitchfork_branches(const SeriesCurve& curve, const Eigen::VectorXd& tangent) {
  const Eigen::VectorXd null = right_singular_vectors(antisymmetric_block(curve)).rightCols(1);
  const std::vector<PairedRow> pairs = paired_rows(curve);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(curve.size() + 1);
  for (std::size_t r = 0; r < pairs.size(); ++r) {
    const double entry = null[static_cast<Eigen::Index>(r)] / std::numbers::sqrt2;
    direction[pairs[r].first] = entry;
    direction[pairs[r].second] = -pairs[r].sign * entry;
  }
  return both_ways(curve, direction, tangent);
}

}  // namespace signorini
