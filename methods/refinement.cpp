#include "methods/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace signorini {

namespace {

class RefinedUntilAgreed final : public PreparedMethod {
 public:
  RefinedUntilAgreed(Resolutions resolutions, WorthChecking worth_checking, double least)
      : resolutions_(std::move(resolutions)), worth_checking_(std::move(worth_checking)), least_(least) {
    resolutions_.at(0);
  }

  Solution solve(const Start& start) override {
    resolutions_.forget_from(1);
    Work spent;
    std::optional<Solution> answer;
    Solution latest;
    double away = 0.0;
    bool cut_short = false;
    for (std::size_t k = 0; k < resolutions_.count(); ++k) {
      cut_short = k > 0 && start.expired();
      if (cut_short) break;
      latest = k == 0 ? resolutions_.at(0).solve(start) : resolutions_.solve_at(k, start);
      add_effort(latest.work, spent);
      latest.message += fmt::format("; N = {}", resolutions_.value(k));
      if (latest.verdict != Verdict::converged) continue;
      const std::optional<Solution> before = std::exchange(answer, latest);
      if (before) {
        away = relative_distance(*before->trajectory, *latest.trajectory, resolutions_.value(k), least_);
        if (away <= kAgreed) break;
      }
      if (!worth_checking_(latest)) break;
    }
    Solution solution = answer ? *std::move(answer) : std::move(latest);
    if (!near_by(away) || cut_short) {
      solution.verdict = Verdict::not_converged;
      solution.message += cut_short
                              ? std::string("; the time was up before a finer one could be asked")
                              : fmt::format("; the motion at the resolution before is {:.2g} away", away);
    }
    solution.work.pivots = spent.pivots;
    solution.work.iterations = spent.iterations;
    solution.work.factorisations = spent.factorisations;
    return solution;
  }

 private:
  static constexpr double kAgreed = 0.05;

  Resolutions resolutions_;
  WorthChecking worth_checking_;
  double least_;
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

std::unique_ptr<PreparedMethod> refined_until_agreed(Resolutions resolutions, WorthChecking worth_checking,
                                                     double least) {
  return std::make_unique<RefinedUntilAgreed>(std::move(resolutions), std::move(worth_checking), least);
}

double relative_distance(const Trajectory& a, const Trajectory& b, int instants, double least) {
  const Eigen::MatrixXd x_a = a.sample(instants).x;
  const Eigen::MatrixXd x_b = b.sample(instants).x;
  const double difference = (x_a - x_b).norm();
  if (difference == 0.0) return 0.0;
  // Sizes are about the mean: where the origin of x is says nothing about a motion. Round-off goes with |x|.
  constexpr double kRoundOff = 1e-9;
  const auto size = [](const Eigen::MatrixXd& x) { return (x.rowwise() - x.colwise().mean()).norm(); };
  return difference / std::max({size(x_a), size(x_b), least * std::sqrt(static_cast<double>(instants)),
                                kRoundOff * std::max(x_a.norm(), x_b.norm())});
}

bool near_by(double distance) { return distance <= kNearOrbit; }

void add_effort(const Work& part, Work& whole) {
  if (part.pivots) whole.pivots = whole.pivots.value_or(0) + *part.pivots;
  if (part.iterations) whole.iterations = whole.iterations.value_or(0) + *part.iterations;
  if (part.factorisations) whole.factorisations = whole.factorisations.value_or(0) + *part.factorisations;
}

}  // namespace signorini
