#include "harness/plots/plot_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

std::string plot_obstacle(const std::string& file) {
  namespace fs = std::filesystem;
  constexpr std::array kEndings{".svg", ".pdf", ".png"};
  const fs::path path = file;
  if (std::ranges::find(kEndings, path.extension()) == kEndings.end())
    return fmt::format("plot = {} (must end in .svg, .pdf or .png)", file);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    return fmt::format("plot = {} (must stand in a folder that is there)", file);
  return {};
}

void require_contact_to_draw(const Problem& problem) {
  if (problem.contacts.empty()) throw UsageError("plot = nothing to draw (the scene has no contact)");
}

void write_plot(const std::filesystem::path& file, const Figure& figure) {
  write_whole(file, drawn(figure, file.extension().string().substr(1)));
}

}  // namespace signorini
