#include "problems/scene/scene_layout.hpp"

#include "problems/scene/scene_document.hpp"
#include "problems/scene/scene_field.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini {

namespace {

TomlNode document_of(const SceneSource& source, const std::string& name) {
  TomlNode document = parse_toml(read_scene_text(source.file), name);
  static_cast<void>(choose_variant(document, name, source.level));
  return document;
}

SystemDescription system_of(const SceneSource& source) {
  const std::string name = source.file.string();
  const TomlNode document = document_of(source, name);
  return read_system(SceneField(document, name)["system"]);
}

}  // namespace

SystemLayout load_layout(const SceneSource& source) { return system_of(source).layout; }

std::vector<std::string> load_notices(const SceneSource& source) { return system_of(source).notices; }

std::vector<DampedStop> load_damped_stops(const SceneSource& source) {
  const std::string name = source.file.string();
  const TomlNode document = document_of(source, name);
  const SceneField root(document, name);
  FromTables<Contact> contacts = read_contacts(root["contact"], read_system(root["system"]));
  return read_laws(root, contacts);
}

}  // namespace signorini
