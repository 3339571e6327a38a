#pragma once
// A family of scenes in one file: the same scene at several levels of severity.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/files/toml_tree.hpp"

namespace signorini {

/// Which scene of which family, and how hard it is meant to be.
struct FamilyLevel {
  std::string family = {};     ///< name in the file
  std::string parameter = {};  ///< what drives the family from easy to impossible, in words, with its unit
  double level = 0.0;          ///< value of the parameter
  int severity = 1;            ///< 1, the easiest, to `levels`
  int levels = 1;              ///< in the family
  /// Member by member.
  bool operator==(const FamilyLevel&) const = default;
};

/// Shortest text that reads back as the level: "1e-4", "0.5", "1000".
std::string level_label(double level);

/// Labels of the levels of a document, easiest first; empty where it is a scene by itself.
/// \throws SceneError for a `family` table that cannot be used
std::vector<std::string> family_labels(const TomlNode& document, const std::string& file);

/// Makes a document of a family the scene of one level: takes the table `family` out, writes the level's
/// values to the places it names. Lines of errors are those of the values. A scene by itself has no level,
/// and is left as it is with an empty label.
/// \throws SceneError if the label is no level of the document, or the `family` table cannot be used
std::optional<FamilyLevel> choose_level(TomlNode& document, const std::string& file, std::string_view label);

}  // namespace signorini
