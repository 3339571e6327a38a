#include "methods/orbit/continuation/linear_mode_starts.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "methods/orbit/family/followed_quantity.hpp"
#include "methods/orbit/family/survey.hpp"
#include "methods/solvers/constants.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

// The state of rest, and how far each contact is from a change there.
struct RestBesideStops {
  std::vector<bool> closed = {};    // Nc
  Eigen::VectorXd u = {};           // Nd
  Eigen::VectorXd room = {};        // d_j: g_j - x_j of an open contact, -lambda_j of a closed one, Nc
  SymmetricEigen modes = {};        // about it, M-orthonormal
  Eigen::MatrixXd amplitudes = {};  // c_j of each mode, Nc x Nd
  std::string obstacle = {};        // one clause; the rest is then undefined
};

SymmetricEigen modes_where(const ContactDynamics& dynamics, const std::vector<bool>& closed) {
  return generalised_eigen(dynamics.stops().stiffness(dynamics.mode(closed)),
                           Eigen::MatrixXd(dynamics.structure().mass));
}

// The rest of one set of closed contacts.
RestBesideStops rest_with(OrbitModel& model, const std::vector<bool>& closed) {
  const ContactDynamics& dynamics = model.dynamics;
  const Eigen::Index n = dynamics.size(), contacts = dynamics.contact_count();
  RestBesideStops rest{.closed = closed, .u = Eigen::VectorXd::Zero(n)};
  rest.modes = modes_where(dynamics, closed);
  if (!rest.modes.converged) return {.obstacle = "the linear modes are not to be had"};
  const Eigen::VectorXd& squares = rest.modes.values;
  if (!(squares[0] > kMatrixRounding * squares[n - 1]))
    return {.obstacle = "no spring holds the structure in place"};
  const Eigen::VectorXd zero = rest.u;
  Eigen::VectorXd acceleration(n);
  dynamics.acceleration(dynamics.mode(closed), 0.0, zero, zero, acceleration);
  const Eigen::MatrixXd& phi = rest.modes.vectors;
  rest.u = phi * (phi.transpose() * (dynamics.structure().mass * acceleration)).cwiseQuotient(squares);
  const LinearFlow& flow = model.flows.of(closed);
  const auto arc = flow.arc();
  arc->start(0.0, {.u = rest.u, .v = zero});
  rest.room.resize(contacts);
  rest.amplitudes.resize(contacts, n);
  for (int j = 0; j < contacts; ++j) {
    const bool holds = closed[static_cast<std::size_t>(j)];
    rest.room[j] = holds ? -arc->force(j, 0.0) : dynamics.structure().gaps[j] - arc->displacement(j, 0.0);
    rest.amplitudes.row(j) = flow.gradient(j, holds).head(n) * phi;
  }
  return rest;
}

RestBesideStops rest_of(OrbitModel& model) {
  const auto contacts = static_cast<std::size_t>(model.dynamics.contact_count());
  std::vector<bool> closed(contacts, false);
  // What no spring of its own holds rests on its stops, as under its weight.
  if (!rest_with(model, closed).obstacle.empty())
    for (std::size_t j = 0; j < contacts; ++j) closed[j] = !model.dynamics.rigid(static_cast<int>(j));
  for (std::size_t tries = 0; tries <= 2 * contacts + 2; ++tries) {
    RestBesideStops rest = rest_with(model, closed);
    if (!rest.obstacle.empty() || (rest.room.array() >= 0.0).all()) return rest;
    for (std::size_t j = 0; j < contacts; ++j) {
      if (rest.room[static_cast<Eigen::Index>(j)] >= 0.0) continue;
      if (model.dynamics.rigid(static_cast<int>(j))) return {.obstacle = "a rigid stop is pressed at rest"};
      closed[j] = !closed[j];
    }
  }
  return {.obstacle = "no state of rest is found"};
}

// A mode at the amplitude at which it reaches a stop: from the section on, sin(theta) about the rest.
SequencedOrbit orbit_of_mode(const OrbitFamily& family, const RestBesideStops& rest, Eigen::Index mode,
                             double amplitude) {
  const double frequency = std::sqrt(rest.modes.values[mode]);
  return sequenced(
      family,
      {.start = {.time = 0.0,
                 .state = {.u = rest.u, .v = amplitude * frequency * rest.modes.vectors.col(mode)},
                 .closed = rest.closed},
       .events = {},
       .origin = "linear mode"},
      kTwoPi / frequency, frequency, frequency);
}

// What begins at the contacts that the mode reaches: an impact, or a phase of contact or its interruption.
SequencedOrbit with_beginnings(SequencedOrbit orbit, std::vector<int> reached,
                               const Eigen::VectorXd& amplitudes, const ContactDynamics& dynamics) {
  std::stable_partition(reached.begin(), reached.end(), [&](int j) { return !dynamics.rigid(j); });
  for (const int j : reached)
    orbit = with_touch(orbit, j, (amplitudes[j] > 0.0 ? 0.5 : 1.5) * std::numbers::pi, dynamics);
  return orbit;
}

std::optional<CurveStart> start_of(OrbitFamily& family, OrbitModel& model, const RestBesideStops& rest,
                                   Eigen::Index mode) {
  const Eigen::VectorXd amplitudes = rest.amplitudes.col(mode);
  const Eigen::VectorXd shares = amplitudes.cwiseAbs().cwiseQuotient(rest.room);  // 1 / A of each contact
  const double most = shares.maxCoeff();
  std::vector<int> reached;
  for (int j = 0; j < shares.size(); ++j) {
    if (shares[j] >= (1.0 - kTouches) * most) reached.push_back(j);
  }
  const SequencedOrbit orbit =
      with_beginnings(orbit_of_mode(family, rest, mode, 1.0 / most), reached, amplitudes, model.dynamics);
  return start_growing(family, orbit, fmt::format("mode {} touches its stop", mode + 1));
}

double energy_of_start(const OrbitModel& model, const CurveStart& start, const CurveUnits& units) {
  return energy_of(
      model,
      {.time = 0.0, .state = state_of(start.orbit.x, model.dynamics, units), .closed = start.orbit.closed});
}

Eigen::VectorXd frequencies_where(const ContactDynamics& dynamics, bool all_closed) {
  const auto contacts = static_cast<std::size_t>(dynamics.contact_count());
  return modes_where(dynamics, std::vector<bool>(contacts, all_closed)).values.cwiseMax(0.0).cwiseSqrt();
}

}  // namespace

LinearModeStarts linear_mode_starts(OrbitFamily& family) {
  const ParametrisedScene& scene = family.scene();
  const auto model = family.model(scene.middle());
  if (model->dynamics.contact_count() == 0) return {.obstacle = "there is no contact"};
  const RestBesideStops rest = rest_of(*model);
  if (!rest.obstacle.empty()) return {.obstacle = rest.obstacle};
  if ((rest.room.array() <= 0.0).any())
    return {.obstacle = "a stop is touched at rest, where the frequency does not depend on the energy"};
  const double infinite = std::numeric_limits<double>::infinity();
  const Eigen::VectorXd open = frequencies_where(model->dynamics, false);
  const Eigen::VectorXd held = model->dynamics.rigid() ? Eigen::VectorXd::Constant(open.size(), infinite)
                                                       : frequencies_where(model->dynamics, true);
  const Eigen::VectorXd largest = rest.amplitudes.cwiseAbs().rowwise().maxCoeff();
  LinearModeStarts result;
  for (Eigen::Index r = 0; r < open.size(); ++r) {
    const double frequency = std::sqrt(rest.modes.values[r]);
    if (open[r] > scene.high() || held[r] < scene.low()) continue;
    if ((rest.amplitudes.col(r).cwiseAbs().array() <= kTouches * largest.array()).all()) continue;
    if (auto start = start_of(family, *model, rest, r))
      result.starts.push_back({.frequency = frequency,
                               .energy = energy_of_start(*model, *start, family.units()),
                               .start = std::move(*start)});
    else
      result.obstacle = fmt::format("how the motion of mode {} goes on at its stop is not told", r + 1);
  }
  return result;
}

std::optional<ParameterRange> free_motion_band(const Problem& problem) {
  constexpr Eigen::Index kModes = 3;
  constexpr double kBelow = 0.95, kBeside = 1.05, kBeyond = 2.0;
  constexpr double kInFlight = 0.1;  // of the first frequency at rest: most of the period is free flight
  if (problem.contacts.empty()) return std::nullopt;
  OrbitModel model(problem);
  const ContactDynamics& dynamics = model.dynamics;
  if (dynamics.size() == 0) return std::nullopt;
  const Eigen::VectorXd open = frequencies_where(dynamics, false);
  const Eigen::Index last = std::min(kModes, open.size()) - 1;
  double high = kBeyond * open[last];
  if (!dynamics.rigid()) high = std::min(high, frequencies_where(dynamics, true)[last]);
  const RestBesideStops rest = rest_of(model);
  if (rest.obstacle.empty()) high = std::max(high, kBeside * std::sqrt(rest.modes.values[last]));
  double low = kBelow * open[0];
  if (!(low * low > kMatrixRounding * high * high))
    low = rest.obstacle.empty() ? kInFlight * std::sqrt(rest.modes.values[0]) : 0.0;
  if (!(low > 0.0 && high > low)) return std::nullopt;
  return ParameterRange{.low = low, .high = high};
}

}  // namespace signorini
