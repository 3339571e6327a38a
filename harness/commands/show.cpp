#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/plan/plan.hpp"
#include "harness/plots/schematic_plot.hpp"
#include "harness/records/record.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/schematic/schematic.hpp"
#include "methods/catalogue.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/scene/scene_layout.hpp"

namespace signorini {

namespace {

/// Largest number of coordinates for which eigenfrequencies are shown: the eigenproblem is solved dense.
constexpr int kMostEigen = 1000;
constexpr std::ptrdiff_t kMostShown = 12;

/// Undamped angular eigenfrequencies, ascending [rad/s]; empty text says why there are none.
std::string eigenfrequencies(const Problem& problem) {
  if (problem.size() > kMostEigen)
    return fmt::format("not computed for more than {} coordinates", kMostEigen);
  const Eigen::MatrixXd mass(problem.mass());
  const Eigen::MatrixXd stiffness(problem.stiffness());
  std::vector<double> found;
  if (mass.llt().info() == Eigen::Success) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass,
                                                                           Eigen::EigenvaluesOnly);
    for (const double value : solver.eigenvalues()) found.push_back(std::sqrt(std::max(0.0, value)));
  } else if (stiffness.llt().info() == Eigen::Success) {
    // Massless coordinates have no eigenfrequency: of the inverse squares only those above round-off count.
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(mass, stiffness,
                                                                           Eigen::EigenvaluesOnly);
    const double largest = solver.eigenvalues().maxCoeff();
    for (const double value : solver.eigenvalues().reverse()) {
      if (value > 1e-12 * largest) found.push_back(1.0 / std::sqrt(value));
    }
  } else {
    return "not computed: mass and stiffness are both singular";
  }
  const auto shown = std::min(kMostShown, static_cast<std::ptrdiff_t>(found.size()));
  std::string text = fmt::format("{:.6g}", fmt::join(found.begin(), found.begin() + shown, ", "));
  if (shown < static_cast<std::ptrdiff_t>(found.size()))
    text += fmt::format(", ... ({} in all)", found.size());
  return text + " rad/s";
}

std::string contact_text(const Contact& contact) {
  std::string normal;
  for (const auto& [dof, coefficient] : contact.normal) {
    normal += fmt::format("{}{:g} u[{}]", normal.empty() ? "" : " + ", coefficient, dof);
  }
  return fmt::format("{} <= {:g} m", normal, contact.gap);
}

void show_scene(const Problem& problem) {
  fmt::print("{}: {}\n", problem.name, problem.title);
  if (!problem.reference.empty()) fmt::print("reference         {}\n", problem.reference);
  fmt::print("tags              {}\n", fmt::join(problem.tags, ", "));
  fmt::print("system            {}, {} coordinates; entries in M {}, D {}, K {}\n", problem.kind,
             problem.size(), problem.mass().nonZeros(), problem.damping().nonZeros(),
             problem.stiffness().nonZeros());
  fmt::print("eigenfrequencies  {}\n", eigenfrequencies(problem));
  fmt::print("forcing           omega {:g} rad/s, {} terms; motion of period {:.6g} s{}\n", problem.frequency,
             problem.force.size(), problem.period(),
             problem.subharmonic > 1 ? fmt::format(" (subharmonic {})", problem.subharmonic) : "");
  for (const Contact& contact : problem.contacts) fmt::print("contact           {}\n", contact_text(contact));
  fmt::print("law               {}\n", law_text(as_represented(problem.law)));
}

void show_method(const MethodEntry& entry) {
  fmt::print("{}: {}\nlaws              {}\nladder            {}\n", entry.name, entry.title, entry.laws,
             entry.ladder);
  if (!entry.plugin.empty()) fmt::print("plugin            {}\n", entry.plugin);
  if (entry.order) fmt::print("order             {:g}, of the error of x along the ladder\n", *entry.order);
  fmt::print("options\n");
  for (const OptionEcho& option : entry.make({})->options()) {
    fmt::print("  {:<16}{:<12} {:<6} {}\n", option.name, print_option(option.value), option.unit,
               option.meaning);
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
    show_scene(scene.problem);
    if (!plot.empty()) write_schematic(plot, schematic(scene.problem, load_layout(source)));
  } catch (const SceneError& error) {
    const bool is_file = name.find('/') != std::string::npos || name.ends_with(".toml");
    if (is_file || std::string_view(error.what()).find(".toml:") != std::string_view::npos) throw;
    throw UsageError(fmt::format("name = {} (must be a method or a scene; see `signorini list`)", name));
  }
}

}  // namespace

void add_show_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "show", "A scene (sizes, eigenfrequencies, contacts, and its picture) or a method (options).");
  const auto name = std::make_shared<std::string>();
  command->add_option("name", *name, "a method, a scene of the catalogue, or a scene file")->required();
  const auto plot = std::make_shared<std::string>();
  add_plot_option(*command, *plot, "the mechanical system of the scene");
  command->callback([name, plot, &exit_code] {
    show(*name, *plot);
    exit_code = kDone;
  });
}

}  // namespace signorini
