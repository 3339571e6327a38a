#pragma once
// What commands say of their words, options and flags, and the line that is read by it; how --help, the
// manual and completion present the commands. CLI11, which reads lines, is known to the sources of this
// folder alone: whoever includes it compiles for seven seconds more.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
class Option;
}  // namespace CLI

namespace signorini {

/// What an option can be read into. An optional stays empty where the option is not given.
using ArgumentTarget = std::variant<std::string*, int*, unsigned*, std::uint64_t*, double*,
                                    std::optional<std::string>*, std::optional<int>*, std::optional<double>*,
                                    std::vector<std::string>*, std::vector<int>*, std::vector<double>*>;

/// An option, a flag or a word of a command, as the rules of others name it; null: none.
using Argument = CLI::Option*;

/// What is known of an option, a flag or a word beside its name; what is left out is not asked for.
struct ArgumentRules {
  /// A closed interval; none where `least` is above `most`.
  template <class Number>
  struct Range {
    Number least = 1, most = 0;
  };

  bool required = false;              ///< refuses a line without it
  std::string_view type_name = {};    ///< --help names its value so in place of TEXT
  bool one_word = false;              ///< it takes one word and may be repeated; words after that are others'
  char separated_by = '\0';           ///< its values may stand in one word, parted so
  std::string_view alone_means = {};  ///< it may stand without a value, and has this one then
  Range<int> range = {};              ///< refuses other numbers
  Range<double> interval = {};        ///< refuses other numbers
  std::vector<std::string> one_of = {};  ///< refuses other words; --help and completion name these
  /// Refuses what the function has a complaint about; an empty text is none.
  std::string (*complaint)(const std::string& word) = nullptr;
  Argument needs = nullptr;     ///< refuses it without this one
  Argument excludes = nullptr;  ///< refuses it beside this one
};

/// A complaint about what is no positive number of seconds, for ArgumentRules; that of CLI11 says what is
/// allowed by printing the largest double in full.
std::string positive_seconds(const std::string& word);

/// A line that is read, and what comes of it.
struct CommandLine {
  std::vector<std::string> words = {};  ///< the program's name first
  int exit_code = 0;                    ///< of the command that was run
};

/// A command, or the program itself, whose commands it has. Copies stand for the same one. What its options
/// are read into lives until the line has been parsed and the command has run.
class Command {
 public:
  Command(CLI::App& app, CommandLine& line) : app_(&app), line_(&line) {}

  /// A command of this one.
  [[nodiscard]] Command command(std::string_view name, std::string_view description) const;
  /// The same with the arguments that `run` is given where the line names it, for options to be read into; it
  /// returns the exit code, or nothing where there is none but 0.
  template <class Result, class Arguments>
  [[nodiscard]] std::pair<Command, std::shared_ptr<Arguments>> command(std::string_view name,
                                                                       Result (*run)(const Arguments&),
                                                                       std::string_view description) const {
    const Command made = command(name, description);
    const auto arguments = std::make_shared<Arguments>();
    made.on_run([arguments, run] {
      if constexpr (std::is_void_v<Result>) {
        run(*arguments);
        return 0;
      } else {
        return run(*arguments);
      }
    });
    return {made, arguments};
  }
  /// Refuses a line that names none of its commands.
  void require_command() const;

  /// An option "--name", or a word where the name has no dashes. Its value is converted into `value`; --help
  /// shows the one that it has now, unless that is empty, out of range, or the option is required.
  template <class T>
  Argument option(std::string_view name, T& value, std::string_view description,
                  const ArgumentRules& rules = {}) const {
    return add_option(name, &value, description, rules);
  }
  /// An option whose word, or whose words where it is repeated, go to a function.
  Argument word_option(std::string_view name, std::function<void(const std::string&)> take,
                       std::string_view description, const ArgumentRules& rules = {}) const;
  Argument words_option(std::string_view name, std::function<void(const std::vector<std::string>&)> take,
                        std::string_view description, const ArgumentRules& rules = {}) const;
  /// An option without a value, which sets `value` to true.
  Argument flag(std::string_view name, bool& value, std::string_view description,
                const ArgumentRules& rules = {}) const;

  /// Takes words that nothing else takes, see `rest`.
  void take_rest() const;
  /// The words that nothing has taken.
  [[nodiscard]] std::vector<std::string> rest() const;
  /// What --help says at its end.
  void footer(std::string_view text) const;
  /// What is done when the line has been read and names this command. \return the exit code
  void on_run(std::function<int()> run) const;
  /// The line, the program's name first.
  [[nodiscard]] const std::vector<std::string>& words() const { return line_->words; }

  [[nodiscard]] std::string name() const;
  /// Its commands, in the order in which they were added.
  [[nodiscard]] std::vector<Command> commands() const;
  /// For the sources of this folder.
  [[nodiscard]] CLI::App& app() const { return *app_; }

 private:
  Argument add_option(std::string_view name, const ArgumentTarget& target, std::string_view description,
                      const ArgumentRules& rules) const;

  CLI::App* app_;
  CommandLine* line_;
};

/// A line that cannot be read; what() is one line for the user, with what may have been meant.
class BadArguments : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A program with commands; they are added to `program()` before the line is read.
class ArgumentParser {
 public:
  /// \param words  of the line, the program's name first \param version  the text that --version prints
  ArgumentParser(std::vector<std::string> words, const std::string& description,
                 std::function<std::string()> version);
  ~ArgumentParser();
  ArgumentParser(const ArgumentParser&) = delete;
  ArgumentParser& operator=(const ArgumentParser&) = delete;

  [[nodiscard]] Command program();

  /// Reads the line, prepares and runs its command; --help and --version print their text instead.
  /// \return the exit code \throws BadArguments; and what the command throws
  int run(std::function<void()> prepare);

 private:
  CommandLine line_;
  std::unique_ptr<CLI::App> app_;
};

// How --help and the manual present the commands: in groups, each with an example.

/// One line to type, and what it does.
struct CommandExample {
  const char* command;  ///< "solve", "submit slurm"
  const char* line;     ///< the whole line
  const char* does;     ///< in a few words
};

/// At least one of every command, in the order of the groups.
std::span<const CommandExample> command_examples();

/// Puts the commands into their groups (Use, Judge, Extend, Cluster), and has every --help printed in lines
/// of 80 columns, with the examples of its command; that of the program says of each command the first
/// sentence.
void guide_commands(const Command& program);

/// A command with those that it belongs to, "signorini submit slurm".
std::string full_name(const CLI::App& command);

// The command line described for shells and for man, from what CLI11 knows of it: it cannot go stale.

/// A script for bash that completes commands, options and names, file names elsewhere.
std::string bash_completion(const Command& program);

/// The same for zsh, with descriptions.
std::string zsh_completion(const Command& program);

/// A page for man, section 1: every command with its options, examples, exit codes, files, environment.
std::string man_page(const Command& program);

}  // namespace signorini
