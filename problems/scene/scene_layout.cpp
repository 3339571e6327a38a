#include "problems/scene/scene_layout.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "problems/scene/scene_field.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini {

SceneOutline load_outline(const SceneSource& source) {
  const std::string name = source.file.string();
  TomlNode tree = parse_toml(read_scene_text(source.file), name);
  static_cast<void>(choose_variant(tree, name, source.level));
  const SceneField document(tree, name), forcing = document["forcing"];
  SystemDescription system = read_system(document["system"]);
  SceneOutline outline{.coordinates = system.size, .files = std::move(system.files)};
  std::ranges::move(read_load(forcing["term"], system, read_frequency(forcing)).files,
                    std::back_inserter(outline.files));
  FromTables<Contact> contacts = read_contacts(document["contact"], system);
  outline.damped_stops = read_laws(document, contacts);
  outline.layout = std::move(system.layout);
  outline.notices = std::move(system.notices);
  return outline;
}

}  // namespace signorini
