#include "methods/kernels/pivoting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "methods/kernels/updated_qr.hpp"

namespace signorini {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
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
      : lcp_(lcp), options_(options), size_(lcp.matrix.size()), in_rows_(static_cast<std::size_t>(size_), 0) {
    q_scale_ = lcp.offset.lpNorm<Eigen::Infinity>();
    limit_ = options.max_pivots > 0 ? options.max_pivots : 6000 + 10L * size_;
  }

  LcpResult run() {
    if (!lcp_.offset.allFinite()) return finish(LcpStatus::breakdown, Eigen::VectorXd::Zero(size_));
    if (lcp_.offset.minCoeff() >= 0.0) return finish(LcpStatus::solved, Eigen::VectorXd::Zero(size_));
    const bool warm = options_.guess.size() == size_ && options_.guess.maxCoeff() > 0.0;
    if (warm ? start_warm() : start_cold()) return conclude();
    while (result_.pivots < limit_) {
      if ((result_.pivots & 63) == 0 && std::chrono::steady_clock::now() > options_.deadline) {
        return finish(LcpStatus::interrupted, Eigen::VectorXd::Zero(size_));
      }
      if (!follow_piece()) return finish(LcpStatus::breakdown, Eigen::VectorXd::Zero(size_));
      const Blocking block = find_blocking();
      if (block.kind == Blocking::Kind::none) return finish(LcpStatus::ray, Eigen::VectorXd::Zero(size_));
      ++result_.pivots;
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
    cover_ = options_.cover.size() == size_ ? options_.cover : smooth_cover(size_);
    int first = 0;
    (-lcp_.offset.array() / cover_.array()).maxCoeff(&first);
    add_row(first);
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
        add_row(i);
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

  /// Values of the basic variables and their rates along the driving variable.
  bool follow_piece() {
    value_ = -gather(lcp_.offset);
    qr_.solve(value_);
    if (driving_z_) {
      lcp_.matrix.gather(rows_, pair_, direction_);
      direction_ = -direction_;
    } else {
      direction_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows_.size()));
      direction_[position_of_row(pair_)] = 1.0;
    }
    qr_.solve(direction_);
    if (!value_.allFinite() || !direction_.allFinite()) return false;
    accumulate(value_, lcp_.offset, w_);
    accumulate(direction_, Eigen::VectorXd::Zero(size_), dw_);
    if (driving_z_) {
      const double one = 1.0;
      lcp_.matrix.add_columns({&pair_, 1}, &one, dw_);
    }
    return true;
  }

  /// out = base + [A, d] applied to the basic variables.
  void accumulate(const Eigen::VectorXd& basic, const Eigen::VectorXd& base, Eigen::VectorXd& out) {
    out = base;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const double weight = basic[static_cast<Eigen::Index>(k)];
      if (columns_[k] == kTau) {
        out += weight * cover_;
      } else {
        lcp_.matrix.add_columns({&columns_[k], 1}, &weight, out);
      }
    }
  }

  /// Ratio test in two passes: the longest step that violates no bound by more than a rounding-sized
  /// tolerance, and of the variables met up to there the one with the largest pivot; tau has precedence.
  Blocking find_blocking() {
    const double z_scale = std::max(value_.lpNorm<Eigen::Infinity>(), q_scale_);
    const double w_scale = std::max(w_.lpNorm<Eigen::Infinity>(), q_scale_);
    const double z_slack = 64 * kEpsilon * z_scale;
    const double w_slack = 64 * kEpsilon * w_scale;
    const double z_pivot = 64 * kEpsilon * std::max(1.0, direction_.lpNorm<Eigen::Infinity>());
    const double w_pivot = 64 * kEpsilon * std::max(1.0, dw_.lpNorm<Eigen::Infinity>());
    double longest = kInfinity;
    for (Eigen::Index k = 0; k < value_.size(); ++k) {
      if (direction_[k] < -z_pivot) {
        longest = std::min(longest, (std::max(value_[k], 0.0) + z_slack) / -direction_[k]);
      }
    }
    for (int i = 0; i < size_; ++i) {
      if (in_rows_[static_cast<std::size_t>(i)] == 0 && dw_[i] < -w_pivot) {
        longest = std::min(longest, (std::max(w_[i], 0.0) + w_slack) / -dw_[i]);
      }
    }
    return choose_within(longest, z_pivot, w_pivot);
  }

  Blocking choose_within(double longest, double z_pivot, double w_pivot) const {
    Blocking best;
    double largest = 0.0;
    for (Eigen::Index k = 0; k < value_.size(); ++k) {
      const double step = std::max(value_[k], 0.0) / -direction_[k];
      if (direction_[k] >= -z_pivot || step > longest) continue;
      const bool tau = columns_[static_cast<std::size_t>(k)] == kTau;
      if (tau) return {Blocking::Kind::tau, static_cast<int>(k), step};
      if (-direction_[k] > largest) {
        largest = -direction_[k];
        best = {Blocking::Kind::z, static_cast<int>(k), step};
      }
    }
    for (int i = 0; i < size_; ++i) {
      if (in_rows_[static_cast<std::size_t>(i)] != 0 || dw_[i] >= -w_pivot) continue;
      const double step = std::max(w_[i], 0.0) / -dw_[i];
      if (step <= longest && -dw_[i] > largest) {
        largest = -dw_[i];
        best = {Blocking::Kind::w, i, step};
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

  [[nodiscard]] Eigen::VectorXd gather(const Eigen::VectorXd& full) const {
    Eigen::VectorXd part(static_cast<Eigen::Index>(rows_.size()));
    for (std::size_t k = 0; k < rows_.size(); ++k) part[static_cast<Eigen::Index>(k)] = full[rows_[k]];
    return part;
  }

  [[nodiscard]] int position_of_row(int index) const {
    return static_cast<int>(std::find(rows_.begin(), rows_.end(), index) - rows_.begin());
  }

  void add_row(int index) {
    rows_.push_back(index);
    in_rows_[static_cast<std::size_t>(index)] = 1;
  }

  void append_row(int index) {
    column_.resize(static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      column_[static_cast<Eigen::Index>(k)] = columns_[k] == kTau ? cover_[index] : lcp_.matrix(index, columns_[k]);
    }
    qr_.append_row(column_);
    add_row(index);
  }

  void remove_row(int index) {
    const int position = position_of_row(index);
    qr_.remove_row(position);
    rows_.erase(rows_.begin() + position);
    in_rows_[static_cast<std::size_t>(index)] = 0;
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
  std::vector<char> in_rows_;
  int pair_ = 0;              // the complementary pair of which neither is basic
  bool driving_z_ = true;
  Eigen::VectorXd value_, direction_, w_, dw_, column_;
  LcpResult result_;
};

}  // namespace

Eigen::VectorXd smooth_cover(int size, double amplitude, double ratio) {
  Eigen::VectorXd cover(size);
  for (int i = 0; i < size; ++i) {
    const double phase = (i + 1) * ratio;
    cover[i] = 1.0 + amplitude * (phase - std::floor(phase) - 0.5);
  }
  return cover;
}

LcpResult solve_by_pivoting(Lcp& lcp, const PivotingOptions& options) { return LemkePath(lcp, options).run(); }

double natural_residual(Lcp& lcp, const Eigen::VectorXd& z) {
  const Eigen::VectorXd w = lcp.offset + lcp.matrix * z;
  const double scale = std::max(lcp.offset.lpNorm<Eigen::Infinity>(), z.lpNorm<Eigen::Infinity>());
  const double residual = z.cwiseMin(w).lpNorm<Eigen::Infinity>();
  if (!z.allFinite() || !w.allFinite()) return kInfinity;
  return scale > 0.0 ? residual / scale : residual;
}

std::string describe(LcpStatus status) {
  switch (status) {
    case LcpStatus::solved: return "solved";
    case LcpStatus::ray: return "the path of pivots ended on a ray";
    case LcpStatus::stalled: return "the line search found no descent";
    case LcpStatus::limit: return "pivots or iterations used up";
    case LcpStatus::breakdown: return "the active block is singular to working precision";
    case LcpStatus::interrupted: return "time budget used up";
  }
  return "unknown";
}

}  // namespace signorini
