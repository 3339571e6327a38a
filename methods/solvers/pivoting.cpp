#include "methods/solvers/pivoting.hpp"

#include <utility>
#include <vector>

#include "methods/solvers/covering_vector.hpp"
#include "methods/solvers/lemke_basis.hpp"
#include "methods/solvers/ratio_test.hpp"

namespace signorini {

namespace {

// Pivots between two recomputations of the basic values: their increments gather rounding, while the factors,
// updated by orthogonal rotations, stay accurate.
constexpr long kRefresh = 64;
constexpr long kClock = 64;  // pivots between two looks at the clock

/// Lemke's method step by step. At every vertex of the path one pair (z_i, w_i) has both members outside the
/// basis, at zero; one of the two is about to grow, the driving variable. It moves until a basic variable
/// blocks; driving and blocking variable change places, and the complement of the blocking one drives next.
class LemkePath {
 public:
  LemkePath(const Lcp& lcp, const PivotingOptions& options)
      : lcp_(lcp), options_(options), basis_(*lcp.matrix) {
    const long size = lcp.offset.size();
    q_scale_ = lcp.offset.lpNorm<Eigen::Infinity>();
    limit_ = options.max_pivots > 0 ? options.max_pivots : 6000 + 10 * size;
  }

  LcpResult run() {
    const Eigen::VectorXd open = Eigen::VectorXd::Zero(lcp_.offset.size());
    if (!lcp_.offset.allFinite()) return finish(LcpStatus::breakdown, open);
    const bool warm = options_.guess.size() == lcp_.offset.size() && options_.guess.maxCoeff() > 0.0;
    // z = 0 solves the problem, but a guess may stand near another solution.
    if (!warm && lcp_.offset.minCoeff() >= 0.0) return finish(LcpStatus::solved, open);
    if (!warm) start_cold();
    if (warm && start_warm()) return conclude();
    while (result_.pivots < limit_) {
      if (result_.pivots % kClock == 0 && std::chrono::steady_clock::now() > options_.deadline)
        return finish(LcpStatus::interrupted, open);
      if (since_refresh_++ % kRefresh == 0) recompute();
      if (!find_direction()) return finish(LcpStatus::breakdown, open);
      const Blocking block = find_blocking(value_, rate_, basis_.position_of_tau(), q_scale_);
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
    const bool own = options_.cover.size() == lcp_.offset.size();
    basis_.set_cover(own ? options_.cover : smooth_cover(static_cast<int>(lcp_.offset.size()), 1));
    (-lcp_.offset.array() / basis_.cover().array()).maxCoeff(&pair_);
    basis_.begin_with_tau(pair_);
    driving_z_ = true;
  }

  /// The guess solves the problem with q + d at tau = 1; tau descends from there, the basic z and the w with
  /// it. True if tau reaches 0 before anything blocks.
  bool start_warm() {
    std::vector<int> active;
    for (int i = 0; i < static_cast<int>(lcp_.offset.size()); ++i) {
      if (options_.guess[i] > 0.0) active.push_back(i);
    }
    basis_.set_cover(cover_through(lcp_, options_.guess));
    basis_.begin_with(std::move(active));
    const Eigen::VectorXd& cover = basis_.cover();
    // A_SS z = -(q + d)_S at tau = 1; lowering tau by one changes z by A_SS dz = d_S.
    value_.basic = -(basis_.gathered(lcp_.offset) + basis_.gathered(cover));
    basis_.solve(value_.basic);
    rate_.basic = -basis_.gathered(cover);
    basis_.solve(rate_.basic);
    rate_.basic = -rate_.basic;
    value_.w = lcp_.offset + cover;
    rate_.w = -cover;
    basis_.accumulate(value_.basic, value_.w);
    basis_.accumulate(rate_.basic, rate_.w);
    const Blocking block = find_blocking(value_, rate_, basis_.position_of_tau(), q_scale_);
    if (block.step >= 1.0) return true;
    // tau has driven so far; it becomes basic in place of what blocked, whose complement drives next.
    driving_z_ = block.kind != Blocking::Kind::z;
    pair_ = driving_z_ ? block.position : basis_.remove_column(block.position);
    basis_.append_tau();
    if (driving_z_) basis_.append_row(pair_);
    ++result_.pivots;
    return false;
  }

  /// Values of the basic variables and of w from scratch: [A_RB, d_R] v = -q_R.
  void recompute() {
    basis_.gather(lcp_.offset, value_.basic);
    value_.basic = -value_.basic;
    basis_.solve(value_.basic);
    value_.w = lcp_.offset;
    basis_.accumulate(value_.basic, value_.w);
  }

  /// Rates along the driving variable: [A_RB, d_R] v' = -A_R,pair if that is a z, the unit vector of its row
  /// if it is a w. False if they are not finite.
  bool find_direction() {
    if (driving_z_) {
      basis_.gather_column(pair_, rate_.basic);
      rate_.basic = -rate_.basic;
    } else {
      rate_.basic.setZero(std::ssize(basis_.rows()));
      rate_.basic[basis_.position_of_row(pair_)] = 1.0;
    }
    basis_.solve(rate_.basic);
    if (!rate_.basic.allFinite() || !value_.basic.allFinite()) return false;
    rate_.w.setZero(lcp_.offset.size());
    if (driving_z_) {
      const double one = 1.0;
      lcp_.matrix->add_columns({&pair_, 1}, &one, rate_.w);
    }
    basis_.accumulate(rate_.basic, rate_.w);
    // Held rows stay where they are exactly; only the driving w moves. What rounding leaves there would be
    // taken for the rate of a blocking variable.
    for (const int row : basis_.rows()) rate_.w[row] = 0.0;
    if (!driving_z_) rate_.w[pair_] = 1.0;
    return true;
  }

  /// Walks to the end of the piece; the basic values are then reordered as `exchange` reorders the columns.
  void advance(const Blocking& block) {
    value_.basic += block.step * rate_.basic;
    value_.w += block.step * rate_.w;
    if (block.kind == Blocking::Kind::w) {
      value_.w[block.position] = 0.0;
    } else {
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
    if (closes) basis_.append_row(block.position);
    if (!driving_z_) basis_.remove_row(entering);
    driving_z_ = closes;
  }

  /// tau has reached zero: what remains is A_SS z_S = -q_S.
  LcpResult conclude() {
    Eigen::VectorXd active = -basis_.gathered(lcp_.offset);
    basis_.solve(active);
    // One step of refinement recovers what the updated factors have lost.
    Eigen::VectorXd residual = lcp_.offset;
    basis_.accumulate(active, residual);
    Eigen::VectorXd correction = -basis_.gathered(residual);
    basis_.solve(correction);
    active += correction;
    const std::vector<int>& positive = basis_.basic_z();
    if (!positive.empty()) result_.condition = basis_.condition();
    Eigen::VectorXd z = Eigen::VectorXd::Zero(lcp_.offset.size());
    for (std::size_t k = 0; k < positive.size(); ++k)
      z[positive[k]] = std::max(0.0, active[static_cast<Eigen::Index>(k)]);
    return finish(LcpStatus::solved, std::move(z));
  }

  LcpResult finish(LcpStatus status, Eigen::VectorXd z) {
    result_.residual = natural_residual(lcp_, z);
    result_.z = std::move(z);
    result_.status = status;
    // The path may have ended well on a basis that is singular to working precision.
    if (status == LcpStatus::solved && !(result_.residual <= options_.tolerance))
      result_.status = LcpStatus::breakdown;
    return std::move(result_);
  }

  const Lcp& lcp_;
  const PivotingOptions& options_;
  double q_scale_ = 1.0;
  long limit_ = 0;
  LemkeBasis basis_;
  int pair_ = 0;           // the complementary pair of which neither is basic
  bool driving_z_ = true;  // which of the two drives
  PathVariables value_, rate_;
  long since_refresh_ = 0;
  LcpResult result_;
};

}  // namespace

LcpResult solve_by_pivoting(const Lcp& lcp, const PivotingOptions& options) {
  return LemkePath(lcp, options).run();
}

}  // namespace signorini
