#pragma once
// The curves of a diagram in the order in which they are followed, and the branches that they are.

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "methods/curve.hpp"

namespace signorini {

/// Starts of curves that wait, and what those before them led to, within the limits of a diagram.
/// `Start::periods` is the period of its curve, in periods of the load or of the scene; `AnyBranch` is a
/// Branch.
template <class Start, class AnyBranch = Branch>
class CurveQueue {
 public:
  /// \param limits  kept by the caller
  explicit CurveQueue(const CurveLimits& limits) : limits_(limits) {}

  void add(Start start) { starts_.push_back(std::move(start)); }  ///< to be followed
  /// What is not followed, and why; said once.
  void note(std::string text) {
    if (std::ranges::find(notes_, text) == notes_.end()) notes_.push_back(std::move(text));
  }

  /// Takes a start out, one of the least rank and of these the first; empty where none is left or the time is
  /// up. \param rank  of a start, by default the period of its curve
  template <class Rank>
  std::optional<Start> next(Rank rank) {
    if (starts_.empty() || expires()) return std::nullopt;
    const auto first = std::ranges::min_element(starts_, {}, rank);
    Start start = std::move(*first);
    starts_.erase(first);
    return start;
  }
  std::optional<Start> next() {
    return next([](const Start& start) { return start.periods(); });
  }
  /// Whether such a start waits.
  template <class Predicate>
  [[nodiscard]] bool holds(Predicate predicate) const {
    return std::ranges::any_of(starts_, predicate);
  }
  /// Whether there are as many branches as the limits permit; one more is then left undone.
  bool is_full() {
    if (static_cast<int>(branches_.size()) < limits_.max_branches) return false;
    unfinished_ = fmt::format("limit of {} branches", limits_.max_branches);
    return true;
  }
  /// The same, or the time is up.
  bool is_over() { return is_full() || expires(); }
  /// Takes in a branch that was followed.
  void keep(AnyBranch branch) {
    branches_.push_back(std::move(branch));
    if (limits_.take) limits_.take(branches_.back());
    (void)expires();
  }

  /// The branches so far.
  [[nodiscard]] const std::vector<AnyBranch>& branches() const { return branches_; }
  /// All of it as a Diagram, a struct like BranchDiagram.
  template <class Diagram>
  Diagram finish() {
    return {std::move(branches_), std::move(unfinished_), std::move(notes_)};
  }

 private:
  bool expires() {
    if (!limits_.expired()) return false;
    unfinished_ = "the time is up";
    return true;
  }

  const CurveLimits& limits_;
  std::list<Start> starts_;
  std::vector<AnyBranch> branches_;
  std::string unfinished_;
  std::vector<std::string> notes_;
};

}  // namespace signorini
