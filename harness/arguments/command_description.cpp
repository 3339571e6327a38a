#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/arguments/arguments.hpp"
#include "harness/build_info.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// A command with its full name, "submit slurm".
struct Page {
  std::string path;
  const CLI::App* command;
};

/// All commands in the order of a manual: "submit" before "submit slurm".
std::vector<Page> pages(const CLI::App& app, const std::string& path = "") {
  std::vector<Page> found;
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::string name = path.empty() ? command->get_name() : path + " " + command->get_name();
    found.push_back({name, command});
    const std::vector<Page> inner = pages(*command, name);
    found.insert(found.end(), inner.begin(), inner.end());
  }
  return found;
}

/// The values that an option takes, where they are few and known: of its check, which CLI11 shows as
/// "{md,csv}".
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  return split(type.substr(begin + 1, end - begin - 1), ',');
}

/// Values of the words without a dash that may follow a command.
std::vector<std::string> positional_choices(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::Option* option : app.get_options())
    if (option->get_lnames().empty())
      for (std::string& word : choices_of(*option)) words.push_back(std::move(word));
  return words;
}

/// The words that may follow a command: its own commands, long options and known values.
std::vector<std::string> words_after(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::App* command : app.get_subcommands({})) words.push_back(command->get_name());
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  std::ranges::copy(positional_choices(app), std::back_inserter(words));
  return words;
}

/// What bash and zsh alike do about a command's options with known values. \param then  what to do with them
template <class Then>
std::string choice_cases(const CLI::App& app, const char* before, const Then& then) {
  std::string cases;
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string> choices = choices_of(*option);
    if (choices.empty() || option->get_lnames().empty()) continue;
    cases += fmt::format("      --{}) {} ;;\n", option->get_lnames().front(), then(joined(choices, " ")));
  }
  return cases.empty() ? "" : fmt::format("      case \"{}\" in\n{}      esac\n", before, cases);
}

/// An entry 'word:description' for zsh's _describe.
std::string zsh_entry(const std::string& word, const std::string& description) {
  const std::string quoted = replaced(description, "'", "'\\''");
  return fmt::format("'{}:{}'", word, replaced(quoted, ":", "\\:"));
}

std::string zsh_entries(const CLI::App& app) {
  std::string entries;
  for (const CLI::App* command : app.get_subcommands({}))
    entries += "      " + zsh_entry(command->get_name(), command->get_description()) + "\n";
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames())
      entries += "      " + zsh_entry("--" + name, option->get_description()) + "\n";
  }
  for (const std::string& word : positional_choices(app)) entries += fmt::format("      '{}'\n", word);
  return entries;
}

/// Text with the characters escaped that mean something to troff.
std::string roff(const std::string& text) {
  std::string safe = replaced(text, "\\", "\\e");
  safe = replaced(safe, "-", "\\-");
  if (!safe.empty() && (safe.front() == '.' || safe.front() == '\'')) safe.insert(0, "\\&");
  return safe;
}

/// The branches of a shell's `case` on the words so far: one per command, the longest path first, and one for
/// no command yet.
template <class Branch>
std::string branches(const CLI::App& app, const Branch& branch) {
  std::string text;
  std::vector<Page> commands = pages(app);
  std::reverse(commands.begin(), commands.end());
  for (const Page& page : commands) text += branch(fmt::format("'{} '*", page.path), *page.command);
  return text + branch("*", app);
}

std::string roff_option(const CLI::Option& option) {
  const bool positional = option.get_positional() && option.get_lnames().empty();
  std::string name = positional ? option.get_name(true) : option.get_name(false, true);
  if (option.get_items_expected_max() > 0 && !positional) name += " " + option.get_type_name();
  std::string text = option.get_description();
  if (!option.get_default_str().empty()) text += fmt::format(" [{}]", option.get_default_str());
  return fmt::format(".TP\n.B {}\n{}\n", roff(name), roff(text));
}

std::string roff_command(const Page& page) {
  std::string text = fmt::format(".SS {}\n{}\n", roff(page.path), roff(page.command->get_description()));
  for (const CLI::Option* option : page.command->get_options()) text += roff_option(*option);
  const std::string footer = page.command->get_footer();
  return footer.empty() ? text : text + fmt::format(".PP\n{}\n", roff(footer));
}

/// What the words without a dash after a command are, for `signorini list`.
std::string_view names_after(const std::string& command) {
  if (command == "solve" || command == "sweep" || command == "orbits" || command == "motion" ||
      command == "reduce")
    return "scenes";
  if (command == "show") return "scenes methods";
  if (command == "check") return "methods";
  return command == "run" ? "suites" : "";
}

/// The functions of the script for bash that ask the program for names, so that they are those of the scenes,
/// methods and suites that are there when the key is pressed.
constexpr const char* kBashFunctions =
    R"sh(# Completion of signorini for bash, written by `signorini completion bash`.
_signorini_names() {
  local kind
  for kind in $1; do
    "${COMP_WORDS[0]}" list "$kind" 2>/dev/null | sed -n 's/^\([^ ]\{1,\}\) .*/\1/p'
  done
}
# The options of the method that the line names, each with the sign that follows it.
_signorini_settings() {
  local i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [ "${COMP_WORDS[i]}" != --method ] || "${COMP_WORDS[0]}" show "${COMP_WORDS[i + 1]}" 2>/dev/null |
      sed -n '/^options/,$s/^  \([a-z_]\{1,\}\) .*/\1=/p'
  done
}
_signorini() {
  local words names= word="${COMP_WORDS[COMP_CWORD]}"
)sh";

/// The same functions for zsh; names come with their titles.
constexpr const char* kZshFunctions =
    R"sh(#compdef signorini
# Completion of signorini for zsh, written by `signorini completion zsh`.
_signorini_names() {
  local kind
  for kind in ${=1}; do
    "${words[1]}" list "$kind" 2>/dev/null | sed -n 's/^\([^ :]\{1,\}\) \{1,\}\(.*\)$/\1:\2/p'
  done
}
# The options of the method that the line names, each with the sign that follows it.
_signorini_settings() {
  local i=${words[(I)--method]}
  (( i == 0 )) || "${words[1]}" show "${words[i + 1]}" 2>/dev/null |
    sed -n '/^options/,$s/^  \([a-z_]\{1,\}\) \{1,\}\(.*\)$/\1=:\2/p'
}
local -a entries names settings
local kinds= found=1
)sh";

struct NamedThing {
  const char* name;
  const char* meaning;
};

constexpr std::array<NamedThing, 9> kFiles{{
    {"problems/catalogue/*.toml, problems/families/*.toml",
     "the scenes that ship, in share/signorini of an installed program"},
    {"problems/suites/*.toml", "the suites"},
    {"results/references/*.json", "the orbits that are kept of each scene"},
    {"results/local-SUITE/",
     "folder of a run unless --out names another; of a single scene of one's own results/local-SCENE/"},
    {"DIR/records.jsonl", "one record a line, each case of a run; docs/records.md has the keys"},
    {"DIR/manifest.json, DIR/plan.txt", "build, machine and limits of a run; its cases"},
    {"DIR/branches.jsonl", "of sweep --out: a line per branch or step, as sweep --format jsonl prints them"},
    {"DIR/table.md, DIR/table.csv, DIR/measures.csv", "tables, written by run and report"},
    {"DIR/report.html, DIR/figures/, DIR/tables/", "page, figures and tables for LaTeX, written by report"},
}};

constexpr std::array<NamedThing, 3> kVariables{{
    {"SIGNORINI_PROBLEMS", "folder with catalogue, families and suites, in place of those that ship"},
    {"SIGNORINI_PLUGIN_PATH", "folders whose *.so and *.toml are loaded as methods, separated by colons"},
    {"NO_COLOR", "if not empty, nothing is coloured; nothing ever is into a pipe"},
}};

}  // namespace

std::string bash_completion(const Command& program) {
  const CLI::App& app = program.app();
  std::string text = kBashFunctions;
  text += "  case \"${COMP_WORDS[*]:1:COMP_CWORD-1} \" in\n";
  text += branches(app, [](const std::string& pattern, const CLI::App& command) {
    return fmt::format("    {}) words='{}' names='{}'\n{}      ;;\n", pattern,
                       joined(words_after(command), " "), names_after(command.get_name()),
                       choice_cases(command, "${COMP_WORDS[COMP_CWORD - 1]}", [](const std::string& choices) {
                         return fmt::format("words='{}' names=", choices);
                       }));
  });
  return text + R"sh(  esac
  case "${COMP_WORDS[COMP_CWORD - 1]}" in
    --method | --methods) words= names=methods ;;
    --scenes) words= names=scenes ;;
    --suite) words= names=suites ;;
    --set) words=$(_signorini_settings) names= ;;
  esac
  [[ $word == -* ]] || words="$words $(_signorini_names "$names")"
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o default -F _signorini signorini
)sh";
}

std::string zsh_completion(const Command& program) {
  const CLI::App& app = program.app();
  std::string text = std::string(kZshFunctions) + "case \"${words[2,CURRENT-1]} \" in\n";
  text += branches(app, [](const std::string& pattern, const CLI::App& command) {
    return fmt::format("  {})\n    kinds='{}'\n    entries=(\n{}    )\n{}    ;;\n", pattern,
                       names_after(command.get_name()), zsh_entries(command),
                       choice_cases(command, "${words[CURRENT - 1]}", [](const std::string& choices) {
                         return fmt::format("kinds= entries=({})", choices);
                       }));
  });
  return text + R"sh(esac
case "${words[CURRENT - 1]}" in
  --method | --methods) entries=() kinds=methods ;;
  --scenes) entries=() kinds=scenes ;;
  --suite) entries=() kinds=suites ;;
  --set) entries=() kinds= settings=(${(f)"$(_signorini_settings)"}) ;;
esac
[[ -z $kinds || ${words[CURRENT]} == -* ]] || names=(${(f)"$(_signorini_names $kinds)"})
(( ${#entries} )) && _describe 'command or option' entries && found=0
(( ${#names} )) && _describe 'name' names && found=0
(( ${#settings} )) && _describe 'setting' settings -S '' && found=0
(( ! found )) || _files
)sh";
}

std::string man_page(const Command& program) {
  const CLI::App& app = program.app();
  std::string text = fmt::format(
      ".TH SIGNORINI 1 \"\" \"signorini {}\"\n.SH NAME\nsignorini \\- {}\n"
      ".SH SYNOPSIS\n.B signorini\n.I COMMAND\n[\\fIARGUMENTS\\fR]\n"
      ".SH DESCRIPTION\n{}\nResults go to standard output, remarks to standard error.\n.SH COMMANDS\n",
      build_info().version, roff("compares methods for periodic vibrations with unilateral contact"),
      roff(app.get_description()));
  for (const Page& page : pages(app)) text += roff_command(page);
  text += ".SH EXAMPLES\n";
  for (const CommandExample& example : command_examples())
    text += fmt::format(".TP\n.B {}\n{}\n", roff(example.line), roff(example.does));
  text +=
      ".SH EXIT STATUS\n.TP\n.B 0\ndone\n.TP\n.B 1\nsomething did not converge that was not expected to "
      "fail, or "
      "verify found a difference, or a check failed\n.TP\n.B 2\nbad input or usage\n.TP\n.B 3\nthe filter "
      "matched "
      "nothing\n.TP\n.B 4\n"
      "compare found a regression\n.TP\n.B 5\ninternal error\n.TP\n.B 6\na sweep is incomplete\n.TP\n.B "
      "130\ninterrupted, resumable\n";
  for (const auto& [section, entries] : {std::pair("FILES", std::span<const NamedThing>(kFiles)),
                                         std::pair("ENVIRONMENT", std::span<const NamedThing>(kVariables))}) {
    text += fmt::format(".SH {}\n", section);
    for (const auto& [name, meaning] : entries)
      text += fmt::format(".TP\n.I {}\n{}\n", roff(name), roff(meaning));
  }
  return text;
}

}  // namespace signorini
