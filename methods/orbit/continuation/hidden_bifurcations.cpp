#include "methods/orbit/continuation/hidden_bifurcations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

namespace signorini {

namespace {

// log |mu|, falling, of the real multipliers above 0, of those below 0, and of the pairs.
using Magnitudes = std::array<std::vector<double>, 3>;
constexpr std::size_t kPairs = 2;
constexpr double kDoubleRoot = 1e-6;  // rounding of the magnitude of multipliers that are 1 twice

// The least magnitude that tests tell of all multipliers beyond.
double least_known(const BifurcationTests& tests) {
  constexpr double kFaded = 1e-2;
  if (!tests.leading || tests.multipliers.size() == 0) return kFaded;
  return std::max(kFaded, (1.0 + kMultiplierRounding) * tests.multipliers.cwiseAbs().minCoeff());
}

// Of those that are no smaller than `least`.
Magnitudes magnitudes(const Eigen::VectorXcd& multipliers, double least) {
  Magnitudes result;
  for (const std::complex<double>& mu : multipliers) {
    const double size = std::abs(mu);
    const bool real = std::abs(mu.imag()) <= kMultiplierRounding * size;
    if (size < least || (!real && mu.imag() < 0.0)) continue;
    result[real ? (mu.real() > 0.0 ? 0 : 1) : kPairs].push_back(std::log(size));
  }
  for (std::vector<double>& sort : result) std::sort(sort.begin(), sort.end(), std::greater<>());
  return result;
}

// How many multipliers are outside the circle; empty where they are not known, or beyond all bounds, as
// beside a grazing.
std::optional<std::ptrdiff_t> count_outside(const Eigen::VectorXcd& multipliers) {
  constexpr double kBeyond = 1e8;
  if (multipliers.size() == 0 || !(multipliers.cwiseAbs().maxCoeff() < kBeyond)) return std::nullopt;
  return std::count_if(multipliers.begin(), multipliers.end(),
                       [](const std::complex<double>& mu) { return std::abs(mu) > 1.0 + kDoubleRoot; });
}

bool changes_sign(const BifurcationTests& begin, const BifurcationTests& end, SpecialKind kind) {
  const auto &first = begin.of(kind), &last = end.of(kind);
  return first && last && *first * *last < 0.0;
}

// Whether more multipliers have crossed the circle than the test functions tell of. A pair outside it that
// meets on the real axis and parts along it has crossed nothing.
bool too_many_cross(const BifurcationTests& begin, const BifurcationTests& end) {
  const auto first = count_outside(begin.multipliers), last = count_outside(end.multipliers);
  if (!first || !last) return false;
  const bool through_one =
      changes_sign(begin, end, SpecialKind::fold) || changes_sign(begin, end, SpecialKind::branch_point);
  const std::ptrdiff_t told = (through_one ? 1 : 0) +
                              (changes_sign(begin, end, SpecialKind::period_doubling) ? 1 : 0) +
                              (changes_sign(begin, end, SpecialKind::neimark_sacker) ? 2 : 0);
  // One alone has crossed with a sign, but for rounding beside the circle.
  return std::abs(*first - *last) > std::max<std::ptrdiff_t>(told, 1);
}

// A function at the point before a step, at its beginning and at its end.
struct ThreeValues {
  double before, begin, end;
};

// The extremum on a step of given length, one of length `back` before it, of the parabola through three
// values; empty if there is none.
std::optional<double> extremum(const ThreeValues& f, double back, double length) {
  const double backward = (f.begin - f.before) / back, forward = (f.end - f.begin) / length;
  const double curvature = (forward - backward) / (back + length);
  const double slope = backward + curvature * back;  // at the beginning
  const double at = -slope / (2.0 * curvature);
  if (!(at > 0.0 && at < length)) return std::nullopt;
  return f.begin + 0.5 * slope * at;
}

// Whether the parabola of a function of one sign at both ends comes near zero, or beyond, between them.
bool comes_near_zero(const ThreeValues& f, double back, double length) {
  constexpr double kNear = 0.1;
  if (!(f.begin * f.end > 0.0)) return false;
  const auto least = extremum(f, back, length);
  return least && *least * std::copysign(1.0, f.begin) < kNear * std::min(std::abs(f.begin), std::abs(f.end));
}

// The logarithms of multipliers, those that keep their rank.
bool multipliers_come_near(const TestsBefore& before, const BifurcationTests& begin, double length,
                           const BifurcationTests& end) {
  const double least = std::max({least_known(before.tests), least_known(begin), least_known(end)});
  const Magnitudes a = magnitudes(before.tests.multipliers, least), b = magnitudes(begin.multipliers, least),
                   c = magnitudes(end.multipliers, least);
  for (std::size_t sort = 0; sort < a.size(); ++sort) {
    // Without a test for pairs none of them leaves its circle.
    if (sort == kPairs && !end.of(SpecialKind::neimark_sacker)) continue;
    if (a[sort].size() != b[sort].size() || b[sort].size() != c[sort].size()) continue;
    for (std::size_t k = 0; k < b[sort].size(); ++k) {
      const ThreeValues f{a[sort][k], b[sort][k], c[sort][k]};
      const bool known = std::min(std::abs(f.begin), std::abs(f.end)) > kDoubleRoot;
      if (known && comes_near_zero(f, before.length, length)) return true;
    }
  }
  return false;
}

bool tests_come_near(const TestsBefore& before, const BifurcationTests& begin, double length,
                     const BifurcationTests& end) {
  constexpr double kOneMagnitude = 0.2;  // determinants that fade by decades have no parabola
  constexpr auto kBifurcations = static_cast<std::size_t>(SpecialKind::phase_resonance);  // those before it
  for (std::size_t k = 0; k < kBifurcations; ++k) {
    const auto &a = before.tests.values[k], &b = begin.values[k], &c = end.values[k];
    if (!a || !b || !c) continue;
    if (std::abs(*b) < kOneMagnitude * std::abs(*a) || std::abs(*c) < kOneMagnitude * std::abs(*b)) continue;
    if (comes_near_zero({*a, *b, *c}, before.length, length)) return true;
  }
  return false;
}

}  // namespace

bool may_hide_bifurcations(const std::optional<TestsBefore>& before, const BifurcationTests& begin,
                           double length, const BifurcationTests& end) {
  if (too_many_cross(begin, end)) return true;
  return before &&
         (multipliers_come_near(*before, begin, length, end) || tests_come_near(*before, begin, length, end));
}

}  // namespace signorini
