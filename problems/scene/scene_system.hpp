#pragma once
// The tables [system], [forcing], [base] and [[contact]] of a scene file: which kind of structure, its
// matrices and files of matrices, and what acts on it from outside.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "problems/assembly/damping.hpp"
#include "problems/damped_stops.hpp"
#include "problems/files/load_table.hpp"
#include "problems/moving_frame.hpp"
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
  SystemLayout layout = {};  ///< the model; contacts and loads may name faces of a block, groups of a mesh
  Definiteness definiteness = Definiteness::to_be_checked;  ///< whether M and K are known to be definite
  std::vector<std::filesystem::path> files = {};            ///< of matrices or a mesh, that it was read from
  std::vector<int> held = {};  ///< coordinates at rest, which loads do not move: supports by penalty
  std::vector<std::string> notices = {};  ///< what the readers of its files decided, a line each
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
SystemDescription read_solid(const SceneField& system);

/// M and K of a structure, given the coordinates that contacts touch.
using Assembly = std::function<Structure(const std::vector<int>& contact_coordinates)>;

/// A structure that gets its damping from its mass and stiffness, besides what its parts have.
/// \param undamped  M and K, given the coordinates that contacts touch  \param size  Nd
SystemDescription damped_structure(SystemLayout layout, Assembly undamped, DampingModel damping, int size);

/// A model whose mass may depend on its contacts: the matrices of a copy that has them.
template <class Model>
Assembly assembly_of(const Model& model) {
  return [model](const std::vector<int>& contact_coordinates) {
    Model with_contacts = model;
    with_contacts.contacts = contact_coordinates;
    return assemble(with_contacts);
  };
}

/// A file that a scene names, relative to its own folder.
struct NamedFile {
  std::filesystem::path path = {};  ///< to open it by
  std::string text = {};            ///< all of it
};
/// Reads it whole. \throws SceneError with the requirement for no name, and for a file that is not read
/// \param most  bytes
NamedFile read_named_file(const SceneField& field, std::string_view requirement, std::size_t most);

/// "consistent" where absent. \throws SceneError
ContactMass read_contact_mass(const SceneField& field);

/// A positive number of a unit. \throws SceneError
double read_positive(const SceneField& field, std::string_view unit);

/// A number of a unit that is 0 or more. \throws SceneError
double read_nonnegative(const SceneField& field, std::string_view unit);

/// Poisson's ratio, between -1 and 0.5. \throws SceneError
double read_poisson(const SceneField& field);

/// { alpha = .., beta = .. } or { modal = .. } for a system of `size` coordinates. \throws SceneError
DampingModel read_damping(const SceneField& damping, int size);

/// Damping ratios: one, or a list of them, for a system of `size` coordinates, `most` at most. \throws
/// SceneError
ModalDamping read_modal(const SceneField& modal, int size, int most = kMostModalCoordinates);

/// alpha and beta of a table, 0 where absent. \throws SceneError
ProportionalDamping read_rayleigh(const SceneField& rayleigh);

/// The frequency of a table: `frequency_hz` where that is given, else `frequency`. \throws SceneError for
/// both
SceneField frequency_field(const SceneField& table);

/// Its value [rad/s], 2 pi times what is given in Hz. \throws SceneError for anything but a positive number
double read_frequency(const SceneField& table);

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

/// The load of [[forcing.term]] tables, and where it was sampled.
struct ReadLoad : FromTables<ForceTerm> {
  std::vector<SampledLoad> sampled = {};          ///< terms given by samples
  std::vector<std::filesystem::path> files = {};  ///< that samples were read from
};

/// The load: [[forcing.term]] tables, each on a coordinate or spread over a face or a group, a harmonic or
/// samples over a period of `frequency`. \throws SceneError
ReadLoad read_load(const SceneField& terms, const SystemDescription& system, double frequency);

/// [[contact]] tables, each a contact, a ring of them, or those of a face or a group; how their stops move is
/// read_stop_motion's business. \throws SceneError
FromTables<Contact> read_contacts(const SceneField& contacts, const SystemDescription& system);

/// [[forcing.unbalance]] tables: discs whose mass turns with the frequency of the load about an axis at right
/// angles to two coordinates, moment omega^2 (cos(omega t + phase), sin(omega t + phase)). \throws SceneError
FromTables<ForceTerm> read_unbalance(const SceneField& unbalance, int size);

/// How the stops of [[contact]] tables move: `gap_term` and `centre_term`. \throws SceneError
std::vector<StopTerm> read_stop_motion(const SceneField& contacts, const FromTables<Contact>& made);

/// Gives the contacts their laws: those of their own tables, else of [law], else none. \return the stops that
/// are springs with dampers, to be given faces. \throws SceneError
std::vector<DampedStop> read_laws(const SceneField& document, FromTables<Contact>& contacts);

/// Refuses `massless` of contacts that carry mass. \throws SceneError
void require_massless(const SceneField& document, const FromTables<Contact>& contacts,
                      const Problem& problem);

/// Where the file gives a contact the restitution, penalty or damper that validate() names: in its own table,
/// or in [law]. \param tables  of all contacts (FromTables)
SceneField law_field_as_written(const SceneField& document, const std::vector<int>& tables,
                                std::size_t contact, const std::string& key);

/// The table [base]: adds the load of a base that moves (move_base). \throws SceneError
void read_base(const SceneField& base, const SystemDescription& system, Problem& problem);

/// A coordinate of a system of `size`. \throws SceneError
int read_dof(const SceneField& field, int size);

/// A pair of different coordinates; a refusal adds the remark. \throws SceneError
std::pair<int, int> read_plane(const SceneField& field, int size, std::string_view remark = {});

/// A face of a block: "x+", "y-" and so on. \throws SceneError
Face read_face(const SceneField& field, const SystemDescription& system);

/// The mesh of a system that is one. Requires that it is.
const SolidMesh& mesh_of(const SystemDescription& system);

/// The group of a mesh that a field names. \throws SceneError
const MeshGroup& group_named(const SceneField& field, const SolidMesh& mesh);

/// A named group of a system that is a mesh. \throws SceneError
const MeshGroup& read_group(const SceneField& field, const SystemDescription& system);

/// "x", "y" or "z", as 0, 1 or 2. \throws SceneError
int read_axis(const SceneField& field);

/// A whole number of any size: ranges are validate()'s business.
int read_int(const SceneField& field, int otherwise);

}  // namespace signorini
