#include "methods/marching/periodic_march.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "methods/solvers/anderson_acceleration.hpp"
#include "methods/solvers/newton_krylov.hpp"

namespace signorini {

namespace {

// How many states of the march are tried where all else failed, and how much longer Anderson's acceleration
// is at the very end.
constexpr int kAttempts = 24, kPatience = 4;

double relative_defect(double difference, const Eigen::VectorXd& state) {
  const double scale = state.norm();
  return difference == 0.0 ? 0.0 : difference / std::max(scale, std::numeric_limits<double>::min());
}

/// Y - P(Y) = 0 as Newton's method sees it.
class PeriodMapSystem {
 public:
  explicit PeriodMapSystem(ContactMarch& march) : march_(march) {}

  Eigen::VectorXd residual(const Eigen::VectorXd& state) { return state - march_.period(state); }

  /// To 1e-3 of the residual: the sets are frozen, so that more would be wasted.
  KrylovSolve solve_jacobian(const Eigen::VectorXd& value) {
    return solve_by_gmres([&](const Eigen::VectorXd& v) { return Eigen::VectorXd(v - march_.tangent(v)); },
                          [](const Eigen::VectorXd& v) { return v; }, value, 1e-3);
  }

  static double error(const Eigen::VectorXd& state, const Eigen::VectorXd& value) {
    return relative_defect(value.norm(), state);
  }

 private:
  ContactMarch& march_;
};

/// The attempts on one march, one after another.
class PeriodicSearch {
 public:
  PeriodicSearch(ContactMarch& march, const PeriodicMarchSettings& settings, Eigen::VectorXd state)
      : march_(march), settings_(settings), state_(std::move(state)), nearest_(state_) {}

  /// All of them, the first after so many periods.
  PeriodicMarch run(int periods) && {
    march(periods);
    if (!newton(nearest_, MarchedBy::newton)) try_everything_else();
    result_.newton_steps = newton_steps_;
    result_.work = march_.work();
    return std::move(result_);
  }

 private:
  void march(int periods) {
    double least = std::numeric_limits<double>::infinity();
    for (int period = 0; period < periods && !late(); ++period) {
      const Eigen::VectorXd next = march_.period(state_);
      if (!next.allFinite()) return;
      const double change = relative_defect((next - state_).norm(), state_);
      state_ = next;
      if (change > least) continue;
      least = change;
      nearest_ = state_;
    }
  }

  bool newton(const Eigen::VectorXd& from, MarchedBy by) {
    if (late()) return false;
    PeriodMapSystem system(march_);
    // Where sets change along a step, a short one may still gain a little and lead on.
    const NewtonKrylovResult newton = solve_newton_krylov(
        system, from, settings_.tolerance,
        {.max_steps = 25, .max_halvings = 8, .sufficient_decrease = 1e-2, .deadline = settings_.deadline});
    newton_steps_ += newton.iterations;
    return judge(newton.unknowns, by);
  }

  bool anderson(int periods) {
    AndersonAcceleration acceleration(15);
    Eigen::VectorXd state = state_;
    for (int period = 0; period < periods && !late(); ++period) {
      const Eigen::VectorXd next = march_.period(state);
      if (!next.allFinite()) return false;
      if (relative_defect((next - state).norm(), state) <= settings_.tolerance)
        return judge(state, MarchedBy::anderson);
      state = acceleration.next(state, next);
    }
    return false;
  }

  bool try_everything_else() {
    march(settings_.further_periods);
    if (newton(nearest_, MarchedBy::more_periods) || anderson(settings_.accelerated_periods) ||
        newton(march_.free_state(), MarchedBy::free_start))
      return true;
    // Where the march does not settle, Newton's method may come from one of its states and not from another.
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      march(settings_.further_periods);
      if (newton(nearest_, MarchedBy::more_periods)) return true;
    }
    return anderson(kPatience * settings_.accelerated_periods);
  }

  [[nodiscard]] bool late() const { return settings_.deadline.passed(); }

  // One more period from there, which is kept: motion and forces belong to the state.
  bool judge(const Eigen::VectorXd& state, MarchedBy by) {
    const Eigen::VectorXd next = march_.period(state);
    const double residual = relative_defect((next - state).norm(), state);
    const bool found = residual <= settings_.tolerance;
    result_ = {.by = found ? by : MarchedBy::nothing,
               .residual = residual,
               .state = state,
               .motion = march_.motion(),
               .force = march_.force(),
               .newton_steps = 0,
               .work = {}};
    return found;
  }

  ContactMarch& march_;
  const PeriodicMarchSettings& settings_;
  // Of the last march the last state, and the one that a period changed least: of a motion that settles its
  // last, of one that never does one near an unstable periodic motion.
  Eigen::VectorXd state_, nearest_;
  PeriodicMarch result_;
  int newton_steps_ = 0;
};

}  // namespace

std::string_view describe(MarchedBy by) {
  constexpr std::array<std::string_view, 5> kWords{
      "Newton's method after a few periods", "Newton's method after many periods", "Anderson's acceleration",
      "Newton's method from the motion without contact", "no periodic motion"};
  return kWords[static_cast<std::size_t>(by)];
}

PeriodicMarch march_to_periodic_motion(ContactMarch& march, const PeriodicMarchSettings& settings) {
  return PeriodicSearch(march, settings, Eigen::VectorXd::Zero(march.size())).run(settings.periods);
}

PeriodicMarch march_from(ContactMarch& march, const Eigen::VectorXd& state,
                         const PeriodicMarchSettings& settings) {
  return PeriodicSearch(march, settings, state).run(0);
}

}  // namespace signorini
