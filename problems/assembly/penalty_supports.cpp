#include "problems/assembly/penalty_supports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace signorini {

namespace {

constexpr double kPenaltyRatio = 1e12;  // of the usual diagonal
constexpr double kTied = 1.0 - 1e-6;    // of the root of both diagonals: a link carries all of them

struct StrongestCoupling {
  int other = -1;
  double value = 0.0;
};

StrongestCoupling strongest_coupling(const SparseMatrix& K, int i) {
  StrongestCoupling strongest;
  for (SparseMatrix::InnerIterator entry(K, i); entry; ++entry) {
    if (entry.row() == i || !(std::abs(entry.value()) > strongest.value)) continue;
    strongest = {static_cast<int>(entry.row()), std::abs(entry.value())};
  }
  return strongest;
}

// The median of the diagonal above 0, of rows that no single link carries; where links carry all, the least.
double usual_stiffness(const SparseMatrix& K, const Eigen::VectorXd& diagonal) {
  std::vector<double> apart;
  double least = 0.0;
  for (int i = 0; i < diagonal.size(); ++i) {
    if (!(diagonal(i) > 0.0)) continue;
    least = least > 0.0 ? std::min(least, diagonal(i)) : diagonal(i);
    const auto [other, value] = strongest_coupling(K, i);
    const bool tied = other >= 0 && value >= kTied * std::sqrt(diagonal(i) * diagonal(other));
    if (!tied) apart.push_back(diagonal(i));
  }
  if (apart.empty()) return least;
  const auto middle = apart.begin() + (std::ssize(apart) - 1) / 2;
  std::ranges::nth_element(apart, middle);
  return *middle;
}

}  // namespace

std::vector<PenaltySpring> penalty_springs(const SparseMatrix& K) {
  constexpr double kCoupling = 1e-10;  // of the diagonal: else it is a link to another coordinate
  const Eigen::VectorXd diagonal = K.diagonal();
  std::vector<PenaltySpring> springs;
  const double usual = usual_stiffness(K, diagonal);
  for (int i = 0; i < diagonal.size() && usual > 0.0; ++i) {
    if (!(diagonal(i) > kPenaltyRatio * usual)) continue;
    const StrongestCoupling coupling = strongest_coupling(K, i);
    springs.push_back({.coordinate = i,
                       .tied_to = coupling.value > kCoupling * diagonal(i) ? coupling.other : -1,
                       .stiffness = diagonal(i),
                       .usual = usual});
  }
  return springs;
}

std::vector<int> hold_supports(Structure& structure, std::vector<std::string>& notices) {
  std::vector<int> held;
  const std::vector<PenaltySpring> springs = penalty_springs(structure.stiffness);
  for (const PenaltySpring& spring : springs) {
    if (spring.tied_to >= 0) continue;
    held.push_back(spring.coordinate);
    notices.push_back(fmt::format(
        "stiffness: {:.3g} N/m at coordinate {}, {:.1g} times the median, is a support by penalty: "
        "the coordinate is held at rest, and loads on it move nothing",
        spring.stiffness, spring.coordinate, spring.stiffness / spring.usual));
  }
  if (held.empty()) return held;
  for (SparseMatrix* A : {&structure.mass, &structure.damping, &structure.stiffness})
    if (A->rows() > 0) uncouple(*A, held);  // without damping before its model is read
  for (const int i : held) structure.stiffness.coeffRef(i, i) = springs.front().usual;
  structure.stiffness.makeCompressed();
  return held;
}

void uncouple(SparseMatrix& A, const std::vector<int>& coordinates) {
  std::vector<bool> alone(static_cast<std::size_t>(A.rows()), false);
  for (const int i : coordinates) alone.at(static_cast<std::size_t>(i)) = true;
  A.prune([&](Eigen::Index row, Eigen::Index column, double) {
    return !alone[static_cast<std::size_t>(row)] && !alone[static_cast<std::size_t>(column)];
  });
}

std::string penalty_explanation(const SparseMatrix& K) {
  const std::vector<PenaltySpring> springs = penalty_springs(K);
  if (springs.empty()) return {};
  const PenaltySpring& first = springs.front();
  return fmt::format(
      "stiffness {} is {:.3g} N/m, {:.1g} times the median of the diagonal, which is rounding beside it: {}",
      first.tied_to < 0 ? fmt::format("of coordinate {}", first.coordinate)
                        : fmt::format("between coordinates {} and {}", first.coordinate, first.tied_to),
      first.stiffness, first.stiffness / first.usual,
      first.tied_to < 0 ? "leave a fixed coordinate out, or support it less stiffly"
                        : "make the two coordinates one, or join them less stiffly");
}

}  // namespace signorini
