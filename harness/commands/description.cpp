// The command line described for shells and for man, from what CLI11 knows of it: it cannot go stale.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <memory>
#include <vector>

#include "harness/build_info.hpp"
#include "harness/commands/command_line.hpp"

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

/// The words that may follow a command: its own commands and long options.
std::vector<std::string> words_after(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::App* command : app.get_subcommands({})) words.push_back(command->get_name());
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  return words;
}

/// An entry 'word:description' for zsh's _describe.
std::string zsh_entry(const std::string& word, const std::string& description) {
  const std::string quoted = boost::replace_all_copy(description, "'", "'\\''");
  return fmt::format("'{}:{}'", word, boost::replace_all_copy(quoted, ":", "\\:"));
}

std::string zsh_entries(const CLI::App& app) {
  std::string entries;
  for (const CLI::App* command : app.get_subcommands({}))
    entries += "      " + zsh_entry(command->get_name(), command->get_description()) + "\n";
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames())
      entries += "      " + zsh_entry("--" + name, option->get_description()) + "\n";
  }
  return entries;
}

/// Text with the characters escaped that mean something to troff.
std::string roff(const std::string& text) {
  std::string safe = boost::replace_all_copy(text, "\\", "\\e");
  boost::replace_all(safe, "-", "\\-");
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

/// A script for bash that completes commands and options, file names elsewhere.
std::string bash_completion(const CLI::App& app) {
  std::string text =
      "# Completion of signorini for bash, written by `signorini completion bash`.\n"
      "_signorini() {\n"
      "  local words\n"
      "  case \"${COMP_WORDS[*]:1:COMP_CWORD-1} \" in\n";
  text += branches(app, [](const std::string& pattern, const CLI::App& command) {
    return fmt::format("    {}) words='{}' ;;\n", pattern, fmt::join(words_after(command), " "));
  });
  return text +
         "  esac\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"${COMP_WORDS[COMP_CWORD]}\")\n"
         "}\n"
         "complete -o default -F _signorini signorini\n";
}

/// The same for zsh, with descriptions.
std::string zsh_completion(const CLI::App& app) {
  std::string text =
      "#compdef signorini\n"
      "# Completion of signorini for zsh, written by `signorini completion zsh`.\n"
      "local -a entries\n"
      "case \"${words[2,CURRENT-1]} \" in\n";
  text += branches(app, [](const std::string& pattern, const CLI::App& command) {
    return fmt::format("  {})\n    entries=(\n{}    ) ;;\n", pattern, zsh_entries(command));
  });
  return text +
         "esac\n"
         "_describe 'command or option' entries || _files\n";
}

/// A page for man, section 1.
std::string man_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH SIGNORINI 1 \"\" \"signorini {}\"\n.SH NAME\nsignorini \\- {}\n"
      ".SH SYNOPSIS\n.B signorini\n.I COMMAND\n[\\fIARGUMENTS\\fR]\n"
      ".SH DESCRIPTION\n{}\nResults go to standard output, remarks to standard error.\n.SH COMMANDS\n",
      build_info().version, roff("compares methods for periodic vibrations with unilateral contact"),
      roff(app.get_description()));
  for (const Page& page : pages(app)) text += roff_command(page);
  text +=
      ".SH EXIT STATUS\n.TP\n.B 0\ndone\n.TP\n.B 1\nsomething did not converge that was not expected to "
      "fail, or "
      "verify found a difference, or a check failed\n.TP\n.B 2\nbad input or usage\n.TP\n.B 3\nthe filter "
      "matched "
      "nothing\n.TP\n.B 4\n"
      "compare found a regression\n.TP\n.B 5\ninternal error\n.TP\n.B 130\ninterrupted, resumable\n";
  return text;
}

}  // namespace

void add_completion_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("completion", "A script that completes commands and options in a shell.");
  const auto shell = std::make_shared<std::string>();
  command->add_option("shell", *shell, "bash or zsh")->required()->check(CLI::IsMember({"bash", "zsh"}));
  command->callback([&app, shell, &exit_code] {
    fmt::print("{}", *shell == "bash" ? bash_completion(app) : zsh_completion(app));
    exit_code = kDone;
  });
}

void add_man_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("man", "This description as a page for man: signorini man | man -l -");
  command->callback([&app, &exit_code] {
    fmt::print("{}", man_page(app));
    exit_code = kDone;
  });
}

}  // namespace signorini
