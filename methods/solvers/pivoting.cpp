#include "methods/solvers/pivoting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/updated_qr.hpp"

namespace signorini {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSlack = 64 * kEpsilon;  // rounding of a few dozen operations, relative
constexpr long kRefresh = 64;             // pivots between two recomputations from scratch
constexpr int kTau = -1;  // the column of the covering vector, and "tau" as a leaving variable

/// What stops the path at the end of one linear piece.
struct Blocking {
  enum class Kind { none, tau, z, w } kind = Kind::none;
  int position = 0;  // of z: place in the column list; of w: index in the problem
  double step = kInfinity;
};

class LemkePath {
 public:
  LemkePath(Lcp& lcp, const PivotingOptions& options)
      : lcp_(lcp), options_(options), size_(lcp.matrix.size()) {
    q_scale_ = lcp.offset.lpNorm<Eigen::Infinity>();
    limit_ = options.max_pivots > 0 ? options.max_pivots : 6000 + 10L * size_;
  }

  LcpResult run() {
    if (!lcp_.offset.allFinite()) return finish(LcpStatus::breakdown, Eigen::VectorXd::Zero(size_));
    const bool warm = options_.guess.size() == size_ && options_.guess.maxCoeff() > 0.0;
    // z = 0 solves the problem, but a guess may stand near another solution.
    if (!warm && lcp_.offset.minCoeff() >= 0.0)
      return finish(LcpStatus::solved, Eigen::VectorXd::Zero(size_));
    if (warm ? start_warm() : start_cold()) return conclude();
    while (result_.pivots < limit_) {
      if ((result_.pivots & 63) == 0 && std::chrono::steady_clock::now() > options_.deadline) {
        return finish(LcpStatus::interrupted, Eigen::VectorXd::Zero(size_));
      }
      if (since_refresh_++ % kRefresh == 0) recompute();
      if (!find_direction()) return finish(LcpStatus::breakdown, Eigen::VectorXd::Zero(size_));
      const Blocking block = find_blocking();
      if (block.kind == Blocking::Kind::none) return finish(LcpStatus::ray, Eigen::VectorXd::Zero(size_));
      ++result_.pivots;
      advance(block);
      if (block.kind == Blocking::Kind::tau) {
        drop_tau();
        return conclude();
      }
      exchange(block);
    }
    return finish(LcpStatus::limit, Eigen::VectorXd::Zero(size_));
  }

 private:
  /// tau comes down from infinity with z = 0: the tightest gap closes first.
  bool start_cold() {
    cover_ = options_.cover.size() == size_ ? options_.cover
                                            : smooth_cover(lcp_.matrix.samples(), lcp_.matrix.contacts());
    int first = 0;
    (-lcp_.offset.array() / cover_.array()).maxCoeff(&first);
    rows_ = {first};
    column_.resize(1);
    column_[0] = cover_[first];
    qr_.clear();
    qr_.factorise(column_.asDiagonal().toDenseMatrix());
    columns_ = {kTau};
    pair_ = first;
    driving_z_ = true;
    return false;
  }

  /// The guess solves the problem with q + d at tau = 1; tau descends from there.
  /// True if it reaches 0 with nothing changing.
  bool start_warm() {
    const Eigen::VectorXd& guess = options_.guess;
    for (int i = 0; i < size_; ++i) {
      if (guess[i] > 0.0) {
        columns_.push_back(i);
        rows_.push_back(i);
      }
    }
    Eigen::VectorXd w = lcp_.offset + lcp_.matrix * guess.cwiseMax(0.0);
    cover_ = -w;
    for (int i = 0; i < size_; ++i) {
      if (guess[i] <= 0.0) cover_[i] += std::max(w[i], 1e-3 * q_scale_);
    }
    qr_.factorise(lcp_.matrix.submatrix(rows_, columns_));
    // Direction in which tau falls by one: A_SS dz = d_S.
    direction_ = -gather(cover_);
    value_ = -(gather(lcp_.offset) + gather(cover_));
    qr_.solve(value_);
    qr_.solve(direction_);
    direction_ = -direction_;
    w_ = lcp_.offset + cover_;
    dw_ = -cover_;
    lcp_.matrix.add_columns(columns_, value_.data(), w_);
    lcp_.matrix.add_columns(columns_, direction_.data(), dw_);
    Blocking block = find_blocking();
    if (block.step >= 1.0) return true;
    // tau enters the basis in place of what blocked; tau itself is no candidate before.
    if (block.kind == Blocking::Kind::z) {
      pair_ = columns_[static_cast<std::size_t>(block.position)];
      qr_.remove_column(block.position);
      columns_.erase(columns_.begin() + block.position);
      qr_.append_column(gather(cover_));
      columns_.push_back(kTau);
      driving_z_ = false;
    } else {
      qr_.append_column(gather(cover_));
      columns_.push_back(kTau);
      pair_ = block.position;
      append_row(block.position);
      driving_z_ = true;
    }
    ++result_.pivots;
    return false;
  }

  /// Values of the basic variables and of w from scratch: sheds what rounding has gathered.
  void recompute() {
    gather(lcp_.offset, value_);
    value_ = -value_;
    qr_.solve(value_);
    accumulate(value_, lcp_.offset, w_);
  }

  /// Rates of the basic variables and of w along the driving variable; false if they are not finite.
  bool find_direction() {
    if (driving_z_) {
      lcp_.matrix.gather(rows_, pair_, direction_);
      direction_ = -direction_;
    } else {
      direction_.setZero(static_cast<Eigen::Index>(rows_.size()));
      direction_[position_of_row(pair_)] = 1.0;
    }
    qr_.solve(direction_);
    if (!direction_.allFinite() || !value_.allFinite()) return false;
    dw_.setZero(size_);
    if (driving_z_) {
      const double one = 1.0;
      lcp_.matrix.add_columns({&pair_, 1}, &one, dw_);
    }
    accumulate(direction_, dw_, dw_);
    // Held rows stay where they are exactly; only the driving w moves.
    for (const int row : rows_) dw_[row] = 0.0;
    if (!driving_z_) dw_[pair_] = 1.0;
    return true;
  }

  /// out = base + [A, d] applied to the basic variables.
  void accumulate(const Eigen::VectorXd& basic, const Eigen::VectorXd& base, Eigen::VectorXd& out) {
    if (&out != &base) out = base;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const double weight = basic[static_cast<Eigen::Index>(k)];
      if (columns_[k] == kTau) {
        out += weight * cover_;
      } else {
        lcp_.matrix.add_columns({&columns_[k], 1}, &weight, out);
      }
    }
  }

  /// Walks to the end of the piece; the basic values are then reordered as `exchange` will reorder the
  /// columns.
  void advance(const Blocking& block) {
    value_ += block.step * direction_;
    w_ += block.step * dw_;
    if (block.kind == Blocking::Kind::w) {
      w_[block.position] = 0.0;
    } else {
      const Eigen::Index tail = value_.size() - block.position - 1;
      value_.segment(block.position, tail) = value_.tail(tail).eval();
      value_.conservativeResize(value_.size() - 1);
    }
    if (driving_z_) {
      value_.conservativeResize(value_.size() + 1);
      value_[value_.size() - 1] = block.step;
    }
  }

  /// Ratio test in two passes: the longest step that violates no bound by more than a rounding-sized
  /// tolerance, and of the variables met up to there the one with the largest pivot; tau has precedence.
  Blocking find_blocking() {
    const double z_slack = kSlack * std::max(value_.lpNorm<Eigen::Infinity>(), q_scale_);
    const double w_slack = kSlack * q_scale_;
    const double z_pivot = kSlack * std::max(1.0, direction_.lpNorm<Eigen::Infinity>());
    const double w_pivot = kSlack * std::max(1.0, -dw_.minCoeff());
    double longest = kInfinity;
    for (Eigen::Index k = 0; k < value_.size(); ++k) {
      if (direction_[k] >= -z_pivot) continue;
      longest = std::min(longest, (std::max(value_[k], 0.0) + z_slack) / -direction_[k]);
    }
    const auto reach = (w_.array().max(0.0) + w_slack) / -dw_.array();
    longest = std::min(longest, (dw_.array() < -w_pivot).select(reach, kInfinity).minCoeff());
    return longest < kInfinity ? choose_within(longest, z_pivot, w_pivot) : Blocking{};
  }

  Blocking choose_within(double longest, double z_pivot, double w_pivot) const {
    Blocking best;
    double largest = 0.0;
    for (Eigen::Index k = 0; k < value_.size(); ++k) {
      if (direction_[k] >= -z_pivot) continue;
      const double step = std::max(value_[k], 0.0) / -direction_[k];
      if (step > longest) continue;
      const auto position = static_cast<int>(k);
      if (columns_[static_cast<std::size_t>(k)] == kTau) return {Blocking::Kind::tau, position, step};
      if (-direction_[k] > largest) {
        largest = -direction_[k];
        best = {Blocking::Kind::z, position, step};
      }
    }
    for (int i = 0; i < size_; ++i) {
      // Rows held have dw >= 0, so that nothing but a basic w passes here.
      if (dw_[i] >= -w_pivot || w_[i] > -longest * dw_[i]) continue;
      if (-dw_[i] > largest) {
        largest = -dw_[i];
        best = {Blocking::Kind::w, i, std::max(w_[i], 0.0) / -dw_[i]};
      }
    }
    return best;
  }

  /// The driving variable becomes basic, the blocking one leaves, its complement drives next.
  void exchange(const Blocking& block) {
    const int entering = pair_;
    if (driving_z_) {
      // Column of the entering z; rows gain the leaving w, or lose nothing when a z leaves.
      if (block.kind == Blocking::Kind::z) {
        const int leaving = columns_[static_cast<std::size_t>(block.position)];
        remove_column(block.position);
        append_column(entering);
        pair_ = leaving;
        driving_z_ = false;
      } else {
        append_column(entering);
        append_row(block.position);
        pair_ = block.position;
        driving_z_ = true;
      }
      return;
    }
    // The entering w takes its row out of the system.
    if (block.kind == Blocking::Kind::z) {
      const int leaving = columns_[static_cast<std::size_t>(block.position)];
      remove_column(block.position);
      remove_row(entering);
      pair_ = leaving;
      driving_z_ = false;
    } else {
      append_row(block.position);
      remove_row(entering);
      pair_ = block.position;
      driving_z_ = true;
    }
  }

  /// tau has reached zero: what remains is A_SS z_S = -q_S.
  void drop_tau() {
    const auto place = std::find(columns_.begin(), columns_.end(), kTau) - columns_.begin();
    remove_column(static_cast<int>(place));
    if (driving_z_) {
      append_column(pair_);
    } else {
      remove_row(pair_);
    }
  }

  LcpResult conclude() {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(size_);
    Eigen::VectorXd active = -gather(lcp_.offset);
    qr_.solve(active);
    // One step of refinement recovers what the updated factors have lost.
    Eigen::VectorXd residual = lcp_.offset;
    lcp_.matrix.add_columns(columns_, active.data(), residual);
    Eigen::VectorXd correction = -gather(residual);
    qr_.solve(correction);
    active += correction;
    if (!columns_.empty()) result_.condition = qr_.condition();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      z[columns_[k]] = std::max(0.0, active[static_cast<Eigen::Index>(k)]);
    }
    return finish(LcpStatus::solved, std::move(z));
  }

  LcpResult finish(LcpStatus status, Eigen::VectorXd z) {
    result_.residual = natural_residual(lcp_, z);
    result_.z = std::move(z);
    result_.status = status;
    if (status == LcpStatus::solved && !(result_.residual <= options_.tolerance)) {
      result_.status = LcpStatus::breakdown;
    }
    return std::move(result_);
  }

  void gather(const Eigen::VectorXd& full, Eigen::VectorXd& part) const {
    part.resize(static_cast<Eigen::Index>(rows_.size()));
    for (std::size_t k = 0; k < rows_.size(); ++k) part[static_cast<Eigen::Index>(k)] = full[rows_[k]];
  }

  [[nodiscard]] Eigen::VectorXd gather(const Eigen::VectorXd& full) const {
    Eigen::VectorXd part;
    gather(full, part);
    return part;
  }

  [[nodiscard]] int position_of_row(int index) const {
    return static_cast<int>(std::find(rows_.begin(), rows_.end(), index) - rows_.begin());
  }

  void append_row(int index) {
    column_.resize(static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      column_[static_cast<Eigen::Index>(k)] =
          columns_[k] == kTau ? cover_[index] : lcp_.matrix(index, columns_[k]);
    }
    qr_.append_row(column_);
    rows_.push_back(index);
  }

  void remove_row(int index) {
    const int position = position_of_row(index);
    qr_.remove_row(position);
    rows_.erase(rows_.begin() + position);
  }

  void append_column(int index) {
    lcp_.matrix.gather(rows_, index, column_);
    qr_.append_column(column_);
    columns_.push_back(index);
  }

  void remove_column(int position) {
    qr_.remove_column(position);
    columns_.erase(columns_.begin() + position);
  }

  Lcp& lcp_;
  const PivotingOptions& options_;
  int size_;
  double q_scale_ = 1.0;
  long limit_ = 0;
  Eigen::VectorXd cover_;
  UpdatedQr qr_;              // factors of [A_RB, d_R], columns in the order of columns_
  std::vector<int> rows_;     // R: indices whose w is held at its driving or zero value
  std::vector<int> columns_;  // basic z, and tau
  int pair_ = 0;              // the complementary pair of which neither is basic
  bool driving_z_ = true;
  Eigen::VectorXd value_, direction_, w_, dw_, column_;
  long since_refresh_ = 0;
  LcpResult result_;
};

}  // namespace

Eigen::VectorXd smooth_cover(int samples, int contacts, double amplitude, double phase) {
  constexpr double kGolden = 0.6180339887498949;  // its multiples fill the unit interval without ties
  constexpr double kTieBreak = 1e-9;
  Eigen::VectorXd cover(samples * contacts);
  for (int i = 0; i < samples * contacts; ++i) {
    const double place = (i + 1) * kGolden;
    cover[i] = 1.0 + amplitude * std::cos(2.0 * std::numbers::pi * (i % samples) / samples + phase) +
               kTieBreak * (place - std::floor(place) - 0.5);
  }
  return cover;
}

LcpResult solve_by_pivoting(Lcp& lcp, const PivotingOptions& options) {
  return LemkePath(lcp, options).run();
}

double natural_residual(Lcp& lcp, const Eigen::VectorXd& z) {
  const Eigen::VectorXd w = lcp.offset + lcp.matrix * z;
  const double scale = std::max(lcp.offset.lpNorm<Eigen::Infinity>(), z.lpNorm<Eigen::Infinity>());
  const double residual = z.cwiseMin(w).lpNorm<Eigen::Infinity>();
  if (!z.allFinite() || !w.allFinite()) return kInfinity;
  return scale > 0.0 ? residual / scale : residual;
}

std::string describe(LcpStatus status) {
  switch (status) {
    case LcpStatus::solved:
      return "solved";
    case LcpStatus::ray:
      return "the path of pivots ended on a ray";
    case LcpStatus::stalled:
      return "the line search found no descent";
    case LcpStatus::limit:
      return "pivots or iterations used up";
    case LcpStatus::breakdown:
      return "the active block is singular to working precision";
    case LcpStatus::interrupted:
      return "time budget used up";
  }
  return "unknown";
}

}  // namespace signorini
