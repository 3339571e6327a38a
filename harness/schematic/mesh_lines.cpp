#include "harness/schematic/mesh_lines.hpp"

#include <fmt/format.h>

namespace signorini {

namespace {

constexpr int kMostLines = 40;

int elements_per_line(int elements) { return (elements + kMostLines - 1) / kMostLines; }

}  // namespace

std::vector<double> mesh_lines(int elements) {
  std::vector<double> shares;
  const int step = elements_per_line(elements);
  for (int i = step; i < elements; i += step) shares.push_back(static_cast<double>(i) / elements);
  return shares;
}

std::string elements_text(int elements) {
  const int step = elements_per_line(elements);
  return fmt::format("{} element{}{}", elements, elements == 1 ? "" : "s",
                     step > 1 ? fmt::format(" (a line every {})", step) : "");
}

}  // namespace signorini
