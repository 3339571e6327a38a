#include "steady_state.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <variant>

namespace siconos_rivals {

signorini::Support ImpactMethod::supports(const signorini::Problem& problem) const {
  constexpr int kMostCoordinates = 400;  // 160 us a step at 100, growing with the square
  if (!std::holds_alternative<signorini::Restitution>(problem.law()))
    return {false, "no law of impact in the scene"};
  if (problem.size() > kMostCoordinates) return {false, "dense matrices of more than 400 coordinates"};
  if ((problem.mass().diagonal().array() <= 0.0).any()) return {false, "coordinates without mass"};
  return {};
}

signorini::RepresentedLaw ImpactMethod::law(const signorini::Problem& problem) const {
  return std::get<signorini::Restitution>(problem.law());
}

System system_of(const signorini::Problem& problem) {
  Eigen::VectorXd gap(problem.contact_count());
  for (int j = 0; j < problem.contact_count(); ++j)
    gap[j] = problem.contacts[static_cast<std::size_t>(j)].gap;
  return {.mass = problem.mass(),
          .damping = problem.damping(),
          .stiffness = problem.stiffness(),
          .directions = contact_directions(problem),
          .gap = gap,
          .restitution = std::get<signorini::Restitution>(problem.law()).e,
          .load = [&problem](double time) { return load_at(problem, time); }};
}

SteadyState::SteadyState(State start, double tolerance, int most, const signorini::Start& limits)
    : state_(std::move(start)),
      tolerance_(tolerance),
      most_(most),
      limits_(limits),
      change_(std::numeric_limits<double>::infinity()) {}

bool SteadyState::over() const { return change_ <= tolerance_ || periods_ >= most_ || limits_.expired(); }

void SteadyState::follow(const NextPeriod& next, int patience) {
  constexpr double kRest = std::numeric_limits<double>::min();  // of a structure that does not move
  double least = std::numeric_limits<double>::infinity();
  for (int left = patience; left > 0 && !over(); --left) {
    Period period = next();
    change_ = std::max((period.end.u - state_.u).cwiseAbs().maxCoeff() / std::max(period.displacement, kRest),
                       (period.end.v - state_.v).cwiseAbs().maxCoeff() / std::max(period.speed, kRest));
    state_ = std::move(period.end);
    trajectory_ = std::move(period.trajectory);
    ++periods_;
    if (change_ > 0.5 * least) continue;
    least = change_;
    left = patience;
  }
}

signorini::Solution SteadyState::solution() const {
  signorini::Solution solution;
  const bool repeats = change_ <= tolerance_;
  solution.verdict = repeats ? signorini::Verdict::converged : signorini::Verdict::not_converged;
  solution.message = repeats ? "the motion repeats after " : "the motion does not repeat within ";
  solution.message += std::to_string(periods_) + " periods";
  solution.trajectory = trajectory_;
  solution.work = {.unknowns = 2 * state_.u.size(), .iterations = periods_};
  solution.residual = change_;
  return solution;
}

signorini::Samples KnottedTrajectory::sample(int count) const {
  const Eigen::Index contacts = knots_.front().x.size();
  signorini::Samples samples{.x = Eigen::MatrixXd(count, contacts),
                             .velocity = Eigen::MatrixXd(count, contacts),
                             .force = Eigen::MatrixXd(count, contacts)};
  for (int i = 0; i < count; ++i) {
    const double time = period_ * i / count;
    const auto later = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, time,
                                        [](double t, const Knot& knot) { return t < knot.time; });
    const Knot& a = *(later - 1);
    const Knot& b = *later;
    const double h = b.time - a.time;
    const double s = h > 0.0 ? std::clamp((time - a.time) / h, 0.0, 1.0) : 0.0;
    const double r = 1.0 - s;
    samples.x.row(i) =
        (r * r * (1.0 + 2.0 * s) * a.x + s * s * (3.0 - 2.0 * s) * b.x + h * s * r * (r * a.v - s * b.v))
            .transpose();
    samples.velocity.row(i) =
        (h > 0.0 ? Eigen::VectorXd(6.0 * s * r * (b.x - a.x) / h + r * (1.0 - 3.0 * s) * a.v +
                                   s * (3.0 * s - 2.0) * b.v)
                 : a.v)
            .transpose();
    samples.force.row(i) = (r * a.force + s * b.force).transpose();
  }
  return samples;
}

}  // namespace siconos_rivals
