#include "harness/arguments/arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <utility>

#include "problems/files/close_names.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

// The parser takes the largest number for all above it.
std::string whole_in_64_bits(const std::string& word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool ok = error == std::errc{} && end == word.data() + word.size();
  return ok ? std::string{} : fmt::format("Value {} is no whole number, 0 to {}", word, UINT64_MAX);
}

std::string number_or_complaint(const std::string& word, double least, double most) {
  double value = 0.0;
  const bool ok = CLI::detail::lexical_cast(word, value) && !std::isnan(value);
  return ok ? std::string{} : fmt::format("Value {} not in range {} to {}", word, least, most);
}

/// --help shows no value that is out of range, or that has to be given.
void hide_default(CLI::Option& option, const ArgumentRules& rules) {
  int value = 0;
  const auto [least, most] = rules.range;
  const bool outside = least <= most && CLI::detail::lexical_cast(option.get_default_str(), value) &&
                       (value < least || value > most);
  if (rules.required || outside) option.default_str("");
}

Argument ruled(CLI::Option* option, const ArgumentRules& rules) {
  hide_default(*option, rules);
  option->required(rules.required);
  if (!rules.type_name.empty()) option->type_name(std::string(rules.type_name));
  if (rules.one_word) option->allow_extra_args(false);
  if (rules.separated_by != '\0') option->delimiter(rules.separated_by);
  if (!rules.alone_means.empty())
    option->expected(0, 1)->default_str(std::string(rules.alone_means))->run_callback_for_default(false);
  if (rules.range.least <= rules.range.most) option->check(CLI::Range(rules.range.least, rules.range.most));
  if (const auto interval = rules.interval; interval.least <= interval.most) {
    option->check(CLI::Range(interval.least, interval.most));  // which takes nan
    option->check([interval](const std::string& word) {
      return number_or_complaint(word, interval.least, interval.most);
    });
  }
  if (!rules.one_of.empty()) option->check(CLI::IsMember(rules.one_of));
  if (rules.complaint != nullptr) option->check(rules.complaint);
  if (rules.needs != nullptr) option->needs(rules.needs);
  if (rules.excludes != nullptr) option->excludes(rules.excludes);
  return option;
}

/// The command that the words lead to.
CLI::App& command_read(CLI::App& app) {
  const std::vector<CLI::App*> read = app.get_subcommands();
  return read.empty() ? app : command_read(*read.front());
}

/// Options that words left over may have meant; several scenes that a shell made of one pattern.
std::string hint_for_rest(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const std::string& word : command.remaining()) {
    if (word.ends_with(".toml")) return "; several scenes: --scenes A.toml:B.toml, or the pattern in quotes";
    if (!word.starts_with("--")) continue;
    const std::string hint = suggestion(word.substr(0, word.find('=')), names);
    if (!hint.empty()) return "; " + word + ": " + hint.substr(2);
  }
  return {};
}

/// Why the line cannot be read.
std::string complaint(CLI::App& app, const CLI::ParseError& error) {
  CLI::App& command = command_read(app);
  std::string line = error.what();
  line = line.substr(0, line.find('\n'));
  line += hint_for_rest(command);
  return fmt::format("{} (see `{} --help`)", one_line(line, 500), full_name(command));
}

}  // namespace

std::string positive_seconds(const std::string& word) {
  double value = 0.0;
  const bool ok = CLI::detail::lexical_cast(word, value) && std::isfinite(value) && value > 0.0;
  return ok ? std::string{} : fmt::format("timeout = {} (must be a positive number of seconds)", word);
}

Command Command::command(std::string_view name, std::string_view description) const {
  return {*app_->add_subcommand(std::string(name), std::string(description)), *line_};
}

void Command::require_command() const { app_->require_subcommand(1); }

Argument Command::add_option(std::string_view name, const ArgumentTarget& target,
                             std::string_view description, const ArgumentRules& rules) const {
  return std::visit(
      [&]<class T>(T* value) {
        CLI::Option* const option = app_->add_option(std::string(name), *value, std::string(description));
        if constexpr (std::is_same_v<T, std::uint64_t>) option->check(whole_in_64_bits);
        if constexpr (std::is_arithmetic_v<T>) {
          option->capture_default_str();
        } else if constexpr (requires { value->empty(); }) {
          if (!value->empty()) option->capture_default_str();
        }
        return ruled(option, rules);
      },
      target);
}

Argument Command::word_option(std::string_view name, std::function<void(const std::string&)> take,
                              std::string_view description, const ArgumentRules& rules) const {
  return ruled(app_->add_option_function<std::string>(std::string(name), take, std::string(description)),
               rules);
}

Argument Command::words_option(std::string_view name,
                               std::function<void(const std::vector<std::string>&)> take,
                               std::string_view description, const ArgumentRules& rules) const {
  return ruled(
      app_->add_option_function<std::vector<std::string>>(std::string(name), take, std::string(description)),
      rules);
}

Argument Command::flag(std::string_view name, bool& value, std::string_view description,
                       const ArgumentRules& rules) const {
  return ruled(app_->add_flag(std::string(name), value, std::string(description)), rules);
}

void Command::take_rest() const { app_->allow_extras(); }

std::vector<std::string> Command::rest() const { return app_->remaining(); }

void Command::footer(std::string_view text) const { app_->footer(std::string(text)); }

void Command::on_run(std::function<int()> run) const {
  app_->callback([line = line_, run = std::move(run)] { line->exit_code = run(); });
}

std::string Command::name() const { return app_->get_name(); }

std::vector<Command> Command::commands() const {
  std::vector<Command> commands;
  for (CLI::App* app : app_->get_subcommands({})) commands.emplace_back(*app, *line_);
  return commands;
}

ArgumentParser::ArgumentParser(std::vector<std::string> words, const std::string& description,
                               std::function<std::string()> version)
    : line_{.words = std::move(words)}, app_(std::make_unique<CLI::App>(description, line_.words.front())) {
  app_->set_version_flag("--version", std::move(version));
}

ArgumentParser::~ArgumentParser() = default;

Command ArgumentParser::program() { return {*app_, line_}; }

int ArgumentParser::run(std::function<void()> prepare) {
  app_->parse_complete_callback(std::move(prepare));
  try {
    app_->parse(
        std::vector<std::string>(line_.words.rbegin(), line_.words.rend() - 1));  // the last word first
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw BadArguments(complaint(*app_, error));
    app_->exit(error);  // --help, --version
  }
  return line_.exit_code;
}

}  // namespace signorini
