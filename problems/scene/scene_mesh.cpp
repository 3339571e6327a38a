#include <fmt/format.h>

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "problems/assembly/solid.hpp"
#include "problems/files/close_names.hpp"
#include "problems/files/gmsh_mesh.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini {

namespace {

// The mesh with its nodes at rest first; none is, where `fixed` is absent.
SolidMesh hold(SolidMesh mesh, const SceneField& fixed) {
  if (!fixed.given()) return mesh;
  std::set<std::string> names;
  for (const SceneField& item : fixed.items("must be a list of groups of the mesh, held at rest")) {
    group_named(item, mesh);
    names.insert(item.text("must be the name of a group of the mesh"));
  }
  SolidMesh held = held_at(std::move(mesh), {names.begin(), names.end()});
  if (held.size() == 0) fixed.refuse("must leave a node that can move");
  return held;
}

}  // namespace

const MeshGroup& group_named(const SceneField& field, const SolidMesh& mesh) {
  const std::string name = field.text("must be the name of a group of the mesh");
  const auto found = mesh.groups.find(name);
  if (found != mesh.groups.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [group, elements] : mesh.groups) known.push_back(group);
  field.refuse(fmt::format(
      "must be the name of a group of the mesh, which has {}{}",
      known.empty() ? "none: in Gmsh, Physical Surface(\"NAME\")" : fmt::format("{} of them", known.size()),
      suggestion(name, known)));
}

SystemDescription read_solid(const SceneField& system) {
  system.allow_only({"kind", "mesh", "fixed", "young", "poisson", "density", "damping", "contact_mass"},
                    "must be a table");
  constexpr std::size_t kLargestMeshFile = std::size_t{1} << 29U;  // bytes: some 5 million nodes and elements
  constexpr double kMostPairs = 2e8;  // nine entries of a matrix each, counted by int
  constexpr int kMostMeshCoordinates = 3'000'000;
  const SceneField mesh_field = system["mesh"];
  const NamedFile file =
      read_named_file(mesh_field, "must be the name of a mesh file of Gmsh, relative to the scene's folder",
                      kLargestMeshFile);
  auto mesh =
      std::make_shared<const SolidMesh>(hold(read_gmsh_mesh(file.text, file.path.string()), system["fixed"]));
  const int size = mesh->size();
  double pairs = 0.0;  // of nodes in one element
  for (const ElementList& elements : mesh->solids)
    pairs += static_cast<double>(elements.nodes.size()) * elements.shape->nodes;
  if (pairs > kMostPairs)
    mesh_field.refuse(fmt::format("{:.0f} pairs of nodes in elements", pairs),
                      fmt::format("must have at most {:.0f}", kMostPairs));
  if (size > kMostMeshCoordinates)
    mesh_field.refuse(fmt::format("{} coordinates", size),
                      fmt::format("must make at most {}", kMostMeshCoordinates));
  const Solid solid{.mesh = mesh,
                    .young = read_positive(system["young"], "[N/m^2]"),
                    .poisson = read_poisson(system["poisson"]),
                    .density = read_positive(system["density"], "[kg/m^3]"),
                    .contact_mass = read_contact_mass(system["contact_mass"])};
  SystemDescription description =
      damped_structure(mesh, assembly_of(solid), read_damping(system["damping"], size), size);
  description.files.push_back(file.path);
  return description;
}

}  // namespace signorini
