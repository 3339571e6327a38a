#include <fmt/format.h>

#include <algorithm>

#include "problems/assembly/rotor.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini {

int read_dof(const SceneField& field, int size) {
  return field.in_range("a coordinate of the system", 0, size - 1);
}

Face read_face(const SceneField& field, const SystemDescription& system) {
  if (!std::holds_alternative<BlockMesh>(system.layout))
    field.refuse("must be absent: only a block has faces");
  const std::string name = field.one_of({"x+", "y-", "y+", "z-", "z+"}, ": x- is clamped");
  return {.axis = name[0] - 'x', .upper = name[1] == '+'};
}

const SolidMesh& mesh_of(const SystemDescription& system) {
  return *std::get<std::shared_ptr<const SolidMesh>>(system.layout);
}

const MeshGroup& read_group(const SceneField& field, const SystemDescription& system) {
  if (!std::holds_alternative<std::shared_ptr<const SolidMesh>>(system.layout))
    field.refuse("must be absent: only a mesh has groups");
  return group_named(field, mesh_of(system));
}

int read_axis(const SceneField& field) { return field.one_of({"x", "y", "z"})[0] - 'x'; }

std::pair<int, int> read_plane(const SceneField& field, int size, std::string_view remark) {
  const std::string requirement = fmt::format("must be a pair of different coordinates{}", remark);
  const std::vector<SceneField> pair = field.items(requirement, 2);
  const int first = read_dof(pair[0], size), second = read_dof(pair[1], size);
  if (first == second) field.refuse(requirement);
  return {first, second};
}

namespace {

constexpr int kMostFacets = 1000;              // of one ring
constexpr std::size_t kMostContacts = 100000;  // of a scene

double read_metres(const SceneField& field) { return field.number("must be a finite number [m]"); }

// The whole face if absent.
Patch read_patch(const SceneField& field, const Face& face, const BlockMesh& mesh) {
  Patch patch;
  for (std::size_t side = 0; side < 2; ++side) {
    patch[side] = {0.0, mesh.lengths[static_cast<std::size_t>(face.axes()[side])]};
  }
  if (!field.given()) return patch;
  constexpr std::string_view kPatch = "must be [[from, to], [from, to]], along the two axes of the face [m]";
  const std::vector<SceneField> sides = field.items(kPatch, 2);
  for (std::size_t side = 0; side < 2; ++side) {
    const std::vector<SceneField> ends = sides[side].items(kPatch, 2);
    patch[side] = {read_metres(ends[0]), read_metres(ends[1])};
  }
  return patch;
}

std::vector<Contact> read_face_contacts(const SceneField& contact, const SystemDescription& system) {
  contact.forbid({"dof", "normal", "dofs", "facets"}, "face is given");
  const Face face = read_face(contact["face"], system);
  const SceneField patch = contact["patch"];
  const auto& mesh = std::get<BlockMesh>(system.layout);  // else there was no face
  std::vector<Contact> made =
      contacts_on_face(mesh, face, read_patch(patch, face, mesh), read_metres(contact["gap"]));
  if (made.empty()) {
    const auto [first, second] = face.axes();
    patch.refuse(fmt::format("must hold a node that can move: they are {:g} m by {:g} m apart",
                             mesh.spacing(first), mesh.spacing(second)));
  }
  return made;
}

// All nodes of a group, along an axis upwards ("z+") or downwards.
std::vector<Contact> read_group_contacts(const SceneField& contact, const SystemDescription& system) {
  contact.forbid({"dof", "normal", "dofs", "facets", "face", "patch"}, "group is given");
  const MeshGroup& group = read_group(contact["group"], system);
  const std::string way =
      contact["direction"].one_of({"x+", "x-", "y+", "y-", "z+", "z-"}, ": the way to the stop");
  std::vector<Contact> made =
      contacts_on_group(mesh_of(system), group, way[0] - 'x', way[1] == '+', read_metres(contact["gap"]));
  if (made.empty()) contact["group"].refuse("must have a node that can move");
  return made;
}

using Normal = std::vector<std::pair<int, double>>;

Normal read_normal(const SceneField& contact, int size) {
  const SceneField dof = contact["dof"], normal = contact["normal"];
  if (dof.given()) contact.forbid({"normal", "between"}, "dof is given");
  if (normal.given()) contact.forbid({"between"}, "normal is given");
  if (contact["between"].given()) {
    const auto [moving, stop] = read_plane(contact["between"], size);
    return {{moving, 1.0}, {stop, -1.0}};
  }
  if (!normal.given()) return {{read_dof(dof, size), 1.0}};
  Normal result;
  for (const SceneField& entry : normal.items("must be a list of pairs [dof, coefficient]")) {
    const std::vector<SceneField> pair = entry.items("must be a pair [dof, coefficient]", 2);
    result.emplace_back(read_dof(pair[0], size), pair[1].number("must be a finite number"));
  }
  return result;
}

Normal opposite(Normal normal) {
  for (auto& [dof, coefficient] : normal) coefficient = -coefficient;
  return normal;
}

// A stop on one side, or those on both sides of a clearance.
std::vector<Contact> read_single(const SceneField& contact, int size) {
  const SceneField side = contact["side"], clearance = contact["clearance"], gap_field = contact["gap"];
  Normal normal = read_normal(contact, size);
  if (side.given() && side.one_of({"above", "below"}) == "below") normal = opposite(std::move(normal));
  if (!clearance.given()) return {{.normal = std::move(normal), .gap = read_metres(gap_field)}};
  contact.forbid({"side"}, "a clearance has stops on both sides");
  contact.forbid({"gap_term"}, "a clearance is given; write its two contacts, or [base]");
  const double room = read_positive(clearance, "[m]");
  const double gap = gap_field.given() ? read_metres(gap_field) : 0.5 * room;
  Normal below = opposite(normal);
  return {{.normal = std::move(normal), .gap = gap}, {.normal = std::move(below), .gap = room - gap}};
}

// A regular polygon of contacts in the plane of two coordinates.
std::vector<Contact> read_ring(const SceneField& contact, int size) {
  contact.forbid({"dof", "normal"}, "a ring of facets has dofs, a pair");
  const auto [first, second] = read_plane(contact["dofs"], size);
  const int facets = contact["facets"].in_range("a whole number", 3, kMostFacets);
  return ring_of_contacts(first, second, facets, read_metres(contact["gap"]));
}

std::vector<Contact> read_contact(const SceneField& contact, const SystemDescription& system) {
  if (contact["law"].given())
    contact["law"].refuse(
        "must be left out: restitution, penalty, damper and massless are keys of the contact itself, "
        "beside gap; a table [law] is the default of all contacts");
  contact.allow_only(
      {"dof", "normal", "between", "side", "dofs", "facets", "face", "patch", "group", "direction", "gap",
       "clearance", "gap_term", "centre_term", "restitution", "penalty", "damper", "damping", "massless"},
      "must be a table");
  if (!contact.has_any({"dofs", "face", "group", "facets", "patch", "direction"}))
    return read_single(contact, system.size);
  contact.forbid({"between", "side", "clearance"}, "it goes with dof, normal or between");
  if (contact["group"].given()) return read_group_contacts(contact, system);
  contact.forbid({"direction"}, "no group is given");
  if (contact["face"].given()) return read_face_contacts(contact, system);
  contact.forbid({"patch"}, "no face is given");
  return read_ring(contact, system.size);
}

// A stop meets what moves: coordinates that a support by penalty holds at rest are left out of its normal.
void leave_out(const std::vector<int>& held, const SceneField& contact, Contact& one) {
  const auto rests = [&held](const auto& part) { return std::ranges::find(held, part.first) != held.end(); };
  const auto resting = std::ranges::find_if(one.normal, rests);
  if (resting == one.normal.end()) return;
  const int dof = resting->first;
  std::erase_if(one.normal, rests);
  if (one.normal.empty() || contact["facets"].given())
    contact.refuse(fmt::format("on coordinate {}", dof),
                   "must act on coordinates that move: the stiffness of this one is a support by penalty, "
                   "which holds it at rest");
}

}  // namespace

FromTables<Contact> read_contacts(const SceneField& contacts, const SystemDescription& system) {
  FromTables<Contact> made;
  for (int table = 0; const SceneField& contact :
                      contacts.items_or_none("must be [[contact]] tables; left out if there is none")) {
    for (Contact& one : read_contact(contact, system)) {
      leave_out(system.held, contact, one);
      made.add(std::move(one), table);
    }
    if (made.things.size() > kMostContacts) {
      contact.refuse(fmt::format("{} contacts so far", made.things.size()),
                     fmt::format("must make at most {} in all", kMostContacts));
    }
    ++table;
  }
  return made;
}

}  // namespace signorini
