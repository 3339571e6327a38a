#include "problems/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "problems/assembly/rotor.hpp"
#include "problems/scene_field.hpp"
#include "problems/scene_system.hpp"
#include "problems/toml_tree.hpp"

namespace signorini {

namespace {

constexpr int kSchema = 1;
constexpr std::size_t kLargestFile = std::size_t{1} << 24;  // bytes; a scene is text written by hand
constexpr std::size_t kLongestName = 64;
constexpr int kMostFacets = 1000;  // of one ring
constexpr std::string_view kNumber = "must be a finite number";
constexpr std::string_view kGap = "must be a finite number [m]";

bool is_lower_kebab_case(std::string_view name) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !name.empty() && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), fits) &&
         name.front() != '-' && name.back() != '-' && name.find("--") == std::string_view::npos;
}

std::string read_name(const SceneField& field) {
  constexpr std::string_view kRequirement =
      "must be a name in lower-kebab-case, such as \"sdof-stop\", of at most 64 characters";
  std::string name = field.text(kRequirement);
  if (!is_lower_kebab_case(name)) field.refuse(kRequirement);
  return name;
}

std::string read_optional_text(const SceneField& field) {
  return field.given() ? field.text("must be one line of text") : std::string();
}

std::vector<std::string> read_tags(const SceneField& field) {
  std::vector<std::string> tags;
  if (!field.given()) return tags;
  constexpr std::string_view kRequirement = "must be a list of words; left out if there is none";
  for (const SceneField& item : field.items(kRequirement)) {
    tags.push_back(item.text("must be a word"));
    if (tags.back().empty()) item.refuse("must be a word");
  }
  return tags;
}

int read_dof(const SceneField& field, int size) {
  const int last = size - 1;
  return field.whole(fmt::format("must be a coordinate of the system, 0..{}", last), 0, last);
}

// Ranges are validate()'s business; here a number need only be an int.
int read_int(const SceneField& field, int otherwise) {
  constexpr int kMost = std::numeric_limits<int>::max();
  return field.whole_or(otherwise, "must be a whole number", -kMost, kMost);
}

void read_forcing(const SceneField& forcing, int size, Problem& problem) {
  forcing.allow_only({"frequency", "subharmonic", "term"}, "must be a table with the frequency");
  problem.frequency = forcing["frequency"].number("must be a positive number [rad/s]");
  problem.subharmonic = read_int(forcing["subharmonic"], 1);
  const SceneField terms = forcing["term"];
  if (!terms.given()) return;
  for (const SceneField& term : terms.items("must be [[forcing.term]] tables; left out if there is none")) {
    term.allow_only({"dof", "harmonic", "cos", "sin"}, "must be a table");
    problem.force.push_back({.dof = read_dof(term["dof"], size),
                             .harmonic = read_int(term["harmonic"], 1),
                             .cos = term["cos"].number_or(0.0, kNumber),
                             .sin = term["sin"].number_or(0.0, kNumber)});
  }
}

std::vector<std::pair<int, double>> read_normal(const SceneField& contact, int size) {
  const SceneField dof = contact["dof"];
  const SceneField normal = contact["normal"];
  if (dof.given() && normal.given()) normal.refuse("must be absent: dof is given");
  if (!normal.given()) return {{read_dof(dof, size), 1.0}};
  constexpr std::string_view kPair = "must be a pair [dof, coefficient]";
  std::vector<std::pair<int, double>> result;
  for (const SceneField& entry : normal.items("must be a list of pairs [dof, coefficient]")) {
    const std::vector<SceneField> pair = entry.items(kPair);
    if (pair.size() != 2) entry.refuse(kPair);
    result.emplace_back(read_dof(pair[0], size), pair[1].number(kNumber));
  }
  return result;
}

// A regular polygon of contacts in the plane of two coordinates.
std::vector<Contact> read_ring(const SceneField& contact, int size) {
  for (const char* key : {"dof", "normal"}) {
    if (contact[key].given()) contact[key].refuse("must be absent: a ring of facets has dofs, a pair");
  }
  constexpr std::string_view kPair = "must be a pair of different coordinates";
  const std::vector<SceneField> pair = contact["dofs"].items(kPair);
  if (pair.size() != 2) contact["dofs"].refuse(kPair);
  const int first = read_dof(pair[0], size);
  const int second = read_dof(pair[1], size);
  if (first == second) contact["dofs"].refuse(kPair);
  const int facets =
      contact["facets"].whole(fmt::format("must be a whole number, 3..{}", kMostFacets), 3, kMostFacets);
  return ring_of_contacts(first, second, facets, contact["gap"].number(kGap));
}

bool is_ring(const SceneField& contact) { return contact["facets"].given() || contact["dofs"].given(); }

void read_contacts(const SceneField& contacts, int size, Problem& problem) {
  if (!contacts.given()) return;
  for (const SceneField& contact : contacts.items("must be [[contact]] tables; left out if there is none")) {
    contact.allow_only({"dof", "normal", "dofs", "facets", "gap"}, "must be a table");
    if (is_ring(contact)) {
      std::ranges::move(read_ring(contact, size), std::back_inserter(problem.contacts));
    } else {
      problem.contacts.push_back({.normal = read_normal(contact, size), .gap = contact["gap"].number(kGap)});
    }
  }
}

// The table that contact `index` was made from; a ring makes many.
SceneField contact_as_written(const SceneField& document, int index) {
  int table = 0;
  while (true) {
    const SceneField contact = document.at(fmt::format("contact[{}]", table));
    const int made = is_ring(contact) ? contact["facets"].whole("", 3, kMostFacets) : 1;
    if (index < made || !contact.given()) return contact;
    index -= made;
    ++table;
  }
}

std::vector<double> read_penalty(const SceneField& penalty, std::size_t contacts) {
  constexpr std::string_view kRequirement = "must be a positive number [N/m], or a list of them";
  if (!penalty.is_array()) return std::vector<double>(contacts, penalty.number(kRequirement));
  std::vector<double> values;
  for (const SceneField& item : penalty.items(kRequirement)) {
    values.push_back(item.number("must be a positive number [N/m]"));
  }
  return values;
}

Law read_law(const SceneField& law, const Problem& problem) {
  if (!law.given()) {
    if (problem.contacts.empty() || !contacts_are_massless(problem)) return {};
    return Massless{};
  }
  law.allow_only({"restitution", "penalty"}, "must be a table with restitution or penalty");
  if (problem.contacts.empty()) law.refuse("must be absent: the scene has no contact");
  const SceneField restitution = law["restitution"];
  const SceneField penalty = law["penalty"];
  if (penalty.given()) {
    if (restitution.given()) penalty.refuse("must be absent: restitution is given");
    return Penalty{read_penalty(penalty, problem.contacts.size())};
  }
  if (!restitution.given()) law.refuse("must hold restitution or penalty, or be left out");
  return Restitution{restitution.number("must be in 0..1")};
}

// The place in the file that a path of validate() stands for.
SceneField as_written(const SceneField& document, const InvalidProblem& error) {
  if (error.field.starts_with("law.penalty[") && !document["law"]["penalty"].is_array()) {
    return document["law"]["penalty"];
  }
  if (constexpr std::string_view kContact = "contact["; error.field.starts_with(kContact)) {
    const std::size_t end = error.field.find(']');
    const int index = std::stoi(error.field.substr(kContact.size(), end - kContact.size()));
    return contact_as_written(document, index).at(std::string_view(error.field).substr(end + 1));
  }
  return system_field_as_written(document, error.field);
}

// Every coordinate with a part in some contact, once.
std::vector<int> contact_coordinates(const Problem& problem) {
  std::set<int> coordinates;
  for (const Contact& contact : problem.contacts) {
    for (const auto& [dof, coefficient] : contact.normal) {
      if (coefficient != 0.0) coordinates.insert(dof);
    }
  }
  return {coordinates.begin(), coordinates.end()};
}

Problem read_scene(const SceneField& scene) {
  static_cast<void>(
      scene["schema"].whole("must be 1", kSchema, kSchema));  // first: others may have other keys
  scene.allow_only({"schema", "name", "title", "reference", "tags", "system", "forcing", "contact", "law"},
                   "must be a table");
  Problem problem;
  problem.name = read_name(scene["name"]);
  problem.title = read_optional_text(scene["title"]);
  problem.reference = read_optional_text(scene["reference"]);
  problem.tags = read_tags(scene["tags"]);
  const SystemDescription system = read_system(scene["system"]);
  problem.kind = system.kind;
  read_forcing(scene["forcing"], system.size, problem);
  read_contacts(scene["contact"], system.size, problem);
  Structure structure = system.assemble(contact_coordinates(problem));
  problem.mass = std::move(structure.mass);
  problem.damping = std::move(structure.damping);
  problem.stiffness = std::move(structure.stiffness);
  problem.law = read_law(scene["law"], problem);
  return problem;
}

std::string read_text(const std::filesystem::path& path) {
  const auto refuse = [&](std::string_view found, std::string_view requirement) {
    throw SceneError(fmt::format("{}: file = {} ({})", path.string(), found, requirement));
  };
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) refuse("missing", "must exist");
  if (std::filesystem::is_directory(path, ignored)) refuse("a folder", "must be a TOML file");
  std::ifstream stream(path, std::ios::binary);
  std::string text;
  std::array<char, 65536> block{};
  while (stream && text.size() <= kLargestFile) {
    stream.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad() || !stream.is_open()) refuse("unreadable", "must be a file that may be read");
  if (text.size() > kLargestFile) refuse("more than 16 MiB", "must be a scene of at most 16 MiB");
  return text;
}

}  // namespace

Problem parse_scene(std::string_view text, const std::string& name) {
  TomlNode document;
  try {
    document = parse_toml(text);
  } catch (const TomlSyntaxError& error) {
    throw SceneError(
        fmt::format("{}:{}: file = not TOML (must be valid TOML 1.0; {})", name, error.line, error.what()));
  }
  const SceneField scene(document, name);
  try {
    Problem problem = read_scene(scene);
    validate(problem);
    return problem;
  } catch (const InvalidProblem& error) {
    as_written(scene, error).refuse(error.found, error.requirement);
  }
}

Problem load_scene(const std::filesystem::path& path) { return parse_scene(read_text(path), path.string()); }

}  // namespace signorini
