#pragma once
// What commands say of their words: options, flags, what may stand there. CLI11, which reads them, is known
// to the sources of this folder alone: whoever includes it compiles for seven seconds more.

#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
class Option;
}  // namespace CLI

namespace signorini {

/// What an option can be read into. An optional stays empty where the option is not given.
template <class T>
concept ArgumentValue = std::same_as<T, std::string> || std::same_as<T, int> || std::same_as<T, unsigned> ||
    std::same_as<T, std::uint64_t> || std::same_as<T, double> ||
    std::same_as<T, std::optional<std::string>> || std::same_as<T, std::optional<int>> ||
    std::same_as<T, std::optional<double>> || std::same_as<T, std::vector<std::string>> ||
    std::same_as<T, std::vector<int>> || std::same_as<T, std::vector<double>>;

/// An option, a flag or a word of a command. Copies stand for the same one; each function returns it for the
/// next.
class Argument {
 public:
  explicit Argument(CLI::Option& option) : option_(&option) {}

  /// Refuses a line without it.
  const Argument& required() const;
  /// --help shows the value that its variable has now.
  const Argument& shows_default() const;
  /// --help names its value so in place of TEXT.
  const Argument& type_name(std::string_view name) const;
  /// It takes one word, and may be repeated: words after that are no more of its values.
  const Argument& one_word() const;
  /// Its values may stand in one word, parted so.
  const Argument& separated_by(char delimiter) const;
  /// It may stand without a value, and has this one then.
  const Argument& alone_means(std::string_view value) const;
  /// Refuses numbers outside of the closed interval.
  const Argument& range(int least, int most) const;
  const Argument& range(double least, double most) const;
  /// Refuses other words; --help and completion name these.
  const Argument& one_of(const std::vector<std::string>& words) const;
  /// Refuses what the function has a complaint about; an empty text is none.
  const Argument& check(std::string (*complaint)(const std::string& word)) const;
  /// Refuses it without the other one.
  const Argument& needs(const Argument& other) const;
  /// Refuses it beside the other one.
  const Argument& excludes(const Argument& other) const;

 private:
  CLI::Option* option_;
};

/// A complaint about what is no positive number of seconds, for Argument::check; that of CLI11 says what is
/// allowed by printing the largest double in full.
std::string positive_seconds(const std::string& word);

/// A command, or the program itself, whose commands it has. Copies stand for the same one. What its options
/// are read into lives until the line has been parsed and the command has run.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  /// A command of this one.
  [[nodiscard]] Command command(std::string_view name, std::string_view description) const;
  /// Refuses a line that names none of its commands.
  void require_command() const;

  /// An option "--name", or a word where the name has no dashes. Its value is converted into `value`.
  template <ArgumentValue T>
  Argument option(std::string_view name, T& value, std::string_view description) const;
  /// An option whose word, or whose words where it is repeated, go to a function.
  Argument word_option(std::string_view name, std::function<void(const std::string&)> take,
                       std::string_view description) const;
  Argument words_option(std::string_view name, std::function<void(const std::vector<std::string>&)> take,
                        std::string_view description) const;
  /// An option without a value, which sets `value` to true.
  Argument flag(std::string_view name, bool& value, std::string_view description) const;

  /// Takes words that nothing else takes, see `rest`.
  void take_rest() const;
  /// The words that nothing has taken.
  [[nodiscard]] std::vector<std::string> rest() const;
  /// What --help says at its end.
  void footer(std::string_view text) const;
  /// What is done when the line has been read and names this command.
  void on_run(std::function<void()> run) const;

  [[nodiscard]] std::string name() const;
  /// Its commands, in the order in which they were added.
  [[nodiscard]] std::vector<Command> commands() const;
  /// For the sources of this folder.
  [[nodiscard]] CLI::App& app() const { return *app_; }

 private:
  CLI::App* app_;
};

}  // namespace signorini
