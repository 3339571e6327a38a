#include "methods/hat_functions/hat_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <numbers>
#include <utility>

#include "methods/discretisation/trajectories.hpp"
#include "methods/hat_functions/marched_contact.hpp"
#include "methods/hat_functions/period_marching.hpp"
#include "methods/marching/periodic_march.hpp"
#include "methods/solvers/lcp/bordered_lcp.hpp"
#include "methods/solvers/lcp/complementarity_solver.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

// Pivots per unknown after which a path counts as long: scenes without chatter need one to two.
constexpr int kShortPath = 4;
// The same after which it is given up.
constexpr int kLongPath = 100;
// Pressures of each contact beyond which it counts as long too: a pivot costs the square of their number.
constexpr int kManyPressures = 128;
// Marching either repeats its contacts soon, or follows a motion that is not periodic.
constexpr int kMarchedPeriods = 300;

/// C_n under a scheme on N nodes, n = 0..N/2, and the reduced structure that it was found on.
ReducedReceptance reduced_grid_receptance(const Problem& problem, HatScheme scheme, int samples) {
  ReducedReceptance found =
      reduced_contact_receptance(problem, samples / 2, grid_weights(problem, scheme, samples));
  weigh_contact_force(found.value.receptance, scheme, samples);
  return found;
}

/// Unknowns from which on a path of pivots, which cost their square each, takes longer than a march.
constexpr int kLongPathUnknowns = 1024;

class PreparedHat final : public PreparedMethod {
 public:
  PreparedHat(const Problem& problem, const HatSettings& options, NodalRestitution restitution)
      : problem_(problem),
        options_(options),
        found_(reduced_grid_receptance(problem, options.scheme, options.samples)),
        receptance_(found_.value),
        stops_(nodal_stops(problem, std::move(restitution))),
        marched_(reduction_to_march()) {}

  Solution solve(const Start& start) override {
    if (receptance_.contacts() == 0) return finish(Eigen::VectorXd{}, {}, {.status = LcpStatus::solved});
    const HatForm form = hat_form(receptance_, stops_, samples());
    const LcpResult result = solve(form, start);
    return finish(form.pressure(result.z), rigid_mean(receptance_, form.lcp, form.unit, result.z), result);
  }

 private:
  [[nodiscard]] int samples() const { return options_.samples; }

  /// The list of attempts (hat_contact); pivots are summed over them.
  [[nodiscard]] LcpResult solve(const HatForm& form, const Start& start) const {
    const int asked = options_.max_iterations;  // 0: not limited
    Eigen::VectorXd guess =
        start.guess ? pressure_samples(*start.guess, samples(), form.unit) : Eigen::VectorXd{};
    if (options_.solver != ComplementaritySolver::automatic)
      return follow_path(form.lcp, asked, start, guess);
    if (asked == 0 && guess.size() == 0 && marched_) {
      if (std::optional<LcpResult> pressed = permanent_contact(form.lcp, options_.tolerance))
        return *std::move(pressed);
      guess = marched_guess(form, start);
      if (guess.size() > 0) {
        LcpResult near = newton_from(form, guess, start);
        if (near.status == LcpStatus::solved) return near;
      }
    }

    const auto pivots = [&](long per_unknown) {
      return static_cast<int>(
          std::min<long>(per_unknown * form.lcp.matrix->size(), std::numeric_limits<int>::max()));
    };
    // A force that hat functions interpolate at one node is felt at the node before: no recurrence has it.
    const bool marches = options_.scheme != HatScheme::consistent;
    const bool within_limit = asked > 0 && asked <= pivots(kShortPath);
    const LcpResult first = follow_path(form.lcp, within_limit ? asked : pivots(kShortPath), start, guess,
                                        marches && asked == 0 ? kManyPressures * receptance_.contacts() : 0);
    if (first.status != LcpStatus::limit || within_limit) return first;

    LcpResult result = marches ? march(form, start) : LcpResult{};
    if (result.status != LcpStatus::solved)
      result = follow_path(form.lcp, asked > 0 ? asked : pivots(kLongPath), start, {});
    result.pivots += first.pivots;
    return result;
  }

  /// Attempts 1 and 2, or the solver asked for, with that many pivots or steps.
  [[nodiscard]] LcpResult follow_path(const Lcp& lcp, int max_iterations, const Start& start,
                                      const Eigen::VectorXd& guess, int most_positive = 0) const {
    return solve_lcp(lcp,
                     {.solver = options_.solver,
                      .tolerance = options_.tolerance,
                      .max_iterations = max_iterations,
                      .most_positive = most_positive,
                      .deadline = start.deadline,
                      .cover_amplitude = options_.cover_amplitude,
                      .cover_phase = options_.cover_phase},
                     guess);
  }

  /// What attempt 0 marches; null where a path of pivots is short, no solver is left open, or the march does
  /// not represent the scene.
  [[nodiscard]] std::shared_ptr<const ContactReduction> reduction_to_march() const {
    if (receptance_.rigid_count() > 0) return nullptr;
    const bool is_short =
        receptance_.contacts() * samples() < kLongPathUnknowns && problem_.size() <= kMostFactorised;
    if (is_short || !options_.way_is_open() || !march_obstacle(problem_).empty()) return nullptr;
    if (found_.reduction.obstacle.empty()) return std::make_shared<const ContactReduction>(found_.reduction);
    return marched_reduction(problem_);
  }

  /// z of the motion that the reduced structure marches to on these nodes, in a quarter of the time that is
  /// left; empty where it finds no periodic motion.
  [[nodiscard]] Eigen::VectorXd marched_guess(const HatForm& form, const Start& start) const {
    const Deadline deadline = Deadline::after(std::max(0.0, start.deadline.left() / 4.0));
    ContactMarch march(*marched_, march_grid(problem_, samples()));
    const PeriodicMarch marched = march_to_periodic_motion(march, {.deadline = deadline});
    if (!marched.found()) return {};
    return form.scaled(-marched.force.reshaped());
  }

  /// Newton's method whose first active set is that of z: of a march it is right where its pressures, of
  /// another scheme or not quite periodic, leave gaps negative.
  [[nodiscard]] LcpResult newton_from(const HatForm& form, const Eigen::VectorXd& z,
                                      const Start& start) const {
    if (form.lcp.free > 0)
      return solve_by_newton(form.lcp, {.tolerance = options_.tolerance, .deadline = start.deadline},
                             with_free_unknowns(form.lcp, z));
    const Eigen::VectorXd w = form.lcp.offset + *form.lcp.matrix * z;
    return solve_by_newton_from(form.lcp, {.tolerance = options_.tolerance, .deadline = start.deadline},
                                (z.array() > 0.0).select(z, -w.cwiseMax(0.0)));
  }

  /// Attempt 3; not solved where no periodic contact is found or Newton's method fails from it.
  [[nodiscard]] LcpResult march(const HatForm& form, const Start& start) const {
    const Eigen::VectorXd pressure =
        march_to_period(problem_, options_.scheme, samples(), stops_, kMarchedPeriods, start);
    if (pressure.size() == 0) return {};
    return newton_from(form, form.scaled(pressure), start);
  }

  /// Nodal motion behind the nodal pressures -lambda >= 0 [N] and the mean of rigid motions.
  [[nodiscard]] Solution finish(const Eigen::VectorXd& pressure, const Eigen::RowVectorXd& mean,
                                const LcpResult& result) const {
    const int contacts = receptance_.contacts();
    Solution solution;
    solution.trajectory = nodal_motion(receptance_, pressure, samples(), mean);
    const bool finite = solution.trajectory != nullptr;
    solution.verdict =
        finite && result.status == LcpStatus::solved ? Verdict::converged : Verdict::not_converged;
    solution.message = contacts == 0 ? "no contact in the scene: linear response" : describe(result.status);
    if (solution.verdict == Verdict::converged && receptance_.rigid_count() > 0 && pressure.isZero(0.0))
      solution.message =
          "nothing touches: one of a family of free motions, of any mean within the clearances";
    solution.residual = result.residual;
    solution.condition = result.condition;
    solution.work.unknowns = samples() * contacts;
    if (options_.solver == ComplementaritySolver::newton) {
      solution.work.iterations = result.iterations;
      solution.work.factorisations = result.factorisations;
    } else {
      solution.work.pivots = result.pivots;
    }
    return solution;
  }

  const Problem& problem_;
  HatSettings options_;
  ReducedReceptance found_;
  const ContactReceptance& receptance_;
  NodalStops stops_;
  std::shared_ptr<const ContactReduction> marched_;
};

/// Nodes of a grid over those of the one before.
constexpr int kFactorOfGrids = 4;

/// Whether the next grid is worth its cost. A pivot costs the square of the nodes in contact, and the next
/// grid has four times as many of both. Long contacts are expensive and rarely disputed.
bool cheap_on_the_next_grid(const Solution& solution) {
  if (solution.verdict != Verdict::converged) return true;
  constexpr double kGrowth = kFactorOfGrids * kFactorOfGrids * kFactorOfGrids;
  constexpr double kOperations = 1e9;  // about a second
  const Eigen::MatrixXd force = solution.trajectory->sample(solution.trajectory->nodes().value()).force;
  const auto pressed = static_cast<double>((force.array() < 0.0).count());
  return kGrowth * static_cast<double>(solution.work.pivots.value_or(0)) * pressed * pressed <= kOperations;
}

/// What the march steps where the settings leave the solver open; null where there is nothing to march.
std::shared_ptr<const ContactReduction> reduction_for(const Problem& problem, const HatSettings& settings) {
  return settings.scheme == HatScheme::bdf2 && settings.way_is_open() ? marched_reduction(problem) : nullptr;
}

/// One grid, marched where there is a reduction.
std::unique_ptr<PreparedMethod> prepared_grid(const Problem& problem, const HatSettings& settings,
                                              NodalRestitution restitution,
                                              std::shared_ptr<const ContactReduction> reduction) {
  if (reduction) return marched_contact(problem, settings.samples, settings.tolerance, std::move(reduction));
  return std::make_unique<PreparedHat>(problem, settings, std::move(restitution));
}

}  // namespace

ContactReceptance grid_receptance(const Problem& problem, HatScheme scheme, int samples) {
  return reduced_grid_receptance(problem, scheme, samples).value;
}

WeightsOfHarmonic grid_weights(const Problem& problem, HatScheme scheme, int samples) {
  return [scheme, samples, step = problem.period() / samples](int n) {
    return scheme_weights(scheme, 2.0 * std::numbers::pi * n / samples, step);
  };
}

void weigh_contact_force(std::vector<Eigen::MatrixXcd>& matrices, HatScheme scheme, int samples) {
  for (std::size_t n = 0; n < matrices.size(); ++n)
    matrices[n] *= contact_force_weight(scheme, 2.0 * std::numbers::pi * static_cast<double>(n) / samples);
}

std::shared_ptr<const Trajectory> nodal_motion(const ContactReceptance& receptance,
                                               const Eigen::VectorXd& pressure, int samples,
                                               const Eigen::RowVectorXd& mean) {
  Eigen::MatrixXd force = -pressure.reshaped(samples, receptance.contacts());
  Eigen::MatrixXd x = nodal_response(receptance, force);
  if (receptance.rigid_count() > 0) x.rowwise() += mean;
  if (!x.allFinite() || !force.allFinite()) return nullptr;
  return std::make_shared<NodalTrajectory>(receptance.period, std::move(x), std::move(force));
}

std::unique_ptr<PreparedMethod> hat_contact(const Problem& problem, const HatSettings& settings,
                                            NodalRestitution restitution) {
  return prepared_grid(problem, settings, std::move(restitution), reduction_for(problem, settings));
}

Support grid_support(const Problem& problem, int samples) {
  const int needed = load_bandwidth(problem);
  if (2 * needed < samples) return {};
  return {false,
          fmt::format(
              "the load reaches harmonic {} of the motion's base frequency: samples = {} cannot resolve it",
              needed, samples)};
}

int coarsest_hat_grid(const Problem& problem) {
  const unsigned needed = 16U * static_cast<unsigned>(load_bandwidth(problem));
  return std::clamp(static_cast<int>(std::bit_ceil(needed)), 256, kFinestHatGrid);
}

Resolutions hat_grids(const Problem& problem, const HatSettings& settings, NodalRestitution restitution) {
  return {rising_resolutions(coarsest_hat_grid(problem), kFactorOfGrids, kFinestHatGrid),
          [&problem, settings, restitution = std::move(restitution),
           reduction = reduction_for(problem, settings)](int samples) {
            HatSettings grid = settings;
            grid.samples = samples;
            return prepared_grid(problem, grid, restitution, reduction);
          }};
}

std::unique_ptr<PreparedMethod> refined_hat_contact(const Problem& problem, const HatSettings& settings,
                                                    NodalRestitution restitution) {
  return refined_until_agreed(hat_grids(problem, settings, std::move(restitution)),
                              {.worth_refining = cheap_on_the_next_grid, .least = size_at_rest(problem)});
}

}  // namespace signorini
