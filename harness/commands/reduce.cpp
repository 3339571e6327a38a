#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/plan/plan.hpp"
#include "methods/reduction/contact_space.hpp"
#include "methods/reduction/reduced_problem.hpp"
#include "problems/scene/kebab_case.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

struct ReduceArguments {
  std::string scene;
  std::string out;
  int vectors = 0;
};

/// The lower triangle of a symmetric matrix in the Matrix Market exchange format, to the last digit.
std::string matrix_market(const SparseMatrix& A) {
  std::string rows;
  long entries = 0;
  for (int column = 0; column < A.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator it(A, column); it; ++it) {
      if (it.row() < it.col()) continue;
      fmt::format_to(std::back_inserter(rows), "{} {} {}\n", it.row() + 1, it.col() + 1, it.value());
      ++entries;
    }
  }
  return fmt::format("%%MatrixMarket matrix coordinate real symmetric\n{} {} {}\n{}", A.rows(), A.cols(),
                     entries, rows);
}

/// A string as TOML has it.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string scene_text(const Problem& reduced, const std::string& name, const std::string& of, int vectors,
                       const ProportionalDamping& damping) {
  std::string text = fmt::format("schema = 1\nname = {}\ntitle = {}\n", quoted(name),
                                 quoted(fmt::format("{}, reduced to {} vectors", reduced.title, vectors)));
  text += fmt::format("reference = {}\n",
                      quoted(fmt::format("{}: its lowest Ritz vectors, and statically all the rest", of)));
  std::vector<std::string> tags = reduced.tags;
  if (std::ranges::find(tags, "reduced") == tags.end()) tags.emplace_back("reduced");
  text += fmt::format("tags = {}\n\n", nlohmann::json(tags).dump());
  text += fmt::format(
      "[system]\nkind = \"matrices\"\nmass = {}\nstiffness = {}\nrayleigh = {{ alpha = {}, beta = {} }}\n\n",
      quoted(name + "-M.mtx"), quoted(name + "-K.mtx"), damping.alpha, damping.beta);
  text += fmt::format("[forcing]\nfrequency = {}\n", reduced.frequency);
  if (reduced.subharmonic > 1) text += fmt::format("subharmonic = {}\n", reduced.subharmonic);
  for (const ForceTerm& term : reduced.force)
    text += fmt::format("\n[[forcing.term]]\ndof = {}\nharmonic = {}\ncos = {}\nsin = {}\n", term.dof,
                        term.harmonic, term.cos, term.sin);
  for (const Contact& contact : reduced.contacts)
    text += fmt::format("\n[[contact]]\ndof = {}\ngap = {}\n", contact.normal.front().first, contact.gap);
  if (const auto* spring = std::get_if<Penalty>(&reduced.law))
    text += fmt::format("\n[law]\npenalty = {}\n", nlohmann::json(spring->stiffness).dump());
  return text;
}

/// |C_n - C_n^m| / |C_n| in Frobenius' norm, C_n by the larger of the two spaces.
double receptance_error(const ContactSpace& space, double period, int harmonic) {
  const double rate = 2.0 * std::numbers::pi / period * harmonic;
  const auto at = [&](const ContactReduction& reduction) {
    return contact_receptance(reduction, period, 0, [&](int) { return exact_weights(rate); })
        .receptance.front();
  };
  const Eigen::MatrixXcd whole = at(space.whole());
  return (at(space.small()) - whole).norm() / whole.norm();
}

int reduce(const ReduceArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  const fs::path out = arguments.out;
  const std::string name = out.stem().string();
  if (out.extension() != ".toml" || !is_lower_kebab_case(name))
    throw UsageError(fmt::format("out = {} (must be NAME.toml, NAME in lower-kebab-case)", arguments.out));
  // Of few contacts the powers of a Krylov space, as many as ContactSpace takes.
  constexpr int kVectorsOfMany = 100;
  const auto loads = static_cast<int>(load_columns(scene.problem).columns.size());
  const bool many = scene.problem.contact_count() + loads > kFewColumns;
  const int vectors_asked = arguments.vectors == 0 && many ? kVectorsOfMany : arguments.vectors;
  const ContactSpace space(scene.problem, {.small = vectors_asked});
  const ReducedProblem reduced = reduced_problem(scene.problem, space.small());
  if (!reduced.obstacle.empty())
    throw UsageError(
        fmt::format("scene = {} (must be one that can be reduced: {})", arguments.scene, reduced.obstacle));
  const auto vectors = static_cast<int>(space.small().vectors());
  const fs::path folder = out.parent_path();
  write_whole(folder / (name + "-M.mtx"), matrix_market(reduced.problem.mass()));
  write_whole(folder / (name + "-K.mtx"), matrix_market(reduced.problem.stiffness()));
  write_whole(out, scene_text(reduced.problem, name, scene.problem.name, vectors, space.damping()));
  fmt::print("{}: {} coordinates in place of {}: {} vectors, {} contacts and their static compliance\n",
             out.string(), reduced.problem.size(), scene.problem.size(), vectors,
             scene.problem.contact_count());
  fmt::print("receptances of the contacts beside those on {} vectors:\n", space.whole().vectors());
  for (const int harmonic : std::array{0, 1, 10, 100})
    fmt::print("  harmonic {:<4} {:.1e}\n", harmonic,
               receptance_error(space, scene.problem.period(), harmonic));
  return kDone;
}

constexpr int kMostVectors = 2000;

}  // namespace

void add_reduce_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("reduce", "A large structure as a scene of what its contacts feel.");
  const auto arguments = std::make_shared<ReduceArguments>();
  command->add_option("scene", arguments->scene, "a scene of the catalogue, or a scene file")->required();
  command
      ->add_option("--out", arguments->out,
                   "NAME.toml: the scene to write, its matrices beside it in NAME-M.mtx and NAME-K.mtx")
      ->required();
  command
      ->add_option("--vectors", arguments->vectors,
                   "vectors kept, or so many that whole powers of the Krylov space are; if absent, 90, "
                   "or six powers, or of more than 20 contacts and loads 100")
      ->check(CLI::Range(1, kMostVectors));
  command->callback([arguments, &exit_code] { exit_code = reduce(*arguments); });
}

}  // namespace signorini
