#include "harness/extend/plugins/command_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/failure.hpp"
#include "harness/plan/plan.hpp"
#include "harness/run/trial.hpp"
#include "problems/scene/toml_tree.hpp"

namespace signorini {

namespace {

/// \throws InvalidOption unless the number is in the option's range
void require_range(const CommandOption& option, const std::string& text) {
  const double number = option_detail::parse_double(option.name, text);
  const bool low = option.least && number < *option.least, high = option.most && number > *option.most;
  if (!low && !high) return;
  const std::string required = low ? fmt::format("must be at least {:g}", *option.least)
                                   : fmt::format("must be at most {:g}", *option.most);
  throw InvalidOption(option_detail::refuse(option.name, text, required));
}

/// A value as text, of the type that the option has. \throws InvalidOption
OptionValue parse_value(const CommandOption& option, const std::string& text) {
  if (std::holds_alternative<bool>(option.value)) return option_detail::parse_bool(option.name, text);
  if (std::holds_alternative<std::string>(option.value)) {
    const std::vector<std::string_view> choices(option.choices.begin(), option.choices.end());
    if (!choices.empty()) static_cast<void>(option_detail::parse_name(option.name, text, choices));
    return text;
  }
  require_range(option, text);
  if (std::holds_alternative<long>(option.value)) return option_detail::parse_integer(option.name, text);
  return option_detail::parse_double(option.name, text);
}

/// One scene, its request written.
class PreparedCommand final : public PreparedMethod {
 public:
  PreparedCommand(const std::vector<std::string>& words, const Problem& problem,
                  const std::vector<OptionEcho>& options)
      : words_(words), period_(problem.period()), request_(command_request(problem, options)) {}

  Solution solve(const Start& start) override {
    const CommandEnd end = run_command(words_, command_input(request_, start), start.deadline);
    if (end.expired) return {.message = "the command was stopped at the time limit"};
    if (!end.failure.empty()) {
      const std::string words = end.last_words.empty() ? "" : ": " + one_line(end.last_words, 400);
      throw CommandFailure(Status::crashed, end.failure + words, end.signal);
    }
    return read_command_answer(end.output, period_);
  }

 private:
  std::vector<std::string> words_;
  double period_;
  nlohmann::ordered_json request_;
};

/// Runs the command once for each solve, in a process group of its own that is killed at the deadline. What
/// the process costs to start is part of its time. docs/plugins.md states what it reads and prints.
class CommandMethod final : public Method {
 public:
  /// \throws InvalidOption
  CommandMethod(CommandDescription description, std::span<const OptionSetting> settings)
      : description_(std::move(description)) {
    std::vector<CommandOption>& options = description_.options;
    for (const auto& [key, text] : settings) {
      const auto option = std::ranges::find(options, key, &CommandOption::name);
      if (option == options.end()) {
        std::string names;
        for (const CommandOption& known : options) names += (names.empty() ? "" : ", ") + known.name;
        throw InvalidOption(option_detail::refuse(key, text, "unknown option; known: " + names));
      }
      option->value = parse_value(*option, text);
    }
  }

  [[nodiscard]] std::vector<OptionEcho> options() const override {
    std::vector<OptionEcho> echo;
    for (const CommandOption& option : description_.options)
      echo.push_back({option.name, option.value, option.unit, option.meaning});
    return echo;
  }

  [[nodiscard]] Support supports(const Problem& problem) const override {
    if (!description_.represents.on(problem.law))
      return {false, "its description names no law for this scene's"};
    const auto exceeds = [](int count, const std::optional<int>& most) { return most && count > *most; };
    if (exceeds(problem.size(), description_.most_coordinates))
      return {false, fmt::format("more than {} coordinates", *description_.most_coordinates)};
    if (exceeds(problem.contact_count(), description_.most_contacts))
      return {false, fmt::format("more than {} contacts", *description_.most_contacts)};
    return {};
  }

  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override {
    return description_.represents.on(problem.law).value_or(Undetermined{});
  }

  /// `solve` throws CommandFailure where the command crashes or prints no answer.
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override {
    return std::make_unique<PreparedCommand>(description_.words, problem, options());
  }

 private:
  CommandDescription description_;  ///< its options with the values that are set
};

}  // namespace

MethodEntry load_command_method(const std::filesystem::path& file) {
  const CommandDescription description = read_command_file(file);
  MethodEntry entry{.name = description.name,
                    .title = description.title,
                    .laws = description.represents.text(),
                    .ladder = description.ladder,
                    .make =
                        [description](std::span<const OptionSetting> settings) {
                          return std::make_unique<CommandMethod>(description, settings);
                        },
                    .plugin = description.sha256};
  try {
    for (const CommandOption& option : description.options) {
      const std::string text = print_option(option.value);
      static_cast<void>(entry.make(Settings{{option.name, text}}));
    }
    for (const Settings& settings : ladder_of(entry)) static_cast<void>(entry.make(settings));
  } catch (const std::runtime_error& error) {  // UsageError: a ladder that cannot be read
    throw UsageError(fmt::format("{}: ladder = {} ({})", file.string(), entry.ladder, error.what()));
  } catch (const InvalidOption& error) {
    throw UsageError(fmt::format("{}: {}", file.string(), error.what()));
  }
  return entry;
}

}  // namespace signorini
