#pragma once
// A method that is any executable, described by a TOML file: docs/plugins.md has every key.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "methods/method.hpp"

namespace signorini {

/// An option as the description declares it, with its default or another value of the same type.
struct CommandOption {
  std::string name = {};
  OptionValue value = {};  ///< bool, long, double or string
  std::string unit = {};
  std::string meaning = {};
  std::optional<double> least = {}, most = {};  ///< of numbers
  std::vector<std::string> choices = {};        ///< of words; empty: any
};

/// Laws that the answers obey, by the scene's own; where there is none the scene is not supported.
struct RepresentedLaws {
  /// On massive contacts: a number, the scene's restitution, or none determined.
  struct SceneRestitution {};
  using OfRestitution = std::variant<std::monostate, SceneRestitution, Restitution, Undetermined>;
  OfRestitution restitution = {};
  bool penalty = false;
  bool massless = false;
  bool no_contact = false;

  /// Empty where the law is not supported.
  [[nodiscard]] std::optional<RepresentedLaw> on(const Law& scene) const;
  /// "restitution 1, penalty", for `list`.
  [[nodiscard]] std::string text() const;
};

/// What a description says.
struct CommandDescription {
  std::string name = {};
  std::string title = {};
  std::string ladder = {};
  std::vector<std::string> words =
      {};  ///< program and arguments, files of the description's folder by their paths
  std::vector<CommandOption> options = {};
  RepresentedLaws represents = {};
  std::optional<int> most_coordinates = {}, most_contacts = {};
  std::string sha256 = {};  ///< of the description and the files that its command names
};

/// \throws SceneError, `FILE:LINE: key = value (what is required)`; UsageError for a file that cannot be read
CommandDescription read_command_file(const std::filesystem::path& file);

}  // namespace signorini
