#include "harness/judge/measures/measures.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "harness/judge/measures/contact_response.hpp"
#include "harness/judge/measures/force_error.hpp"
#include "harness/judge/measures/impacts.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/structure/bases/condensation.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

namespace {

/// Coordinates of the largest structure whose field is compared for u_l2.
constexpr int kLargestField = 10000;
/// Impacts slower than this share of the largest speed say nothing about restitution.
constexpr double kSlow = 0.01;

Measure impulse_error(const Motion& answer, const Motion& orbit) {
  if (answer.samples.x.cols() == 0) return std::nullopt;
  const Eigen::VectorXd found = impulse_per_forcing_period(answer);
  const Eigen::VectorXd exact = impulse_per_forcing_period(orbit);
  const double scale = exact.cwiseAbs().maxCoeff();
  if (scale == 0.0) return std::nullopt;
  return (found - exact).cwiseAbs().maxCoeff() / scale;
}

/// a - b, over the harmonics of either.
Eigen::MatrixXcd series_difference(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(std::max(a.rows(), b.rows()), a.cols());
  result.topRows(a.rows()) += a;
  result.topRows(b.rows()) -= b;
  return result;
}

/// |u_answer - u_orbit| / |u_orbit - mean(u_orbit)|, root mean squares over time and coordinates, by the
/// harmonics of the responses to the difference of the forces and to the orbit's: both from one factorisation
/// of each Z_n; harmonics without force have no response.
Measure field_error(const Problem& problem, const Motion& answer, const Motion& orbit) {
  if (problem.size() <= problem.contact_count() || problem.size() > kLargestField) return std::nullopt;
  const int order = std::lcm(answer.order, orbit.order);
  const Eigen::MatrixXcd found =
      repeated(force_series(problem, answer, kMeasuredHarmonics).lambda, order / answer.order);
  Eigen::MatrixXcd exact =
      repeated(force_series(problem, orbit, kMeasuredHarmonics).lambda, order / orbit.order);
  const Eigen::MatrixXcd apart = series_difference(found, exact);
  exact.conservativeResizeLike(Eigen::MatrixXcd::Zero(apart.rows(), apart.cols()));
  const double base = kTwoPi / (order * orbit.forcing_period);
  const SparseMatrix W = contact_directions(problem);
  double error = 0.0, moving = 0.0, constant = 0.0;
  try {
    DynamicStiffness stiffness(problem);
    for (Eigen::Index n = 0; n < apart.rows(); ++n) {
      const double sides = n == 0 ? 1.0 : 2.0;  // of the spectrum
      Eigen::MatrixXcd u(problem.size(), 2);
      u << W * apart.row(n).transpose(), W * exact.row(n).transpose();
      if (n % order == 0) u.col(1) += 1.0 / sides * load_harmonic(problem, static_cast<int>(n) / order);
      if (u.isZero(0.0)) continue;
      stiffness.factorise(exact_weights(static_cast<double>(n) * base));
      u = stiffness.solve(u);
      error += sides * u.col(0).squaredNorm();
      (n == 0 ? constant : moving) += sides * u.col(1).squaredNorm();
    }
  } catch (const std::exception&) {
    return std::nullopt;  // some harmonic excites an undamped eigenfrequency: the field is not determined
  }
  const double unit = std::max(std::sqrt(moving), kRoundOff * std::sqrt(constant));
  return unit > 0.0 ? Measure(std::sqrt(error) / unit) : std::nullopt;
}

/// The same on a space, in which the difference of two fields is the response to that of their forces.
Measure field_error_on(const ContactSpace& space, const Problem& problem, const Motion& answer,
                       const Motion& orbit) {
  if (answer.order != orbit.order) return std::nullopt;
  const Eigen::MatrixXcd force = force_series(problem, orbit, kMeasuredHarmonics).lambda;
  const Eigen::MatrixXcd apart =
      series_difference(force_series(problem, answer, kMeasuredHarmonics).lambda, force);
  const double base = kTwoPi / orbit.period();
  const auto load = [&](const Eigen::MatrixXcd& lambda) {
    return space.load().coefficients(base, static_cast<int>(lambda.rows()) - 1);
  };
  try {
    const double size = space.field_size(base, force, load(force), 1);
    if (!(size > 0.0)) return std::nullopt;
    return space.field_size(base, apart, 0.0 * load(apart), 0) / size;
  } catch (const SingularStiffness&) {
    return std::nullopt;  // as above
  }
}

/// The scale of lengths: the amplitude, but at least a tenth of the largest distance of the contact-free
/// motion from the stop, so that a contact that hardly moves is not judged by its noise.
double length_scale(const Problem& problem, const Motion& motion, const Eigen::VectorXd& gaps,
                    const std::optional<ContactResponse>& response, const ContactSpace* space) {
  constexpr int kInstants = 512;
  constexpr double kLeast = 0.1;
  const double moving = amplitude(motion);
  // An answer may have no response where the load alone has one: its harmonics are more.
  const bool known = response && !response->mean_is_free();
  const std::optional<Eigen::MatrixXd> free =
      known ? response->free_displacement(kInstants) : contact_free_motion(problem, kInstants, space);
  if (!free || !free->allFinite()) return std::max(moving, least_size(problem, space));
  return std::max(moving, kLeast * (free->rowwise() - gaps.transpose()).cwiseAbs().maxCoeff());
}

/// Of contacts of different laws that of those that are no springs.
Measure penetration(const Motion& motion, const Eigen::VectorXd& gaps, const RepresentedLaw& law,
                    double scale) {
  if (scale == 0.0) return std::nullopt;
  const bool mixed = std::holds_alternative<MixedLaws>(law);
  double deepest = 0.0;
  for (Eigen::Index c = 0; c < gaps.size(); ++c) {
    if (mixed && std::holds_alternative<Spring>(law_of_contact(law, static_cast<int>(c)))) continue;
    deepest = std::max(deepest, (motion.samples.x.col(c).array() - gaps[c]).maxCoeff());
  }
  return deepest / scale;
}

Measure complementarity(const Motion& motion, const Eigen::VectorXd& gaps, const RepresentedLaw& law,
                        const Eigen::VectorXd& stiffness, double scale) {
  if (scale == 0.0) return std::nullopt;
  const Eigen::ArrayXXd room = (-motion.samples.x.array()).rowwise() + gaps.transpose().array();
  double sum = 0.0;
  for (Eigen::Index c = 0; c < room.cols(); ++c) {
    const Eigen::ArrayXd force = motion.samples.force.col(c).array();
    const ContactLaw own = law_of_contact(law, static_cast<int>(c));
    if (const auto* spring = std::get_if<Spring>(&own)) {
      sum += (force / spring->stiffness + (-room.col(c)).max(0.0)).abs().mean();
    } else {
      sum += (-force / stiffness[c]).min(room.col(c)).abs().mean();
    }
  }
  return sum / static_cast<double>(room.cols()) / scale;
}

std::vector<double> restitutions(const Motion& motion) {
  std::vector<double> found;
  const double fastest = motion.samples.velocity.cwiseAbs().maxCoeff();
  for (const ContactPhase& phase : contact_phases(motion)) {
    if (phase.lasting || !phase.speed_before || !phase.speed_after) continue;
    if (*phase.speed_before > kSlow * fastest) found.push_back(-*phase.speed_after / *phase.speed_before);
  }
  return found;
}

/// sum over n > H of cos(n theta) / n^2, 0 <= theta < 2 pi.
double cosine_tail(double theta, int harmonics) {
  double tail =
      std::numbers::pi * std::numbers::pi / 6.0 - std::numbers::pi * theta / 2.0 + theta * theta / 4.0;
  for (int n = 1; n <= harmonics; ++n) tail -= std::cos(n * theta) / (static_cast<double>(n) * n);
  return tail;
}

/// Dissipation beyond harmonic H of velocities that jump by M^-1 W p: with v_n = M^-1 W p_n / (i n w),
/// W_D = sum over n > H of 2 T v_n^* D v_n.
double dissipation_tail(const Problem& problem, const Motion& answer, int harmonics) {
  const std::vector<Impulse>& impulses = answer.impulses;
  if (impulses.empty()) return 0.0;
  const Eigen::MatrixXd jumps = velocity_jumps(problem);
  const Eigen::MatrixXd weight = jumps.transpose() * (problem.damping() * jumps);
  const double period = answer.period();
  double sum = 0.0;
  for (const Impulse& a : impulses) {
    for (const Impulse& b : impulses) {
      const double turn = (a.time - b.time) / period;
      const double theta = 2.0 * std::numbers::pi * (turn - std::floor(turn));
      sum += a.value * b.value * weight(a.contact, b.contact) * cosine_tail(theta, harmonics);
    }
  }
  return sum * period / (2.0 * std::numbers::pi * std::numbers::pi);
}

/// Response to an answer's contact force, or why there is none.
struct Response {
  Response(const Problem& problem, const Motion& answer, const ContactSpace* space) {
    try {
      found.emplace(problem, force_series(problem, answer, kMeasuredHarmonics), space);
    } catch (const std::bad_alloc&) {
      throw;  // the child's memory limit is told apart
    } catch (const std::exception& error) {
      reason = error.what();
    }
  }

  std::optional<ContactResponse> found;
  std::string reason;
};

/// Whether every contact that pushes does so throughout the period.
bool holds_throughout(const Motion& answer) {
  const std::vector<ContactPhase> phases = contact_phases(answer);
  const auto lasts = [&](const ContactPhase& phase) {
    return phase.lasting && phase.end - phase.begin > answer.period() - 0.5 * answer.step();
  };
  return !phases.empty() && std::ranges::all_of(phases, lasts);
}

EnergyDefect energy_defect(const Problem& problem, const RepresentedLaw& law, const Motion& answer,
                           const Response& response) {
  if (std::holds_alternative<Undetermined>(law)) return {.reason = "the law leaves the impacts open"};
  if (!response.found) return {.reason = response.reason};
  const double work = response.found->work_of_load();
  // Without damping the exact work is zero: what round-off leaves of it is no scale.
  if (!response.found->load_works()) return {.reason = "the load does no work"};
  // The response to the force of a grid moves a little where the contact holds, and that is all its work.
  const bool rigid = !std::holds_alternative<Penalty>(law);
  if (rigid && !answer.integrated && holds_throughout(answer))
    return {.reason = "the contacts hold throughout"};
  // What is missed: W_f - W_D is minus the work of the contacts.
  double missed = 0.0;
  try {
    if (answer.integrated) {
      missed = -contact_work(answer, law, contact_gaps(problem));
    } else {
      missed = work - response.found->dissipation();
      if (!answer.bandwidth) missed -= dissipation_tail(problem, answer, kMeasuredHarmonics);
    }
    if (std::holds_alternative<MixedLaws>(law)) return {.reason = "its contacts have different laws"};
    const auto* restitution = std::get_if<Restitution>(&law);
    if (restitution != nullptr && restitution->e < 1.0) {
      missed -= expected_loss(answer, restitution->e,
                              contact_directions(problem).transpose() * velocity_jumps(problem));
    }
  } catch (const std::invalid_argument& error) {
    return {.reason = error.what()};  // an impulse on what has no mass
  }
  return {.value = std::abs(missed) / std::abs(work)};
}

/// (x'_- + x'_+) / 2 at an impulse; of one side where the other cannot be told, 0 where neither can.
double mean_speed(const SpeedsBeside& speeds, double restitution) {
  const auto& [before, after] = speeds;
  if (before && after) return 0.5 * (*before + *after);
  if (before) return 0.5 * (1.0 - restitution) * *before;
  if (after && restitution > 0.0) return 0.5 * (1.0 - 1.0 / restitution) * *after;
  return 0.0;
}

}  // namespace

Errors measure_errors(const Problem& problem, const Motion& answer, const Motion& orbit,
                      const ContactSpace* space) {
  const Distance d = distance(answer, orbit);
  Errors errors;
  errors.x_l2 = d.x_l2;
  errors.x_max = d.x_max;
  errors.velocity_l2 = d.velocity_l2;
  errors.impulse = impulse_error(answer, orbit);
  errors.force_l2 = d.force_l2;
  errors.x_worst = d.x_worst;
  errors.force = force_errors(answer, orbit).worst();
  const bool on_space = space != nullptr && space->obstacle().empty();
  errors.u_l2 =
      on_space ? field_error_on(*space, problem, answer, orbit) : field_error(problem, answer, orbit);
  return errors;
}

double expected_loss(const Motion& motion, double restitution, const Eigen::MatrixXd& delassus) {
  const double factor = (1.0 - restitution) / (2.0 * (1.0 + restitution));
  const double together = time_resolution(motion);
  double loss = 0.0;
  Eigen::VectorXd impulse = Eigen::VectorXd::Zero(delassus.rows());
  constexpr double kOneInstant = 1e-9;  // of the period
  double last = -1.0;
  const auto finish = [&] {
    loss += factor * impulse.dot(delassus * impulse);
    impulse.setZero();
  };
  for (const ContactPhase& phase : contact_phases(motion)) {
    if (phase.lasting) {
      // A listed impulse accounts for the closing by itself.
      const double v =
          phase.speed_before && motion.impulses.empty() ? std::max(0.0, *phase.speed_before) : 0.0;
      if (restitution < 1.0) loss += 0.5 * v * v / delassus(phase.contact, phase.contact);
      continue;
    }
    const double window = phase.listed ? kOneInstant * motion.period() : together;
    if (phase.begin - last > window) finish();
    impulse[phase.contact] += phase.impulse;
    last = phase.end;
  }
  finish();
  return loss;
}

EnergyDefect energy_defect(const Problem& problem, const RepresentedLaw& law, const Motion& answer) {
  return energy_defect(problem, law, answer, Response(problem, answer, nullptr));
}

Physics measure_physics(const Problem& problem, const RepresentedLaw& law, const Motion& answer,
                        const ContactSpace* space) {
  Physics physics;
  const Response response(problem, answer, space);
  EnergyDefect energy = energy_defect(problem, law, answer, response);
  physics.energy_defect = energy.value;
  physics.energy_reason = std::move(energy.reason);
  if (problem.contacts.empty()) return physics;
  const Eigen::VectorXd gaps = contact_gaps(problem);
  const double scale = length_scale(problem, answer, gaps, response.found, space);
  physics.penetration = penetration(answer, gaps, law, scale);
  physics.complementarity = complementarity(answer, gaps, law, contact_stiffness_scale(problem), scale);
  physics.contact_ratio = contact_ratio(answer);
  physics.effective_restitution = restitutions(answer);
  return physics;
}

double contact_work(const Motion& motion, const RepresentedLaw& law, const Eigen::VectorXd& gaps) {
  Eigen::ArrayXXd force = motion.samples.force.array();
  for (Eigen::Index c = 0; c < force.cols(); ++c) {
    const ContactLaw own = law_of_contact(law, static_cast<int>(c));
    if (const auto* spring = std::get_if<Spring>(&own))
      force.col(c) += spring->stiffness * (motion.samples.x.col(c).array() - gaps[c]).max(0.0);
  }
  double work = motion.step() * (force * motion.samples.velocity.array()).sum();
  const std::vector<SpeedsBeside> speeds = speeds_beside_impulses(motion);
  for (std::size_t i = 0; i < speeds.size(); ++i)
    work += motion.impulses[i].value *
            mean_speed(speeds[i], restitution_of(law_of_contact(law, motion.impulses[i].contact)));
  return work;
}

}  // namespace signorini
