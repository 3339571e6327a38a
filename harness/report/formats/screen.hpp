#pragma once
// A run on one screen of a terminal: which method for which scenes, what went wrong, where to read on.

#include <cstddef>
#include <string>
#include <vector>

#include "harness/report/evaluation/evaluation.hpp"
#include "harness/report/evaluation/outcome.hpp"

namespace signorini {

/// Lines of the screen; its columns are kScreenWidth.
inline constexpr std::size_t kScreenLines = 40;

/// What the records do not know.
struct ScreenContext {
  std::string heading = {};                  ///< first, one sentence; may be empty
  std::string folder = {};                   ///< of the run, as the user calls it
  std::string program = {};                  ///< as the user calls it
  std::vector<std::string> unexpected = {};  ///< cases that failed and were not expected to
  bool colour = false;                       ///< with escape sequences of a terminal (ECMA-48)
};

/// At most kScreenLines lines of at most kScreenWidth columns, each ended; escape sequences count as nothing.
/// Only a word of the context that is wider, such as a path, makes a line wider. For each kind of scene
/// (scene_groups.hpp) the methods in their order, as many as there is room for.
std::string screen_report(const Evaluation& evaluation, const ScreenContext& context);

/// "3 cases have unsteady times: ..."; empty where none has.
std::string unsteady_remark(const Evaluation& evaluation);

/// "37 scenes, 999 cases, 684 certified, 315 failed": what became of a run.
std::string counts_line(const Evaluation& evaluation);

/// One line on the cases of `scenes`, such as "sdof-stop: 27 cases, 20 certified, 5 refuted, 2 failed";
/// without an end of line.
std::string scene_line(const std::string& scenes, const OutcomeCounts& counts);

}  // namespace signorini
