#include "harness/arguments/argument_parser.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "problems/files/close_names.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

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
  return fmt::format("{} (see `{} --help`)", one_line(line, 500), full_name(Command(command)));
}

}  // namespace

ArgumentParser::ArgumentParser(const std::string& name, const std::string& description,
                               std::function<std::string()> version)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->set_version_flag("--version", std::move(version));
}

ArgumentParser::~ArgumentParser() = default;

Command ArgumentParser::program() const { return Command(*app_); }

void ArgumentParser::before_run(std::function<void()> prepare) {
  app_->parse_complete_callback(std::move(prepare));
}

void ArgumentParser::run(std::vector<std::string> words) {
  try {
    std::ranges::reverse(words);  // CLI11 takes the last word first
    app_->parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw BadArguments(complaint(*app_, error));
    app_->exit(error);  // --help, --version
  }
}

}  // namespace signorini
