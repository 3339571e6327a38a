#include "methods/linear_flow/modes/spring_modes.hpp"

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "methods/solvers/dense_products.hpp"
#include "methods/solvers/rank_one.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

namespace {

using Eigen::Index;

// The undamped modes of a structure that is damped by alpha M + beta K.
struct ProportionalModes {
  std::vector<long double> squares;  // l_k, ascending
  Eigen::MatrixXd shapes;            // S, S^T M S = 1
  long double alpha = 0.0L, beta = 0.0L;
};

// Of modes that damping does not couple, one pair or two real mu for each undamped mode.
std::optional<ProportionalModes> proportional_modes(const ComplexModes& modes) {
  constexpr long double kRounded = 1e-12L;  // of each damping
  const Index n = modes.shapes.rows();
  ProportionalModes result{.squares = {}, .shapes = Eigen::MatrixXd(n, n)};
  std::vector<long double> damping;
  for (Index place = 0; place < modes.mu.size();) {
    const bool pair = modes.weight[place] > 1.0;
    if (std::ssize(damping) == n || (!pair && place + 1 == modes.mu.size())) return std::nullopt;
    const std::complex<long double> mu = modes.mu[place];
    const std::complex<long double> other =
        pair ? std::conj(mu) : std::complex<long double>(modes.mu[place + 1]);
    if (!modes.shapes.col(place).imag().isZero(0.0)) return std::nullopt;
    result.shapes.col(std::ssize(damping)) = modes.shapes.col(place).real();
    result.squares.push_back((mu * other).real());
    damping.push_back(-(mu + other).real());
    place += pair ? 1 : 2;
  }
  if (n < 2 || std::ssize(damping) != n) return std::nullopt;
  result.beta = (damping.back() - damping.front()) / (result.squares.back() - result.squares.front());
  result.alpha = damping.front() - result.beta * result.squares.front();
  for (std::size_t k = 0; k < damping.size(); ++k) {
    const long double misfit = damping[k] - result.alpha - result.beta * result.squares[k];
    if (!(std::abs(misfit) <= kRounded * std::abs(damping[k]))) return std::nullopt;
  }
  return result;
}

}  // namespace

std::optional<ComplexModes> modes_with_springs(const ComplexModes& without, const SparseMatrix& mass,
                                               const GroundedSprings& springs, double rate) {
  std::optional<ProportionalModes> modes = proportional_modes(without);
  if (!modes) return std::nullopt;
  DashpotCoupling coupling{.shares = transposed_product(modes->shapes, springs.directions),
                           .strength = springs.damping};
  Eigen::MatrixXd moved(modes->shapes.rows(), modes->shapes.cols());
  for (Index j = 0; j < springs.stiffness.size(); ++j) {
    auto next = add_rank_one(modes->squares, coupling.shares.col(j), springs.stiffness[j]);
    if (!next) return std::nullopt;
    modes->squares = std::move(next->values);
    set_product(moved, modes->shapes, next->vectors);
    modes->shapes.swap(moved);
    coupling.shares = transposed_product(next->vectors, coupling.shares);
    // alpha + beta (K + springs) damps these modes by themselves; the springs have only c_j of it.
    coupling.strength[j] -= static_cast<double>(modes->beta) * springs.stiffness[j];
  }
  RealModes real{.squares = modes->squares, .damping = {}, .shapes = {}, .coupling = {}};
  for (std::size_t k = 0; k < real.squares.size(); ++k) {
    long double damping = modes->alpha + modes->beta * real.squares[k];
    for (Index j = 0; j < coupling.strength.size(); ++j) {
      const long double share = coupling.shares(static_cast<Index>(k), j);
      damping += coupling.strength[j] * share * share;
    }
    real.damping.push_back(damping);
  }
  std::optional<ComplexModes> coupled = weakly_coupled(real, coupling, rate);
  if (!coupled) return std::nullopt;
  return in_coordinates(*std::move(coupled), modes->shapes, sparse_product(mass, modes->shapes));
}

}  // namespace signorini
