#include "problems/scene/scene_system.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "problems/assembly/chain.hpp"
#include "problems/assembly/rotor.hpp"
#include "problems/files/input_file.hpp"
#include "problems/files/matrix_market.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

constexpr std::size_t kLargestMatrixFile = std::size_t{1} << 29U;  // bytes: some 20 million entries
constexpr std::string_view kKinds =
    "\"sdof\", \"chain\", \"bar\", \"beam\", \"block\", \"mesh\", \"rotor\", \"shaft\" or \"matrices\"";

std::vector<double> read_elements(const SceneField& field, std::string_view unit, std::size_t count) {
  const std::string requirement = fmt::format("must be a list of numbers >= 0 {}, at least one", unit);
  const std::string each = fmt::format("must be a number >= 0 {}", unit);
  std::vector<double> values;
  for (const SceneField& item : field.items(requirement)) values.push_back(item.number(each, 0.0));
  if (count != 0 && values.size() != count) {
    field.refuse(fmt::format("{} values", values.size()), fmt::format("must have one per mass: {}", count));
  }
  return values;
}

SystemDescription independent_of_contacts(std::shared_ptr<const Structure> structure) {
  const int size = static_cast<int>(structure->mass.rows());
  return {.size = size,
          .assemble = [structure = std::move(structure)](const std::vector<int>&) { return structure; }};
}

template <class Model>
SystemDescription assembled(const Model& model) {
  SystemDescription description = independent_of_contacts(std::make_shared<const Structure>(assemble(model)));
  description.layout = model;
  return description;
}

Rotor read_disc(const SceneField& system) {
  system.allow_only({"kind", "mass", "damping", "stiffness"}, "must be a table");
  return {.mass = system["mass"].number("must be a positive number [kg]", kLeastPositive),
          .damping = system["damping"].number("must be a number >= 0 [N s/m]", 0.0),
          .stiffness = system["stiffness"].number("must be a number >= 0 [N/m]", 0.0)};
}

SystemDescription read_rotor(const SceneField& system) { return assembled(read_disc(system)); }

// One coordinate of a rotor by itself.
SystemDescription read_sdof(const SceneField& system) {
  const auto [mass, damping, stiffness] = read_disc(system);
  return assembled(Chain{.masses = {mass}, .dampers = {damping}, .springs = {stiffness}});
}

// Absent: empty.
std::vector<double> read_ground(const SceneField& field, std::string_view unit, std::size_t count) {
  return field.given() ? read_elements(field, unit, count) : std::vector<double>();
}

std::vector<Link> read_links(const SceneField& links, int size) {
  std::vector<Link> result;
  if (!links.given()) return result;
  constexpr std::string_view kLink = "must be [mass, another mass, spring, damper]";
  const std::string mass = fmt::format("must be a mass of the chain, 0..{}", size - 1);
  for (const SceneField& link : links.items("must be a list of [mass, another mass, spring, damper]")) {
    const std::vector<SceneField> items = link.items(kLink, 4);
    result.push_back({.first = items[0].whole(mass, 0, size - 1),
                      .second = items[1].whole(mass, 0, size - 1),
                      .spring = items[2].number("must be a number >= 0 [N/m]", 0.0),
                      .damper = items[3].number("must be a number >= 0 [N s/m]", 0.0)});
    if (result.back().first == result.back().second) link.refuse(kLink);
  }
  return result;
}

SystemDescription read_chain(const SceneField& system) {
  system.allow_only({"kind", "masses", "dampers", "springs", "ground_dampers", "ground_springs", "links"},
                    "must be a table");
  Chain chain{.masses = read_elements(system["masses"], "[kg]", 0), .dampers = {}, .springs = {}};
  const std::size_t size = chain.masses.size();
  chain.dampers = read_elements(system["dampers"], "[N s/m]", size);
  chain.springs = read_elements(system["springs"], "[N/m]", size);
  chain.ground_dampers = read_ground(system["ground_dampers"], "[N s/m]", size);
  chain.ground_springs = read_ground(system["ground_springs"], "[N/m]", size);
  chain.links = read_links(system["links"], static_cast<int>(size));
  return assembled(chain);
}

std::filesystem::path file_beside(const SceneField& field, const std::string& name) {
  return std::filesystem::path(field.file()).parent_path() / name;
}

SparseMatrix read_matrix(const SceneField& field) {
  const NamedFile file = read_named_file(
      field, "must be the name of a Matrix Market file, relative to the scene's folder", kLargestMatrixFile);
  return read_matrix_market(file.text, file.path.string());
}

SparseMatrix read_matrix(const SceneField& field, Eigen::Index size) {
  SparseMatrix A = read_matrix(field);
  if (A.rows() != size) {
    field.refuse(fmt::format("{} x {} matrix", A.rows(), A.cols()),
                 fmt::format("must be {} x {}, as mass", size, size));
  }
  return A;
}

// A system that validate() will refuse may have no modes: it is left undamped here, for validate() to refuse.
bool has_modes(const Structure& structure) {
  const double inertia = largest_entry(structure.mass);
  const double springs = largest_entry(structure.stiffness);
  if (!(inertia > 0.0)) return false;
  for (const SparseMatrix* A : {&structure.mass, &structure.stiffness}) {
    if (!is_symmetric(*A) || !is_semidefinite(*A)) return false;
  }
  return is_definite(springs > 0.0 ? SparseMatrix(structure.mass / inertia + structure.stiffness / springs)
                                   : structure.mass);
}

// One of damping, rayleigh and modal.
SparseMatrix read_matrix_damping(const SceneField& system, const Structure& structure) {
  const auto size = static_cast<int>(structure.mass.rows());
  const SceneField damping = system["damping"];
  const SceneField rayleigh = system["rayleigh"];
  const SceneField modal = system["modal"];
  if (damping.given() && rayleigh.given()) rayleigh.refuse("must be absent: damping is given");
  if (modal.given() && (damping.given() || rayleigh.given())) {
    modal.refuse(fmt::format("must be absent: {} is given", damping.given() ? "damping" : "rayleigh"));
  }
  if (modal.given()) {
    const ModalDamping model = read_modal(modal, size);
    if (!has_modes(structure)) return {size, size};
    return damping_matrix(model, structure.mass, structure.stiffness);
  }
  if (!rayleigh.given()) return read_matrix(damping, size);
  constexpr std::string_view kRequirement = "must be { alpha = .., beta = .. }";
  rayleigh.allow_only({"alpha", "beta"}, kRequirement);
  if (!rayleigh["alpha"].given() && !rayleigh["beta"].given()) rayleigh.refuse(kRequirement);
  return damping_matrix(read_rayleigh(rayleigh), structure.mass, structure.stiffness);
}

// A part of a matrix that does no work, or feeds it, where it is given.
void add_skew_matrix(const SceneField& field, SparseMatrix& whole) {
  constexpr double kRounding = 1e-12;  // of the largest entry
  if (!field.given()) return;
  const SparseMatrix skew = read_matrix(field, whole.rows());
  if (!(largest_entry(SparseMatrix(skew + SparseMatrix(skew.transpose()))) <=
        kRounding * largest_entry(skew)))
    field.refuse("matrix with a symmetric part", "must be skew-symmetric to 1e-12 of its largest entry");
  whole += skew;
}

SystemDescription read_matrices(const SceneField& system) {
  system.allow_only(
      {"kind", "mass", "damping", "rayleigh", "modal", "stiffness", "gyroscopic", "circulatory"},
      "must be a table");
  // Swapped, not moved: these matrices have no moves, and copies of a dense one are large.
  auto structure = std::make_shared<Structure>();
  read_matrix(system["mass"]).swap(structure->mass);
  read_matrix(system["stiffness"], structure->mass.rows()).swap(structure->stiffness);
  if (!is_symmetric(structure->stiffness))
    system["stiffness"].refuse("unsymmetric matrix",
                               "must be symmetric to 1e-12 of its largest entry: a skew part is circulatory");
  read_matrix_damping(system, *structure).swap(structure->damping);
  add_skew_matrix(system["gyroscopic"], structure->damping);
  add_skew_matrix(system["circulatory"], structure->stiffness);
  SystemDescription description = independent_of_contacts(std::move(structure));
  for (const char* key : {"mass", "damping", "stiffness", "gyroscopic", "circulatory"}) {
    const SceneField matrix = system[key];
    if (matrix.given()) description.files.push_back(file_beside(matrix, matrix.text("must be a file")));
  }
  return description;
}

}  // namespace

NamedFile read_named_file(const SceneField& field, std::string_view requirement, std::size_t most) {
  const std::string name = field.text(requirement);
  if (name.empty()) field.refuse(requirement);
  const std::filesystem::path path = file_beside(field, name);
  try {
    return {.path = path, .text = read_input_file(path, most)};
  } catch (const UnreadableFile& error) {
    field.refuse(fmt::format("{}; it is {}", requirement, error.found));
  }
}

SystemDescription read_system(const SceneField& system) {
  constexpr std::array<std::pair<std::string_view, SystemDescription (*)(const SceneField&)>, 9> kReaders{
      {{"sdof", read_sdof},
       {"chain", read_chain},
       {"bar", read_bar},
       {"beam", read_beam},
       {"block", read_block},
       {"mesh", read_solid},
       {"rotor", read_rotor},
       {"shaft", read_shaft},
       {"matrices", read_matrices}}};
  const std::string requirement = fmt::format("must be {}", kKinds);
  if (!system.is_table()) system.refuse(fmt::format("must be a table with kind = {}", kKinds));
  const std::string kind = system["kind"].text(requirement);
  for (const auto& [name, read] : kReaders) {
    if (kind != name) continue;
    SystemDescription description = read(system);
    description.kind = kind;
    return description;
  }
  system["kind"].refuse(requirement);
}

SceneField system_field_as_written(const SceneField& document, const std::string& path) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kStandFor{
      {{"system.mass", "system.masses"},
       {"system.mass", "system.density"},
       {"system.damping", "system.dampers"},
       {"system.stiffness", "system.springs"},
       {"system.stiffness", "system.young"}}};
  for (const auto& [field, written] : kStandFor) {
    if (path == field && document.at(written).given()) return document.at(written);
  }
  return document.at(path);
}

}  // namespace signorini
