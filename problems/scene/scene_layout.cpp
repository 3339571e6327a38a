#include "problems/scene/scene_layout.hpp"

#include "problems/scene/scene_document.hpp"
#include "problems/scene/scene_field.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini {

SystemLayout load_layout(const SceneSource& source) {
  const std::string name = source.file.string();
  TomlNode document = parse_toml(read_scene_text(source.file), name);
  choose_level(document, name, source.level);
  return read_system(SceneField(document, name)["system"]).layout;
}

}  // namespace signorini
