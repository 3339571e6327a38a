#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "methods/orbit/exact_orbit.hpp"
#include "methods/orbit/modal_green_function.hpp"
#include "methods/orbit/orbit_equations.hpp"
#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

constexpr const char* kSingularEquations =
    "the equations are singular (a multiplier is 1, or an impact grazes)";

// Largest distance of a purely impulsive orbit to the sum of its impulses' periodic responses; empty if there
// is contact that lasts, or no unique response.
std::optional<double> distance_to_green_function(const OrbitModel& model, const ExactTrajectory& motion) {
  constexpr int kInstants = 17;
  const OrbitGuess& path = motion.orbit();
  const FlowStructure& structure = model.dynamics.structure();
  // Impulses of relaxing contacts move xi, too, and the motion counts all contacts.
  if (structure.relaxing() > 0 || !structure.open.contacts.empty() || any_closed(path.start.closed) ||
      std::ranges::any_of(path.events, [](const SequenceEvent& event) {
        return event.kind != ContactEvent::Kind::impact || any_closed(event.closed);
      }))
    return std::nullopt;
  const ModalGreenFunction green(model.dynamics, model.period);
  if (!green.defined()) return std::nullopt;
  const MotionScales& scales = model.dynamics.scales();
  const std::vector<Impulse> impulses = motion.impulses();
  double largest = 0.0;
  for (int i = 0; i < kInstants; ++i) {
    const double time = path.start.time + model.period * i / kInstants;
    const State a = green.state(time, impulses), b = motion.at(time);
    largest = std::max(largest, scales.distance(a, b));
  }
  return largest;
}

// What the residual and its noise make of the motion. \param inverse  of the Jacobian
double error_bar_by(const Eigen::MatrixXd& inverse, const ExactOrbit& orbit) {
  return inverse.cwiseAbs().rowwise().sum().maxCoeff() * (orbit.residual + orbit.attainable);
}

// The distance to a second evaluation of the motion, by Green's function or by matrix exponentials: 0 where
// there is none. \param inverse  of the Jacobian, its rows weighted
double second_distance(const OrbitModel& model, const ExactTrajectory& motion, const Eigen::MatrixXd& inverse,
                       const Expired& expired) {
  if (const auto distance = distance_to_green_function(model, motion)) return *distance;
  OrbitModel other(model.dynamics, model.period, FlowForm::exponential);
  OrbitEquations again(other, motion.orbit(), expired);
  return again.evaluate(again.guess()) ? (inverse * again.residual()).lpNorm<Eigen::Infinity>() : 0.0;
}

// By the first order, unknowns are wrong by J^-1 times what the residual is and what it cannot show.
// \return what the orbit is one of a family of; else empty
std::string_view measure_error(const OrbitModel& model, const OrbitEquations& equations,
                               const PolishOptions& options, ExactOrbit& orbit) {
  const LuFactors lu(equations.jacobian());
  const auto family = family_inverse(equations, lu.reciprocal_condition());
  orbit.condition = family ? family->condition : condition_from(lu.reciprocal_condition());
  // An instant counts with the displacement that it costs: with the speed there.
  Eigen::VectorXd weight = Eigen::VectorXd::Ones(equations.size());
  for (Eigen::Index i = 0; i < equations.events(); ++i) {
    const double v = equations.crossings()[static_cast<std::size_t>(i)].approach;
    weight[equations.size() - equations.events() + i] = std::abs(v) / model.dynamics.scales().velocity;
  }
  const Eigen::MatrixXd inverse = weight.asDiagonal() * (family ? family->inverse : lu.inverse());
  orbit.error_bar = error_bar_by(inverse, orbit);
  const Eigen::VectorXd& left_out = orbit.admissibility.chatter_error;
  if (left_out.size() > 0 && left_out.maxCoeff() > 0.0)
    orbit.error_bar +=
        left_out.maxCoeff() + image(inverse.rightCols(equations.events()).cwiseAbs(), left_out).maxCoeff();
  if (options.second_evaluation)
    orbit.error_bar =
        std::max(orbit.error_bar, second_distance(model, *orbit.trajectory, inverse, options.expired));
  return family ? "free parts that no contact of the motion holds in their place may be anywhere" : "";
}

// What the orbit has come to, and its multipliers.
void conclude(OrbitModel& model, const OrbitEquations& equations, const PolishOptions& options,
              ExactOrbit& orbit) {
  constexpr double kUndetermined = 1e-3;  // an error bar of this size determines nothing
  const Admissibility& found = orbit.admissibility;
  const OrbitGuess& path = orbit.trajectory->orbit();
  const auto becomes = [&](OrbitOutcome outcome, std::string reason) {
    orbit.outcome = outcome;
    orbit.reason = std::move(reason);
  };
  if (!(orbit.error_bar < kUndetermined)) {
    orbit.admissibility.reached.clear();  // of a motion that is not known
    const bool known = std::isfinite(orbit.error_bar);
    return becomes(OrbitOutcome::no_convergence,
                   kSingularEquations + (known ? fmt::format(": error bar {:.2g}", orbit.error_bar) : ""));
  }
  if (!found.ok) return becomes(OrbitOutcome::not_admissible, found.reason);
  if (found.impacts > 0 && found.weakest_impact < options.grazing)
    return becomes(
        OrbitOutcome::grazing,
        fmt::format("an impact grazes its stop (approach speed {:.2g} of the scale)", found.weakest_impact));
  orbit.multipliers = multipliers_of_orbit(model, path, equations, options.expired);
  const std::vector<int> of_contacts = path.closings();
  const int closings = std::accumulate(of_contacts.begin(), of_contacts.end(), 0);
  if (found.chatter_error.sum() > 0.0)
    becomes(OrbitOutcome::chatter,
            fmt::format("complete chattering: {} impacts resolved, then contact", found.impacts));
  else
    becomes(OrbitOutcome::converged,
            fmt::format("periodic orbit, impacts {}, phases of contact {}", found.impacts, closings));
  if (closings == 0 && any_closed(path.start.closed)) orbit.reason += " (closed throughout)";
}

// Takes the motion at which the equations are evaluated. \param measured  the error of the orbit, and what it
// is one of a family of, if any
void take_motion(const std::shared_ptr<OrbitModel>& model, const OrbitGuess& path,
                 const OrbitEquations& equations, const PolishOptions& options,
                 const std::function<std::string_view()>& measured, ExactOrbit& orbit) {
  const auto trajectory =
      std::make_shared<ExactTrajectory>(model, path, equations.arcs(), equations.crossings());
  orbit.attainable = equations.noise();
  orbit.trajectory = trajectory;
  orbit.admissibility = check_admissible(*model, path, equations, options.expired);
  const std::string_view family = measured();
  conclude(*model, equations, options, orbit);
  if (!family.empty() && orbit.certified()) orbit.multipliers = {.undefined = std::string(family)};
  trajectory->set_quality({.error_bar = orbit.error_bar, .multipliers = orbit.multipliers.values});
}

// The step along a family of free motions, 1 - J^+ J of their equations, to the nearest one that stays clear
// of the stops. Empty where the motion passes none, or every one does.
std::optional<Eigen::VectorXd> step_clear_of_stops(const OrbitModel& model, const ExactTrajectory& motion,
                                                   const Eigen::MatrixXd& family) {
  constexpr int kInstants = 1024;  // of a forcing period
  constexpr double kClear = 1e-3;  // of X
  const ContactDynamics& dynamics = model.dynamics;
  const FlowStructure& structure = dynamics.structure();
  const Eigen::MatrixXd moved = product(Eigen::MatrixXd(structure.directions.transpose()),
                                        Eigen::MatrixXd(family.topRows(dynamics.size())));
  const auto order = std::lround(model.period / structure.forcing_period);
  const Eigen::RowVectorXd most = motion.sample(static_cast<int>(order) * kInstants).x.colwise().maxCoeff();
  std::vector<int> met;  // contacts that the family moves
  Eigen::VectorXd room(dynamics.contact_count());
  for (int j = 0; j < room.size(); ++j) {
    room[j] = (structure.gaps[j] - most[motion.scene_contact(j)]) / dynamics.scales().displacement;
    if (moved.row(j).norm() > kClear) met.push_back(j);
  }
  if (met.empty() || room.minCoeff() >= -kAdmissible) return std::nullopt;
  const Eigen::MatrixXd rows = moved(met, Eigen::all);
  const auto z = solve_small_lcp(product_by_transposed(rows, rows),
                                 Eigen::VectorXd(entries_of(room, met).array() - kClear),
                                 std::vector<bool>(met.size(), false));
  return z ? std::optional<Eigen::VectorXd>(-image_by_transposed(rows, *z)) : std::nullopt;
}

// Puts the instants of events that rounding has exchanged at one; the order of the events by their instants
// where more than rounding has.
std::vector<std::size_t> order_in_time(OrbitGuess& path, double period) {
  std::vector<std::size_t> order(path.events.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  bool overtaken = false;
  for (std::size_t i = 1; i < path.events.size(); ++i)
    overtaken = overtaken || path.events[i].time < path.events[i - 1].time - kOrbitRounding * period;
  if (overtaken) std::ranges::stable_sort(order, {}, [&](std::size_t i) { return path.events[i].time; });
  for (std::size_t i = 1; i < path.events.size() && !overtaken; ++i)
    path.events[i].time = std::max(path.events[i].time, path.events[i - 1].time);
  return order;
}

ExactOrbit polish(const std::shared_ptr<OrbitModel>& model, const OrbitGuess& guess,
                  const PolishOptions& options, bool again = true) {
  OrbitEquations equations(*model, guess, options.expired);
  const OrbitNewtonResult newton =
      solve(equations, options.tolerance, options.max_iterations, options.expired);
  ExactOrbit orbit{.origin = guess.origin, .residual = newton.residual, .iterations = newton.iterations};
  if (!newton.solved) {
    orbit.outcome = newton.merging ? OrbitOutcome::events_merge : OrbitOutcome::no_convergence;
    orbit.reason = newton.reason;
    return orbit;
  }
  OrbitGuess path = equations.orbit(newton.unknowns);
  const std::vector<std::size_t> order = order_in_time(path, model->period);
  if (!std::ranges::is_sorted(order)) {
    path.events = reordered(path.events, path.start.closed, order);
    if (again) {
      orbit = polish(model, path, options, false);
      orbit.iterations += newton.iterations;
      return orbit;
    }
  }
  take_motion(
      model, path, equations, options, [&] { return measure_error(*model, equations, options, orbit); },
      orbit);
  return orbit;
}

}  // namespace

std::string ExactOrbit::describe_multipliers() const {
  if (multipliers.undefined.empty())
    return fmt::format("largest multiplier {:.6g}", largest_magnitude(multipliers.values));
  return "stability undefined: " + describe_orders(multipliers);
}

std::string describe(OrbitOutcome outcome) {
  constexpr const char* kWords[] = {"converged",      "complete chattering", "grazing",
                                    "not admissible", "two events merge",    "no convergence"};
  return kWords[static_cast<std::size_t>(outcome)];
}

ExactOrbit polish_free_member(const std::shared_ptr<OrbitModel>& model, const OrbitGuess& guess,
                              const PolishOptions& options) {
  if (touches(guess)) return {};
  try {
    OrbitEquations equations(*model, guess, options.expired);
    Eigen::VectorXd unknowns = equations.guess();
    if (!equations.evaluate(unknowns)) return {};
    const auto family = family_inverse(equations.jacobian(), model->dynamics.structure().states());
    if (!family) return {};
    const Eigen::MatrixXd& inverse = family->inverse;
    unknowns -= inverse * equations.residual();
    if (!equations.evaluate(unknowns)) return {};
    const Eigen::MatrixXd along =
        Eigen::MatrixXd::Identity(unknowns.size(), unknowns.size()) - inverse * equations.jacobian();
    const ExactTrajectory motion(model, equations.orbit(unknowns), equations.arcs(), equations.crossings());
    if (const auto step = step_clear_of_stops(*model, motion, along)) {
      unknowns += *step;
      if (!equations.evaluate(unknowns)) return {};
    }
    ExactOrbit orbit{.origin = guess.origin, .residual = equations.residual().lpNorm<Eigen::Infinity>()};
    const auto measured = [&] {
      orbit.condition = family->condition;
      orbit.error_bar = error_bar_by(inverse, orbit);
      return "nothing touches: one of a family of free motions, of any mean within the clearances";
    };
    take_motion(model, equations.orbit(unknowns), equations, options, measured, orbit);
    return orbit;
  } catch (const std::exception& error) {  // as of polish_sequence
    return {.reason = error.what(), .origin = guess.origin};
  }
}

ExactOrbit polish_sequence(const std::shared_ptr<OrbitModel>& model, const OrbitGuess& guess,
                           const PolishOptions& options) {
  try {
    return polish(model, guess, options);
  } catch (const std::exception& error) {  // a mode whose flow cannot be formed; the time is up
    return {.reason = error.what(), .origin = guess.origin};
  }
}

}  // namespace signorini
