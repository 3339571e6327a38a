#include "methods/kernels/resolutions.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "methods/kernels/receptance.hpp"

namespace signorini {

namespace {

/// One solve at a resolution; a structure that it cannot factorise has no motion.
Solution solve_at(Resolutions& resolutions, std::size_t k, const Start& start) {
  try {
    return resolutions.at(k).solve(start);
  } catch (const SingularStiffness& error) {
    return {.message = error.what()};
  }
}

class RefinedUntilConverged final : public PreparedMethod {
 public:
  RefinedUntilConverged(Resolutions resolutions, std::string symbol)
      : resolutions_(std::move(resolutions)), symbol_(std::move(symbol)) {
    resolutions_.at(0);
  }

  Solution solve(const Start& start) override {
    Solution solution = resolutions_.at(0).solve(start);
    for (std::size_t finer = 1; finer < resolutions_.count(); ++finer) {
      if (solution.verdict == Verdict::converged || start.expired()) break;
      const Work spent = solution.work;
      solution = solve_at(resolutions_, finer, start);
      add_effort(spent, solution.work);
      solution.message += fmt::format("; {} = {}", symbol_, resolutions_.value(finer));
    }
    return solution;
  }

 private:
  Resolutions resolutions_;
  std::string symbol_;
};

class RefinedUntilAgreed final : public PreparedMethod {
 public:
  RefinedUntilAgreed(Resolutions resolutions, std::string symbol, WorthChecking worth_checking)
      : resolutions_(std::move(resolutions)),
        symbol_(std::move(symbol)),
        worth_checking_(std::move(worth_checking)) {
    resolutions_.at(0);
  }

  Solution solve(const Start& start) override {
    Work spent;
    std::optional<Solution> answer;
    Solution latest;
    double away = 0.0;
    for (std::size_t k = 0; k < resolutions_.count() && (k == 0 || !start.expired()); ++k) {
      latest = k == 0 ? resolutions_.at(0).solve(start) : solve_at(resolutions_, k, start);
      add_effort(latest.work, spent);
      latest.message += fmt::format("; {} = {}", symbol_, resolutions_.value(k));
      if (latest.verdict != Verdict::converged) continue;
      const std::optional<Solution> before = std::exchange(answer, latest);
      if (before) {
        away = relative_distance(*before->trajectory, *latest.trajectory, resolutions_.value(k));
        if (away <= kAgreed) break;
      }
      if (!worth_checking_(latest)) break;
    }
    Solution solution = answer ? *std::move(answer) : std::move(latest);
    if (!near_by(away)) {
      solution.verdict = Verdict::not_converged;
      solution.message += fmt::format("; the motion at the resolution before is {:.2g} away", away);
    }
    solution.work.pivots = spent.pivots;
    solution.work.iterations = spent.iterations;
    return solution;
  }

 private:
  static constexpr double kAgreed = 0.05;

  Resolutions resolutions_;
  std::string symbol_;
  WorthChecking worth_checking_;
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

std::unique_ptr<PreparedMethod> refined_until_converged(Resolutions resolutions, std::string symbol) {
  return std::make_unique<RefinedUntilConverged>(std::move(resolutions), std::move(symbol));
}

std::unique_ptr<PreparedMethod> refined_until_agreed(Resolutions resolutions, std::string symbol,
                                                     WorthChecking worth_checking) {
  return std::make_unique<RefinedUntilAgreed>(std::move(resolutions), std::move(symbol),
                                              std::move(worth_checking));
}

double relative_distance(const Trajectory& a, const Trajectory& b, int instants) {
  const Eigen::MatrixXd x = b.sample(instants).x;
  return (a.sample(instants).x - x).norm() / x.norm();
}

bool near_by(double distance) { return distance <= 0.5; }

void add_effort(const Work& part, Work& whole) {
  if (part.pivots) whole.pivots = whole.pivots.value_or(0) + *part.pivots;
  if (part.iterations) whole.iterations = whole.iterations.value_or(0) + *part.iterations;
}

}  // namespace signorini
