#pragma once
// The lines of a screen, and those of them that say which method to take for which scenes.

#include <cstddef>
#include <string>
#include <vector>

#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// Columns of the screen.
inline constexpr std::size_t kScreenWidth = 80;

enum class Emphasis { none, title, good, bad };

struct ScreenLine {
  std::string text = {};
  Emphasis emphasis = Emphasis::none;
};

using ScreenLines = std::vector<ScreenLine>;

void append(ScreenLines& lines, ScreenLines more);

/// Broken into lines of kScreenWidth.
ScreenLines wrapped_text(const std::string& text, Emphasis emphasis = Emphasis::none);

/// "1 case", "2 cases".
std::string plural(std::ptrdiff_t count, const char* noun);

/// For each kind of scene a title with the methods that are recommended, and rows of methods, best first, as
/// many as `most` lines hold; above them the rule. Of each method its best configuration gets room before any
/// second one. Nothing where no scene has a kind.
ScreenLines group_lines(const Evaluation& evaluation, std::size_t most);

}  // namespace signorini
