// Phase resonances on forced responses and as backbones over the load, against closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include "methods/orbit/bifurcation_curves/bifurcation_curve.hpp"
#include "tests/methods/orbit/continuation/diagrams.hpp"
#include "tests/reference/bilinear_orbit.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::phase_resonance_test {
namespace {

using test::ImpactOscillator;

constexpr double kPi = std::numbers::pi, kStop = 3.0;  // stiffness of the spring stop: 2 rad/s with it

ImpactOscillator lightly_damped(double load, double restitution = 1.0, double damping = 0.02) {
  return {.damping = damping, .load = load, .gap = 1.0, .restitution = restitution};
}

Problem before_spring(const ImpactOscillator& oscillator) {
  Problem problem = to_problem(oscillator);
  problem.set_law(Penalty{{kStop}});
  return problem;
}

ScenePlane over_load(const std::function<Problem(double)>& scene, double from, double to) {
  return {.at = [scene](double load) { return over_frequency(scene(load), 0.7, 1.9); },
          .second = "load",
          .from = from,
          .to = to};
}

std::vector<Branch> backbone(const ScenePlane& plane) {
  OrbitFamily family(plane.at(plane.from));
  const OrbitDiagram diagram =
      trace_diagram(family, {contact_free_orbit(family, family.scene().to).value()}, {.max_order = 1});
  return bifurcation_curves(plane, diagram, SpecialKind::phase_resonance, {});
}

std::vector<SpecialPoint> resonances(const OrbitDiagram& diagram) {
  std::vector<SpecialPoint> found;
  for (const OrbitBranch& branch : diagram.branches)
    std::ranges::copy_if(branch.special, std::back_inserter(found), [](const SpecialPoint& special) {
      return special.kind == SpecialKind::phase_resonance;
    });
  return found;
}

// P / (w^3 m |u|^2), the power that the damper and the impacts take by a sum over one period.
template <class Orbit>
double damping_ratio(const Orbit& orbit, double period, double lost_at_impacts) {
  constexpr int kInstants = 2000;
  double power = lost_at_impacts / period;
  for (int i = 0; i < kInstants; ++i) {
    const double v = orbit.velocity(period * (i + 0.5) / kInstants);
    power += orbit.oscillator.damping * v * v / kInstants;
  }
  const double u = 2.0 * std::abs(orbit.fourier(1)), w = orbit.oscillator.frequency;
  return power / (w * w * w * orbit.oscillator.mass * u * u);
}

// The forced orbit of a point, one contact about a quarter of a period after the load's maximum.
test::BilinearOrbit forced_orbit(const SolutionPoint& point, double load) {
  ImpactOscillator oscillator = lightly_damped(load);
  oscillator.frequency = point.frequency;
  const double amplitude = 2.0 * point.amplitude[0] - point.x_max[0], w = std::sqrt(1.0 + kStop);
  const double v = std::sqrt(amplitude * amplitude - 1.0), held = 2.0 / w * std::atan2(v / w, 1.0 / (w * w));
  const double middle = 0.5 * kPi / point.frequency;
  return test::bilinear_orbit(oscillator, kStop, middle - 0.5 * held, middle + 0.5 * held, v);
}

TEST(PhaseResonance, OfOneMassIsItsModeWithItsDamping) {
  const auto scene = [](double load) {
    return to_problem(ImpactOscillator{.damping = 0.1, .load = load, .gap = 100.0});
  };
  const std::vector<SpecialPoint> found = resonances(test::diagram_of(scene(1.0), 0.7, 1.9));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].point.frequency, 1.0, 1e-13);
  EXPECT_NEAR(found[0].point.damping_ratio.value(), 0.05, 1e-14);
  EXPECT_EQ(found[0].text, "damping ratio 0.05");
  const auto curves = backbone(over_load(scene, 0.5, 5.0));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].ended, "end of the interval of load");
  for (std::size_t i = 0; i < curves[0].points.size(); ++i) {
    EXPECT_NEAR(curves[0].points[i].frequency, 1.0, 1e-12);
    EXPECT_NEAR(curves[0].points[i].amplitude[0], 10.0 * *curves[0].points[i].second, 1e-9);
    EXPECT_EQ(curves[0].points[i].stability, OrbitStability::stable);
  }
}

// Where the load acts on the first of two masses, its displacement is in quadrature three times: at both
// resonances, and between them.
TEST(PhaseResonance, LeavesOutAntiresonances) {
  Problem problem;
  const SparseMatrix stiffness = test::symmetric(2.0, -1.0, 2.0);
  problem.edit_structure([&](Structure& structure) {
    structure.mass = test::symmetric(1.0, 0.0, 1.0);
    structure.damping = 0.02 * stiffness;
    structure.stiffness = stiffness;
  });
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 1.0}};
  problem.contacts = {{.normal = {{1, 1.0}}, .gap = 100.0}};
  problem.set_law(Penalty{{1.0}});
  const std::vector<SpecialPoint> found = resonances(test::diagram_of(problem, 0.7, 2.2));
  ASSERT_EQ(found.size(), 2U);
  const auto in_phase = [](double w) {
    const std::complex<double> a(2.0 - w * w, 0.04 * w), b(-1.0, -0.02 * w);
    return (a / (a * a - b * b)).real();
  };
  for (const auto& [low, high] : {std::pair(0.9, 1.2), std::pair(1.6, 1.9)}) {
    double begin = low, end = high;
    for (int i = 0; i < 60; ++i) (in_phase(0.5 * (begin + end)) > 0.0 ? begin : end) = 0.5 * (begin + end);
    EXPECT_TRUE(std::ranges::any_of(found, [&](const SpecialPoint& special) {
      return std::abs(special.point.frequency - begin) < 1e-11;
    })) << begin;
  }
}

TEST(PhaseResonance, OfAMassBeforeASpringIsThatOfItsClosedForm) {
  const auto curves =
      backbone(over_load([](double load) { return before_spring(lightly_damped(load)); }, 0.005, 0.1));
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_NEAR(*curves[0].points.back().second, 0.02, 1e-11);  // c w g
  EXPECT_EQ(curves[0].ended, "contact 0 begins to press on its stop");
  EXPECT_NEAR(*curves[1].points.front().second, 0.02, 1e-11);
  EXPECT_NEAR(*curves[1].points.back().second, 0.1, 1e-13);
  EXPECT_EQ(curves[1].ended, "end of the interval of load");
  EXPECT_GT(curves[1].points.size(), 10U);
  for (std::size_t i = 0; i < curves[1].points.size(); ++i) {
    const SolutionPoint& point = curves[1].points[i];
    if (*curves[1].points[i].second < 0.0201) continue;  // Newton's method of the oracle needs a contact
    const test::BilinearOrbit orbit = forced_orbit(point, *curves[1].points[i].second);
    EXPECT_LT(std::abs(std::arg(orbit.fourier(1)) + 0.5 * kPi), 1e-8) << point.frequency;
    EXPECT_NEAR(orbit.penetration(), point.x_max[0] - 1.0, 1e-9);
    EXPECT_NEAR(damping_ratio(orbit, orbit.period(), 0.0) / point.damping_ratio.value(), 1.0, 1e-6);
  }
}

// The frequency of a free motion of the same amplitude, to second order in the damping.
TEST(PhaseResonance, LiesOnTheModeWithoutDamping) {
  const auto farthest = [](double damping) {
    const auto scene = [damping](double load) { return before_spring(lightly_damped(load, 1.0, damping)); };
    double most = 0.0;
    for (const Branch& curve : backbone(over_load(scene, 0.5 * damping, 5.0 * damping))) {
      for (const SolutionPoint& point : curve.points) {
        const double amplitude = 2.0 * point.amplitude[0] - point.x_max[0];
        const double v = std::sqrt(std::max(0.0, amplitude * amplitude - 1.0));
        const double open = 2.0 * (kPi - std::acos(std::min(1.0, 1.0 / amplitude)));
        const double held = 2.0 / 2.0 * std::atan2(v / 2.0, 0.25);
        const double free = amplitude > 1.0 ? 2.0 * kPi / (open + held) : 1.0;
        most = std::max(most, std::abs(point.frequency - free));
      }
    }
    return most;
  };
  const double coarse = farthest(0.04), fine = farthest(0.02);
  EXPECT_LT(coarse, 5.0 * 0.02 * 0.02);
  EXPECT_NEAR(fine / coarse, 0.25, 0.05);
}

TEST(PhaseResonance, OfAMassBeforeARigidStopIsThatOfItsClosedForm) {
  const auto curves =
      backbone(over_load([](double load) { return to_problem(lightly_damped(load, 0.95)); }, 0.005, 0.15));
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_NEAR(*curves[0].points.back().second, 0.02, 1e-11);
  EXPECT_GT(curves[1].points.size(), 10U);
  EXPECT_NEAR(*curves[1].points.back().second, 0.15, 1e-13);
  for (std::size_t i = 1; i < curves[1].points.size(); ++i) {
    const SolutionPoint& point = curves[1].points[i];
    ImpactOscillator oscillator = lightly_damped(*curves[1].points[i].second, 0.95);
    oscillator.frequency = point.frequency;
    double nearest = 1e300, ratio = 0.0;
    for (const test::SingleImpactOrbit& orbit : single_impact_orbits(oscillator)) {
      const double off = std::abs(std::arg(orbit.fourier(1)) + 0.5 * kPi);
      if (off > nearest) continue;
      nearest = off;
      ratio = damping_ratio(orbit, orbit.period, 0.5 * orbit.approach * orbit.approach * (1.0 - 0.95 * 0.95));
    }
    EXPECT_LT(nearest, 1e-8) << point.frequency;
    EXPECT_NEAR(ratio / point.damping_ratio.value(), 1.0, 1e-4);
  }
}

// Followed in two numbers it comes to where the forced response, followed in one, has it located; the peak of
// that is beside it by the square of the damping.
TEST(PhaseResonance, IsThatOfTheForcedResponseAtItsPeak) {
  for (const bool rigid : {false, true}) {
    const auto scene = [rigid](double load) {
      return rigid ? to_problem(lightly_damped(load, 0.95)) : before_spring(lightly_damped(load));
    };
    const auto curves = backbone(over_load(scene, 0.01, 0.06));
    ASSERT_EQ(curves.size(), 2U) << rigid;
    const SolutionPoint& end = curves[1].points.back();
    const OrbitDiagram forced = test::diagram_of(scene(0.06), 0.7, 1.9, {.max_order = 1});
    const std::vector<SpecialPoint> found = resonances(forced);
    EXPECT_TRUE(std::ranges::any_of(found, [&](const SpecialPoint& special) {
      return std::abs(special.point.frequency - end.frequency) < 1e-10 &&
             std::abs(special.point.amplitude[0] - end.amplitude[0]) < 1e-9;
    })) << rigid;
    SolutionPoint peak{.amplitude = {0.0}};
    for (const OrbitBranch& branch : forced.branches)
      for (const SolutionPoint& point : branch.points)
        if (point.amplitude[0] > peak.amplitude[0]) peak = point;
    EXPECT_NEAR(peak.amplitude[0] / end.amplitude[0], 1.0, 1e-3) << rigid;
    EXPECT_NEAR(peak.frequency, end.frequency, 1e-2) << rigid;
  }
}

}  // namespace
}  // namespace signorini::phase_resonance_test
