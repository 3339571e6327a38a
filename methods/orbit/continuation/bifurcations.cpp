#include "methods/orbit/continuation/bifurcations.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include "methods/flow/impact_groups.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

// det A over the product of the norms of its rows.
double relative_determinant(const Eigen::MatrixXd& A) {
  return LuFactors(A.rowwise().norm().cwiseInverse().asDiagonal() * A).determinant();
}

// Re prod (1 - mu_i mu_j), i < j, by sign and mean magnitude over the pairs of `count` multipliers, of which
// the factors of those that are not given are positive and near 1; the product is real.
double pair_product(const Eigen::VectorXcd& mu, Eigen::Index count) {
  double logarithm = 0.0, angle = 0.0;
  for (Eigen::Index i = 0; i < mu.size(); ++i) {
    for (Eigen::Index j = i + 1; j < mu.size(); ++j) {
      const Complex factor = 1.0 - mu[i] * mu[j];
      if (factor == 0.0) return 0.0;
      logarithm += std::log(std::abs(factor));
      angle += std::arg(factor);
    }
  }
  const double pairs = 0.5 * static_cast<double>(count * (count - 1));
  return (std::cos(angle) < 0.0 ? -1.0 : 1.0) * std::exp(logarithm / pairs);
}

// Sum of the products of all but two of mu_i - 1: the product of all but the two that are 0; 0 where it is
// rounding.
double product_of_the_others(const Eigen::VectorXcd& mu) {
  Eigen::VectorXcd sums = Eigen::VectorXcd::Zero(mu.size() + 1);  // of the products of k of them
  sums[0] = 1.0;
  for (Eigen::Index i = 0; i < mu.size(); ++i) {
    for (Eigen::Index k = i + 1; k > 0; --k) sums[k] += sums[k - 1] * (mu[i] - 1.0);
  }
  const double product = sums[mu.size() - 2].real();
  return std::abs(product) < kMultiplierRounding ? 0.0 : product;
}

// Of a free motion all but the two nearest to 1.
Eigen::VectorXcd decisive_multipliers(const ExtendedEquations& equations,
                                      const Eigen::VectorXcd& multipliers) {
  if (equations.family().driven() || multipliers.size() < 2) return multipliers;
  std::vector<Complex> sorted(multipliers.begin(), multipliers.end());
  std::ranges::sort(sorted, std::greater<>(), [](const Complex& mu) { return std::abs(mu - 1.0); });
  return Eigen::VectorXcd::Map(sorted.data(), multipliers.size() - 2);
}

}  // namespace

bool loses_nothing(const ExtendedEquations& equations) {
  const FlowStructure& structure = equations.model().dynamics.structure();
  if (structure.damping.nonZeros() > 0 && structure.damping.norm() > 0.0) return false;
  if (structure.relaxing() > 0 && !equations.orbit().events.empty()) return false;  // by damped stops
  return std::ranges::all_of(equations.orbit().events, [](const SequenceEvent& event) {
    return std::ranges::all_of(event.restitution, [](double e) { return e == 1.0; });
  });
}

namespace {

// The columns of the load that are not constant and not zero.
std::vector<Eigen::Index> loaded_harmonics(const FlowStructure& structure) {
  std::vector<Eigen::Index> loaded;
  for (Eigen::Index h = 1; h < structure.load.cols(); ++h)
    if (!structure.load.col(h).isZero(0.0)) loaded.push_back(h);
  return loaded;
}

// The harmonic of rate w of the contact forces, Re lambda e^{i w t}, impulses included, Nc [N]; empty where
// it is not known.
Eigen::VectorXcd force_harmonic(const ExtendedEquations& equations, double w) {
  const SequencedOrbit& orbit = equations.orbit();
  const auto& arcs = equations.equations().arcs();
  const double begin = equations.time_of(0.0), end = equations.time_of(orbit.end());
  Eigen::MatrixXcd sums = Eigen::MatrixXcd::Zero(2, equations.model().dynamics.contact_count());
  double from = begin;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const bool last = i == orbit.events.size();
    const double to = last ? end : equations.time_of(orbit.phase(static_cast<Eigen::Index>(i)));
    if (!arcs[i]->mode().active.empty() && !arcs[i]->add_force_integrals(from, to, w, sums)) return {};
    from = to;
    if (last) break;
    const std::vector<int>& pushed = orbit.events[i].pushed;
    for (std::size_t k = 0; k < pushed.size(); ++k)
      sums(1, pushed[k]) += equations.equations().crossings()[i].impulses[static_cast<Eigen::Index>(k)] *
                            std::polar(1.0, -w * to);
  }
  return 2.0 / (end - begin) * sums.row(1).transpose();
}

// What the ends of a period that does not close add where M u'' + D u' + K u, times (2 / T) e^{-i w t}, is
// integrated by parts: (2 / T) e^{-i w t_0} [M dv + (D + i w M) du], Nd [N]; 0 of an orbit.
Eigen::VectorXcd open_ends(const ExtendedEquations& equations, double w) {
  const FlowStructure& structure = equations.model().dynamics.structure();
  const CurveUnits& units = equations.family().units();
  const Eigen::VectorXd du = units.displacement * equations.residual().head(structure.size());
  const Eigen::VectorXd dv =
      units.velocity * equations.residual().segment(structure.positions(), structure.size());
  const Eigen::VectorXd impulse = structure.mass * dv, moved = structure.mass * du,
                        damped = structure.damping * du;
  Eigen::VectorXcd ends(structure.size());
  ends.real() = impulse + damped;
  ends.imag() = w * moved;
  const double begin = equations.time_of(0.0), end = equations.time_of(equations.orbit().end());
  return 2.0 / (end - begin) * std::polar(1.0, -w * begin) * ends;
}

// K - w^2 M + i w D.
Eigen::MatrixXcd dynamic_stiffness(const FlowStructure& structure, double w) {
  Eigen::MatrixXcd Z(structure.size(), structure.size());
  Z.real() = Eigen::MatrixXd(structure.stiffness) - w * w * Eigen::MatrixXd(structure.mass);
  Z.imag() = w * Eigen::MatrixXd(structure.damping);
  return Z;
}

}  // namespace

std::string phase_obstacle(const FlowStructure& structure) {
  const std::size_t harmonics = loaded_harmonics(structure).size();
  if (harmonics != 1) return harmonics == 0 ? "no load varies" : "the load has more than one harmonic";
  for (Eigen::Index h = 1; h < structure.shift.cols(); ++h)
    if (!structure.shift.col(h).isZero(0.0)) return "the load acts on contacts without mass";
  return structure.damping.norm() > 0.0 ? "" : "there are no dampers to balance";
}

std::optional<LoadPhase> load_phase(const ExtendedEquations& equations) {
  const FlowStructure& structure = equations.model().dynamics.structure();
  if (!phase_obstacle(structure).empty()) return std::nullopt;
  const Eigen::Index harmonic = loaded_harmonics(structure).front();
  const double w = structure.rates[static_cast<std::size_t>(harmonic)];
  const Eigen::VectorXcd force = force_harmonic(equations, w);
  if (force.size() != structure.contact_count()) return std::nullopt;
  const Eigen::VectorXcd f = structure.load.col(harmonic);
  const Eigen::VectorXcd u =
      lu_solve(dynamic_stiffness(structure, w),
               f + image_of_complex(structure.directions, force) - open_ends(equations, w));
  const Eigen::VectorXd cosine = u.real(), sine = u.imag();
  const Complex work = f.dot(u);  // f^H u
  const double kinetic =
      2.0 * w * w * (cosine.dot(structure.mass * cosine) + sine.dot(structure.mass * sine));
  const LoadPhase phase{
      .in_phase = work.real() * f.norm() * equations.family().units().displacement / std::norm(work),
      .damping_ratio = std::abs(work) / kinetic};
  if (!std::isfinite(phase.in_phase) || !std::isfinite(phase.damping_ratio)) return std::nullopt;
  return phase;
}

Eigen::VectorXcd multipliers_of(const Eigen::MatrixXd& monodromy) {
  constexpr Eigen::Index kSmall = 16;
  if (monodromy.rows() <= kSmall) return general_eigenvalues(monodromy);
  // M P = Q R to rank r: M and R P^T Q, r x r, have the same eigenvalues but for zeros.
  const PivotedQr qr(monodromy);
  const Eigen::VectorXd diagonal = qr.diagonal().cwiseAbs();
  Eigen::Index rank = 0;
  while (rank < monodromy.rows() && diagonal[rank] > kEpsilon * diagonal[0]) ++rank;
  Eigen::VectorXcd all = Eigen::VectorXcd::Zero(monodromy.rows());
  if (rank == 0) return all;
  const Eigen::MatrixXd Q = qr.basis(rank);
  all.head(rank) = general_eigenvalues(product(product_of_transposed(Q, monodromy), Q));
  return all;
}

namespace {

double doubling_test(ExtendedEquations& equations) {
  const Eigen::Index states = equations.orbit().states();
  Eigen::MatrixXd doubled = equations.jacobian().leftCols(equations.size());
  doubled.topLeftCorner(states, states).diagonal().array() += 2.0;  // from y(2 pi n) - y_0 to y(2 pi n) + y_0
  return relative_determinant(doubled);
}

// The same by the multipliers, det J_-1 = det dh/dtheta det(M + 1): of those that are not given, as they lie
// well inside the circle, the factors are positive. An event depends on those before it alone.
double doubling_product(ExtendedEquations& equations, const Eigen::VectorXcd& multipliers) {
  const Eigen::Index states = equations.orbit().states(), size = equations.size();
  const Eigen::MatrixXd& J = equations.jacobian();
  double events = 1.0;
  for (Eigen::Index row = states; row < size; ++row) events *= J(row, row) / J.row(row).head(size).norm();
  Complex product = 1.0;
  for (const Complex& mu : multipliers) product *= 1.0 + mu;
  return events * product.real();
}

// The multipliers; none at a grazing.
BifurcationTests multipliers_at(const ExtendedEquations& equations, MultiplierRange range) {
  constexpr double kKnown = 1e-10, kInside = 0.9;
  const Eigen::MatrixXd M = equations.monodromy();
  if (M.size() == 0 || !M.allFinite()) return {};
  const bool decide = equations.family().driven() && !loses_nothing(equations);  // else all of them do
  if (range == MultiplierRange::leading && M.rows() >= kManyStates && decide) {
    BifurcationTests tests{.multipliers = leading_eigenvalues(M, kKnown), .leading = true};
    const Eigen::Index count = tests.multipliers.size();
    const double least = count == 0 ? 1.0 : std::abs(tests.multipliers[count - 1]);
    if (least < kInside * std::min(1.0, 1.0 / largest_magnitude(tests.multipliers))) return tests;
  }
  return {.multipliers = multipliers_of(M)};
}

std::optional<double> test_of(ExtendedEquations& equations, const Eigen::VectorXd& tangent, SpecialKind kind,
                              const Eigen::VectorXcd& multipliers) {
  const bool driven = equations.family().driven(), known = multipliers.size() > 0;
  if (kind == SpecialKind::fold && (driven || !known)) return tangent[equations.size()];
  if (kind == SpecialKind::fold) return product_of_the_others(multipliers);
  if (kind == SpecialKind::period_doubling && known && equations.orbit().states() >= kManyStates)
    return doubling_product(equations, multipliers);
  if (kind == SpecialKind::period_doubling) return doubling_test(equations);
  if (kind == SpecialKind::branch_point && driven)
    return relative_determinant(bordered_jacobian(equations, tangent));
  if (kind == SpecialKind::neimark_sacker && known && equations.orbit().states() > 2 &&
      !loses_nothing(equations))
    return pair_product(multipliers, equations.orbit().states());
  if (kind == SpecialKind::phase_resonance && equations.family().scene().parameter == kFrequency) {
    const auto phase = load_phase(equations);
    return phase ? std::optional(phase->in_phase) : std::nullopt;
  }
  return std::nullopt;
}

// Whether several contacts that feel each other strike at one event: beside the orbit they do not.
bool struck_together(const ExtendedEquations& equations) {
  const FlowStructure& structure = equations.model().dynamics.structure();
  const std::vector<bool>* before = &equations.orbit().closed;
  for (const SequenceEvent& event : equations.orbit().events) {
    if (coupling_of(structure, *before, {&event, 1}) != ImpactCoupling::none) return true;
    before = &event.closed;
  }
  return false;
}

}  // namespace

std::optional<double> bifurcation_test(ExtendedEquations& equations, const Eigen::VectorXd& tangent,
                                       SpecialKind kind) {
  const bool needed = kind == SpecialKind::neimark_sacker ||
                      (kind == SpecialKind::fold && !equations.family().driven()) ||
                      (kind == SpecialKind::period_doubling && equations.orbit().states() >= kManyStates);
  return test_of(equations, tangent, kind,
                 needed ? multipliers_at(equations, MultiplierRange::all).multipliers : Eigen::VectorXcd());
}

BifurcationTests bifurcation_tests(ExtendedEquations& equations, const Eigen::VectorXd& tangent,
                                   MultiplierRange range, const CurveFactors* factors) {
  const auto slot = [](SpecialKind kind) { return static_cast<std::size_t>(kind); };
  if (struck_together(equations)) {
    BifurcationTests continuous;
    continuous.values[slot(SpecialKind::fold)] = tangent[equations.size()];
    continuous.values[slot(SpecialKind::phase_resonance)] =
        bifurcation_test(equations, tangent, SpecialKind::phase_resonance);
    return continuous;
  }
  BifurcationTests tests = multipliers_at(equations, range);
  for (const SpecialKind kind : BifurcationTests::kKinds)
    tests.values[slot(kind)] = factors != nullptr && kind == SpecialKind::branch_point
                                   ? factors->relative_determinant()
                                   : test_of(equations, tangent, kind, tests.multipliers);
  return tests;
}

bool confirmed(SpecialKind kind, const Eigen::VectorXcd& multipliers) {
  constexpr double kDoubling = 1e-4;  // a double -1 of a motion without loss is known to the root of rounding
  constexpr double kNear = 1e-5, kComplex = 1e-6;
  const auto any = [&](auto&& test) { return std::any_of(multipliers.begin(), multipliers.end(), test); };
  if (kind == SpecialKind::period_doubling)
    return any([](const Complex& mu) { return std::abs(mu + 1.0) < kDoubling; });
  if (kind == SpecialKind::neimark_sacker) {
    return any([](const Complex& mu) {
      return std::abs(std::abs(mu) - 1.0) < kNear && std::abs(mu.imag()) > kComplex;
    });
  }
  return multipliers.size() == 0 || any([](const Complex& mu) { return std::abs(mu - 1.0) < kNear; });
}

OrbitStability stability_of(const ExtendedEquations& equations, const Eigen::VectorXcd& multipliers) {
  constexpr double kGrazing = 1e-9;  // of V
  for (Eigen::Index i = 0; i < equations.orbit().count(); ++i) {
    const SequenceEvent& event = equations.orbit().event(i);
    if (event.kind != ContactEvent::Kind::open && equations.model().dynamics.halts(event.contact) &&
        std::abs(equations.speed(i)) < kGrazing)
      return OrbitStability::undefined;
  }
  if (multipliers.size() == 0) return OrbitStability::undefined;
  const Eigen::VectorXcd decisive = decisive_multipliers(equations, multipliers);
  const double largest = decisive.size() == 0 ? 1.0 : decisive.cwiseAbs().maxCoeff();
  if (loses_nothing(equations))
    return largest > 1.0 + kOnCircle ? OrbitStability::unstable : OrbitStability::elliptic;
  return largest < 1.0 - kMultiplierRounding ? OrbitStability::stable : OrbitStability::unstable;
}

}  // namespace signorini
