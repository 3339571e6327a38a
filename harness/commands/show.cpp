#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/plan/plan.hpp"
#include "harness/plots/schematic_plot.hpp"
#include "harness/records/record.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/text/columns.hpp"
#include "harness/text/words.hpp"
#include "methods/catalogue.hpp"
#include "methods/structure/bases/block_lanczos.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/scene/scene_layout.hpp"
#include "problems/skew_parts.hpp"
#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

/// Largest number of coordinates for which all eigenfrequencies are computed: dense.
constexpr int kMostEigen = 1000;
constexpr int kMostGyroscopic = 300;
constexpr double kHertz = 0.5 / std::numbers::pi;  // of 1 rad/s
constexpr std::size_t kMostShown = 12;             // of numbers, and of contacts
constexpr std::size_t kShowIndent = 18, kOptionIndent = 38;

/// "1.2, 3.4, ... (20 in all)"
std::string first_of(const std::vector<double>& found, const char* form = "{:.6g}") {
  const std::size_t shown = std::min(kMostShown, found.size());
  std::string text = joined(std::span(found).first(shown), form, ", ");
  if (shown < found.size()) text += fmt::format(", ... ({} in all)", found.size());
  return text;
}

/// Angular frequencies of the damped free motions of a gyroscopic structure, ascending [rad/s]; empty without
/// mass everywhere, or beyond kMostGyroscopic coordinates.
std::vector<double> whirl_frequencies(const Problem& problem) {
  const Eigen::Index n = problem.size();
  const CholeskyFactors mass(Eigen::MatrixXd(problem.mass()));
  if (n > kMostGyroscopic || !mass.definite()) return {};
  Eigen::MatrixXd state = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  state.topRightCorner(n, n).setIdentity();
  state.bottomLeftCorner(n, n) = -mass.solve(Eigen::MatrixXd(problem.stiffness()));
  state.bottomRightCorner(n, n) = -mass.solve(Eigen::MatrixXd(problem.damping()));
  std::vector<double> found;
  for (const std::complex<double>& value : general_eigenvalues(state))
    if (value.imag() > 0.0) found.push_back(value.imag());
  std::ranges::sort(found);
  return found;
}

/// Undamped modes, K without its skew part.
struct ShownModes {
  std::vector<double> frequencies = {};  ///< ascending [rad/s]
  std::vector<double> ratios = {};       ///< phi^T D phi / (2 w), phi^T M phi = 1; none of a rigid motion [-]
  bool few = false;                      ///< whether there are more
  std::string none = {};                 ///< why there are none
};

/// A mode of this shape, phi^T M phi = 1, and frequency.
void add_mode(const Problem& problem, double frequency, const Eigen::VectorXd& shape, bool rigid,
              ShownModes& modes) {
  modes.frequencies.push_back(frequency);
  if (!rigid) modes.ratios.push_back(0.5 * shape.dot(problem.damping() * shape) / frequency);
}

/// The lowest modes of a large structure, kMostShown of them, by Lanczos' method on (K + s M)^{-1} M, s
/// small: 1 / mu = w^2 + s. A residual r of a Ritz vector leaves an error of r^2 in its mu.
ShownModes lowest_modes(const Problem& problem) {
  constexpr double kMostOperations = 5e10;  // of a factorisation: some seconds
  constexpr double kShift = 1e-9;           // of the mean square of all frequencies
  constexpr double kResidual = 1e-6, kRigid = 1e-3;
  constexpr Eigen::Index kColumns = 4, kMostVectors = 600;
  const SparseMatrix elastic = symmetric_part(problem.stiffness());
  const double shift = kShift * elastic.diagonal().sum() / problem.mass().diagonal().sum();
  const SparseMatrix definite = elastic + shift * problem.mass();
  if (SparseCholesky::cost_of(definite).operations > kMostOperations)
    return {.none = "not computed: a factorisation of the stiffness takes more than 5e10 operations"};
  Eigen::MatrixXd start(problem.size(), kColumns);
  for (Eigen::Index i = 0; i < start.rows(); ++i)
    for (Eigen::Index j = 0; j < kColumns; ++j)  // of no symmetry that a structure has
      start(i, j) = std::cos(static_cast<double>((i + 1) * (i + 3 + 7 * j)));
  const SparseMatrix start_columns = start.sparseView();
  BlockLanczos space(definite, problem.mass(), start_columns, kMostVectors);
  if (!space.definite()) return {.none = "not computed: mass and stiffness are both singular"};
  for (; !space.exhausted() && space.size() < kMostVectors; space.grow()) {
    if (space.size() < static_cast<Eigen::Index>(2 * kMostShown)) continue;
    const RitzPairs pairs = ritz_pairs(space);
    const Eigen::Index newest = space.coupling().cols();
    Eigen::Index good = 0;
    for (Eigen::Index k = pairs.values.size(); k-- > 0 && good < static_cast<Eigen::Index>(kMostShown);) {
      if ((space.coupling() * pairs.vectors.col(k).tail(newest)).norm() > kResidual * pairs.values(k)) break;
      ++good;
    }
    if (good == static_cast<Eigen::Index>(kMostShown)) break;
  }
  const RitzPairs pairs = ritz_pairs(space);
  ShownModes modes{.few = true};
  for (Eigen::Index k = pairs.values.size(); k-- > 0 && modes.frequencies.size() < kMostShown;) {
    if (!(pairs.values(k) > 0.0)) break;
    const double square = 1.0 / pairs.values(k) - shift;
    const bool rigid = square <= kRigid * shift;
    add_mode(problem, std::sqrt(std::max(0.0, rigid ? 0.0 : square)),
             space.combined(pairs.vectors.col(k)) / std::sqrt(pairs.values(k)), rigid, modes);
  }
  return modes;
}

ShownModes modes_of(const Problem& problem) {
  if (problem.size() > kMostEigen) return lowest_modes(problem);
  constexpr double kRounding = 1e-12;  // of the largest square, or inverse square
  const Eigen::MatrixXd mass(problem.mass());
  const Eigen::MatrixXd stiffness(symmetric_part(problem.stiffness()));
  const bool massive = CholeskyFactors(mass).definite();
  if (!massive && !CholeskyFactors(stiffness).definite())
    return {.none = "not computed: mass and stiffness are both singular"};
  // Massless coordinates have no eigenfrequency: of the inverse squares only those above round-off count.
  const SymmetricEigen found =
      massive ? generalised_eigen(stiffness, mass) : generalised_eigen(mass, stiffness);
  if (!found.converged) return {.none = "not computed: the eigenvalues do not converge"};
  ShownModes modes;
  const Eigen::Index count = found.values.size();
  const double largest = found.values.maxCoeff();
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index column = massive ? i : count - 1 - i;
    const double value = found.values(column);
    if (!massive && value <= kRounding * largest) continue;
    const bool rigid = massive && value <= kRounding * largest;
    const double square = rigid ? 0.0 : massive ? value : 1.0 / value;
    add_mode(problem, std::sqrt(square), found.vectors.col(column) * (massive ? 1.0 : std::sqrt(square)),
             rigid, modes);
  }
  return modes;
}

/// " + 0.02 cos(2 omega t)" and so on.
std::string motion_text(const Eigen::VectorXcd& motion) {
  std::string text;
  for (Eigen::Index h = 1; h < motion.size(); ++h) {
    const std::string angle = h == 1 ? "omega t" : fmt::format("{} omega t", h);
    for (const auto& [size, wave] :
         {std::pair(motion(h).real(), "cos"), std::pair(-motion(h).imag(), "sin")}) {
      if (size != 0.0)
        text += fmt::format(" {} {:g} {}({})", size < 0.0 ? '-' : '+', std::abs(size), wave, angle);
    }
  }
  return text;
}

/// "u[6] - u[8] <= 0.01 m", without a coefficient of 1.
std::string contact_text(const Problem& problem, const Contact& contact, int number) {
  std::string text;
  for (const auto& [dof, coefficient] : contact.normal) {
    const double size = std::abs(coefficient);
    text += text.empty() ? (coefficient < 0.0 ? "-" : "") : (coefficient < 0.0 ? " - " : " + ");
    text += (size == 1.0 ? "" : fmt::format("{:g} ", size)) + fmt::format("u[{}]", dof);
  }
  const std::string motion = problem.frame.empty() ? "" : motion_text(stop_motion(problem, number));
  return fmt::format("{} <= {:g}{} m{}", text, contact.gap, motion, contact.gap < 0.0 ? ", a preload" : "");
}

std::string law_words(const Law& law) {
  if (std::holds_alternative<MixedLaws>(law)) return "one for each contact";
  const char* stops = std::holds_alternative<Restitution>(law) ? "rigid stops, "
                      : std::holds_alternative<Penalty>(law)   ? "springs as stops, "
                                                               : "";
  return stops + law_text(as_represented(law));
}

void show_title(const std::string& name, const std::string& title) {
  fmt::print("{}", named_lines("", 0, title.empty() ? name : name + ": " + title, kTerminalWidth));
}

void show_line(const std::string& name, const std::string& text) {
  fmt::print("{}", named_lines(name, kShowIndent, text, kTerminalWidth));
}

/// "a to b rad/s (c to d Hz)"
std::string range_text(double from, double to) {
  return fmt::format("{:.4g} to {:.4g} rad/s ({:.4g} to {:.4g} Hz)", from, to, from * kHertz, to * kHertz);
}

/// Where responses bend: from below a mode to the double of its frequency, which a rigid stop that touches at
/// rest makes of it.
void show_sweeps(const Problem& problem, const std::vector<double>& frequencies) {
  constexpr std::size_t kMostSweeps = 3;
  constexpr double kBelow = 0.8, kAbove = 2.0, kLinear = 1.25;
  const double above = problem.contacts.empty() ? kLinear : kAbove;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < frequencies.size() && shown < kMostSweeps; ++i) {
    if (!(frequencies[i] > 1e-6 * frequencies.back())) continue;
    show_line(shown++ == 0 ? "suggested sweep" : "",
              fmt::format("mode {}: {}", i + 1, range_text(kBelow * frequencies[i], above * frequencies[i])));
  }
}

void show_eigenfrequencies(const Problem& problem) {
  const ShownModes modes = modes_of(problem);
  show_line("eigenfrequencies",
            modes.none.empty() ? first_of(modes.frequencies) + " rad/s" + (modes.few ? ", the lowest" : "")
                               : modes.none);
  if (modes.none.empty()) {
    std::vector<double> hertz = modes.frequencies;
    for (double& frequency : hertz) frequency *= kHertz;
    show_line("", first_of(hertz) + " Hz");
    if (!modes.ratios.empty()) show_line("damping ratios", first_of(modes.ratios, "{:.3g}"));
  }
  const bool gyroscopic = !is_symmetric(problem.damping()), circulatory = !is_symmetric(problem.stiffness());
  if (gyroscopic || circulatory) {
    const std::vector<double> whirls = whirl_frequencies(problem);
    if (!whirls.empty())
      show_line("", fmt::format("with damping{}{} {} rad/s", gyroscopic ? " and gyroscopic moments" : "",
                                circulatory ? " and circulatory forces" : "", first_of(whirls)));
  }
  show_sweeps(problem, modes.frequencies);
}

void show_forcing(const Scene& scene) {
  const Problem& problem = scene.problem;
  show_line(
      "forcing",
      fmt::format(
          "omega {:g} rad/s ({:.4g} Hz), {}; period sought {:.6g} s{}", problem.frequency,
          problem.frequency * kHertz, plural(std::ssize(problem.force), "term"), problem.period(),
          problem.subharmonic > 1 ? fmt::format(" ({} periods of the load)", problem.subharmonic) : ""));
  if (load_grows(problem))
    show_line("", "terms that grow with omega: unbalance, or a base or stop that moves");
  if (follows_speed(problem))
    show_line("", "gyroscopic or circulatory matrices grow with omega: those above are of this omega");
  for (const SampledLoad& load : scene.sampled_loads)
    show_line(
        "",
        fmt::format("{} samples: harmonics 0..{} of the load, which leave out {:.3g} N rms, {:.3g} N at most",
                    load.samples, load.harmonics(), load.left_out_rms, load.left_out_max));
}

/// ", stop of 100 N/m and 4 N s/m, face u[1]", and the law of each contact where they differ.
std::string stop_text(const Problem& problem, const std::vector<DampedStop>& damped, std::size_t number) {
  const Contact& contact = problem.contacts[number];
  const auto stop = std::ranges::find(damped, static_cast<int>(number), &DampedStop::contact);
  if (stop != damped.end())
    return fmt::format(", stop of {:g} N/m and {:g} N s/m, face u[{}]", stop->stiffness, stop->damping,
                       contact.normal.front().first);
  if (!std::holds_alternative<MixedLaws>(problem.law())) return "";
  return ", " + law_text(as_represented(common_law({contact.law})));
}

void show_contacts(const Problem& problem, const std::vector<DampedStop>& damped) {
  const std::vector<Contact> contacts = contacts_of_structure(problem.contacts, damped);
  const std::size_t count = problem.contacts.size();
  const std::size_t shown = count <= kMostShown ? count : kMostShown - 1;
  for (std::size_t i = 0; i < shown; ++i)
    show_line(fmt::format("contact {}", i),
              contact_text(problem, contacts[i], static_cast<int>(i)) + stop_text(problem, damped, i));
  if (shown < count) show_line("", fmt::format("and {} more", count - shown));
  if (!problem.frame.empty()) show_line("", "x of a contact is measured from its stop, which moves");
  if (!damped.empty())
    show_line("", "x of a contact is that of the face, the structure's less what the stop is compressed");
}

void show_scene(const Scene& scene, const std::vector<DampedStop>& damped,
                const std::vector<std::string>& notices) {
  const Problem& problem = scene.problem;
  show_title(problem.name, problem.title);
  if (!problem.reference.empty()) show_line("reference", problem.reference);
  if (!problem.tags.empty()) show_line("tags", joined(problem.tags, ", "));
  show_line("system", fmt::format("{}, {}; nonzero entries: M {}, D {}, K {}", problem.kind,
                                  plural(problem.size(), "coordinate"), problem.mass().nonZeros(),
                                  problem.damping().nonZeros(), problem.stiffness().nonZeros()));
  for (const std::string& notice : notices) show_line("notice", notice);
  show_eigenfrequencies(problem);
  show_forcing(scene);
  show_contacts(problem, damped);
  const bool all_damped = !damped.empty() && damped.size() == problem.contacts.size();
  show_line("law", (all_damped ? "springs with dampers as stops, faces " : "") + law_words(problem.law()));
}

void show_method(const MethodEntry& entry) {
  show_title(entry.name, entry.title);
  show_line("laws", entry.laws);
  if (!entry.limits.empty()) show_line("limits", entry.limits);
  show_line("resolutions", entry.ladder + ", those of `run`");
  if (!entry.plugin.empty()) show_line("plugin", entry.plugin);
  if (entry.order)
    show_line("order", fmt::format("{:g}, of the error of x over the resolutions", *entry.order));
  fmt::print("options\n");
  for (const OptionEcho& option : entry.make({})->options()) {
    const std::string name =
        fmt::format("  {:<16}{:<12} {:<6} ", option.name, print_option(option.value), option.unit);
    fmt::print("{}", named_lines(name, kOptionIndent, option.meaning, kTerminalWidth));
  }
}

struct ShowArguments {
  std::string name, plot;
};

void show(const ShowArguments& arguments) {
  const auto& [name, plot] = arguments;
  for (const MethodEntry& entry : method_catalogue()) {
    if (entry.name != name) continue;
    if (!plot.empty()) throw UsageError("plot = " + plot + " (must be left out: a method has no picture)");
    return show_method(entry);
  }
  try {
    const SceneSource source = find_scene(name);
    const Scene scene = read_scene(source);
    const SceneOutline outline = load_outline(source);
    show_scene(scene, outline.damped_stops, outline.notices);
    if (!plot.empty()) write_schematic(plot, schematic(scene.problem, outline.layout, outline.damped_stops));
  } catch (const SceneError& error) {
    const bool is_file = name.find('/') != std::string::npos || name.ends_with(".toml");
    if (is_file || std::string_view(error.what()).find(".toml:") != std::string_view::npos) throw;
    throw UsageError(fmt::format("name = {} (must be a method or a scene; see `signorini list`)", name));
  }
}

}  // namespace

void add_show_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "show", show, "A scene (sizes, eigenfrequencies, contacts, and its picture) or a method (options).");
  command.option("name", arguments->name, "a method, a scene of the catalogue, or a scene file",
                 {.required = true});
  add_plot_option(command, arguments->plot, "the mechanical system of the scene");
}

}  // namespace signorini
