#include "problems/scene/varied_scene.hpp"

#include <utility>

#include "problems/scene/scene_field.hpp"

namespace signorini {

VariedScene::VariedScene(const SceneSource& source, std::string place)
    : document_(parse_toml(read_scene_text(source.file), source.file.string())),
      file_(source.file.string()),
      place_(std::move(place)),
      variant_(choose_variant(document_, file_, source.level)) {
  value_ = SceneField(document_, file_)
               .at(place_)
               .number("must be the place of a number in this file, such as contact[0].gap");
}

TomlNode VariedScene::document(double value) const {
  TomlNode own = document_;
  // The field is a reader's; it leads into the copy.
  const_cast<TomlNode&>(SceneField(own, file_).at(place_).node()).value = value;
  return own;
}

Problem VariedScene::at(double value) const {
  return read_scene_document(document(value), file_, variant_).problem;
}

Problem VariedScene::unchecked(double value) const {
  return read_scene_document(document(value), file_, variant_, SceneChecks::reading).problem;
}

}  // namespace signorini
