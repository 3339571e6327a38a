#pragma once
// A method that is an executable: it reads a problem as JSON and prints its answer as JSON.

#include <filesystem>

#include "harness/extend/plugins/command_file.hpp"
#include "methods/catalogue.hpp"

namespace signorini {

/// Runs the command once for each solve, in a process group of its own that is killed at the deadline. What
/// the process costs to start is part of its time. docs/plugins.md states what it reads and prints.
class CommandMethod final : public Method {
 public:
  /// \throws InvalidOption
  CommandMethod(CommandDescription description, std::span<const OptionSetting> settings);

  [[nodiscard]] std::vector<OptionEcho> options() const override;
  [[nodiscard]] Support supports(const Problem& problem) const override;
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;
  /// `solve` throws CommandFailure where the command crashes or prints no answer.
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override;

 private:
  CommandDescription description_;
  std::vector<OptionValue> values_;
};

/// The catalogue entry of a description. \throws SceneError, UsageError
MethodEntry load_command_method(const std::filesystem::path& file);

}  // namespace signorini
