#pragma once
// A run on one screen of a terminal: which method for which scenes, what went wrong, where to read on.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/evaluation/case_result.hpp"
#include "harness/report/evaluation/evaluation.hpp"
#include "harness/report/evaluation/scene_groups.hpp"
#include "harness/text/columns.hpp"

namespace signorini {

/// Lines of the screen; its columns are kTerminalWidth.
inline constexpr std::size_t kScreenLines = 40;

/// What the records do not know.
struct ScreenContext {
  std::string heading = {};                  ///< first, one sentence; may be empty
  std::string folder = {};                   ///< of the run, as the user calls it
  std::string program = {};                  ///< as the user calls it
  std::vector<std::string> unexpected = {};  ///< cases that failed and were not expected to
  bool colour = false;                       ///< with escape sequences of a terminal (ECMA-48)
};

/// At most kScreenLines lines of at most kTerminalWidth columns, each ended; escape sequences count as
/// nothing. Only a word of the context that is wider, such as a path, makes a line wider. For each kind of
/// scene (scene_groups.hpp) the methods in their order, as many as there is room for.
std::string screen_report(const Evaluation& evaluation, const ScreenContext& context);

/// "3 cases have unsteady times: ..."; empty where none has.
std::string unsteady_remark(const Evaluation& evaluation);

/// "37 scenes, 999 cases, 684 certified, 315 failed": what became of a run.
std::string counts_line(const Evaluation& evaluation);

/// One line on the cases of `scenes`, such as "sdof-stop: 27 cases, 20 certified, 5 refuted, 2 failed";
/// without an end of line.
std::string scene_line(const std::string& scenes, const OutcomeCounts& counts);

// The lines of a screen, and those of them that say which method to take for which scenes.

enum class Emphasis { none, title, good, bad };

struct ScreenLine {
  std::string text = {};
  Emphasis emphasis = Emphasis::none;
};

using ScreenLines = std::vector<ScreenLine>;

void append(ScreenLines& lines, ScreenLines more);

/// Broken into lines of kTerminalWidth.
ScreenLines wrapped_text(const std::string& text, Emphasis emphasis = Emphasis::none);

/// The rule by which a method is recommended, as reports print it above their groups.
inline constexpr std::string_view kVerdictRule =
    "* marks the method that reaches 1 % on the most scenes with a stable motion; if tied, those within 10 % "
    "of the least time. A second * marks a faster method that does so on one scene fewer. Each cell: median "
    "time to that error, number of scenes; - if half or more do not reach it. Last column: unstable motions "
    "among those found to 10 %:";

/// The titles of kGroupErrors.
inline constexpr std::array<const char*, kGroupErrors.size()> kErrorTitles{"10 %", "1 %", "0.1 %", "1e-6"};

/// "Spring, 3 scenes: exact-orbit": the methods that are recommended, what decides behind all but the first;
/// or that the scenes are too few.
std::string verdict_title(const SceneGroup& group);

/// Sentences that say which method to take for which scenes; then for each kind of scene a title with the
/// methods that are recommended, and rows of methods, best first, as many as `most` lines hold; above them
/// the rule. Of each method its best configuration gets room before any second one. Nothing where no scene
/// has a kind.
ScreenLines group_lines(const Evaluation& evaluation, std::size_t most);

/// The same of frequency responses, by kResponseRule, which stands below: as many methods of each kind as
/// `most` lines hold, at least two. Nothing for a run without responses.
ScreenLines response_lines(const Evaluation& evaluation, std::size_t most);

}  // namespace signorini
