#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "methods/solvers/lcp/complementarity_solver.hpp"
#include "methods/solvers/lcp/lemke_basis.hpp"
#include "methods/solvers/lcp/open_rows.hpp"

namespace signorini {

namespace {

// Pivots between two looks at the clock, and between two recomputations of the basic values: their increments
// gather rounding, while the factors, updated by orthogonal rotations, stay accurate.
constexpr long kRefresh = 64;

/// z with the basic ones at their places, none below zero, and zero elsewhere.
Eigen::VectorXd spread(const std::vector<int>& places, const Eigen::VectorXd& basic, Eigen::Index size) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(size);
  z(places) = basic.cwiseMax(0.0);
  return z;
}

/// d of a cold path: smooth on the contacts, 1 on the rows of balances.
Eigen::VectorXd cold_cover(const Lcp& lcp, const SolverSettings& settings) {
  Eigen::VectorXd cover = Eigen::VectorXd::Ones(lcp.offset.size());
  cover.head(lcp.contact_unknowns()) =
      smooth_cover(lcp.samples, lcp.contacts(), settings.cover_amplitude, settings.cover_phase);
  return cover;
}

constexpr int kNone = -1;

/// Lemke's method step by step. At every vertex of the path one pair (z_i, w_i) has both members outside the
/// basis, at zero; one of the two is about to grow, the driving variable. It moves until a basic variable
/// blocks; driving and blocking variable change places, and the complement of the blocking one drives next.
class LemkePath {
 public:
  LemkePath(const Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& guess)
      : lcp_(lcp), settings_(settings), guess_(guess), basis_(*lcp.matrix) {
    q_scale_ = lcp.offset.lpNorm<Eigen::Infinity>();
    limit_ = settings.max_iterations > 0 ? settings.max_iterations : 6000 + 10 * lcp.offset.size();
    most_positive_ = settings.most_positive > 0 ? settings.most_positive : lcp.offset.size();
  }

  LcpResult run() {
    const Eigen::VectorXd open = Eigen::VectorXd::Zero(lcp_.offset.size());
    if (!lcp_.offset.allFinite()) return finish(LcpStatus::breakdown, open);
    const bool warm = guess_.size() == lcp_.offset.size() && guess_.maxCoeff() > 0.0;
    // z = 0 solves the problem, but a guess may stand near another solution.
    if (!warm && lcp_.offset.minCoeff() >= 0.0) return finish(LcpStatus::solved, open);
    if (!warm) start_cold();
    if (warm && start_warm()) return conclude();
    while (result_.pivots < limit_ &&
           std::ssize(basis_.rows()) <= most_positive_ + 1) {  // one is that of tau
      if (result_.pivots % kRefresh == 0 && settings_.deadline.passed())
        return finish(LcpStatus::interrupted, open);
      if (since_refresh_++ % kRefresh == 0) recompute();
      if (!find_direction()) return finish(LcpStatus::breakdown, open);
      const Blocking block = find_end(driving_z_ ? kNone : pair_);
      if (block.kind == Blocking::Kind::none) return finish(LcpStatus::ray, open);
      ++result_.pivots;
      advance(block);
      exchange(block);
      if (block.kind == Blocking::Kind::tau) return conclude();
    }
    return finish(LcpStatus::limit, open);
  }

 private:
  /// tau comes down from infinity with z = 0: at tau = max(-q_i / d_i) the tightest gap closes, tau takes the
  /// place of its w in the basis, and its z drives.
  void start_cold() {
    set_cover(cold_cover(lcp_, settings_));
    (-lcp_.offset.array() / basis_.cover().array()).maxCoeff(&pair_);
    basis_.begin_with_tau(pair_);
    open_->hold(pair_);
    driving_z_ = true;
  }

  void set_cover(Eigen::VectorXd cover) {
    open_.emplace(lcp_, cover);
    basis_.set_cover(std::move(cover));
  }

  /// The guess solves the problem with q + d at tau = 1; tau descends from there, the basic z and the w with
  /// it. True if tau reaches 0 before anything blocks.
  bool start_warm();

  void hold(int row) {
    basis_.append_row(row);
    open_->hold(row);
  }

  /// Values of the basic variables from scratch, [A_RB, d_R] v = -q_R, and w behind them.
  void recompute() {
    const Eigen::VectorXd before = std::exchange(value_.basic, -lcp_.offset(basis_.rows()));
    basis_.solve(value_.basic);
    if (before.size() != value_.basic.size()) return open_->forget_values();
    basis_.combine(value_.basic - before, value_terms_);
    open_->correct_values(value_terms_);
  }

  /// What ends the piece, among the basic variables and the rows that may close; of w its index in the
  /// problem.
  Blocking find_end(int rising) {
    open_->find_falling(value_terms_, rate_terms_, rising,
                        longest_step_of_basic(value_.basic, rate_.basic, q_scale_));
    value_.w = open_->value();
    rate_.w = open_->rate();
    Blocking block = find_blocking(value_, rate_, basis_.position_of_tau(), q_scale_);
    if (block.kind == Blocking::Kind::w)
      block.position = open_->falling()[static_cast<std::size_t>(block.position)];
    return block;
  }

  /// Rates along the driving variable: [A_RB, d_R] v' = -A_R,pair if that is a z, the unit vector of its row
  /// if it is a w. False if they are not finite.
  bool find_direction() {
    if (driving_z_) {
      rate_.basic = -lcp_.matrix->submatrix(basis_.rows(), {&pair_, 1});
    } else {
      rate_.basic.setZero(std::ssize(basis_.rows()));
      rate_.basic[basis_.position_of_row(pair_)] = 1.0;
    }
    basis_.solve(rate_.basic);
    if (!rate_.basic.allFinite() || !value_.basic.allFinite()) return false;
    basis_.combine(value_.basic, value_terms_);
    basis_.combine(rate_.basic, rate_terms_);
    if (driving_z_) {
      rate_terms_.columns.push_back(pair_);
      rate_terms_.weights.push_back(1.0);
    }
    return true;
  }

  /// Walks to the end of the piece; the basic values are then reordered as `exchange` reorders the columns.
  void advance(const Blocking& block) {
    value_.basic += block.step * rate_.basic;
    open_->advance(block.step);
    if (block.kind != Blocking::Kind::w) {
      const Eigen::Index tail = value_.basic.size() - block.position - 1;
      value_.basic.segment(block.position, tail) = value_.basic.tail(tail).eval();
      value_.basic.conservativeResize(value_.basic.size() - 1);
    }
    if (driving_z_) {
      value_.basic.conservativeResize(value_.basic.size() + 1);
      value_.basic[value_.basic.size() - 1] = block.step;
    }
  }

  /// The driving variable becomes basic, the blocking one leaves, its complement drives next. A blocking z
  /// (or tau) takes its column out, a blocking w brings its row in; a driving z brings its column in, a
  /// driving w takes its row out. G is square again afterwards, and never more than one row or column off.
  void exchange(const Blocking& block) {
    const int entering = pair_;
    const bool closes = block.kind == Blocking::Kind::w;
    pair_ = closes ? block.position : basis_.remove_column(block.position);
    if (driving_z_) basis_.append_z(entering);
    if (closes) hold(pair_);
    if (!driving_z_) {
      basis_.remove_row(entering);
      open_->release(entering, block.step);
    }
    driving_z_ = closes;
  }

  /// tau has reached zero: what remains is A_SS z_S = -q_S.
  LcpResult conclude() {
    Eigen::VectorXd active = -lcp_.offset(basis_.rows());
    basis_.solve(active);
    // One step of refinement recovers what the updated factors have lost.
    const std::vector<int>& positive = basis_.basic_z();
    Eigen::VectorXd residual = lcp_.offset;
    lcp_.matrix->add_columns(positive, active.data(), 0, residual);
    Eigen::VectorXd correction = -residual(basis_.rows());
    basis_.solve(correction);
    active += correction;
    if (!positive.empty()) result_.condition = basis_.condition();
    return finish(LcpStatus::solved, spread(positive, active, lcp_.offset.size()));
  }

  LcpResult finish(LcpStatus status, Eigen::VectorXd z) {
    result_.residual = natural_residual(lcp_, z);
    result_.z = std::move(z);
    result_.status = status;
    // The path may have ended well on a basis that is singular to working precision.
    if (status == LcpStatus::solved && !(result_.residual <= settings_.tolerance))
      result_.status = LcpStatus::breakdown;
    return std::move(result_);
  }

  const Lcp& lcp_;
  const SolverSettings& settings_;
  const Eigen::VectorXd& guess_;
  double q_scale_ = 1.0;
  long limit_ = 0, most_positive_ = 0;
  LemkeBasis basis_;
  std::optional<OpenRows> open_;  // from the first cover on
  int pair_ = 0;                  // the complementary pair of which neither is basic
  bool driving_z_ = true;         // which of the two drives
  PathVariables value_, rate_;
  Combination value_terms_, rate_terms_;  // the same, as what they add to w
  long since_refresh_ = 0;
  LcpResult result_;
};

bool LemkePath::start_warm() {
  std::vector<int> active;
  for (int i = 0; i < static_cast<int>(lcp_.offset.size()); ++i) {
    if (guess_[i] > 0.0) active.push_back(i);
  }
  set_cover(cover_through(lcp_, guess_));
  for (const int row : active) open_->hold(row);
  basis_.begin_with(std::move(active));
  const Eigen::VectorXd& cover = basis_.cover();
  // A_SS z = -(q + d)_S at tau = 1; lowering tau by one changes z by A_SS dz = d_S.
  value_.basic = -(lcp_.offset + cover)(basis_.rows());
  basis_.solve(value_.basic);
  rate_.basic = -cover(basis_.rows());
  basis_.solve(rate_.basic);
  rate_.basic = -rate_.basic;
  basis_.combine(value_.basic, value_terms_);
  value_terms_.cover = 1.0;
  basis_.combine(rate_.basic, rate_terms_);
  rate_terms_.cover = -1.0;
  const Blocking block = find_end(kNone);
  if (block.step >= 1.0) return true;
  // tau has driven so far; it becomes basic in place of what blocked, whose complement drives next.
  driving_z_ = block.kind != Blocking::Kind::z;
  pair_ = driving_z_ ? block.position : basis_.remove_column(block.position);
  basis_.append_tau();
  if (driving_z_) hold(pair_);
  value_.basic.resize(0);  // of another basis
  ++result_.pivots;
  return false;
}

}  // namespace

Eigen::VectorXd smooth_cover(int samples, int contacts, double amplitude, double phase) {
  constexpr double kGolden = 0.6180339887498949;  // its multiples fill the unit interval without ties
  constexpr double kTieBreak = 1e-9;  // far above rounding, far below what would lengthen the path
  Eigen::VectorXd cover(samples * contacts);
  for (int i = 0; i < samples * contacts; ++i) {
    const double place = (i + 1) * kGolden;
    cover[i] = 1.0 + amplitude * std::cos(2.0 * std::numbers::pi * (i % samples) / samples + phase) +
               kTieBreak * (place - std::floor(place) - 0.5);
  }
  return cover;
}

Eigen::VectorXd cover_through(const Lcp& lcp, const Eigen::VectorXd& guess) {
  constexpr double kRoom = 1e-3;
  const double scale = lcp.offset.lpNorm<Eigen::Infinity>();
  const Eigen::VectorXd w = lcp.offset + *lcp.matrix * guess.cwiseMax(0.0);
  // d = -w makes w vanish at tau = 1; where the guess is zero, w may be positive and stays so.
  Eigen::VectorXd cover = -w;
  for (Eigen::Index i = 0; i < cover.size(); ++i) {
    if (guess[i] <= 0.0) cover[i] += std::max(w[i], kRoom * scale);
  }
  return cover;
}

LcpResult solve_by_pivoting(const Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& guess) {
  return LemkePath(lcp, settings, guess).run();
}

}  // namespace signorini
