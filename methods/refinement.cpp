#include "methods/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace signorini {

namespace {

/// Motions are at rest below this share of the static deflection.
constexpr double kAtRest = 1e-6;

constexpr double kAgreed = 0.05;

/// Instants that tell an answer as its own representation does.
int instants_of(const Trajectory& motion, int resolution) {
  return motion.nodes().value_or(2 * motion.bandwidth().value_or(resolution) + 1);
}

class RefinedUntilAgreed final : public PreparedMethod {
 public:
  RefinedUntilAgreed(Resolutions resolutions, RefinementRule rule)
      : resolutions_(std::move(resolutions)), rule_(std::move(rule)) {
    resolutions_.at(0);
  }

  Solution solve(const Start& start) override {
    resolutions_.forget_from(1);
    Work spent;
    std::optional<Solution> answer;
    Solution latest;
    Check check;
    for (std::size_t k = 0; k < resolutions_.count() && !check.agreed() && !check.ended; ++k) {
      check.cut_short = k > 0 && start.expired();
      if (check.cut_short) break;
      latest = k == 0 ? resolutions_.at(0).solve(start) : resolutions_.solve_at(k, start);
      add_effort(latest.work, spent);
      latest.message += fmt::format("; {} = {}", rule_.resolution, resolutions_.value(k));
      check.ended = rule_.worth_refining && !rule_.worth_refining(latest);
      if (latest.verdict != Verdict::converged) continue;
      const std::optional<Solution> before = std::exchange(answer, latest);
      check.taken = check.ended;
      if (!before) continue;
      const Trajectory& motion = *latest.trajectory;
      check.away = relative_distance(*before->trajectory, motion, instants_of(motion, resolutions_.value(k)),
                                     rule_.least);
    }
    const bool doubtful = answer || check.cut_short;
    Solution solution = answer ? *std::move(answer) : std::move(latest);
    if (doubtful) judge(check, solution);
    solution.work.pivots = spent.pivots;
    solution.work.iterations = spent.iterations;
    solution.work.factorisations = spent.factorisations;
    return solution;
  }

 private:
  /// What is known of the answer.
  struct Check {
    std::optional<double> away = {};  // from the one before
    bool cut_short = false;           // a finer one could not be asked
    bool ended = false;               // a finer one is not worth its cost
    bool taken = false;               // neither is one for the answer, as it is
    [[nodiscard]] bool agreed() const { return away && *away <= kAgreed; }
  };

  /// Takes back the claim of an answer of which too little is known.
  void judge(const Check& check, Solution& solution) const {
    std::string doubt;
    if (check.cut_short)
      doubt = "the time was up before a finer one could be asked";
    else if (check.away && !(*check.away <= kNearOrbit))
      doubt = fmt::format("the motion at the resolution before is {:.2g} away", *check.away);
    else if (!rule_.only_confirmed || check.taken || check.agreed())
      return;
    else if (check.away)
      doubt = fmt::format("the motion at the resolution before is {:.2g} away, the limit is {}", *check.away,
                          kAgreed);
    else
      doubt = "no other resolution confirms it";
    solution.verdict = Verdict::not_converged;
    solution.message += "; " + doubt;
  }

  Resolutions resolutions_;
  RefinementRule rule_;
};

}  // namespace

std::vector<int> rising_resolutions(int first, int factor, int finest) {
  std::vector<int> values{first};
  while (values.back() <= finest / factor) values.push_back(factor * values.back());
  return values;
}

Resolutions::Resolutions(std::vector<int> values, AtResolution prepare)
    : values_(std::move(values)), prepare_(std::move(prepare)), prepared_(values_.size()) {}

PreparedMethod& Resolutions::at(std::size_t k) {
  if (!prepared_[k]) prepared_[k] = prepare_(values_[k]);
  return *prepared_[k];
}

Solution Resolutions::solve_at(std::size_t k, const Start& start) {
  try {
    return at(k).solve(start);
  } catch (const std::exception& error) {
    return {.message = error.what()};
  }
}

void Resolutions::forget_from(std::size_t k) {
  for (; k < prepared_.size(); ++k) prepared_[k].reset();
}

std::unique_ptr<PreparedMethod> refined_until_agreed(Resolutions resolutions, RefinementRule rule) {
  return std::make_unique<RefinedUntilAgreed>(std::move(resolutions), std::move(rule));
}

double relative_distance(const Trajectory& a, const Trajectory& b, int instants, double least) {
  const Eigen::MatrixXd x_a = a.sample(instants).x;
  const Eigen::MatrixXd x_b = b.sample(instants).x;
  const double difference = (x_a - x_b).norm();
  if (difference == 0.0) return 0.0;
  // Sizes are about the mean: where the origin of x is says nothing about a motion. Round-off goes with |x|.
  constexpr double kRoundOff = 1e-9;
  const auto size = [](const Eigen::MatrixXd& x) { return (x.rowwise() - x.colwise().mean()).norm(); };
  const double moves = std::max(size(x_a), size(x_b)),
               rest = least * std::sqrt(static_cast<double>(instants));
  // Where nothing moves, two answers differ by the places at which they rest.
  if (moves <= rest) return difference / (rest / kAtRest);
  return difference / std::max(moves, kRoundOff * std::max(x_a.norm(), x_b.norm()));
}

double static_deflection(const Problem& problem) {
  double load = 0.0;
  for (const ForceTerm& term : problem.force) load += std::abs(force_amplitude(term, problem.frequency));
  return load / contact_stiffness_scale(problem).minCoeff();
}

double size_at_rest(const Problem& problem) { return kAtRest * static_deflection(problem); }

void add_effort(const Work& part, Work& whole) {
  for (const auto count : {&Work::pivots, &Work::iterations, &Work::factorisations})
    if (part.*count) whole.*count = (whole.*count).value_or(0) + *(part.*count);
}

}  // namespace signorini
