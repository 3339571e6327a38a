#pragma once
// The tables [system], [forcing] and [[contact]] of a scene file: which kind of structure, its matrices and
// files of matrices, and what acts on it from outside.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "problems/assembly/damping.hpp"
#include "problems/scene/scene_field.hpp"
#include "problems/scene/system_layout.hpp"
#include "problems/structure.hpp"
#include "problems/validation.hpp"

namespace signorini {

/// A [system] table that has been read and checked. Contacts name coordinates and the mass of a structure may
/// depend on where its contacts are: the matrices come last.
struct SystemDescription {
  std::string kind = {};     ///< as the scene names it, "beam"
  int size = 0;              ///< Nd
  SystemLayout layout = {};  ///< the model; of a block, contacts and loads may name faces
  Definiteness definiteness = Definiteness::to_be_checked;  ///< whether M and K are known to be definite
  std::vector<std::filesystem::path> files = {};            ///< Matrix Market files it was read from
  /// The matrices, given the coordinates that contacts touch.
  /// \throws InvalidProblem if contacts there and the system do not go together
  std::function<std::shared_ptr<const Structure>(const std::vector<int>& contact_coordinates)> assemble = {};
};

/// \throws SceneError for anything but a sound [system] table
SystemDescription read_system(const SceneField& system);

// The kinds that are finite-element structures. \throws SceneError for anything but a sound table of its kind

SystemDescription read_bar(const SceneField& system);
SystemDescription read_beam(const SceneField& system);
SystemDescription read_block(const SceneField& system);
SystemDescription read_shaft(const SceneField& system);

/// { alpha = .., beta = .. } or { modal = .. } for a system of `size` coordinates. \throws SceneError
DampingModel read_damping(const SceneField& damping, int size);

/// Damping ratios: one, or a list of them, for a system of `size` coordinates. \throws SceneError
ModalDamping read_modal(const SceneField& modal, int size);

/// alpha and beta of a table, 0 where absent. \throws SceneError
ProportionalDamping read_rayleigh(const SceneField& rayleigh);

/// The field of the document that a matrix path of validate() ("system.mass") stands for in a system of its
/// kind; other paths as they are.
SceneField system_field_as_written(const SceneField& document, const std::string& path);

/// Things made from a list of tables; one table may make many.
template <class Thing>
struct FromTables {
  std::vector<Thing> things = {};
  std::vector<int> tables = {};  ///< for each thing, the table it was made from

  void add(Thing thing, int table) {
    things.push_back(std::move(thing));
    tables.push_back(table);
  }
};

/// The load: [[forcing.term]] tables, each on a coordinate or spread over a face. \throws SceneError
FromTables<ForceTerm> read_load(const SceneField& terms, const SystemDescription& system);

/// [[contact]] tables, each a contact, a ring of them, or those of a face. \throws SceneError
FromTables<Contact> read_contacts(const SceneField& contacts, const SystemDescription& system);

/// A whole number of any size: ranges are validate()'s business.
int read_int(const SceneField& field, int otherwise);

}  // namespace signorini
