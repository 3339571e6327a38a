#pragma once
// Methods from plugins beside the program's own: their times at equal error.

#include <array>
#include <string>
#include <vector>

#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// What a configuration from a plugin does at an error, on the scenes that it is ranked on.
struct RivalTimes {
  int scenes = 0;   ///< where it is ranked, whether it solves them or not
  int reached = 0;  ///< of these, where it has that error
  /// Its least time over the least of the program's own methods that are not plain, on the scenes where both
  /// have that error, rising [-].
  std::vector<double> to_own = {};
  /// The same over plain forms of the literature.
  std::vector<double> to_plain = {};
  /// Of those with an answer that a curve was followed to (Work::points): its time for one point of the curve
  /// over the least of the program's own, rising [-].
  std::vector<double> per_point = {};
  std::vector<long> points = {};  ///< of these curves, rising
  int stable = 0, unstable = 0;   ///< of the reached ones, by the motion of the least time
  int fastest = 0;                ///< where no other method of the run, plugins included, is as fast
};

/// A configuration from a plugin, at each of kHeadlineErrors.
struct Rival {
  std::string configuration = {};
  std::array<RivalTimes, kHeadlineErrors.size()> at = {};
};

/// Of each configuration from a plugin, in the order of configurations. A scene counts where the
/// configuration solves the problem that the scene states; repeated problems count once. Without a time an
/// error is not reached. Scenes that a motion without contact solves (Evaluation::is_contact_free) are left
/// out.
std::vector<Rival> rivals(const Evaluation& evaluation);

/// A configuration whose cases tell their own time, medians over those that were timed.
struct HandOver {
  std::string configuration = {};
  int cases = 0;
  double own = 0.0;     ///< set-up and solve by the command's own account, as tables show them [s]
  double beside = 0.0;  ///< writing the problem, waiting for and reading the answer of one solve [s]
};

/// Of each configuration with a record that has Seconds::exchange, in the order of configurations.
std::vector<HandOver> hand_overs(const Evaluation& evaluation);

}  // namespace signorini
