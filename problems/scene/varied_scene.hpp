#pragma once
// A scene one of whose numbers is changed again and again.

#include <string>

#include "problems/scene/scene_file.hpp"

namespace signorini {

/// A scene file with one of its numbers left free, named by its place: "forcing.term[0].cos",
/// "contact[1].gap", "law.restitution", "system.stiffness".
class VariedScene {
 public:
  /// \throws SceneError where the file or its level cannot be read, or no number stands at the place
  VariedScene(const SceneSource& source, std::string place);

  [[nodiscard]] const std::string& place() const { return place_; }  ///< as given
  [[nodiscard]] double value() const { return value_; }              ///< in the file
  /// The scene with another value there. \throws SceneError where that is no scene, as load_scene does
  [[nodiscard]] Problem at(double value) const;
  /// The same without `validate`, for values next to those that are scenes. \throws SceneError
  [[nodiscard]] Problem unchecked(double value) const;

 private:
  [[nodiscard]] TomlNode document(double value) const;

  TomlNode document_;
  std::string file_, place_;
  SceneVariant variant_;
  double value_ = 0.0;
};

}  // namespace signorini
