// Periodic orbits known in closed form or computed by independent scripts (tests/data/oracles).

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "methods/periodic_motion/period_map.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/exponential.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "tests/methods/event_driven/scenes.hpp"
#include "tests/methods/periodic_motion/steady_state_cases.hpp"
#include "tests/support/data_folder.hpp"

namespace signorini::test::oracle_orbits_test {
namespace {

constexpr EventDriven::Steady kMarching = EventDriven::Steady::marching;
constexpr EventDriven::Steady kShooting = EventDriven::Steady::shooting;

nlohmann::json oracle(const std::string& name) {
  std::ifstream file(test::data_folder() / "oracles" / name);
  if (!file) throw std::runtime_error("tests/data/oracles/" + name + " is missing");
  return nlohmann::json::parse(file);
}

Eigen::VectorXd one(double value) { return Eigen::VectorXd::Constant(1, value); }

// One impact a period: x, impact time and impulse against the closed form, marching from rest and shooting.
TEST(ImpactOscillatorOrbits, AreReachedFromRestToTenDigits) {
  for (const double e : {1.0, 0.8, 0.5, 0.0}) {
    const ImpactOscillator o{.frequency = 2.2, .gap = 0.2, .restitution = e};
    const auto orbit = single_impact_orbits(o).at(0);
    for (const auto steady : {kMarching, kShooting}) {
      const Solution solution = solve(to_problem(o), {.tolerance = 1e-11, .steady = steady});
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      EXPECT_LT(distance(*solution.trajectory, orbit), 1e-10) << "e = " << e;
      const auto impulses = solution.trajectory->impulses();
      ASSERT_EQ(impulses.size(), 1U);
      EXPECT_NEAR(impulses[0].time, orbit.impact_time, 1e-10);
      EXPECT_NEAR(impulses[0].value, -orbit.impulse, 1e-10);
      EXPECT_LE(solution.residual.value_or(1.0), 5e-11);
      EXPECT_EQ(solution.work.unknowns, 2);
      EXPECT_GT(solution.work.rhs_evaluations.value_or(0), 100);
      EXPECT_GT(solution.work.iterations.value_or(0), 0);
    }
  }
}

TEST(ImpactOscillatorOrbits, ReproduceThePublishedDigitsAtResonance) {
  const Solution solution =
      solve(to_problem({.frequency = 1.0, .gap = 1.0, .restitution = 0.8}), {.tolerance = 1e-11});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const auto events = events_of(solution);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_NEAR(events[0].time, 0.075952164938, 1e-10);
  EXPECT_NEAR(approach_speed(events[0], 0.8), 1.695732937595, 1e-10);
}

TEST(ImpactOscillatorOrbits, GrowFromTheGrazeAsTheClosedFormSays) {
  // S-B's family: grazing at F = 0.1; the branch near it is reached from its own state.
  for (const auto& [load, speed] : {std::pair{0.2, 0.29861285}, std::pair{0.101, 0.02856331}}) {
    const ImpactOscillator o{.load = load, .frequency = 1.0, .gap = 1.0, .restitution = 0.8};
    const auto orbit = single_impact_orbits(o).at(0);
    const Problem problem = to_problem(o);
    const Solution solution = solve(problem, {.tolerance = 1e-11, .steady = kShooting},
                                    guess_from(problem, one(orbit.x(0.0)), one(orbit.velocity(0.0))));
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    EXPECT_NEAR(approach_speed(events_of(solution).at(0), o.restitution), speed, 1e-8);
  }
  // Just below the grazing load there is no impact and the motion is the linear one.
  const Solution below =
      solve(to_problem({.load = 0.0999999, .frequency = 1.0, .gap = 1.0, .restitution = 0.8}),
            {.tolerance = 1e-11});
  ASSERT_EQ(below.verdict, Verdict::converged) << below.message;
  EXPECT_TRUE(below.trajectory->impulses().empty());
  EXPECT_NEAR(below.trajectory->sample(4).x.maxCoeff(), 0.999999, 1e-9);
}

TEST(ImpactOscillatorOrbits, ErrorFallsWithTheTolerance) {
  const ImpactOscillator o{.frequency = 1.0, .gap = 1.0, .restitution = 0.8};
  const auto orbit = single_impact_orbits(o).at(0);
  double before = 1.0;
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
    const Solution solution = solve(to_problem(o), {.tolerance = tolerance});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const double error = distance(*solution.trajectory, orbit);
    EXPECT_LT(error, 10.0 * tolerance);
    EXPECT_LT(error, before / 8.0);
    before = error;
  }
}

// Chatter and sticking, values of an independent closed form: release, first impact and its speed, number of
// impacts faster than 3e-6, limit of the chatter, share of the period in contact, lowest point.
struct ChatterCase {
  ImpactOscillator oscillator;
  double release, first, speed;
  int impacts;
  double limit, share, lowest;
};

TEST(ChatteringOrbits, ReleaseAndAccumulateWhenTheClosedFormSays) {
  const ChatterCase cases[] = {{{.damping = .02, .frequency = .5, .gap = .2, .restitution = 0.0},
                                2.7388768120,
                                9.4661871002,
                                1.2476540087,
                                2,
                                10.5184268516,
                                .380923,
                                -1.7879233734},
                               {{.damping = .02, .frequency = .5, .gap = .2, .restitution = .5},
                                2.7388768120,
                                9.4661871002,
                                1.2476540087,
                                20,
                                14.4431813264,
                                .068601,
                                -1.7879233734},
                               {{.damping = .02, .frequency = .25, .gap = 0., .restitution = .8},
                                6.2831853072,
                                18.8711841977,
                                .5017858118,
                                57,
                                26.9041317069,
                                .179519,
                                -1.2556097261},
                               {{.damping = .1, .frequency = .4, .gap = 0., .restitution = 0.0},
                                3.9269908170,
                                11.3196847784,
                                .6319648387,
                                2,
                                12.6136929098,
                                .446987,
                                -1.5288868396}};
  for (const ChatterCase& c : cases) {
    const Solution solution = solve(to_problem(c.oscillator), {.tolerance = 1e-12});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const double period = solution.trajectory->period();
    const double e = c.oscillator.restitution;
    double release = -1.0, limit = -1.0;
    std::vector<ContactEvent> impacts;
    for (const ContactEvent& event : events_of(solution)) {
      if (event.kind == ContactEvent::Kind::open) release = event.time;
      if (event.kind == ContactEvent::Kind::close) limit = event.time;
      if (approach_speed(event, e) > 3e-6) impacts.push_back(event);
    }
    EXPECT_NEAR(release, c.release, 1e-8);
    EXPECT_NEAR(std::remainder(limit - c.limit, period), 0.0, 1e-8);
    EXPECT_NEAR(std::fmod(release - limit + period, period) / period, c.share, 1e-6);
    ASSERT_EQ(static_cast<int>(impacts.size()), c.impacts);
    double nearest = period;
    for (const ContactEvent& event : impacts) {
      if (std::abs(event.time - c.first) > 1e-8) continue;
      nearest = std::abs(event.time - c.first);
      EXPECT_NEAR(approach_speed(event, e), c.speed, 1e-8);
    }
    EXPECT_LT(nearest, 1e-8);
    const Samples samples = solution.trajectory->sample(40000);
    EXPECT_NEAR(samples.x.minCoeff(), c.lowest, 1e-7);  // between samples: x'' h^2 / 8
    EXPECT_LE(samples.x.maxCoeff(), c.oscillator.gap + 1e-12);
    EXPECT_LE(samples.force.maxCoeff(), 0.0);
  }
}

TEST(SpringStopOrbits, HaveTheTabulatedMonodromyTraceAndContactTime) {
  struct Row {
    double stiffness, contact_time, depth, trace;
  };
  // The same oscillator as S-A with a spring in place of the stop.
  const Row rows[] = {{1e2, .245530, 2.3858e-2, -1.634806}, {1e3, .092719, 1.0300e-2, -.541600},
                      {1e4, .030802, 3.7828e-3, -.028449},  {1e5, .009875, 1.2658e-3, .144483},
                      {1e6, .003136, 4.0795e-4, .199723},   {1e7, .000993, 1.2978e-4, .217226}};
  for (const Row& row : rows) {
    Problem problem = to_problem({.frequency = 2.2, .gap = 0.2});
    problem.set_law(Penalty{{row.stiffness}});
    const auto rigid = single_impact_orbits({.frequency = 2.2, .gap = 0.2}).at(0);
    const auto guess = guess_from(problem, one(rigid.x(0.0)), one(rigid.velocity(0.0)));
    const Solution solution =
        solve(problem, {.tolerance = 1e-11, .steady = kShooting, .max_iterations = 50}, guess);
    ASSERT_EQ(solution.verdict, Verdict::converged) << row.stiffness << ": " << solution.message;
    const auto& found = trajectory_of(solution);
    const ContactDynamics dynamics(problem);
    EventFlow flow(dynamics, 1e-11, [] { return false; });
    PeriodMap map(flow);
    const FixedPoint orbit =
        find_fixed_point(map, found.start(), 1, {.accepted = 1e-9}, [] { return false; });
    ASSERT_TRUE(orbit.converged) << orbit.message;
    const auto events = events_of(solution);
    if (events.size() == 2) {  // one contact a period
      EXPECT_NEAR(orbit.monodromy.trace(), row.trace, 1e-6);
      EXPECT_NEAR(determinant(orbit.monodromy), 0.7515637, 1e-7);
      const double length = std::abs(events[1].time - events[0].time);
      EXPECT_NEAR(length, row.contact_time, 1e-6);
      EXPECT_NEAR(found.sample(200000).x.maxCoeff() - 0.2, row.depth, 2e-4 * row.depth);
    } else {
      ADD_FAILURE() << "another orbit at stiffness " << row.stiffness;
    }
  }
}

// n coordinates, one contact, one impact a period: closed form through the periodic Green's function of the
// whole structure, g(tau) the response to a unit impulse repeated every period.
struct GreensOrbit {
  double impact_time = 0.0, impulse = 0.0;
  Eigen::VectorXd u, v;  // at t = 0
};

std::vector<GreensOrbit> greens_orbits(const Problem& problem) {
  const Eigen::MatrixXd M = problem.mass(), K = problem.stiffness(), D = problem.damping();
  const Eigen::Index n = M.rows();
  const double w = problem.frequency, T = problem.period(), e = std::get<Restitution>(problem.law()).e;
  const double gap = problem.contacts[0].gap;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  for (const auto& [dof, factor] : problem.contacts[0].normal) b[dof] = factor;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  const Eigen::MatrixXd of_force = LuFactors(M).inverse();
  A.bottomLeftCorner(n, n) = -of_force * K;
  A.bottomRightCorner(n, n) = -of_force * D;
  const auto greens = [&](double tau) -> Eigen::VectorXd {  // after the impulse, 0 <= tau <= T
    Eigen::VectorXd kick = Eigen::VectorXd::Zero(2 * n);
    kick.tail(n) = of_force * b;
    const Eigen::MatrixXd once = matrix_exponential(A * T);
    const Eigen::VectorXd first = lu_solve(Eigen::MatrixXd::Identity(2 * n, 2 * n) - once, kick);
    return matrix_exponential(A * tau) * first;
  };
  const Eigen::VectorXd after = greens(0.0), before = greens(T);
  const double g0 = b.dot(after.head(n)), gp = b.dot(after.tail(n)), gm = b.dot(before.tail(n));
  Eigen::VectorXcd load = Eigen::VectorXcd::Zero(n);
  for (const ForceTerm& term : problem.force) load[term.dof] += std::complex<double>(term.cos, -term.sin);
  const std::complex<double> iw(0.0, w);
  const Eigen::MatrixXcd Z = K.cast<std::complex<double>>() - w * w * M.cast<std::complex<double>>() +
                             iw * D.cast<std::complex<double>>();
  const Eigen::VectorXcd linear = lu_solve(Z, load);
  const std::complex<double> seen = b.cast<std::complex<double>>().dot(linear);
  const double a = std::abs(seen), theta = std::arg(seen);
  const double ratio = (gp + e * gm) / ((1.0 + e) * g0), q = ratio * gap / (a * std::hypot(w, ratio)),
               psi = std::atan2(ratio, w);
  std::vector<GreensOrbit> orbits;
  if (std::abs(q) > 1.0) return orbits;
  for (const double phase : {std::asin(q) - psi, std::numbers::pi - std::asin(q) - psi}) {
    GreensOrbit orbit;
    orbit.impact_time = std::fmod((phase - theta) / w + 2.0 * T, T);
    orbit.impulse = (a * std::cos(phase) - gap) / g0;
    const double approach = -a * w * std::sin(phase) - orbit.impulse * gm;
    if (orbit.impulse <= 0.0 || approach <= 0.0) continue;
    const auto x_at = [&](double time) {
      const double tau = std::fmod(time - orbit.impact_time + 2.0 * T, T);
      return a * std::cos(w * time + theta) - orbit.impulse * b.dot(greens(tau).head(n));
    };
    bool admissible = true;
    for (int i = 1; i < 2000; ++i) admissible = admissible && x_at(orbit.impact_time + T * i / 2000) <= gap;
    if (!admissible) continue;
    const Eigen::VectorXd response = greens(std::fmod(2.0 * T - orbit.impact_time, T));
    orbit.u = linear.real() - orbit.impulse * response.head(n);
    orbit.v = (iw * linear).real() - orbit.impulse * response.tail(n);
    orbits.push_back(orbit);
  }
  return orbits;
}

TEST(TwoMassOrbits, WithOneImpactAgreeWithTheGreensFunctionOfTheStructure) {
  int compared = 0;
  for (const double frequency : {0.9, 1.0, 1.1, 1.25, 1.8, 2.2}) {
    for (const double e : {1.0, 0.9, 0.5, 0.0}) {
      const Problem problem = two_masses(frequency, e);
      for (const GreensOrbit& orbit : greens_orbits(problem)) {
        const Solution solution =
            solve(problem, {.tolerance = 1e-11, .steady = kShooting, .max_iterations = 50},
                  guess_from(problem, orbit.u * 1.001, orbit.v * 0.999));
        ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
        const auto impulses = solution.trajectory->impulses();
        ASSERT_EQ(impulses.size(), 1U) << frequency << " " << e;
        EXPECT_NEAR(impulses[0].time, orbit.impact_time, 2e-10);
        EXPECT_NEAR(impulses[0].value, -orbit.impulse, 1e-9);
        EXPECT_NEAR(solution.trajectory->sample(1).x(0, 0), orbit.u[1], 1e-9);
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 6);
}

TEST(IndependentOrbits, OfOneMassAtARigidStop) {
  const auto data = oracle("sdof_rigid_orbits.json");
  for (const auto& orbit : data.at("orbits")) {
    const ImpactOscillator o{
        .frequency = orbit.at("frequency"), .gap = 1.0, .restitution = orbit.at("restitution")};
    const Problem problem = to_problem(o);
    const double x0 = orbit.at("start")[0], v0 = orbit.at("start")[1];
    const Solution solution = solve(problem, {.tolerance = 1e-11, .steady = kShooting, .max_iterations = 50},
                                    guess_from(problem, one(x0 - 1e-3), one(v0 + 1e-3)));
    ASSERT_EQ(solution.verdict, Verdict::converged) << orbit.dump() << solution.message;
    const auto events = events_of(solution);
    ASSERT_EQ(events.size(), orbit.at("impacts").size());
    for (std::size_t k = 0; k < events.size(); ++k) {
      EXPECT_NEAR(events[k].time, orbit.at("impacts")[k][0].get<double>(), 1e-9);
      EXPECT_NEAR(approach_speed(events[k], o.restitution), orbit.at("impacts")[k][1].get<double>(), 1e-9);
      EXPECT_NEAR(-events[k].impulse, orbit.at("impacts")[k][2].get<double>(), 2e-9);
    }
    const Samples start = solution.trajectory->sample(1);
    EXPECT_NEAR(start.x(0, 0), x0, 1e-9);
    EXPECT_NEAR(start.velocity(0, 0), v0, 1e-9);
  }
}

// Same contacts at the same times, and the same state at t = 0.
void expect_spring_orbit(const Problem& problem, const nlohmann::json& orbit, double tolerance) {
  const auto state = orbit.at("start").get<std::vector<double>>();
  const auto n = static_cast<Eigen::Index>(state.size() / 2);
  const Eigen::VectorXd u = Eigen::VectorXd::Map(state.data(), n),
                        v = Eigen::VectorXd::Map(state.data() + n, n);
  const Solution solution = solve(problem, {.tolerance = 1e-11, .steady = kShooting, .max_iterations = 50},
                                  guess_from(problem, 1.0005 * u, 0.9995 * v));
  ASSERT_EQ(solution.verdict, Verdict::converged) << problem.frequency << solution.message;
  const auto events = events_of(solution);
  ASSERT_EQ(events.size(), orbit.at("events").size()) << problem.frequency;
  for (std::size_t k = 0; k < events.size(); ++k) {
    EXPECT_NEAR(events[k].time, orbit.at("events")[k][0].get<double>(), tolerance) << problem.frequency;
    EXPECT_EQ(events[k].kind == ContactEvent::Kind::close, orbit.at("events")[k][2] == 1);
  }
  const Samples start = solution.trajectory->sample(1);
  const int dof = problem.contacts[0].normal[0].first;
  EXPECT_NEAR(start.x(0, 0), u[dof], tolerance);
  EXPECT_NEAR(start.velocity(0, 0), v[dof], tolerance);
}

TEST(IndependentOrbits, OfOneMassAtASpringStop) {
  const auto data = oracle("sdof_penalty_orbits.json");
  for (const auto& orbit : data.at("orbits")) {
    Problem problem = to_problem({.frequency = orbit.at("frequency"), .gap = 1.0});
    problem.set_law(Penalty{{orbit.at("penalty").get<double>()}});
    // The reference's own residual is 3e-12 times the sensitivity of a stiff contact.
    expect_spring_orbit(problem, orbit, 1e-9);
  }
}

TEST(IndependentOrbits, OfTwoMassesAtASpringStopStableAndUnstable) {
  const auto data = oracle("two_mass_penalty_orbits.json");
  int unstable = 0;
  for (const auto& orbit : data.at("orbits")) {
    Problem problem;
    problem.edit_structure([&](Structure& s) {
      s.mass = sparse(data.at("mass").get<Rows>());
      s.stiffness = sparse(data.at("stiffness").get<Rows>());
      s.damping = data.at("damping_over_stiffness").get<double>() * s.stiffness;
    });
    problem.frequency = orbit.at("frequency");
    problem.force = {{.dof = 1, .harmonic = 1, .cos = 0.1, .sin = 0.0}};
    problem.contacts = {{.normal = {{0, 1.0}}, .gap = 1.0}};
    problem.set_law(Penalty{{data.at("penalty").get<double>()}});
    expect_spring_orbit(problem, orbit, 1e-8);
    unstable += orbit.at("largest_multiplier").get<double>() > 1.0 ? 1 : 0;
  }
  EXPECT_GE(unstable, 5);
}

}  // namespace
}  // namespace signorini::test::oracle_orbits_test
