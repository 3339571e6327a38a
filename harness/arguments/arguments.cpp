#include "harness/arguments/arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace signorini {

namespace {

// The parser takes the largest number for all above it.
std::string whole_in_64_bits(const std::string& word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool ok = error == std::errc{} && end == word.data() + word.size();
  return ok ? std::string{} : fmt::format("Value {} is no whole number, 0 to {}", word, UINT64_MAX);
}

}  // namespace

const Argument& Argument::required() const {
  option_->required();
  return *this;
}

const Argument& Argument::shows_default() const {
  option_->capture_default_str();
  return *this;
}

const Argument& Argument::type_name(std::string_view name) const {
  option_->type_name(std::string(name));
  return *this;
}

const Argument& Argument::one_word() const {
  option_->allow_extra_args(false);
  return *this;
}

const Argument& Argument::separated_by(char delimiter) const {
  option_->delimiter(delimiter);
  return *this;
}

const Argument& Argument::alone_means(std::string_view value) const {
  option_->expected(0, 1)->default_str(std::string(value))->run_callback_for_default(false);
  return *this;
}

const Argument& Argument::range(int least, int most) const {
  option_->check(CLI::Range(least, most));
  return *this;
}

const Argument& Argument::range(double least, double most) const {
  option_->check(CLI::Range(least, most));  // which takes nan
  const std::string reason = fmt::format("not in range {} to {}", least, most);
  option_->check([reason](const std::string& word) {
    double value = 0.0;
    const bool ok = CLI::detail::lexical_cast(word, value) && !std::isnan(value);
    return ok ? std::string{} : fmt::format("Value {} {}", word, reason);
  });
  return *this;
}

const Argument& Argument::one_of(const std::vector<std::string>& words) const {
  option_->check(CLI::IsMember(words));
  return *this;
}

const Argument& Argument::check(std::string (*complaint)(const std::string& word)) const {
  option_->check(complaint);
  return *this;
}

const Argument& Argument::needs(const Argument& other) const {
  option_->needs(other.option_);
  return *this;
}

const Argument& Argument::excludes(const Argument& other) const {
  option_->excludes(other.option_);
  return *this;
}

std::string positive_seconds(const std::string& word) {
  double value = 0.0;
  const bool ok = CLI::detail::lexical_cast(word, value) && std::isfinite(value) && value > 0.0;
  return ok ? std::string{} : fmt::format("timeout = {} (must be a positive number of seconds)", word);
}

Command Command::command(std::string_view name, std::string_view description) const {
  return Command(*app_->add_subcommand(std::string(name), std::string(description)));
}

void Command::require_command() const { app_->require_subcommand(1); }

template <ArgumentValue T>
Argument Command::option(std::string_view name, T& value, std::string_view description) const {
  CLI::Option* const option = app_->add_option(std::string(name), value, std::string(description));
  if constexpr (std::is_same_v<T, std::uint64_t>) option->check(whole_in_64_bits);
  return Argument(*option);
}

template Argument Command::option(std::string_view, std::string&, std::string_view) const;
template Argument Command::option(std::string_view, int&, std::string_view) const;
template Argument Command::option(std::string_view, unsigned&, std::string_view) const;
template Argument Command::option(std::string_view, std::uint64_t&, std::string_view) const;
template Argument Command::option(std::string_view, double&, std::string_view) const;
template Argument Command::option(std::string_view, std::optional<std::string>&, std::string_view) const;
template Argument Command::option(std::string_view, std::optional<int>&, std::string_view) const;
template Argument Command::option(std::string_view, std::optional<double>&, std::string_view) const;
template Argument Command::option(std::string_view, std::vector<std::string>&, std::string_view) const;
template Argument Command::option(std::string_view, std::vector<int>&, std::string_view) const;
template Argument Command::option(std::string_view, std::vector<double>&, std::string_view) const;

Argument Command::word_option(std::string_view name, std::function<void(const std::string&)> take,
                              std::string_view description) const {
  return Argument(*app_->add_option_function<std::string>(std::string(name), take, std::string(description)));
}

Argument Command::words_option(std::string_view name,
                               std::function<void(const std::vector<std::string>&)> take,
                               std::string_view description) const {
  return Argument(*app_->add_option_function<std::vector<std::string>>(std::string(name), take,
                                                                       std::string(description)));
}

Argument Command::flag(std::string_view name, bool& value, std::string_view description) const {
  return Argument(*app_->add_flag(std::string(name), value, std::string(description)));
}

void Command::take_rest() const { app_->allow_extras(); }

std::vector<std::string> Command::rest() const { return app_->remaining(); }

void Command::footer(std::string_view text) const { app_->footer(std::string(text)); }

void Command::on_run(std::function<void()> run) const { app_->callback(std::move(run)); }

std::string Command::name() const { return app_->get_name(); }

std::vector<Command> Command::commands() const {
  std::vector<Command> commands;
  for (CLI::App* app : app_->get_subcommands({})) commands.emplace_back(*app);
  return commands;
}

}  // namespace signorini
