#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <utility>
#include <vector>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/plan/plan.hpp"
#include "harness/plots/schematic_plot.hpp"
#include "harness/records/record.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/text/words.hpp"
#include "methods/catalogue.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/scene/scene_layout.hpp"
#include "problems/skew_parts.hpp"

namespace signorini {

namespace {

/// Largest number of coordinates for which eigenfrequencies are shown: the eigenproblem is solved dense.
constexpr int kMostEigen = 1000;
constexpr int kMostGyroscopic = 300;
constexpr std::size_t kMostShown = 12;
constexpr std::size_t kMostContacts = 12;
constexpr std::size_t kShownColumns = 80, kShowIndent = 18, kOptionIndent = 38;

/// "1.2, 3.4, ... (20 in all)"
std::string first_of(const std::vector<double>& found) {
  const std::size_t shown = std::min(kMostShown, found.size());
  std::string text = joined(std::span(found).first(shown), "{:.6g}", ", ");
  if (shown < found.size()) text += fmt::format(", ... ({} in all)", found.size());
  return text + " rad/s";
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

/// Undamped angular eigenfrequencies, ascending [rad/s], without a skew part of K; a text says why there are
/// none.
std::string eigenfrequencies(const Problem& problem) {
  if (problem.size() > kMostEigen)
    return fmt::format("not computed for more than {} coordinates", kMostEigen);
  const Eigen::MatrixXd mass(problem.mass());
  const Eigen::MatrixXd stiffness(symmetric_part(problem.stiffness()));
  std::vector<double> found;
  if (CholeskyFactors(mass).definite()) {
    for (const double value : generalised_eigenvalues(stiffness, mass))
      found.push_back(std::sqrt(std::max(0.0, value)));
  } else if (CholeskyFactors(stiffness).definite()) {
    // Massless coordinates have no eigenfrequency: of the inverse squares only those above round-off count.
    const Eigen::VectorXd inverse_squares = generalised_eigenvalues(mass, stiffness);
    const double largest = inverse_squares.maxCoeff();
    for (const double value : inverse_squares.reverse()) {
      if (value > 1e-12 * largest) found.push_back(1.0 / std::sqrt(value));
    }
  } else {
    return "not computed: mass and stiffness are both singular";
  }
  return first_of(found);
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
  return fmt::format("{} <= {:g}{} m", text, contact.gap, motion);
}

std::string law_words(const Law& law) {
  const char* stops = std::holds_alternative<Restitution>(law) ? "rigid stops, "
                      : std::holds_alternative<Penalty>(law)   ? "springs as stops, "
                                                               : "";
  return stops + law_text(as_represented(law));
}

void show_title(const std::string& name, const std::string& title) {
  fmt::print("{}", named_lines("", 0, title.empty() ? name : name + ": " + title, kShownColumns));
}

void show_line(const std::string& name, const std::string& text) {
  fmt::print("{}", named_lines(name, kShowIndent, text, kShownColumns));
}

void show_eigenfrequencies(const Problem& problem) {
  show_line("eigenfrequencies", eigenfrequencies(problem));
  const bool gyroscopic = !is_symmetric(problem.damping()), circulatory = !is_symmetric(problem.stiffness());
  if (!gyroscopic && !circulatory) return;
  const std::vector<double> whirls = whirl_frequencies(problem);
  if (!whirls.empty())
    show_line("", fmt::format("with damping{}{} {}", gyroscopic ? " and gyroscopic moments" : "",
                              circulatory ? " and circulatory forces" : "", first_of(whirls)));
}

void show_forcing(const Scene& scene) {
  const Problem& problem = scene.problem;
  show_line("forcing", fmt::format("omega {:g} rad/s, {}; motion of period {:.6g} s{}", problem.frequency,
                                   plural(std::ssize(problem.force), "term"), problem.period(),
                                   problem.subharmonic > 1
                                       ? fmt::format(" ({} periods of the load)", problem.subharmonic)
                                       : ""));
  if (load_grows(problem))
    show_line("", "terms that grow with omega: unbalance, or a base or stop that moves");
  for (const SampledLoad& load : scene.sampled_loads)
    show_line(
        "",
        fmt::format("{} samples: harmonics 0..{} of the load, which leave out {:.3g} N rms, {:.3g} N at most",
                    load.samples, load.harmonics(), load.left_out_rms, load.left_out_max));
}

/// ", stop of 100 N/m and 4 N s/m, face u[1]"
std::string stop_text(const Problem& problem, const std::vector<DampedStop>& damped, std::size_t number) {
  if (damped.empty()) return "";
  return fmt::format(", stop of {:g} N/m and {:g} N s/m, face u[{}]", damped[number].stiffness,
                     damped[number].damping, problem.contacts[number].normal.front().first);
}

void show_contacts(const Problem& problem, const std::vector<DampedStop>& damped) {
  const std::vector<Contact> contacts = contacts_of_structure(problem.contacts, damped);
  const std::size_t count = problem.contacts.size();
  const std::size_t shown = count <= kMostContacts ? count : kMostContacts - 1;
  for (std::size_t i = 0; i < shown; ++i)
    show_line(fmt::format("contact {}", i),
              contact_text(problem, contacts[i], static_cast<int>(i)) + stop_text(problem, damped, i));
  if (shown < count) show_line("", fmt::format("and {} more", count - shown));
  if (!problem.frame.empty()) show_line("", "x of a contact is measured from its stop, which moves");
  if (!damped.empty())
    show_line("", "x of a contact is that of the face, the structure's less what the stop is compressed");
}

void show_scene(const Scene& scene, const std::vector<DampedStop>& damped) {
  const Problem& problem = scene.problem;
  show_title(problem.name, problem.title);
  if (!problem.reference.empty()) show_line("reference", problem.reference);
  if (!problem.tags.empty()) show_line("tags", joined(problem.tags, ", "));
  show_line("system", fmt::format("{}, {}; entries in M {}, D {}, K {}", problem.kind,
                                  plural(problem.size(), "coordinate"), problem.mass().nonZeros(),
                                  problem.damping().nonZeros(), problem.stiffness().nonZeros()));
  show_eigenfrequencies(problem);
  show_forcing(scene);
  show_contacts(problem, damped);
  show_line("law", (damped.empty() ? "" : "springs with dampers as stops, faces ") + law_words(problem.law));
}

void show_method(const MethodEntry& entry) {
  show_title(entry.name, entry.title);
  show_line("laws", entry.laws);
  if (!entry.limits.empty()) show_line("limits", entry.limits);
  show_line("ladder", entry.ladder + ", the resolutions of `run`");
  if (!entry.plugin.empty()) show_line("plugin", entry.plugin);
  if (entry.order) show_line("order", fmt::format("{:g}, of the error of x along the ladder", *entry.order));
  fmt::print("options\n");
  for (const OptionEcho& option : entry.make({})->options()) {
    const std::string name =
        fmt::format("  {:<16}{:<12} {:<6} ", option.name, print_option(option.value), option.unit);
    fmt::print("{}", named_lines(name, kOptionIndent, option.meaning, kShownColumns));
  }
}

void show(const std::string& name, const std::string& plot) {
  for (const MethodEntry& entry : method_catalogue()) {
    if (entry.name != name) continue;
    if (!plot.empty()) throw UsageError("plot = " + plot + " (must be left out: a method has no picture)");
    return show_method(entry);
  }
  try {
    const SceneSource source = find_scene(name);
    const Scene scene = read_scene(source);
    const std::vector<DampedStop> damped = load_damped_stops(source);
    show_scene(scene, damped);
    if (!plot.empty()) write_schematic(plot, schematic(scene.problem, load_layout(source), damped));
  } catch (const SceneError& error) {
    const bool is_file = name.find('/') != std::string::npos || name.ends_with(".toml");
    if (is_file || std::string_view(error.what()).find(".toml:") != std::string_view::npos) throw;
    throw UsageError(fmt::format("name = {} (must be a method or a scene; see `signorini list`)", name));
  }
}

}  // namespace

void add_show_command(const Command& program, int& exit_code) {
  const Command command = program.command(
      "show", "A scene (sizes, eigenfrequencies, contacts, and its picture) or a method (options).");
  const auto name = std::make_shared<std::string>();
  command.option("name", *name, "a method, a scene of the catalogue, or a scene file").required();
  const auto plot = std::make_shared<std::string>();
  add_plot_option(command, *plot, "the mechanical system of the scene");
  command.on_run([name, plot, &exit_code] {
    show(*name, *plot);
    exit_code = kDone;
  });
}

}  // namespace signorini
