// Periodic motions by the time stepping of Moreau and Jean: a plugin for signorini, and an example of one.

#include <Eigen/QR>
#include <algorithm>
#include <deque>
#include <limits>
#include <string>

#include "methods/discretisation/trajectories.hpp"
#include "methods/plugin/plugin.hpp"
#include "time_stepping.hpp"

namespace moreau_jean {

namespace {

using signorini::Problem;
using signorini::Solution;
using signorini::Start;

/// A period in N steps.
struct Grid {
  Grid(const Problem& problem, int count, double theta)
      : steps(count),
        h(problem.period() / count),
        W(contact_directions(problem)),
        stepping(problem, h, theta) {}

  int steps;
  double h;                   ///< [s]
  signorini::SparseMatrix W;  ///< Nd x Nc
  TimeStepping stepping;
};

/// One period, step by step.
struct Period {
  State end;
  Eigen::MatrixXd x, impulse;              ///< steps x Nc
  double displacement = 0.0, speed = 0.0;  ///< largest of any coordinate [m] [m/s]
  bool finished = false;                   ///< false: the time ran out
};

Period follow(Grid& grid, const State& start, const Start& limits) {
  constexpr int kBetweenLooks = 64;  // at the clock
  const Eigen::Index contacts = grid.W.cols();
  Period period{.end = start,
                .x = Eigen::MatrixXd(grid.steps, contacts),
                .impulse = Eigen::MatrixXd(grid.steps, contacts)};
  for (int k = 0; k < grid.steps; ++k) {
    if (k % kBetweenLooks == 0 && limits.expired()) return period;
    period.x.row(k) = (grid.W.transpose() * period.end.u).transpose();
    period.impulse.row(k) = grid.stepping.advance(period.end, k * grid.h).transpose();
    period.displacement = std::max(period.displacement, period.end.u.cwiseAbs().maxCoeff());
    period.speed = std::max(period.speed, period.end.v.cwiseAbs().maxCoeff());
  }
  period.finished = true;
  return period;
}

/// Anderson's acceleration of s -> P(s): the next state is the mixture of past P(s) whose mixture of past
/// P(s) - s is least. Depth 0 is the plain iteration.
class Anderson {
 public:
  explicit Anderson(int depth) : depth_(static_cast<std::size_t>(depth)) {}

  Eigen::VectorXd next(const Eigen::VectorXd& s, const Eigen::VectorXd& image) {
    const Eigen::VectorXd defect = image - s;
    // Where a contact opens or closes the past tells nothing of the future: begin again from the plain step.
    if (!defects_.empty() && defect.norm() > 2.0 * defects_.back().norm()) clear();
    images_.push_back(image);
    defects_.push_back(defect);
    if (images_.size() > depth_ + 1) {
      images_.pop_front();
      defects_.pop_front();
    }
    const auto past = static_cast<Eigen::Index>(images_.size()) - 1;
    if (past == 0) return image;
    Eigen::MatrixXd dg(s.size(), past), df(s.size(), past);
    for (Eigen::Index i = 0; i < past; ++i) {
      const auto k = static_cast<std::size_t>(i);
      dg.col(i) = images_[k + 1] - images_[k];
      df.col(i) = defects_[k + 1] - defects_[k];
    }
    const Eigen::VectorXd mixture = df.colPivHouseholderQr().solve(defect);
    return image - dg * mixture;
  }

 private:
  void clear() {
    images_.clear();
    defects_.clear();
  }

  std::size_t depth_;
  std::deque<Eigen::VectorXd> images_, defects_;
};

}  // namespace

/// Starts from rest and follows the motion period by period until it repeats; a motion that would be reached
/// anyway is reached sooner by Anderson's acceleration [anderson1965]. Converges at first order in the step.
///
/// An impact takes place at the end of a step, so the state after a period jumps by an amount of order h
/// where the instant of an impact passes from one step to the next. The periodic motion of a grid may fall
/// into such a jump: then it has none, and the iteration circles. A grid of one step more has its steps
/// elsewhere; so where the change over a period stays as large as it is, the motion goes on with N + 1 steps,
/// N + 2, ...
class MoreauJean final : public signorini::Method {
 public:
  static constexpr signorini::MethodText kText{.name = "moreau-jean",
                                               .title = "Moreau-Jean time stepping until the motion repeats",
                                               .laws = "restitution 0..1",
                                               .ladder = "steps=256|1024|4096"};

  struct Options {
    int steps = 1024;    ///< N per period of the motion [-]
    double theta = 0.5;  ///< [-]
    double tolerance =
        1e-8;  ///< on the change over a period, relative to the largest displacement or speed [-]
    int max_iterations = 2000;  ///< periods [-]
    int depth = 3;              ///< of Anderson's acceleration; 0: none [-]

    void visit(auto&& field) {
      field("steps", steps, "[-]",
            "time steps N per period, 4..10000000; a few more where the motion does not settle");
      field("theta", theta, "[-]", "implicitness, 0.5 (keeps energy) to 1 (dissipates)");
      field("tolerance", tolerance, "[-]", "change over a period accepted, relative, in (0, 1e-2]");
      field("max_iterations", max_iterations, "[-]", "limit on the periods followed, 1..1000000");
      field("depth", depth, "[-]", "periods that Anderson's acceleration remembers, 0 (none) to 20");
    }
  };

  /// \throws signorini::InvalidOption
  explicit MoreauJean(const Options& options) : options_(options) {
    using signorini::require_option;
    const Options& o = options;
    require_option(o.steps >= 4 && o.steps <= 10000000, "steps", o.steps, "must be from 4 to 10000000");
    require_option(o.theta >= 0.5 && o.theta <= 1.0, "theta", o.theta, "must be from 0.5 to 1");
    require_option(o.tolerance > 0.0 && o.tolerance <= 1e-2, "tolerance", o.tolerance,
                   "must be in (0, 1e-2]");
    require_option(o.max_iterations >= 1 && o.max_iterations <= 1000000, "max_iterations", o.max_iterations,
                   "must be from 1 to 1000000");
    require_option(o.depth >= 0 && o.depth <= 20, "depth", o.depth, "must be from 0 to 20");
  }

  [[nodiscard]] std::vector<signorini::OptionEcho> options() const override {
    return signorini::echo_options(options_);
  }

  [[nodiscard]] signorini::Support supports(const Problem& problem) const override {
    if (signorini::has_springs(problem)) return {false, "a spring is no rigid stop"};
    if (const auto one = signorini::supports_one_law(problem); !one.ok) return one;
    const Eigen::VectorXd mass = problem.mass().diagonal();
    if ((mass.array() <= 0.0).any()) return {false, "coordinates without mass have no velocity to step"};
    return {};
  }

  [[nodiscard]] signorini::RepresentedLaw law(const Problem& problem) const override {
    return std::visit([](const auto& law) -> signorini::RepresentedLaw { return law; }, problem.law());
  }

  [[nodiscard]] std::unique_ptr<signorini::PreparedMethod> prepare(const Problem& problem) const override;

 private:
  Options options_;
};

namespace {

class Prepared final : public signorini::PreparedMethod {
 public:
  Prepared(const Problem& problem, const MoreauJean::Options& options)
      : problem_(problem), options_(options), grid_(problem, options.steps, options.theta) {}

  Solution solve(const Start& start) override {
    const Eigen::Index n = problem_.size();
    State state{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
    Solution solution;
    solution.work.unknowns = 2 * n;
    solution.work.iterations = 0;
    bool over = settle(grid_, state, start, solution);
    for (int steps = options_.steps + 1; !over; ++steps) {
      Grid grid(problem_, steps, options_.theta);
      over = settle(grid, state, start, solution);
    }
    return solution;
  }

 private:
  /// Follows the motion on one grid; false where it does not settle and another grid is to be tried.
  bool settle(Grid& grid, State& state, const Start& start, Solution& solution) const {
    constexpr int kPatience = 60;  // periods in which the change must halve once
    Anderson acceleration(options_.depth);
    double least = std::numeric_limits<double>::infinity();
    for (int patience = kPatience; patience > 0; --patience) {
      if (*solution.work.iterations >= options_.max_iterations)
        return end(solution, "the motion does not repeat");
      const Period period = follow(grid, state, start);
      if (!period.finished) return end(solution, "out of time before the motion repeated");
      ++*solution.work.iterations;
      solution.residual = change(state, period);
      solution.trajectory =
          std::make_shared<signorini::NodalTrajectory>(problem_.period(), period.x, period.impulse / grid.h);
      if (*solution.residual <= options_.tolerance) {
        solution.verdict = signorini::Verdict::converged;
        return end(solution, "the motion repeats on " + std::to_string(grid.steps) + " steps");
      }
      if (*solution.residual <= 0.5 * least) {
        least = *solution.residual;
        patience = kPatience;
      }
      state = next(acceleration, state, period);
    }
    return false;
  }

  static bool end(Solution& solution, const std::string& message) {
    solution.message = message + ", after " + std::to_string(*solution.work.iterations) + " periods";
    return true;
  }

  /// Of the state over a period, relative to its largest displacement and speed.
  static double change(const State& state, const Period& period) {
    constexpr double kRest = std::numeric_limits<double>::min();  // of a structure that does not move
    return std::max((period.end.u - state.u).cwiseAbs().maxCoeff() / std::max(period.displacement, kRest),
                    (period.end.v - state.v).cwiseAbs().maxCoeff() / std::max(period.speed, kRest));
  }

  /// Displacements are stacked on velocities times a time, so that both count alike.
  [[nodiscard]] State next(Anderson& acceleration, const State& state, const Period& period) const {
    const Eigen::Index n = state.u.size();
    const double time = 1.0 / problem_.base_frequency();
    Eigen::VectorXd s(2 * n), image(2 * n);
    s << state.u, time * state.v;
    image << period.end.u, time * period.end.v;
    const Eigen::VectorXd mixed = acceleration.next(s, image);
    return {mixed.head(n), mixed.tail(n) / time};
  }

  const Problem& problem_;
  MoreauJean::Options options_;
  Grid grid_;
};

}  // namespace

std::unique_ptr<signorini::PreparedMethod> MoreauJean::prepare(const Problem& problem) const {
  return std::make_unique<Prepared>(problem, options_);
}

}  // namespace moreau_jean

SIGNORINI_PLUGIN(moreau_jean::MoreauJean)
