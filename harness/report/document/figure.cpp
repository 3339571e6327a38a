#include "harness/report/document/figure.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace signorini {

LineStyle line_style(std::size_t configuration) {
  // Okabe and Ito's palette without its yellow, which vanishes on white.
  constexpr std::array<std::string_view, 7> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                     "#E69F00", "#56B4E9", "#000000"};
  constexpr std::array<std::string_view, 5> kDashes{"1", "'-'", "'.'", "'_.'", "'..-'"};
  // gnuplot's marks come in pairs: square, circle, triangles, diamond, pentagon; hollow, then filled.
  constexpr std::size_t kMarks = 6, kFirstHollow = 4;
  const std::size_t mark = kFirstHollow + 2 * (configuration % kMarks);
  const std::string colour = fmt::format("lc rgb '{}'", kColours[configuration % kColours.size()]);
  return {.line = fmt::format("{} dt {} lw 1.6", colour, kDashes[configuration % kDashes.size()]),
          .mark = fmt::format("pt {}", mark + 1),
          .filled = fmt::format("{} pt {}", colour, mark + 1),
          .hollow = fmt::format("{} pt {}", colour, mark)};
}

std::string key_panel(const std::vector<KeyEntry>& entries, double height, int columns) {
  std::string script = fmt::format(R"(unset logscale
unset border
unset tics
unset grid
unset xlabel
unset ylabel
unset title
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.00
set tmargin at screen {:.2f}
set xrange [0:1]
set yrange [0:1]  # what must be plotted beside a key lies outside
set key center center horizontal maxcols {} Left reverse samplen 3 font ',9' noenhanced
plot 2 notitle)",
                                   height, columns);
  for (const KeyEntry& entry : entries)
    script += fmt::format(", \\\n  keyentry with linespoints {} title '{}'", entry.style, entry.title);
  return script + "\n";
}

}  // namespace signorini
