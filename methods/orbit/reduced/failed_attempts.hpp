#pragma once
// What the attempts of a search ended by, for its message.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace signorini {

/// Attempts that failed, each reason once with the names of all attempts that ended by it.
class FailedAttempts {
 public:
  /// Adds an attempt. \param reason  one clause
  void note(const std::string& attempt, const std::string& reason) {
    const auto known = std::ranges::find(failed_, reason, &Failure::second);
    if (known == failed_.end())
      failed_.emplace_back(attempt, reason);
    else
      known->first += ", " + attempt;
  }
  /// "N = 256, N = 1024: two events merge; the guess: ...", empty without attempts.
  [[nodiscard]] std::string text() const {
    std::string all;
    for (const auto& [attempts, reason] : failed_)
      all += (all.empty() ? "" : "; ") + attempts + ": " + reason;
    return all;
  }

 private:
  using Failure = std::pair<std::string, std::string>;
  std::vector<Failure> failed_;
};

}  // namespace signorini
