#include "harness/report/figures/canvas.hpp"

#include <fmt/format.h>

#include <utility>

namespace signorini {

std::optional<int> Canvas::add(const std::string& lines, std::string_view comment) {
  if (lines.empty()) return std::nullopt;
  if (!comment.empty()) data_ += fmt::format("# {}\n", comment);
  data_ += lines + "\n\n";
  return blocks_++;
}

void Canvas::plot(std::optional<int> block, std::string_view how) {
  if (block) plot(fmt::format("data index {} {}", *block, how));
}

void Canvas::plot(std::string_view what) {
  curves_ += curves_.empty() ? "plot " : ", \\\n  ";
  curves_ += what;
}

std::string Canvas::panel() {
  const std::string command = std::exchange(curves_, {});
  return command.empty() ? "set xrange [0:1]\nset yrange [0:1]\nplot 2 notitle\n" : command + "\n";
}

}  // namespace signorini
