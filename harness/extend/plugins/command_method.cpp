#include "harness/extend/plugins/command_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/extend/plugins/curve_exchange.hpp"
#include "harness/failure.hpp"
#include "harness/plan/plan.hpp"
#include "harness/run/trial.hpp"
#include "problems/files/toml_tree.hpp"

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

constexpr const char* kStoppedCommand = "the command was stopped at the time limit";

/// What a command printed within its time. \throws SolveFailure
const std::string& output_of(const CommandEnd& end) {
  if (end.unasked) {
    throw SolveFailure(Status::invalid_output,
                       "the command's answer: more than one line (must be one for each request)");
  }
  if (!end.failure.empty()) {
    const std::string words = end.last_words.empty() ? "" : ": " + one_line(end.last_words, 400);
    throw SolveFailure(Status::crashed, end.failure + words, end.signal);
  }
  return end.output;
}

/// \throws SolveFailure for a command that says it took more than that
void require_within(double seconds, double passed) {
  if (seconds <= passed) return;
  throw SolveFailure(
      Status::invalid_output,
      fmt::format("the command's answer: seconds = {} (must be at most the {:.6g} s that passed)", seconds,
                  passed));
}

/// A told time, but of the time that passed at least what a hand-over does not explain: so many seconds, and
/// so many times what writing the request and reading the answer took here.
double believed(double told, double passed, double hand_over) {
  constexpr double kSeconds = 0.05, kTimes = 10.0;
  return std::max(told, passed - kSeconds - kTimes * hand_over);
}

/// One scene, its request written.
class PreparedCommand final : public PreparedMethod {
 public:
  PreparedCommand(const CommandDescription& description, const Problem& problem,
                  const std::vector<OptionEcho>& options)
      : words_(description.words), period_(problem.period()), request_(command_request(problem, options)) {
    if (!description.persistent) return;
    request_["persistent"] = true;
    session_ = std::make_unique<CommandSession>(words_);
  }

  Solution solve(const Start& start) override {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t writing = std::clock();
    const std::string input = command_input(request_, start);
    const std::clock_t written = std::clock();
    const CommandEnd end =
        session_ ? session_->ask(input, start.deadline) : run_command(words_, input, start.deadline);
    times_.last.reset();
    // By the processor time of another process, which `start` does not see.
    if (end.expired) throw SolveFailure(Status::timeout, kStoppedCommand);
    const std::clock_t reading = std::clock();
    CommandAnswer answer = read_command_answer(output_of(end), period_);
    const std::clock_t ticks = (written - writing) + (std::clock() - reading);
    const double hand_over = static_cast<double>(ticks) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    if (!answer.seconds) return std::move(answer.solution);
    require_within(*answer.seconds, passed.count());
    // What else passes until a command that does not stay answers is its start, or so it says.
    if (!session_) return std::move(answer.solution);
    times_.last = believed(*answer.seconds, passed.count(), hand_over);
    times_.least_exchange =
        std::min(times_.least_exchange.value_or(passed.count()), passed.count() - *times_.last);
    return std::move(answer.solution);
  }

  bool take_frequency(const Problem& problem) override {
    signorini::take_frequency(request_, problem);
    period_ = problem.period();
    return true;
  }

  [[nodiscard]] OwnTimes own_times() const override { return times_; }

 private:
  std::vector<std::string> words_;
  double period_;
  nlohmann::ordered_json request_;
  std::unique_ptr<CommandSession> session_;  ///< null: started for each solve
  OwnTimes times_;
};

/// Runs the command once for each solve, or once for all of a prepared scene, in a process group of its own
/// that is killed at the deadline. Its time is the one that a command that stays tells, as far as it is
/// believed, else all that passes, its start included.
/// docs/plugins.md states what it reads and prints.
class CommandMethod final : public Method, public CurveMethod {
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
    if (!description_.represents.on(problem.law()))
      return {false, "its description names no law for this scene's"};
    const auto exceeds = [](int count, const std::optional<int>& most) { return most && count > *most; };
    if (exceeds(problem.size(), description_.most_coordinates))
      return {false, fmt::format("more than {} coordinates", *description_.most_coordinates)};
    if (exceeds(problem.contact_count(), description_.most_contacts))
      return {false, fmt::format("more than {} contacts", *description_.most_contacts)};
    return {};
  }

  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override {
    return description_.represents.on(problem.law()).value_or(Undetermined{});
  }

  /// `solve` throws SolveFailure where the command crashes, prints no answer or is stopped.
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override {
    return std::make_unique<PreparedCommand>(description_, problem, options());
  }

  [[nodiscard]] const CurveMethod* curve() const override { return description_.curves ? this : nullptr; }

  [[nodiscard]] Support follows(const ParametrisedScene& scene) const override {
    if (follows_speed(scene.at(scene.from)))
      return {false, "matrices that follow the frequency are not told to a command: sweep with --natural"};
    return follows_frequency(*this, scene);
  }

  /// Throws SolveFailure where the command crashes or prints no curve; what a command took counts by the
  /// clock.
  [[nodiscard]] BranchDiagram follow(const ParametrisedScene& scene,
                                     const CurveLimits& limits) const override {
    const Problem problem = scene.at(scene.from);
    nlohmann::ordered_json request = command_request(problem, options());
    request["follow"] = follow_request(scene, limits);
    const std::string input = command_input(std::move(request), {.guess = {}, .deadline = limits.deadline});
    const auto begin = std::chrono::steady_clock::now();
    const CommandEnd end = run_command(description_.words, input, limits.deadline);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    BranchDiagram diagram;
    if (end.expired)
      diagram.unfinished = kStoppedCommand;
    else
      diagram = read_command_curve(output_of(end), scene, problem.contact_count(), limits);
    require_within(diagram.seconds.value_or(0.0), passed.count());
    diagram.seconds = std::max(diagram.seconds.value_or(passed.count()), kLeastShare * passed.count());
    return diagram;
  }

 private:
  CommandDescription description_;  ///< its options with the values that are set
};

}  // namespace

MethodEntry load_command_method(const std::filesystem::path& file) {
  const CommandDescription description = read_command_file(file);
  MethodEntry entry{
      .name = description.name,
      .title = description.title,
      .laws = description.represents.text(),
      .ladder = description.ladder,
      .make = [description](std::span<const OptionSetting> settings) -> std::unique_ptr<Method> {
        if (description.branches && settings.empty())
          return method_of_branches(description.branches,
                                    [laws = description.represents](const Law& law) { return laws.on(law); });
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
    throw UsageError("{}: ladder = {} ({})", file.string(), entry.ladder, error.what());
  } catch (const InvalidOption& error) {
    throw UsageError("{}: {}", file.string(), error.what());
  }
  return entry;
}

}  // namespace signorini
