#include "harness/report/figures/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <system_error>
#include <utility>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/schematic/drawing.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// Of letters in SVG, where gnuplot takes points for pixels.
constexpr double kPixelsPerPoint = 96.0 / 72.0;

/// The standard error of gnuplot; kept where it fails.
constexpr const char* kLog = "gnuplot.log";

/// Runs gnuplot in the folder; its exit code, -1 where a signal ended it. \throws UsageError where it cannot
/// be started
int run_gnuplot(const fs::path& folder, const std::vector<std::string>& scripts) {
  std::error_code ignored;
  fs::remove(folder / kLog, ignored);
  std::vector<std::string> words{"gnuplot", "-d"};  // without what ~/.gnuplot would add
  words.insert(words.end(), scripts.begin(), scripts.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  constexpr int kReadable = 0644;
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, kLog, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW,
                                   kReadable);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT)
    throw UsageError("figures need gnuplot, which is not there (install the package gnuplot-nox)");
  if (failure != 0)
    throw MachineFull(fmt::format("machine = full (must allow gnuplot to start in {}: {})", folder.string(),
                                  std::error_code(failure, std::generic_category()).message()));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Names stand in scripts and become files of the folder.
void require_plain_name(const std::string& name) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("@._-").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!name.empty() && name.front() != '.' && name.front() != '-' && std::ranges::all_of(name, plain)) return;
  throw UsageError(fmt::format("figure = {} (must be a name of letters, digits and \"@._-\")", name));
}

/// What gnuplot draws with: svg, pdf or png.
std::string terminal_of(const Figure& figure, std::string_view format) {
  constexpr double kPixels = 2.0;  // of a bitmap, per pixel of a screen
  const double width = figure.width * kPixelsPerCentimetre, height = figure.height * kPixelsPerCentimetre;
  const std::string terminal =
      format == "svg"
          ? fmt::format("svg size {:.0f},{:.0f} font 'sans-serif,9' fontscale {:.3f} background '#ffffff'",
                        width, height, kPixelsPerPoint)
      : format == "pdf"
          ? fmt::format("pdfcairo size {:.1f}cm,{:.1f}cm font 'sans,9'", figure.width, figure.height)
          : fmt::format(
                "pngcairo size {:.0f},{:.0f} font 'sans,9' fontscale {:g} linewidth {:g} pointscale {:g}",
                kPixels * width, kPixels * height, kPixels, kPixels, kPixels);
  return terminal + " dashlength 0.7 rounded";
}

}  // namespace

std::string gnuplot_string(std::string_view text) {
  std::string literal = "'";
  for (const char c : text) {
    if (c == '\'') literal += '\'';  // doubled: the only character with a meaning in such a literal
    literal += static_cast<unsigned char>(c) < 0x20U ? ' ' : c;
  }
  return literal + "'";
}

std::string line_colour(std::size_t configuration) {
  // Okabe and Ito's palette without its yellow, which vanishes on white.
  constexpr std::array<std::string_view, 7> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                     "#E69F00", "#56B4E9", "#000000"};
  return fmt::format("lc rgb '{}'", kColours[configuration % kColours.size()]);
}

LineStyle line_style(std::size_t configuration) {
  constexpr std::array<std::string_view, 5> kDashes{"1", "'-'", "'.'", "'_.'", "'..-'"};
  // gnuplot's marks come in pairs: square, circle, triangles, diamond, pentagon; hollow, then filled.
  constexpr std::size_t kMarks = 6, kFirstHollow = 4;
  const std::size_t mark = kFirstHollow + 2 * (configuration % kMarks);
  const std::string colour = line_colour(configuration);
  return {.line = fmt::format("{} dt {} lw 1.6", colour, kDashes[configuration % kDashes.size()]),
          .mark = fmt::format("pt {}", mark + 1),
          .filled = fmt::format("{} pt {}", colour, mark + 1),
          .hollow = fmt::format("{} pt {}", colour, mark)};
}

double tic_step(double range, int most) {
  if (!(range > 0.0) || !std::isfinite(range)) return 1.0;
  const double least = range / most, power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;  // up to round-off of a share of one
  return 10.0 * power;
}

double key_height(std::size_t entries, int columns) {
  constexpr double kLine = 0.34, kAround = 0.4;
  const auto count = static_cast<std::size_t>(columns);
  const std::size_t rows = (entries + count - 1) / count;
  return kLine * static_cast<double>(rows) + kAround;
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
set key center center horizontal maxcols {} Left reverse samplen 2 width -4 font ',8' noenhanced
plot 2 notitle)",
                                   height, columns);
  for (const KeyEntry& entry : entries)
    script += fmt::format(", \\\n  keyentry with {} {} title {}", entry.with, entry.style,
                          gnuplot_string(entry.title));
  return script + "\n";
}

std::string whole_script(const Figure& figure) {
  constexpr std::string_view kScript = R"(# gnuplot {0}.gp makes {0}.svg and {0}.pdf of {0}.dat
data = '{0}.dat'
svg = "{1}"
pdf = "{2}"
do for [format in 'svg pdf'] {{
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output '{0}.'.format
{3}unset output
}}
)";
  return fmt::format(kScript, figure.name, terminal_of(figure, "svg"), terminal_of(figure, "pdf"),
                     figure.script);
}

std::string without_date(std::string pdf) {
  constexpr std::string_view kKey = "/CreationDate (D:", kEpoch = "19700101000000";
  for (std::size_t at = pdf.find(kKey); at != std::string::npos; at = pdf.find(kKey, at + 1))
    pdf.replace(at + kKey.size(), kEpoch.size(), kEpoch);
  return pdf;
}

std::string drawn(const Figure& figure, std::string_view format) {
  require_plain_name(figure.name);
  const TemporaryFolder folder;
  write_whole(folder.path() / "figure.dat", figure.data);
  write_whole(folder.path() / "figure.gp",
              fmt::format("data = 'figure.dat'\nset terminal {}\nset output 'figure.out'\n{}unset output\n",
                          terminal_of(figure, format), figure.script));
  if (const int code = run_gnuplot(folder.path(), {"figure.gp"}); code != 0)
    throw UsageError(fmt::format("figure = {} (gnuplot ended with exit code {}: {})", figure.name, code,
                                 first_line(folder.path() / kLog)));
  const std::string bytes = read_file(folder.path() / "figure.out");
  return format == "pdf" ? without_date(bytes) : bytes;
}

void draw_figures(const fs::path& folder, std::span<const Figure> figures) {
  folder_inside(folder.parent_path(), folder.filename().string());
  if (figures.empty()) return;
  std::error_code failure;
  std::vector<std::string> scripts;
  for (const Figure& figure : figures) {
    require_plain_name(figure.name);
    fs::remove(folder / (figure.name + ".pdf"), failure);  // gnuplot would follow a link
    write_whole(folder / (figure.name + ".dat"), figure.data);
    write_whole(folder / (figure.name + ".gp"), whole_script(figure));
    scripts.push_back(figure.name + ".gp");
  }
  if (const int code = run_gnuplot(folder, scripts); code != 0) {
    throw UsageError(fmt::format("dir = {} (gnuplot ended with exit code {}, see {})", folder.string(), code,
                                 (folder / kLog).string()));
  }
  fs::remove(folder / kLog, failure);
  for (const Figure& figure : figures) {
    const fs::path file = folder / (figure.name + ".pdf");
    write_whole(file, without_date(read_file(file)));
  }
}

std::string panels(int rows, int columns, std::string_view layout) {
  return fmt::format("set multiplot layout {},{}{}\n{}set tics font ',8'\nunset key\n", rows, columns, layout,
                     kFrame);
}

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
