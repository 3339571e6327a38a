#include "problems/scene/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "problems/files/input_file.hpp"
#include "problems/files/kebab_case.hpp"
#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_field.hpp"
#include "problems/scene/scene_system.hpp"
#include "problems/validation.hpp"

namespace signorini {

namespace {

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
  for (const SceneField& item : field.items_or_none("must be a list of words; left out if there is none")) {
    tags.push_back(item.text("must be a word"));
    if (tags.back().empty()) item.refuse("must be a word");
  }
  return tags;
}

SceneHeader read_header(const SceneField& document, SceneVariant variant) {
  std::ignore = document["schema"].whole("must be 1", 1, 1);  // first: others may have other keys
  document.allow_only(
      {"schema", "name", "title", "reference", "tags", "system", "forcing", "base", "contact", "law"},
      "must be a table");
  SceneHeader header{.name = read_name(document["name"]),
                     .title = read_optional_text(document["title"]),
                     .reference = read_optional_text(document["reference"]),
                     .tags = read_tags(document["tags"]),
                     .family = std::move(variant.family),
                     .instance = std::move(variant.instance)};
  if (header.instance) header.name += "@" + instance_label(header.instance->seed, header.instance->number);
  if (header.family) {
    header.family->family = header.name;
    header.name += "@" + level_label(header.family->level);
  }
  return header;
}

// A scene, and the tables that its load and its contacts were made from.
struct ReadScene : SceneWithSources {
  std::vector<int> term_tables = {};
  std::vector<int> contact_tables = {};
  // Terms of the load that are not written as such: the number of the first, and what they come from.
  std::vector<std::pair<int, std::string>> derived_terms = {};
  Definiteness definiteness = Definiteness::to_be_checked;
};

// "contact[12].gap" with the number of the table that made contact 12.
std::string with_table(const std::string& path, std::string_view list, const std::vector<int>& tables) {
  const std::size_t end = path.find(']');
  const int index = std::stoi(path.substr(list.size(), end - list.size()));
  return fmt::format("{}{}{}", list, tables.at(static_cast<std::size_t>(index)), path.substr(end));
}

// "forcing.term[3].cos" with the number of the table, or what else in the file the term comes from.
std::string origin_of_term(const ReadScene& scene, const std::string& path) {
  constexpr std::string_view kTerm = "forcing.term[";
  const int term = std::stoi(path.substr(kTerm.size()));
  if (term < std::ssize(scene.term_tables)) return with_table(path, kTerm, scene.term_tables);
  std::string origin = "forcing";
  for (const auto& [first, name] : scene.derived_terms)
    if (term >= first) origin = name;
  return origin;
}

// The place in the file that a path of validate() stands for.
SceneField as_written(const SceneField& document, const ReadScene& scene, const std::string& path) {
  constexpr std::string_view kContact = "contact[";
  if (path == "forcing.frequency") return frequency_field(document["forcing"]);
  if (path.starts_with("frame[")) return document["contact"];
  if (path.starts_with(kContact)) {
    const std::string key = path.substr(path.find(']') + 1);
    if (key != ".restitution" && key != ".penalty" && key != ".damper")
      return document.at(with_table(path, kContact, scene.contact_tables));
    return law_field_as_written(document, scene.contact_tables, std::stoul(path.substr(kContact.size())),
                                key.substr(1));
  }
  if (path.starts_with("forcing.term[")) return document.at(origin_of_term(scene, path));
  return system_field_as_written(document, path);
}

void mark_derived(ReadScene& scene, std::string origin) {
  scene.derived_terms.emplace_back(static_cast<int>(scene.problem.force.size()), std::move(origin));
}

void read_forcing(const SceneField& forcing, const SystemDescription& system, ReadScene& scene) {
  forcing.allow_only({"frequency", "frequency_hz", "subharmonic", "term", "unbalance"},
                     "must be a table with the frequency");
  scene.problem.frequency = read_frequency(forcing);
  scene.problem.subharmonic = read_int(forcing["subharmonic"], 1);
  ReadLoad load = read_load(forcing["term"], system, scene.problem.frequency);
  scene.problem.force = std::move(load.things);
  scene.sampled_loads = std::move(load.sampled);
  scene.files.insert(scene.files.end(), load.files.begin(), load.files.end());
  scene.term_tables = std::move(load.tables);
  mark_derived(scene, "forcing.unbalance");
  const FromTables<ForceTerm> unbalance = read_unbalance(forcing["unbalance"], system.size);
  scene.problem.force.insert(scene.problem.force.end(), unbalance.things.begin(), unbalance.things.end());
  for (ForceTerm& term : scene.problem.force) {
    if (std::ranges::find(system.held, term.dof) != system.held.end()) term.cos = term.sin = 0.0;
  }
}

// Stops that give way, and loads of what moves, which needs the matrices.
void read_stops(const SceneField& document, const SystemDescription& system,
                const FromTables<Contact>& contacts, const std::vector<DampedStop>& damped,
                ReadScene& scene) {
  const Structure& structure = *scene.problem.structure;
  for (const SparseMatrix* A : {&structure.mass, &structure.damping, &structure.stiffness})
    if (A->rows() != system.size || A->cols() != system.size) return;  // validate() will say so
  mark_derived(scene, "base");
  read_base(document["base"], system, scene.problem);
  mark_derived(scene, "contact");
  require_massless(document, contacts, scene.problem);
  if (!damped.empty()) damp_stops(scene.problem, damped);
  move_stops(scene.problem, read_stop_motion(document["contact"], contacts));
}

// Fills `scene` as far as it comes.
void read_scene(const SceneField& document, SceneVariant variant, ReadScene& scene) {
  SceneHeader header = read_header(document, std::move(variant));
  scene.family = std::move(header.family);
  scene.instance = std::move(header.instance);
  Problem& problem = scene.problem;
  problem.name = std::move(header.name);
  problem.title = std::move(header.title);
  problem.reference = std::move(header.reference);
  problem.tags = std::move(header.tags);
  const SystemDescription system = read_system(document["system"]);
  problem.kind = system.kind;
  scene.definiteness = system.definiteness;
  scene.files = system.files;
  read_forcing(document["forcing"], system, scene);
  FromTables<Contact> contacts = read_contacts(document["contact"], system);
  const std::vector<DampedStop> damped = read_laws(document, contacts);
  problem.contacts = contacts.things;
  scene.contact_tables = contacts.tables;
  problem.structure = system.assemble(contact_coordinates(problem.contacts));
  read_stops(document, system, contacts, damped, scene);
  const double omega = problem.frequency;
  problem = at_frequency(std::move(problem), omega);
}

}  // namespace

std::string read_scene_text(const std::filesystem::path& path) {
  try {
    return read_input_file(path, kLargestScene);
  } catch (const UnreadableFile& error) {
    throw SceneError(fmt::format("{}: file = {}", path.string(), error.what()));
  }
}

bool SceneHeader::carries(std::string_view tag) const {
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

bool offers_instances(const std::filesystem::path& path) {
  return has_ranges(parse_toml(read_scene_text(path), path.string()));
}

std::vector<std::string> load_levels(const std::filesystem::path& path) {
  return family_labels(parse_toml(read_scene_text(path), path.string()), path.string());
}

SceneHeader load_header(const SceneSource& source) {
  const std::string name = source.file.string();
  TomlNode document = parse_toml(read_scene_text(source.file), name);
  SceneVariant variant = choose_variant(document, name, source.level);
  return read_header(SceneField(document, name), std::move(variant));
}

SceneWithSources read_scene_document(const TomlNode& document, const std::string& name,
                                     const SceneVariant& variant, SceneChecks checks) {
  const SceneField root(document, name);
  ReadScene scene;
  try {
    read_scene(root, variant, scene);
    if (checks == SceneChecks::all) validate(scene.problem, scene.definiteness);
    return scene;
  } catch (const InvalidProblem& error) {
    as_written(root, scene, error.field).refuse(error.found, error.requirement);
  } catch (const std::invalid_argument& error) {  // of an assembly whose numbers leave the range of doubles
    root["system"].refuse("what it is",
                          fmt::format("must be a structure that can be assembled: {}", error.what()));
  }
}

SceneWithSources parse_scene_with_sources(std::string_view text, const std::string& name,
                                          std::string_view level) {
  TomlNode document = parse_toml(text, name);
  const SceneVariant variant = choose_variant(document, name, level);
  return read_scene_document(document, name, variant);
}

Problem parse_scene(std::string_view text, const std::string& name, std::string_view level) {
  return parse_scene_with_sources(text, name, level).problem;
}

Problem load_scene(const SceneSource& source) {
  return parse_scene(read_scene_text(source.file), source.file.string(), source.level);
}

}  // namespace signorini
