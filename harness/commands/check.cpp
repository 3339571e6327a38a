#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "harness/cluster/scripts.hpp"
#include "harness/commands/command_line.hpp"
#include "harness/conformance/check_result.hpp"
#include "harness/conformance/check_runner.hpp"
#include "harness/extend/plugins/plugins.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/plan/suite.hpp"
#include "harness/progress.hpp"
#include "harness/text/json.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

struct CheckArguments {
  std::optional<std::string> method;
  bool all = false;
  std::string suite = "easy";
  std::vector<std::string> scenes;
  std::string checks = "*";
  double timeout = CheckOptions{}.timeout;
  bool json = false;
};

/// The method that was named; all methods; or else those of plugins.
std::vector<const MethodEntry*> methods_of(const CheckArguments& arguments) {
  if (arguments.method && !arguments.all) return {&find_method(*arguments.method)};
  std::vector<const MethodEntry*> entries;
  for (const MethodEntry& entry : method_catalogue()) {
    if (arguments.all || !entry.plugin.empty()) entries.push_back(&entry);
  }
  if (arguments.method || entries.empty())
    throw UsageError(
        fmt::format("method = {} (must be a method, or --all without one, or left out with --plugin)",
                    arguments.method.value_or("missing")));
  return entries;
}

/// The scenes of the suite, or those of --scenes among all that ship and one's own files.
std::vector<Scene> scenes_of(const CheckArguments& arguments) {
  const Suite all{.name = "of all that ship", .scenes = {"*"}};
  std::vector<Scene> scenes = choose_scenes(arguments.scenes.empty() ? load_suite(arguments.suite) : all,
                                            arguments.scenes, shipped_scenes());
  // The commands that show a failure again must find the scene by this name.
  for (Scene& scene : scenes) scene.problem.name = scene.word;
  return scenes;
}

/// The words that load the plugins again, " --plugin march.toml".
std::string plugin_words() {
  std::string words;
  for (const std::string& file : given_plugins()) words += " --plugin " + shell_word(file);
  return words;
}

int check(const CheckArguments& arguments) {
  const std::vector<const MethodEntry*> methods = methods_of(arguments);
  const CheckOptions options{
      .scenes = scenes_of(arguments), .checks = arguments.checks, .timeout = arguments.timeout};
  watch_interrupts();
  bool failed = false;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  Progress progress(methods.size());
  for (const MethodEntry* entry : methods) {
    const std::vector<CheckResult> results =
        check_method(*entry, options, [&](const std::string& what) { progress.begin(what); });
    if (interrupted()) break;
    failed = failed || any_failed(results);
    progress.advance();
    if (arguments.json) {
      for (const CheckResult& result : results) {
        list.push_back({{"method", entry->name}});
        list.back().update(to_json(result));
        if (!result.reproduce.empty()) list.back()["reproduce"] = result.reproduce + plugin_words();
      }
    } else {
      fmt::print("{}{}", entry == methods.front() ? "" : "\n", review_text(*entry, results, plugin_words()));
      std::fflush(stdout);
    }
  }
  if (interrupted()) {
    fmt::print(stderr, "interrupted\n");
    return kInterrupted;
  }
  if (arguments.json) fmt::print("{}\n", json_line(list));
  return failed ? kUnexpectedFailure : kDone;
}

}  // namespace

void add_check_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "check", check,
      "Runs the tests that every method must pass: declared options and laws, determinism, time budget, "
      "invariances, convergence, and no answer that is proved wrong. Exit code 1 if something failed.");
  command.option("method", arguments->method, "method name; see `signorini list methods`");
  command.flag("--all", arguments->all, "every method there is");
  command.option("--suite", arguments->suite, "whose scenes are asked about");
  command.option("--scenes", arguments->scenes,
                 "instead: scenes by glob, A*:B*-C*, of all that ship, and files or folders of one's own; "
                 "may be repeated",
                 {.one_word = true});
  command.option("--checks", arguments->checks, fmt::format("by glob, of {}", joined(check_names(), ", ")));
  command.option("--timeout", arguments->timeout, "processor time of one solve [s]",
                 {.complaint = positive_seconds});
  command.flag("--json", arguments->json, "print the findings as a JSON array");
}

}  // namespace signorini
