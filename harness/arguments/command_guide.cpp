#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "harness/arguments/arguments.hpp"
#include "harness/text/columns.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

constexpr std::size_t kHelpIndent = 24;

constexpr std::array<CommandExample, 30> kExamples{{
    {"list", "signorini list scenes", "the scenes that ship, one a line"},
    {"list", "signorini list scenes 'beam*'", "some of them, by name or tag"},
    {"show", "signorini show hat-lcp", "the options of a method"},
    {"solve", "signorini solve sdof-stop --method exact-orbit", "one motion, and its accuracy"},
    {"solve", "signorini solve own.toml --method hat-lcp --set samples=512 --dofs 0,5 --plot own.svg",
     "a scene of one's own, two coordinates, a picture"},
    {"orbits", "signorini orbits sdof-two-sided", "coexisting periodic motions, stable or not"},
    {"motion", "signorini motion sdof-stop --starts 8", "where motions settle, or Lyapunov exponents"},
    {"reduce", "signorini reduce block-nine-contacts --out pad.toml",
     "a large structure as a small scene of one's own"},
    {"sweep", "signorini sweep sdof-stop --methods exact-orbit --from 0.5 --to 3 --plot response.svg",
     "the response curve with its unstable parts"},
    {"completion", "source <(signorini completion bash)", "completion in this shell"},
    {"man", "signorini man | man -l -", "the manual"},
    {"run", "signorini run quick --scenes own.toml:'sdof*' --methods 'hat-lcp:exact-orbit'",
     "two methods on a scene of one's own and some that ship"},
    {"report", "signorini report results/local-quick --format html", "a page with figures"},
    {"report", "signorini report results/mine theirs.tar.gz --out results/both --format html",
     "a run of one's own and a pack of somebody else's on one page"},
    {"compare", "signorini compare results/before results/after", "what got slower or less accurate"},
    {"history", "signorini history results/2026-* --plot history.svg", "what has become better, run by run"},
    {"verify", "signorini verify results/references", "whether kept orbits are found again"},
    {"verify", "signorini verify theirs.tar.gz --plugin march.toml",
     "whether the results of others are reproduced here"},
    {"pack", "signorini pack results/mine --out mine.tar.gz", "a run as one file, for others"},
    {"doctor", "signorini doctor", "before times are measured"},
    {"new", "signorini new scene my-scene", "a template of a scene"},
    {"new method", "signorini new method my-method --python", "a template of a method in Python"},
    {"new scene", "signorini new scene my-scene", "a template of a scene"},
    {"check", "signorini check --plugin my-method.toml", "the review of a method of one's own"},
    {"submit", "signorini submit slurm results/cluster --shards 8 catalogue", "a suite on a cluster"},
    {"submit slurm", "signorini submit slurm results/cluster --shards 8 catalogue", "a suite on a cluster"},
    {"submit parallel", "signorini submit parallel results/here --shards 2 quick", "on this machine"},
    {"status", "signorini status results/cluster", "how far it is"},
    {"merge", "signorini merge results/cluster/shard-* --out results/whole", "shards as one run"},
    {"merge", "signorini merge results/a results/b --out results/both", "two runs of one machine as one"},
}};

struct CommandGroup {
  const char* title;
  std::string_view commands;  // each followed by a blank
};

constexpr std::array<CommandGroup, 4> kGroups{{
    {"Use", "list show solve orbits motion sweep reduce completion man "},
    {"Judge", "run report compare history verify pack fetch doctor "},
    {"Extend", "new check "},
    {"Cluster", "submit status merge "},
}};

std::string indented(const std::vector<std::string>& lines, std::size_t indent) {
  return joined(lines, "\n" + std::string(indent, ' '));
}

std::string first_sentence(const std::string& text) {
  const std::size_t question = text.find("? ");
  if (question != std::string::npos) return text.substr(0, question + 1);
  std::string sentence = text.substr(0, std::min(text.find(". "), text.find("; ")));
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

std::string examples_of(const std::string& path) {
  std::string text;
  for (const CommandExample& example : kExamples) {
    if (example.command == path) text += fmt::format("  {}\n      {}\n", example.line, example.does);
  }
  return text.empty() ? text : "Examples:\n" + text;
}

/// CLI11's own, in lines of limited width.
class GuideFormatter final : public CLI::Formatter {
 public:
  std::string make_description(const CLI::App* app) const override {
    return indented(wrapped_lines(app->get_description(), kTerminalWidth), 0) + "\n";
  }
  std::string make_subcommand(const CLI::App* sub) const override {
    const auto lines = wrapped_lines(first_sentence(sub->get_description()), kTerminalWidth - kHelpIndent);
    return fmt::format("  {:<{}}{}\n", sub->get_name(), kHelpIndent - 2, indented(lines, kHelpIndent));
  }
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string name = make_option_name(option, is_positional) + make_option_opts(option);
    const auto lines = wrapped_lines(make_option_desc(option), kTerminalWidth - kHelpIndent);
    const bool beside = name.size() + 4 <= kHelpIndent;
    return fmt::format("  {:<{}}{}{}\n", name, beside ? kHelpIndent - 2 : 0,
                       beside ? "" : "\n" + std::string(kHelpIndent, ' '), indented(lines, kHelpIndent));
  }
  std::string make_footer(const CLI::App* app) const override {
    const std::string path = full_name(*app);
    const std::size_t blank = path.find(' ');
    const std::string footer = app->get_footer();
    const std::string text = footer.empty() ? "" : indented(wrapped_lines(footer, kTerminalWidth), 0) + "\n";
    if (blank != std::string::npos) return text + examples_of(path.substr(blank + 1));
    std::string examples = "Examples (signorini COMMAND --help has those of each command):\n";
    for (const char* command : {"solve", "run", "check", "submit"}) {
      const auto* const example = std::ranges::find_if(
          kExamples, [&](const CommandExample& one) { return one.command == std::string_view(command); });
      examples += fmt::format("  {}\n      {}\n", example->line, example->does);
    }
    return text + examples;
  }
};

}  // namespace

std::span<const CommandExample> command_examples() { return kExamples; }

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return (parent == nullptr ? "" : full_name(*parent) + " ") + command.get_name();
}

void guide_commands(const Command& program) {
  const auto formatter = std::make_shared<GuideFormatter>();
  program.app().formatter(formatter);
  for (const Command& command : program.commands()) {
    command.app().formatter(formatter);
    for (const Command& inner : command.commands()) inner.app().formatter(formatter);
    for (const CommandGroup& group : kGroups) {
      if (group.commands.find(command.name() + " ") != std::string_view::npos)
        command.app().group(group.title);
    }
  }
}

}  // namespace signorini
