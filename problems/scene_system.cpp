#include "problems/scene_system.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

#include "problems/assembly/bar.hpp"
#include "problems/assembly/beam.hpp"
#include "problems/assembly/chain.hpp"
#include "problems/assembly/damping.hpp"
#include "problems/assembly/rotor.hpp"
#include "problems/definiteness.hpp"
#include "problems/matrix_market.hpp"

namespace signorini {

namespace {

constexpr double kSmallest = std::numeric_limits<double>::min();
constexpr int kMostElements = 100000;
constexpr std::string_view kKinds = "\"sdof\", \"chain\", \"bar\", \"beam\", \"rotor\" or \"matrices\"";

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

SystemDescription independent_of_contacts(Structure structure) {
  const int size = static_cast<int>(structure.mass.rows());
  return {.size = size,
          .assemble = [structure = std::move(structure)](const std::vector<int>&) { return structure; }};
}

SystemDescription read_sdof(const SceneField& system) {
  system.allow_only({"kind", "mass", "damping", "stiffness"}, "must be a table");
  return independent_of_contacts(
      assemble(Chain{.masses = {system["mass"].number("must be a positive number [kg]", kSmallest)},
                     .dampers = {system["damping"].number("must be a number >= 0 [N s/m]", 0.0)},
                     .springs = {system["stiffness"].number("must be a number >= 0 [N/m]", 0.0)}}));
}

SystemDescription read_rotor(const SceneField& system) {
  system.allow_only({"kind", "mass", "damping", "stiffness"}, "must be a table");
  return independent_of_contacts(
      assemble(Rotor{.mass = system["mass"].number("must be a positive number [kg]", kSmallest),
                     .damping = system["damping"].number("must be a number >= 0 [N s/m]", 0.0),
                     .stiffness = system["stiffness"].number("must be a number >= 0 [N/m]", 0.0)}));
}

SystemDescription read_chain(const SceneField& system) {
  system.allow_only({"kind", "masses", "dampers", "springs"}, "must be a table");
  Chain chain{.masses = read_elements(system["masses"], "[kg]", 0), .dampers = {}, .springs = {}};
  chain.dampers = read_elements(system["dampers"], "[N s/m]", chain.masses.size());
  chain.springs = read_elements(system["springs"], "[N/m]", chain.masses.size());
  return independent_of_contacts(assemble(chain));
}

double read_positive(const SceneField& field, std::string_view unit) {
  return field.number(fmt::format("must be a positive number {}", unit), kSmallest);
}

int read_element_count(const SceneField& field) {
  return field.whole(fmt::format("must be a whole number, 1..{}", kMostElements), 1, kMostElements);
}

ContactMass read_contact_mass(const SceneField& field) {
  constexpr std::string_view kRequirement = "must be \"consistent\", \"lumped\" or \"massless\"";
  if (!field.given()) return ContactMass::consistent;
  const std::string word = field.text(kRequirement);
  if (word == "lumped") return ContactMass::lumped;
  if (word == "massless") return ContactMass::massless;
  if (word != "consistent") field.refuse(kRequirement);
  return ContactMass::consistent;
}

ModalDamping read_modal(const SceneField& modal, int size) {
  constexpr std::string_view kRequirement = "must be a damping ratio >= 0 [-], or a list of them";
  if (size > kMostModalCoordinates) {
    modal.refuse(fmt::format("a system of {} coordinates", size),
                 fmt::format("modal damping takes at most {}: use alpha and beta", kMostModalCoordinates));
  }
  if (!modal.is_array()) return {{modal.number(kRequirement, 0.0)}};
  ModalDamping damping;
  for (const SceneField& item : modal.items(kRequirement)) {
    damping.ratios.push_back(item.number("must be a damping ratio >= 0 [-]", 0.0));
  }
  if (std::ssize(damping.ratios) > size) {
    modal.refuse(fmt::format("{} values", damping.ratios.size()), fmt::format("has at most {} modes", size));
  }
  return damping;
}

RayleighDamping read_rayleigh(const SceneField& rayleigh) {
  const auto read = [&](std::string_view key, std::string_view unit) {
    const SceneField field = rayleigh[key];
    return field.given() ? field.number(fmt::format("must be a number >= 0 {}", unit), 0.0) : 0.0;
  };
  return {.alpha = read("alpha", "[1/s]"), .beta = read("beta", "[s]")};
}

DampingModel read_damping(const SceneField& damping, int size) {
  constexpr std::string_view kRequirement = "must be { alpha = .., beta = .. } or { modal = .. }";
  damping.allow_only({"alpha", "beta", "modal"}, kRequirement);
  const SceneField modal = damping["modal"];
  const bool rayleigh = damping["alpha"].given() || damping["beta"].given();
  if (modal.given() && rayleigh) modal.refuse("must be absent: alpha or beta is given");
  if (modal.given()) return read_modal(modal, size);
  if (!rayleigh) damping.refuse(kRequirement);
  return read_rayleigh(damping);
}

// Before damping is made of it, so that the complaint names the culprit.
void require_finite(const SparseMatrix& A, const std::string& field) {
  const double largest = largest_entry(A);
  if (!std::isfinite(largest))
    throw InvalidProblem(field, fmt::format("{}", largest), "must be a finite number");
}

// A finite-element model whose mass may depend on its contacts.
template <class Model>
SystemDescription described(const Model& model, const DampingModel& damping, int size) {
  return {.size = size, .assemble = [model, damping](const std::vector<int>& contact_coordinates) {
            Model with_contacts = model;
            with_contacts.contacts = contact_coordinates;
            Structure structure = assemble(with_contacts);
            require_finite(structure.mass, "system.mass");
            require_finite(structure.stiffness, "system.stiffness");
            structure.damping = damping_matrix(damping, structure.mass, structure.stiffness);
            return structure;
          }};
}

SystemDescription read_bar(const SceneField& system) {
  system.allow_only({"kind", "elements", "length", "area", "young", "density", "damping", "contact_mass"},
                    "must be a table");
  const Bar bar{.elements = read_element_count(system["elements"]),
                .length = read_positive(system["length"], "[m]"),
                .area = read_positive(system["area"], "[m^2]"),
                .young = read_positive(system["young"], "[N/m^2]"),
                .density = read_positive(system["density"], "[kg/m^3]"),
                .contact_mass = read_contact_mass(system["contact_mass"])};
  return described(bar, read_damping(system["damping"], bar.elements), bar.elements);
}

SystemDescription read_beam(const SceneField& system) {
  system.allow_only(
      {"kind", "elements", "length", "area", "inertia", "young", "density", "damping", "contact_mass"},
      "must be a table");
  const Beam beam{.elements = read_element_count(system["elements"]),
                  .length = read_positive(system["length"], "[m]"),
                  .area = read_positive(system["area"], "[m^2]"),
                  .inertia = read_positive(system["inertia"], "[m^4]"),
                  .young = read_positive(system["young"], "[N/m^2]"),
                  .density = read_positive(system["density"], "[kg/m^3]"),
                  .contact_mass = read_contact_mass(system["contact_mass"])};
  return described(beam, read_damping(system["damping"], 2 * beam.elements), 2 * beam.elements);
}

SparseMatrix read_matrix(const SceneField& field) {
  constexpr std::string_view kRequirement =
      "must be the name of a Matrix Market file, relative to the scene's folder";
  const std::string name = field.text(kRequirement);
  const std::filesystem::path path = std::filesystem::path(field.file()).parent_path() / name;
  std::error_code ignored;
  if (name.empty() || std::filesystem::is_directory(path, ignored)) field.refuse(kRequirement);
  std::ifstream stream(path, std::ios::binary);
  if (!stream.is_open()) field.refuse("must be a file that may be read, relative to the scene's folder");
  return read_matrix_market(stream, path.string());
}

SparseMatrix read_matrix(const SceneField& field, Eigen::Index size) {
  SparseMatrix A = read_matrix(field);
  if (A.rows() != size) {
    field.refuse(fmt::format("{} x {} matrix", A.rows(), A.cols()),
                 fmt::format("must be {} x {}, as mass", size, size));
  }
  return A;
}

// What validate() refuses has no modes: it is left undamped here, and the complaint to validate().
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

SystemDescription read_matrices(const SceneField& system) {
  system.allow_only({"kind", "mass", "damping", "rayleigh", "modal", "stiffness"}, "must be a table");
  Structure structure{.mass = read_matrix(system["mass"]), .damping = {}, .stiffness = {}};
  structure.stiffness = read_matrix(system["stiffness"], structure.mass.rows());
  structure.damping = read_matrix_damping(system, structure);
  return independent_of_contacts(std::move(structure));
}

}  // namespace

SystemDescription read_system(const SceneField& system) {
  constexpr std::array<std::pair<std::string_view, SystemDescription (*)(const SceneField&)>, 6> kReaders{
      {{"sdof", read_sdof},
       {"chain", read_chain},
       {"bar", read_bar},
       {"beam", read_beam},
       {"rotor", read_rotor},
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
