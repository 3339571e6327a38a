#pragma once
// Errors against a closed form, and the order at which they fall.

#include <functional>
#include <memory>
#include <vector>

#include "methods/method.hpp"

namespace signorini::test {

/// Relative L2 error of contact `contact`, |x - exact|_2 / |exact|_2, from `count` samples of a period.
double relative_error(const Trajectory& trajectory, const std::function<double(double)>& exact,
                      int contact = 0, int count = 8192);

/// Relative L2 distance of two trajectories of equal period, all contacts together.
double relative_distance(const Trajectory& a, const Trajectory& b, int count = 4096);

/// Slope p of log error over log step by least squares: error ~ step^p. At least four levels, please.
double observed_order(const std::vector<double>& steps, const std::vector<double>& errors);

/// One cold solve, or one from a guess.
template <class M>
Solution solve(const Problem& problem, const typename M::Options& options,
               std::shared_ptr<const Trajectory> guess = nullptr) {
  return M(options).prepare(problem)->solve({.guess = std::move(guess)});
}

/// A trajectory given as a function of time, one contact, without impulses; force is zero.
class GivenMotion final : public Trajectory {
 public:
  GivenMotion(double period, std::function<double(double)> x, std::function<double(double)> force = {})
      : period_(period), x_(std::move(x)), force_(std::move(force)) {}
  [[nodiscard]] int contact_count() const override { return 1; }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] Samples sample(int count) const override;

 private:
  double period_;
  std::function<double(double)> x_, force_;
};

}  // namespace signorini::test
