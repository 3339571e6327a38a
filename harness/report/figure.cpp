#include "harness/report/figure.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace signorini {

LineStyle line_style(std::size_t contestant) {
  // Okabe and Ito's palette without its yellow, which vanishes on white.
  constexpr std::array<std::string_view, 7> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                     "#E69F00", "#56B4E9", "#000000"};
  constexpr std::array<std::string_view, 5> kDashes{"1", "'-'", "'.'", "'_.'", "'..-'"};
  // gnuplot's marks come in pairs: square, circle, triangles, diamond, pentagon; hollow, then filled.
  constexpr std::size_t kMarks = 6, kFirstHollow = 4;
  const std::size_t mark = kFirstHollow + 2 * (contestant % kMarks);
  const std::string colour = fmt::format("lc rgb '{}'", kColours[contestant % kColours.size()]);
  return {.line = fmt::format("{} dt {} lw 1.6", colour, kDashes[contestant % kDashes.size()]),
          .mark = fmt::format("pt {}", mark + 1),
          .filled = fmt::format("{} pt {}", colour, mark + 1),
          .hollow = fmt::format("{} pt {}", colour, mark)};
}

}  // namespace signorini
