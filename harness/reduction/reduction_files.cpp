#include "harness/reduction/reduction_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/text/json.hpp"
#include "methods/reduction/contact_space.hpp"
#include "methods/reduction/reduced_problem.hpp"
#include "methods/structure/bases/structure_modes.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/assembly/damping.hpp"
#include "problems/files/kebab_case.hpp"
#include "problems/sparse_cholesky.hpp"
#include "problems/validation.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// The lower triangle of a symmetric matrix in the Matrix Market exchange format, to the last digit.
std::string matrix_market(const SparseMatrix& A) {
  std::string rows;
  long entries = 0;
  for (int column = 0; column < A.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator it(A, column); it; ++it) {
      if (it.row() < it.col() || it.value() == 0.0) continue;
      fmt::format_to(std::back_inserter(rows), "{} {} {}\n", it.row() + 1, it.col() + 1, it.value());
      ++entries;
    }
  }
  return fmt::format("%%MatrixMarket matrix coordinate real symmetric\n{} {} {}\n{}", A.rows(), A.cols(),
                     entries, rows);
}

/// A string as TOML has it.
std::string toml_string(const std::string& text) { return json_text(nlohmann::ordered_json(text)); }

/// Whether a scene may state the damping so: of an undamped structure with a damped stop alpha is negative.
bool is_rayleigh(const ProportionalDamping& damping) { return damping.alpha >= 0.0 && damping.beta >= 0.0; }

/// \param rayleigh  of the damping; none: it is a matrix in a file
std::string scene_text(const Problem& reduced, const std::string& name, const std::string& of, int vectors,
                       const std::optional<ProportionalDamping>& rayleigh) {
  std::string text =
      fmt::format("schema = 1\nname = {}\ntitle = {}\n", toml_string(name),
                  toml_string(fmt::format("{}, reduced to {} vectors",
                                          reduced.title.empty() ? of : reduced.title, vectors)));
  text +=
      fmt::format("reference = {}\n",
                  toml_string(fmt::format("{}: its lowest Ritz vectors{}", of,
                                          reduced.size() > vectors ? ", and statically all the rest" : "")));
  std::vector<std::string> tags = reduced.tags;
  if (std::ranges::find(tags, "reduced") == tags.end()) tags.emplace_back("reduced");
  text += fmt::format("tags = {}\n\n", json_text(nlohmann::ordered_json(tags)));
  text += fmt::format(
      "[system]\nkind = \"matrices\"\nmass = {}\nstiffness = {}\n{}\n\n", toml_string(name + "-M.mtx"),
      toml_string(name + "-K.mtx"),
      rayleigh ? fmt::format("rayleigh = {{ alpha = {}, beta = {} }}", rayleigh->alpha, rayleigh->beta)
               : fmt::format("damping = {}", toml_string(name + "-D.mtx")));
  text += fmt::format("[forcing]\nfrequency = {}\n", reduced.frequency);
  if (reduced.subharmonic > 1) text += fmt::format("subharmonic = {}\n", reduced.subharmonic);
  for (const ForceTerm& term : reduced.force)
    text += fmt::format("\n[[forcing.term]]\ndof = {}\nharmonic = {}\ncos = {}\nsin = {}\n", term.dof,
                        term.harmonic, term.cos, term.sin);
  const bool mixed = std::holds_alternative<MixedLaws>(reduced.law());
  for (const Contact& contact : reduced.contacts) {
    std::string normal;
    for (const auto& [dof, coefficient] : contact.normal)
      normal += fmt::format("{}[{}, {}]", normal.empty() ? "" : ", ", dof, coefficient);
    text += fmt::format("\n[[contact]]\nnormal = [{}]\ngap = {}\n", normal, contact.gap);
    if (const auto* spring = std::get_if<Spring>(&contact.law); spring != nullptr && mixed)
      text += fmt::format("penalty = {}\n", spring->stiffness);
  }
  if (const Law scene_law = reduced.law(); const auto* spring = std::get_if<Penalty>(&scene_law))
    text += fmt::format("\n[law]\npenalty = {}\n", json_text(nlohmann::ordered_json(spring->stiffness)));
  return text;
}

/// The modes of an undamped structure, lowest last, by which a list of damping ratios counts; null where all
/// are the same. \throws UsageError where they are too many to be found
std::shared_ptr<const StructureModes> counted_modes(const ReducibleScene& scene, const std::string& word) {
  if (std::ranges::adjacent_find(scene.ratios, std::not_equal_to{}) == scene.ratios.end()) return nullptr;
  if (scene.problem.size() > kMostModalCoordinates)
    throw UsageError(fmt::format(
        "scene = {} (must have one damping ratio for all modes: those of a list are counted of at "
        "most {} coordinates)",
        word, kMostModalCoordinates));
  auto modes = uncoupled_modes(scene.problem);
  if (!modes)
    throw UsageError(
        fmt::format("scene = {} (must have one damping ratio for all modes: they are not found)", word));
  return modes;
}

/// Every vector has the damping ratio of the mode whose frequency is nearest.
/// \param modes  null: all have the first ratio
void damp(const std::vector<double>& ratios, const StructureModes* modes, ContactReduction& reduction) {
  reduction.damping.resize(reduction.vectors());
  for (Eigen::Index k = 0; k < reduction.vectors(); ++k) {
    std::size_t mode = 0;
    if (modes != nullptr) {
      Eigen::Index nearest = 0;
      (modes->mass.array() - 1.0 / reduction.squares[k]).abs().minCoeff(&nearest);
      mode = static_cast<std::size_t>(modes->mass.size() - 1 - nearest);
    }
    reduction.damping[k] = 2.0 * ratios[std::min(mode, ratios.size() - 1)] * std::sqrt(reduction.squares[k]);
  }
}

/// \throws UsageError where there is no reduction, or its numbers are none that a scene may have
void require_scene(const ReducedProblem& reduced, const std::string& word) {
  std::string obstacle = reduced.obstacle;
  try {
    if (obstacle.empty()) validate(reduced.problem);
  } catch (const InvalidProblem& error) {
    obstacle = error.what();
  }
  if (!obstacle.empty())
    throw UsageError(fmt::format("scene = {} (must be one that can be reduced: {})", word, obstacle));
}

/// |C_n - C_n^m| / |C_n| in Frobenius' norm, C_n by the larger of two reductions; at a resonance in words.
std::string receptance_error(const ContactReduction& small, const ContactReduction& large, double period,
                             int harmonic) {
  const double rate = 2.0 * std::numbers::pi / period * harmonic;
  const auto at = [&](const ContactReduction& reduction) {
    return contact_receptance(reduction, period, 0, [&](int) { return exact_weights(rate); })
        .receptance.front();
  };
  try {
    const Eigen::MatrixXcd whole = at(large);
    return fmt::format("{:.1e}", (at(small) - whole).norm() / whole.norm());
  } catch (const SingularStiffness&) {
    return "none: it resonates undamped";
  }
}

}  // namespace

void require_scene_file(const fs::path& out) {
  if (out.extension() != ".toml" || !is_lower_kebab_case(out.stem().string()))
    throw UsageError(fmt::format("out = {} (must be NAME.toml, NAME in lower-kebab-case)", out.string()));
  if (!out.parent_path().empty() && !fs::is_directory(out.parent_path()))
    throw UsageError(fmt::format("out = {} (must be in a folder that exists)", out.string()));
}

void require_room_for_factors(const std::string& scene, const SparseMatrix& stiffness, double room) {
  constexpr double kWhileMade = 1.3;  // of the factors, while they are made
  const auto size = static_cast<double>(stiffness.rows());
  const auto taken = [](double entries) { return sizeof(double) * kWhileMade * entries; };
  if (taken(size * (size + 1.0) / 2.0) <= room) return;  // even a full matrix fits
  constexpr double kMostCounted = 2147483647.0;          // CHOLMOD's counts have 32 bits
  double needed = taken(kMostCounted);
  const char* least = "more than ";
  try {
    needed = taken(SparseCholesky::cost_of(stiffness).entries);
    if (needed <= room) return;
    least = "";
  } catch (const std::bad_alloc&) {  // too many to count, or to analyse
  }
  throw UsageError(fmt::format(
      "scene = {} (must have factors that fit into memory: they take {}{:.1f} GB and {:.1f} GB are free; "
      "--mpi N shares them between N processes)",
      scene, least, 1e-9 * needed, 1e-9 * room));
}

std::string write_reduction(const ReducibleScene& scene, const ReductionOrder& order,
                            const Factorise& factorise) {
  // Of few contacts the first powers of a Krylov space, which are better than as many modes.
  constexpr int kVectorsOfMany = 100, kVectorsOfFew = 90, kLeastPowers = 6;
  const Problem& problem = scene.problem;
  const int columns = problem.contact_count() + static_cast<int>(load_columns(problem).columns.size());
  const int unasked =
      columns > kFewColumns ? kVectorsOfMany : std::max(kVectorsOfFew, kLeastPowers * columns);
  const int vectors_asked = order.vectors == 0 ? unasked : order.vectors;
  const std::shared_ptr<const StructureModes> modes = counted_modes(scene, order.scene);
  const ContactSpace space(problem, {.small = vectors_asked, .factorise = factorise});
  ContactReduction small = space.small(), whole = space.whole();
  std::optional<ProportionalDamping> rayleigh;
  if (!scene.ratios.empty() && space.obstacle().empty()) {
    for (ContactReduction* reduction : {&small, &whole}) damp(scene.ratios, modes.get(), *reduction);
  } else if (is_rayleigh(space.damping())) {
    rayleigh = space.damping();
  }
  const ReducedProblem reduced = reduced_problem(problem, small);
  require_scene(reduced, order.scene);
  const auto vectors = static_cast<int>(small.vectors());
  const fs::path folder = order.out.parent_path();
  const std::string name = order.out.stem().string();
  write_whole(folder / (name + "-M.mtx"), matrix_market(reduced.problem.mass()));
  write_whole(folder / (name + "-K.mtx"), matrix_market(reduced.problem.stiffness()));
  if (!rayleigh) write_whole(folder / (name + "-D.mtx"), matrix_market(reduced.problem.damping()));
  write_whole(order.out, scene_text(reduced.problem, name, problem.name, vectors, rayleigh));
  std::string told = fmt::format(
      "{}: {} coordinates in place of {}: {} vectors, {} contacts, {} of them with a static compliance "
      "besides\n"
      "receptances of the contacts beside those on {} vectors:\n",
      order.out.string(), reduced.problem.size(), problem.size(), vectors, problem.contact_count(),
      reduced.problem.size() - vectors, whole.vectors());
  for (const int harmonic : std::array{0, 1, 10, 100})
    told += fmt::format("  harmonic {:<4} {}\n", harmonic,
                        receptance_error(small, whole, problem.period(), harmonic));
  return told;
}

}  // namespace signorini
