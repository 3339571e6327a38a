#pragma once
// Several scenes in one file: a family, the same scene at several levels of severity, or instances, whose
// numbers are drawn from ranges.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

/// Numbers drawn from ranges: the place in the file, "contact[0].gap", and the value there.
using DrawnValues = std::vector<std::pair<std::string, double>>;

/// Which of the scenes that the ranges of a file describe. Seed and number give the same numbers everywhere,
/// for everyone.
struct SceneInstance {
  std::string scene = {};   ///< name in the file
  std::uint64_t seed = 1;   ///< of all instances
  int number = 1;           ///< 1, 2, ...
  DrawnValues values = {};  ///< place by place, in the order of the file
  /// Member by member.
  bool operator==(const SceneInstance&) const = default;
};

/// What of a file with several scenes is one scene; neither for a scene by itself.
struct SceneVariant {
  std::optional<FamilyLevel> family = {};      ///< of a family
  std::optional<SceneInstance> instance = {};  ///< of a file with ranges
};

/// Shortest text that reads back as the level: "1e-4", "0.5", "1000".
std::string level_label(double level);

/// Labels of the levels of a document, easiest first; empty where it is a scene by itself.
/// \throws SceneError for a `family` table that cannot be used
std::vector<std::string> family_labels(const TomlNode& document, const std::string& file);

/// "7-3": the third instance of seed 7.
std::string instance_label(std::uint64_t seed, int number);

/// Whether a document has ranges, [[range]], to draw instances from.
bool has_ranges(const TomlNode& document);

/// Makes a document one scene. Of a family: takes the table `family` out, writes the values of the level that
/// the label names to the places it names. Of a document with ranges: takes these out, and writes the numbers
/// that are drawn for the label "SEED-NUMBER"; with an empty label the scene is as it is written. Each number
/// depends on seed, number, name of the scene and its places alone, by std::mt19937_64, and has six digits;
/// it is uniform from `from` to `to`, in the logarithm where `log` says so, or one of `one_of`. Lines of
/// errors are those of the values. A scene by itself is left as it is with an empty label.
/// \throws SceneError if the label is none of the document, or `family` or `range` cannot be used
SceneVariant choose_variant(TomlNode& document, const std::string& file, std::string_view label);

}  // namespace signorini
