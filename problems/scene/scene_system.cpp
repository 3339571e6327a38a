#include "problems/scene/scene_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "problems/assembly/chain.hpp"
#include "problems/assembly/penalty_supports.hpp"
#include "problems/assembly/rotor.hpp"
#include "problems/files/input_file.hpp"
#include "problems/files/matrices/matrix_file.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/skew_parts.hpp"

namespace signorini {

namespace {

std::vector<double> read_elements(const SceneField& field, std::string_view unit, std::size_t count) {
  std::vector<double> values;
  for (const SceneField& item :
       field.items(fmt::format("must be a list of numbers >= 0 {}, at least one", unit)))
    values.push_back(read_nonnegative(item, unit));
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
  const auto structure = std::make_shared<Structure>(assemble(model));
  SystemDescription description = independent_of_contacts(structure);
  description.layout = model;
  description.held = hold_supports(*structure, description.notices);
  return description;
}

Rotor read_disc(const SceneField& system) {
  system.allow_only({"kind", "mass", "damping", "stiffness"}, "must be a table");
  return {.mass = read_positive(system["mass"], "[kg]"),
          .damping = read_nonnegative(system["damping"], "[N s/m]"),
          .stiffness = read_nonnegative(system["stiffness"], "[N/m]")};
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
  constexpr std::string_view kLink = "must be [mass, another mass, spring, damper]";
  std::vector<Link> result;
  for (const SceneField& link :
       links.items_or_none("must be a list of [mass, another mass, spring, damper]")) {
    const std::vector<SceneField> items = link.items(kLink, 4);
    result.push_back({.first = items[0].in_range("a mass of the chain", 0, size - 1),
                      .second = items[1].in_range("a mass of the chain", 0, size - 1),
                      .spring = read_nonnegative(items[2], "[N/m]"),
                      .damper = read_nonnegative(items[3], "[N s/m]")});
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

constexpr std::array kMatrixKeys{"mass",
                                 "damping",
                                 "stiffness",
                                 "gyroscopic",
                                 "circulatory",
                                 "gyroscopic_per_speed",
                                 "circulatory_per_speed"};

NamedFile read_matrix_text(const SceneField& field) {
  constexpr std::size_t kLargestMatrixFile = std::size_t{1} << 29U;  // bytes: some 20 million entries
  return read_named_file(field, "must be the name of a file of a matrix, relative to the scene's folder",
                         kLargestMatrixFile);
}

// The matrices of a system from their files.
class MatrixFiles {
 public:
  explicit MatrixFiles(const SceneField& system) : system_(system) {}

  SparseMatrix read(const char* key) {
    const NamedFile file = read_matrix_text(system_[key]);
    MatrixFile read = read_matrix_file(file.text, file.path.string(), coordinates(file));
    for (std::string& notice : read.notices) notices_.push_back(std::move(notice));
    if (wants_symmetric_part(key)) take_symmetric_part(key, read.matrix);
    drop_noise(key, read.matrix);
    return read.matrix;
  }

  SparseMatrix read(const char* key, Eigen::Index size) {
    SparseMatrix A = read(key);
    if (A.rows() != size) {
      system_[key].refuse(fmt::format("{} x {} matrix", A.rows(), A.cols()),
                          fmt::format("must be {} x {}, as mass", size, size));
    }
    return A;
  }

  std::vector<std::string> take_notices() { return std::move(notices_); }

 private:
  // Of all files of Abaqus, once one is met.
  const NodeDofs& coordinates(const NamedFile& file) {
    if (!coordinates_.empty() || coordinates_of_matrix_file(file.text, file.path.string()).empty())
      return coordinates_;
    for (const char* key : kMatrixKeys) {
      if (!system_[key].given()) continue;
      const NamedFile other = read_matrix_text(system_[key]);
      coordinates_.merge(coordinates_of_matrix_file(other.text, other.path.string()));
    }
    return coordinates_;
  }

  [[nodiscard]] bool wants_symmetric_part(std::string_view key) const {
    constexpr std::string_view kWhich = "must be a list of \"mass\", \"damping\" and \"stiffness\"";
    bool wanted = false;
    for (const SceneField& item : system_["symmetric_part"].items_or_none(kWhich)) {
      const std::string name = item.text(kWhich);
      if (std::ranges::find(kMatrixKeys.begin(), kMatrixKeys.begin() + 3, name) == kMatrixKeys.begin() + 3)
        item.refuse(kWhich);
      wanted = wanted || name == key;
    }
    return wanted;
  }

  void take_symmetric_part(std::string_view key, SparseMatrix& A) {
    const double largest = largest_entry(A);
    SparseMatrix part = symmetric_part(A);
    const double dropped = largest_entry(SparseMatrix(A - part));
    A.swap(part);
    notices_.push_back(
        fmt::format("{}: its symmetric part; dropped are skew entries up to {:.3g}, {:.2g} of the "
                    "largest entry",
                    key, dropped, largest > 0.0 ? dropped / largest : 0.0));
  }

  // Coordinates whose diagonal is below 0, and all of whose entries are rounding: zeros that were computed.
  void drop_noise(std::string_view key, SparseMatrix& A) {
    const double least = -kEntryRounding * largest_entry(A);
    const Eigen::VectorXd diagonal = A.diagonal();
    std::vector<bool> noise(static_cast<std::size_t>(A.rows()));
    for (int i = 0; i < A.rows(); ++i)
      noise[static_cast<std::size_t>(i)] = diagonal(i) < 0.0 && diagonal(i) >= least;
    if (std::ranges::find(noise, true) == noise.end()) return;
    const auto is_noise = [&](Eigen::Index i) { return noise[static_cast<std::size_t>(i)]; };
    for_each_entry(A, [&](int row, int column, double value) {
      if (std::abs(value) > -least)
        noise[static_cast<std::size_t>(row)] = noise[static_cast<std::size_t>(column)] = false;
    });
    for (int i = 0; i < A.rows(); ++i)
      if (is_noise(i))
        notices_.push_back(
            fmt::format("{}: {:.2g} at coordinate {} is rounding and taken as 0", key, diagonal(i), i));
    A.prune(
        [&](Eigen::Index row, Eigen::Index column, double) { return !is_noise(row) && !is_noise(column); });
  }

  const SceneField& system_;
  NodeDofs coordinates_;
  std::vector<std::string> notices_;
};

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
SparseMatrix read_matrix_damping(const SceneField& system, const Structure& structure, MatrixFiles& files) {
  const auto size = static_cast<int>(structure.mass.rows());
  const SceneField damping = system["damping"], rayleigh = system["rayleigh"], modal = system["modal"];
  if (damping.given()) system.forbid({"rayleigh", "modal"}, "damping is given");
  if (rayleigh.given()) system.forbid({"modal"}, "rayleigh is given");
  if (modal.given()) {
    const ModalDamping model = read_modal(modal, size);
    if (!has_modes(structure)) return {size, size};
    return damping_matrix(model, structure.mass, structure.stiffness);
  }
  if (!rayleigh.given()) {
    if (!damping.given()) damping.refuse("must be the name of a file; or give modal or rayleigh instead");
    return files.read("damping", size);
  }
  rayleigh.allow_only({"alpha", "beta"}, "must be { alpha = .., beta = .. }");
  if (!rayleigh.has_any({"alpha", "beta"})) rayleigh.refuse("must be { alpha = .., beta = .. }");
  return damping_matrix(read_rayleigh(rayleigh), structure.mass, structure.stiffness);
}

// A part of a matrix that does no work, or feeds it; zero where it is not given.
SparseMatrix read_skew_matrix(const SceneField& system, const char* key, MatrixFiles& files,
                              Eigen::Index size) {
  if (!system[key].given()) return {size, size};
  SparseMatrix skew = files.read(key, size);
  if (!(largest_entry(SparseMatrix(skew + SparseMatrix(skew.transpose()))) <=
        kEntryRounding * largest_entry(skew)))
    system[key].refuse("matrix with a symmetric part",
                       "must be skew-symmetric to 1e-12 of its largest entry");
  return skew;
}

void require_symmetric(const SceneField& system, const char* key, const SparseMatrix& A,
                       std::string_view otherwise) {
  if (is_symmetric(A)) return;
  const double skew = largest_entry(SparseMatrix(A - SparseMatrix(A.transpose())));
  system[key].refuse(
      "unsymmetric matrix",
      fmt::format("must be symmetric to 1e-12 of its largest entry; a_ij - a_ji is up to {:.2g} of it: "
                  "symmetric_part = [\"{}\"] drops that{}",
                  skew / largest_entry(A), key, otherwise));
}

SystemDescription read_matrices(const SceneField& system) {
  system.allow_only({"kind", "mass", "damping", "rayleigh", "modal", "stiffness", "gyroscopic", "circulatory",
                     "gyroscopic_per_speed", "circulatory_per_speed", "symmetric_part"},
                    "must be a table");
  MatrixFiles files(system);
  // Swapped, not moved: these matrices have no moves, and copies of a dense one are large.
  auto structure = std::make_shared<Structure>();
  files.read("mass").swap(structure->mass);
  require_symmetric(system, "mass", structure->mass, "");
  files.read("stiffness", structure->mass.rows()).swap(structure->stiffness);
  require_symmetric(system, "stiffness", structure->stiffness, "; what is meant is a circulatory matrix");
  std::vector<std::string> notices;
  std::vector<int> held = hold_supports(*structure, notices);
  read_matrix_damping(system, *structure, files).swap(structure->damping);
  const Eigen::Index size = structure->mass.rows();
  if (system["gyroscopic"].given()) structure->damping += read_skew_matrix(system, "gyroscopic", files, size);
  if (system["circulatory"].given())
    structure->stiffness += read_skew_matrix(system, "circulatory", files, size);
  SparseMatrix gyroscopic = read_skew_matrix(system, "gyroscopic_per_speed", files, size);
  SparseMatrix circulatory = read_skew_matrix(system, "circulatory_per_speed", files, size);
  if (!held.empty()) {
    uncouple(gyroscopic, held);
    uncouple(circulatory, held);
    uncouple(structure->damping, held);
    const Eigen::VectorXd diagonal = structure->stiffness.diagonal();
    uncouple(structure->stiffness, held);  // of its circulatory part, too
    for (const int i : held) structure->stiffness.coeffRef(i, i) = diagonal[i];
    structure->stiffness.makeCompressed();
  }
  if (system.has_any({"gyroscopic_per_speed", "circulatory_per_speed"}))
    follow_speed(*structure, gyroscopic, circulatory);
  SystemDescription description = independent_of_contacts(std::move(structure));
  description.held = std::move(held);
  description.notices = files.take_notices();
  std::ranges::move(notices, std::back_inserter(description.notices));
  for (const char* key : kMatrixKeys) {
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
  using Kind = std::pair<std::string_view, SystemDescription (*)(const SceneField&)>;
  constexpr std::array<Kind, 9> kReaders{{{"sdof", read_sdof},
                                          {"chain", read_chain},
                                          {"bar", read_bar},
                                          {"beam", read_beam},
                                          {"block", read_block},
                                          {"mesh", read_solid},
                                          {"rotor", read_rotor},
                                          {"shaft", read_shaft},
                                          {"matrices", read_matrices}}};
  std::vector<std::string_view> kinds;
  for (const auto& [name, reader] : kReaders) kinds.push_back(name);
  if (!system.is_table()) system.refuse(fmt::format("must be a table with kind = {}", alternatives(kinds)));
  const std::string kind = system["kind"].one_of(kinds);
  SystemDescription description = std::ranges::find(kReaders, kind, &Kind::first)->second(system);
  description.kind = kind;
  return description;
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
