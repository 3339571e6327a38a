#include "methods/closed_hbm/closed_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <utility>
#include <vector>

#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/complementarity/impact_closure.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

constexpr int kFewestSeeds = 1024;
constexpr double kNoForce = 1e-9;  // of the largest force: no contact

/// How the phases of a sampled force are told.
struct SeedSampling {
  int count = 0;       // instants
  int longest = 0;     // instants that an impact may press
  int resolution = 1;  // without force that separate two phases
};

SeedSampling seed_sampling(const Trajectory& motion) {
  if (const auto nodes = motion.nodes()) return {.count = *nodes, .longest = 3, .resolution = 2};
  if (!motion.impulses().empty()) return {kFewestSeeds, 0, 1};
  const int harmonics = std::max(1, motion.bandwidth().value_or(kFewestSeeds / kResolvingSamples));
  return {kResolvingSamples * harmonics, static_cast<int>(kLongestContact * kResolvingSamples),
          kResolvingSamples};
}

/// One solve by impact closure.
class ImpactClosing {
 public:
  ImpactClosing(const HarmonicSetup& setup, const ClosureSetup& closure, const Start& start, Work& work)
      : setup_(setup), closure_(closure), start_(start), work_(work) {
    if (closure.response)
      motion_.emplace(*closure.response, setup.receptance.free_response, setup.gap, closure.restitution);
  }

  /// The answer that a motion's impacts lead to, found as `how` says.
  std::optional<Solution> from(const Trajectory& motion, const std::string& how) {
    const ImpactSeeds seeds = impact_seeds(motion);
    if (seeds.lasting) return failed("a contact lasts: only separate impacts are closed");
    if (seeds.impacts.count() == 0) return contact_free();
    if (!all_have_mass(seeds.impacts)) {
      harmonics_may_help_ = true;
      return failed("a contact that is struck has no mass beyond the harmonics");
    }
    const auto settled = motion_->settle(seeds.impacts, 0.01 * setup_.options.tolerance,
                                         steps_left(ImpactMotion::kSettlingSteps));
    if (!settled) return failed("instants and impulses of the impacts do not settle");
    count_iterations(settled->steps, work_);
    if (!motion_->are_separate(settled->impacts)) return failed("two contacts are struck at once");
    if (motion_->overshoot(settled->impacts) > 1e-6 * motion_->size(settled->impacts))
      return failed("the motion behind the impacts passes a stop");
    return closed(settled->impacts, how);
  }

  /// The motion in which nothing touches.
  std::optional<Solution> contact_free() {
    if (free_motion_passes_a_stop()) return failed("the motion without contact passes a stop");
    ExactProjection none;
    none.converged = true;
    none.lambda = Eigen::MatrixXcd::Zero(setup_.receptance.harmonics() + 1, setup_.receptance.contacts());
    return exact_solution(setup_.equations(), none, "nothing touches");
  }

  /// The motion in which each contact presses throughout or never.
  std::optional<Solution> permanent_contact() {
    const ExactProjection held = solve_permanent_contact(setup_.equations(), setup_.options.tolerance);
    if (!held.converged) return std::nullopt;
    return exact_solution(setup_.equations(), held, "permanent contact");
  }

  /// Takes down why an attempt failed.
  std::nullopt_t failed(std::string_view reason) {
    reason_ = reason;
    return std::nullopt;
  }

  /// What the attempts have come to.
  [[nodiscard]] ClosedAnswer ended(std::optional<Solution> answer) const {
    return {.answer = std::move(answer), .reason = reason_, .harmonics_may_help = harmonics_may_help_};
  }

 private:
  /// Beyond rounding of its size, however shortly.
  [[nodiscard]] bool free_motion_passes_a_stop() const {
    constexpr double kRounding = 1e-13;  // of the sum of what cancels
    const int instants = kResolvingSamples * std::max(setup_.receptance.harmonics(), kFewestOnGrid);
    for (Eigen::Index c = 0; c < setup_.gap.size(); ++c) {
      Eigen::VectorXcd clearance = setup_.receptance.free_response.col(c);
      clearance[0] -= setup_.gap[c];
      clearance[0] -= kRounding * clearance.cwiseAbs().sum();
      if (!positive_intervals(clearance, instants).empty()) return true;
    }
    return false;
  }

  [[nodiscard]] bool all_have_mass(const PeriodicImpacts& impacts) const {
    const int harmonics = setup_.receptance.harmonics();
    return motion_ && std::ranges::all_of(impacts.contacts, [&](int contact) {
             return is_mass_beyond(*closure_.response, contact, harmonics);
           });
  }

  /// Steps that may be taken, of so many where there is no limit.
  [[nodiscard]] int steps_left(int most) const {
    const int limit = setup_.options.max_iterations;
    return limit == 0 ? most : std::clamp(limit - static_cast<int>(steps_spent(work_)), 0, most);
  }

  std::optional<Solution> closed(const PeriodicImpacts& impacts, const std::string& how) {
    const int samples = kResolvingSamples * std::max(setup_.receptance.harmonics(), kFewestOnGrid);
    const double hard = closure_.stiffness_factor;
    for (const double factor : {hard, 1.0}) {
      const ProjectedLaw law{factor * setup_.law.constant, setup_.law.multiplier_weight};
      const ImpactClosure closure = close_impacts(
          {setup_.receptance, setup_.gap, law}, impacts,
          {.samples = samples, .tolerance = setup_.options.tolerance, .deadline = start_.deadline},
          steps_left(ExactProjectionSettings{}.most));
      count_iterations(closure.steps, work_);
      if (closure.converged) return answer(law, closure, impacts, how);
      failed(closure.failure);
      if (hard == 1.0) break;
    }
    harmonics_may_help_ = true;
    return std::nullopt;
  }

  /// Root mean square of what the structure makes, up to H, of forces in place of the impacts that they
  /// close, relative to that of X about its mean: the width of a force changes its low harmonics by a share
  /// of the order of (n / H)^2, and a resonance multiplies that by up to 1 / (2 zeta).
  [[nodiscard]] double moved_by_width(const Eigen::MatrixXcd& lambda, const PeriodicImpacts& impacts) const {
    const ContactReceptance& seen = setup_.receptance;
    double moved = 0.0, mean = 0.0;
    for (Eigen::Index n = 0; n < lambda.rows(); ++n) {
      Eigen::VectorXcd struck = Eigen::VectorXcd::Zero(lambda.cols());
      for (int k = 0; k < impacts.count(); ++k)
        struck[impacts.contacts[static_cast<std::size_t>(k)]] -=
            impacts.moments(1, k) * std::polar(1.0, -kTwoPi * static_cast<double>(n) * impacts.moments(0, k));
      const Eigen::MatrixXcd& C = seen.receptance[static_cast<std::size_t>(n)];
      moved += (n == 0 ? 1.0 : 2.0) * (C * (lambda.row(n).transpose() - struck)).squaredNorm();
      if (n == 0) mean = (seen.free_response.row(0).transpose() + C * struck).squaredNorm();
    }
    const auto contacts = static_cast<double>(lambda.cols());
    return std::sqrt(moved / (contacts * std::pow(motion_->size(impacts), 2) - mean));
  }

  [[nodiscard]] Solution answer(const ProjectedLaw& law, const ImpactClosure& closure,
                                const PeriodicImpacts& closed, const std::string& how) const {
    FourierTrajectory::Data data = series_data({setup_.receptance, setup_.gap, law}, closure.lambda);
    data.shifts = closure.shifts;
    const int impacts = closed.count();
    const double moved = moved_by_width(closure.lambda, closed);
    const std::string warning =
        moved > 0.01
            ? fmt::format("; near a resonance: the width of its forces moves it by {:.2g} of its size", moved)
            : "";
    return {
        .verdict = Verdict::converged,
        .message = fmt::format("{}; {} impact{} closed at restitution {:g}, stops moved by up to {:.1e}, net "
                               "contact work {:.1e}{}",
                               how, impacts, impacts == 1 ? "" : "s", closure_.restitution, closure.largest,
                               net_work_ratio(data.x, data.lambda), warning),
        .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
        .residual = closure.residual,
        .condition = closure.condition};
  }

  const HarmonicSetup& setup_;
  const ClosureSetup& closure_;
  const Start& start_;
  Work& work_;
  std::optional<ImpactMotion> motion_;  // none where no contact has mass
  std::string reason_;                  // why the last attempt failed
  bool harmonics_may_help_ = false;     // some attempt failed for want of them alone
};

/// From the scene on hat functions, from coarse to fine.
std::optional<Solution> close_from_hat_functions(const HarmonicSetup& setup, ClosureSetup& closure,
                                                 const Start& start, Work& work, ImpactClosing& closing) {
  if (!closure.hat_grids)
    return closing.failed("no contact has mass beyond the harmonics, or they are too many");
  Resolutions& grids = *closure.hat_grids;
  grids.forget_from(0);  // preparing them is part of this solve
  const std::size_t count = setup.options.max_iterations > 0 ? 1 : grids.count();  // within a limit on steps
  int lasting = 0;
  // Where two grids show contact that lasts, finer ones will: they are for impacts that a coarse one runs
  // together.
  for (std::size_t grid = 0; grid < count && lasting < 2 && !start.expired(); ++grid) {
    const int nodes = grids.value(grid);
    if (static_cast<long>(nodes) * setup.receptance.contacts() > kMostHatUnknowns) break;
    const Solution hat = grids.solve_at(grid, {.deadline = start.deadline});
    add_effort(hat.work, work);
    if (hat.verdict != Verdict::converged) {
      closing.failed("no motion on hat functions to begin with");
      continue;
    }
    if (impact_seeds(*hat.trajectory).lasting) ++lasting;
    if (auto answer = closing.from(*hat.trajectory, fmt::format("{} hat functions first", nodes)))
      return answer;
  }
  return std::nullopt;
}

/// Whether each contact presses throughout the period or never: nothing is struck.
bool presses_throughout_or_never(const Trajectory& motion) {
  const int count = seed_sampling(motion).count;
  const Eigen::MatrixXd force = motion.sample(count).force;
  const double none = kNoForce * force.cwiseAbs().maxCoeff();
  const auto pressed = (force.array() < -none).colwise().count();
  return (pressed == 0 || pressed == count).all();
}

}  // namespace

ImpactSeeds impact_seeds(const Trajectory& motion) {
  ImpactSeeds seeds;
  std::vector<int> contacts;
  std::vector<double> moments;
  const auto append = [&](int contact, double turn, double force) {
    contacts.push_back(contact);
    moments.push_back(turn - std::floor(turn));
    moments.push_back(force);
  };
  for (const Impulse& impulse : motion.impulses())
    append(impulse.contact, impulse.time / motion.period(), -impulse.value / motion.period());
  const SeedSampling sampling = seed_sampling(motion);
  const Eigen::MatrixXd force = motion.sample(sampling.count).force;
  const double none = kNoForce * force.cwiseAbs().maxCoeff();
  for (Eigen::Index c = 0; c < force.cols(); ++c) {
    for (const SampledPhase& phase : contact_phases(force.col(c), none, sampling.resolution)) {
      if (phase.length > sampling.longest) seeds.lasting = true;
      double sum = 0.0;
      double first = 0.0;
      for (int i = 0; i < phase.length; ++i) {
        const double push = -force((phase.first + i) % sampling.count, c);
        sum += push;
        first += push * (phase.first + i);
      }
      append(static_cast<int>(c), first / (sum * sampling.count), sum / sampling.count);
    }
  }
  seeds.impacts.moments =
      Eigen::Map<Eigen::Matrix2Xd>(moments.data(), 2, static_cast<Eigen::Index>(contacts.size()));
  seeds.impacts.contacts = std::move(contacts);
  return seeds;
}

ClosedAnswer close_answer(const HarmonicSetup& setup, ClosureSetup& closure, const Start& start, Work& work) {
  ImpactClosing closing(setup, closure, start, work);
  std::optional<Solution> answer;
  if (start.guess) answer = closing.from(*start.guess, "impacts of the guess");
  if (!answer) answer = closing.contact_free();
  if (!answer) answer = closing.permanent_contact();
  if (!answer) answer = close_from_hat_functions(setup, closure, start, work, closing);
  if (start.expired()) closing.failed("the time is up");
  return closing.ended(std::move(answer));
}

ClosedAnswer close_series(const HarmonicSetup& setup, const ClosureSetup& closure, const Solution& series,
                          const Start& start, Work& work) {
  if (presses_throughout_or_never(*series.trajectory)) return {.answer = series};
  ImpactClosing closing(setup, closure, start, work);
  return closing.ended(closing.from(*series.trajectory, series.message));
}

}  // namespace signorini
