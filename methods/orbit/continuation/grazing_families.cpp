#include "methods/orbit/continuation/grazing_families.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "methods/orbit/continuation/orbit_section.hpp"

namespace signorini {

namespace {

std::vector<int> rotated(const std::vector<int>& hits, int by, int n) {
  std::vector<int> result;
  for (const int hit : hits) result.push_back((hit + by) % n);
  std::sort(result.begin(), result.end());
  return result;
}

// The first of its rotations, and no repetition of a shorter pattern.
bool represents_its_class(const std::vector<int>& hits, int n) {
  for (int by = 1; by < n; ++by) {
    const std::vector<int> other = rotated(hits, by, n);
    if (other < hits || other == hits) return false;
  }
  return true;
}

}  // namespace

Eigen::VectorXd grazing_response(OrbitFamily& family, const SequencedOrbit& base, int contact, double phase,
                                 int periods) {
  constexpr double kNone = 1e-9;  // of the state after the impulses: their displacement vanishes
  ExtendedEquations equations(family, base);
  if (!equations.evaluate(base.x)) return {};
  const SequencedOrbit there = with_section(base, equations, phase);
  ExtendedEquations from_grazing(family, there);
  if (!from_grazing.evaluate(there.x)) return {};
  const Eigen::MatrixXd M = from_grazing.monodromy();
  const Eigen::Index states = there.states(), n = states / 2;
  if (M.rows() != states || !M.allFinite()) return {};
  const FlowStructure& structure = from_grazing.model().dynamics.structure();
  Eigen::VectorXd b = Eigen::VectorXd::Zero(states), h = Eigen::VectorXd::Zero(states);
  b.tail(n) = structure.velocity_per_impulse.col(contact) / family.units().velocity;
  h.head(n) = structure.directions.col(contact) * family.units().displacement;
  Eigen::MatrixXd power = Eigen::MatrixXd::Identity(states, states);
  for (int k = 0; k < periods; ++k) power = (power * M).eval();
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(Eigen::MatrixXd::Identity(states, states) - power);
  if (!(lu.rcond() > 1e-13)) return {};
  Eigen::VectorXd y = lu.solve(b), response(periods);
  if (!(std::abs(h.dot(y)) > kNone * h.norm() * y.norm())) return {};
  for (int k = 0; k < periods; ++k, y = (M * y).eval()) response[k] = h.dot(y);
  return response;
}

std::vector<GrazingFamily> impact_patterns(const Eigen::VectorXd& response) {
  constexpr double kTouching = -1e-12;  // of the penetration: a passage that just does not strike
  const auto n = static_cast<int>(response.size());
  std::vector<GrazingFamily> families;
  for (unsigned support = 1; support < (1U << static_cast<unsigned>(n)); support += 2) {  // with passage 0
    std::vector<int> hits;
    for (int k = 0; k < n; ++k) {
      if ((support >> static_cast<unsigned>(k)) & 1U) hits.push_back(k);
    }
    if (!represents_its_class(hits, n)) continue;
    Eigen::MatrixXd C(n, n);
    for (int a = 0; a < n; ++a) {
      for (int l = 0; l < n; ++l) C(a, l) = response[(a - l + n) % n];
    }
    const auto count = static_cast<Eigen::Index>(hits.size());
    for (const double delta : {1.0, -1.0}) {
      const Eigen::VectorXd J = C(hits, hits).fullPivLu().solve(Eigen::VectorXd::Constant(count, delta));
      const Eigen::VectorXd gaps = (C(Eigen::all, hits) * J).array() - delta;
      if (!J.allFinite() || !(J.minCoeff() > 0.0) ||
          !(gaps.minCoeff() > kTouching * std::max(1.0, gaps.maxCoeff())))
        continue;
      families.push_back({.periods = n, .hits = hits, .beyond = delta > 0.0, .impulses = J});
    }
  }
  return families;
}

std::optional<std::vector<GrazingFamily>> grazing_families(OrbitFamily& family, const SequencedOrbit& base,
                                                           int contact, double phase, int most_periods) {
  std::vector<GrazingFamily> all;
  for (int n = 1; n <= most_periods; ++n) {
    const Eigen::VectorXd response = grazing_response(family, base, contact, phase, n);
    if (response.size() == 0) return std::nullopt;
    for (GrazingFamily& found : impact_patterns(response)) all.push_back(std::move(found));
  }
  return all;
}

}  // namespace signorini
