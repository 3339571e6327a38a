#include <fmt/format.h>

#include "problems/assembly/rotor.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini {

int read_dof(const SceneField& field, int size) {
  const int last = size - 1;
  return field.whole(fmt::format("must be a coordinate of the system, 0..{}", last), 0, last);
}

Face read_face(const SceneField& field, const SystemDescription& system) {
  if (!std::holds_alternative<BlockMesh>(system.layout))
    field.refuse("must be absent: only a block has faces");
  constexpr std::string_view kFace = "must be \"x+\", \"y-\", \"y+\", \"z-\" or \"z+\": x- is clamped";
  const std::string name = field.text(kFace);
  const std::size_t axis = name.size() == 2 ? std::string_view("xyz").find(name[0]) : std::string_view::npos;
  if (axis == std::string_view::npos || name == "x-" || (name[1] != '-' && name[1] != '+')) {
    field.refuse(kFace);
  }
  return {.axis = static_cast<int>(axis), .upper = name[1] == '+'};
}

const SolidMesh& mesh_of(const SystemDescription& system) {
  return *std::get<std::shared_ptr<const SolidMesh>>(system.layout);
}

const MeshGroup& read_group(const SceneField& field, const SystemDescription& system) {
  if (!std::holds_alternative<std::shared_ptr<const SolidMesh>>(system.layout))
    field.refuse("must be absent: only a mesh has groups");
  return group_named(field, mesh_of(system));
}

int read_axis(const SceneField& field) {
  constexpr std::string_view kAxis = "must be \"x\", \"y\" or \"z\"";
  const std::string name = field.text(kAxis);
  const std::size_t axis = name.size() == 1 ? std::string_view("xyz").find(name[0]) : std::string_view::npos;
  if (axis == std::string_view::npos) field.refuse(kAxis);
  return static_cast<int>(axis);
}

namespace {

constexpr int kMostFacets = 1000;              // of one ring
constexpr std::size_t kMostContacts = 100000;  // of a scene
constexpr std::string_view kNumber = "must be a finite number";
constexpr std::string_view kGap = "must be a finite number [m]";

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
    patch[side] = {ends[0].number(kGap), ends[1].number(kGap)};
  }
  return patch;
}

std::vector<Contact> read_face_contacts(const SceneField& contact, const SystemDescription& system) {
  for (const char* key : {"dof", "normal", "dofs", "facets"}) {
    if (contact[key].given()) contact[key].refuse("must be absent: face is given");
  }
  const Face face = read_face(contact["face"], system);
  const SceneField patch = contact["patch"];
  const auto& mesh = std::get<BlockMesh>(system.layout);  // else there was no face
  std::vector<Contact> made =
      contacts_on_face(mesh, face, read_patch(patch, face, mesh), contact["gap"].number(kGap));
  if (made.empty()) {
    const auto [first, second] = face.axes();
    patch.refuse(fmt::format("must hold a node that can move: they are {:g} m by {:g} m apart",
                             mesh.spacing(first), mesh.spacing(second)));
  }
  return made;
}

// All nodes of a group, along an axis upwards ("z+") or downwards.
std::vector<Contact> read_group_contacts(const SceneField& contact, const SystemDescription& system) {
  for (const char* key : {"dof", "normal", "dofs", "facets", "face", "patch"}) {
    if (contact[key].given()) contact[key].refuse("must be absent: group is given");
  }
  const MeshGroup& group = read_group(contact["group"], system);
  constexpr std::string_view kWay =
      "must be \"x+\", \"x-\", \"y+\", \"y-\", \"z+\" or \"z-\": the way to the stop";
  const SceneField direction = contact["direction"];
  const std::string way = direction.text(kWay);
  const std::size_t axis = way.size() == 2 ? std::string_view("xyz").find(way[0]) : std::string_view::npos;
  if (axis == std::string_view::npos || (way[1] != '-' && way[1] != '+')) direction.refuse(kWay);
  std::vector<Contact> made = contacts_on_group(mesh_of(system), group, static_cast<int>(axis), way[1] == '+',
                                                contact["gap"].number(kGap));
  if (made.empty()) contact["group"].refuse("must have a node that can move");
  return made;
}

using Normal = std::vector<std::pair<int, double>>;

Normal read_normal(const SceneField& contact, int size) {
  const SceneField dof = contact["dof"], normal = contact["normal"], between = contact["between"];
  if (dof.given() && normal.given()) normal.refuse("must be absent: dof is given");
  if (between.given()) {
    if (dof.given() || normal.given())
      between.refuse(fmt::format("must be absent: {} is given", dof.given() ? "dof" : "normal"));
    constexpr std::string_view kPair = "must be a pair of different coordinates";
    const std::vector<SceneField> pair = between.items(kPair, 2);
    const int moving = read_dof(pair[0], size), stop = read_dof(pair[1], size);
    if (moving == stop) between.refuse(kPair);
    return {{moving, 1.0}, {stop, -1.0}};
  }
  if (!normal.given()) return {{read_dof(dof, size), 1.0}};
  constexpr std::string_view kPair = "must be a pair [dof, coefficient]";
  Normal result;
  for (const SceneField& entry : normal.items("must be a list of pairs [dof, coefficient]")) {
    const std::vector<SceneField> pair = entry.items(kPair, 2);
    result.emplace_back(read_dof(pair[0], size), pair[1].number(kNumber));
  }
  return result;
}

Normal opposite(Normal normal) {
  for (auto& [dof, coefficient] : normal) coefficient = -coefficient;
  return normal;
}

// A stop on one side, or those on both sides of a clearance.
std::vector<Contact> read_single(const SceneField& contact, int size) {
  constexpr std::string_view kSide = "must be \"above\" or \"below\"";
  const SceneField side = contact["side"], clearance = contact["clearance"];
  Normal normal = read_normal(contact, size);
  if (side.given()) {
    const std::string name = side.text(kSide);
    if (name != "above" && name != "below") side.refuse(kSide);
    if (name == "below") normal = opposite(std::move(normal));
  }
  if (!clearance.given()) return {{.normal = std::move(normal), .gap = contact["gap"].number(kGap)}};
  if (side.given()) side.refuse("must be absent: a clearance has stops on both sides");
  if (contact["gap_term"].given())
    contact["gap_term"].refuse("must be absent: a clearance is given; write its two contacts, or [base]");
  const double room = clearance.number("must be a positive number [m]", kLeastPositive);
  const double gap = contact["gap"].number_or(0.5 * room, kGap);
  Normal below = opposite(normal);
  return {{.normal = std::move(normal), .gap = gap}, {.normal = std::move(below), .gap = room - gap}};
}

// A regular polygon of contacts in the plane of two coordinates.
std::vector<Contact> read_ring(const SceneField& contact, int size) {
  for (const char* key : {"dof", "normal"}) {
    if (contact[key].given()) contact[key].refuse("must be absent: a ring of facets has dofs, a pair");
  }
  constexpr std::string_view kPair = "must be a pair of different coordinates";
  const std::vector<SceneField> pair = contact["dofs"].items(kPair, 2);
  const int first = read_dof(pair[0], size);
  const int second = read_dof(pair[1], size);
  if (first == second) contact["dofs"].refuse(kPair);
  const int facets =
      contact["facets"].whole(fmt::format("must be a whole number, 3..{}", kMostFacets), 3, kMostFacets);
  return ring_of_contacts(first, second, facets, contact["gap"].number(kGap));
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
  if (!contact["dofs"].given() && !contact["face"].given() && !contact["group"].given() &&
      !contact["facets"].given() && !contact["patch"].given() && !contact["direction"].given())
    return read_single(contact, system.size);
  for (const char* key : {"between", "side", "clearance"})
    if (contact[key].given()) contact[key].refuse("must be absent: it goes with dof, normal or between");
  if (contact["group"].given()) return read_group_contacts(contact, system);
  if (contact["direction"].given()) contact["direction"].refuse("must be absent: no group is given");
  if (contact["face"].given()) return read_face_contacts(contact, system);
  if (contact["patch"].given()) contact["patch"].refuse("must be absent: no face is given");
  return read_ring(contact, system.size);
}

}  // namespace

FromTables<Contact> read_contacts(const SceneField& contacts, const SystemDescription& system) {
  FromTables<Contact> made;
  if (!contacts.given()) return made;
  int table = 0;
  for (const SceneField& contact : contacts.items("must be [[contact]] tables; left out if there is none")) {
    for (Contact& one : read_contact(contact, system)) made.add(std::move(one), table);
    if (made.things.size() > kMostContacts) {
      contact.refuse(fmt::format("{} contacts so far", made.things.size()),
                     fmt::format("must make at most {} in all", kMostContacts));
    }
    ++table;
  }
  return made;
}

}  // namespace signorini
