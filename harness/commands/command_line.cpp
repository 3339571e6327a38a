#include "harness/commands/command_line.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>

#include "harness/build_info.hpp"
#include "harness/extend/plugins/plugins.hpp"
#include "harness/failure.hpp"
#include "harness/isolation/process_state.hpp"
#include "harness/plots/plot_file.hpp"
#include "harness/terminal/terminal.hpp"
#include "methods/options.hpp"
#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/validation.hpp"

namespace signorini {

namespace {

std::string version_text() {
  const BuildInfo& info = build_info();
  std::string text = fmt::format("signorini {}", info.version);
  if (!info.commit.empty())
    text += fmt::format(" ({}{})", info.commit.substr(0, 12), info.dirty ? ", changed" : "");
  text += fmt::format(", {} {}", info.compiler, info.build_type);
  for (const auto& [name, version] : info.libraries) {
    if (!version.empty()) text += fmt::format(", {} {}", name, version);
  }
  return text;
}

/// Prints a complaint as one line that does nothing to a terminal: it may quote arguments and files. Unlike
/// fmt::print it does not throw where stderr is full: the exit code is all that can be told then.
int complain(const std::string& line, int code) {
  std::fputs((one_line(line, 1000) + "\n").c_str(), stderr);
  return code;
}

/// Signals as a program finds them that nobody has prepared: a parent may ignore or block what this one waits
/// for, or what ends it.
void take_default_signals() {
  for (const int signal : {SIGCHLD, SIGTERM}) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// What a caller has closed of stdin, stdout and stderr becomes /dev/null: the next file that is opened, a
/// run's records for instance, would bear its number and take what is printed.
void open_standard_files() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) < 0) static_cast<void>(open("/dev/null", O_RDWR));
  }
}

/// Reports a full disk, or a closed pipe, behind stdout or stderr.
int complain_of_output(const std::string& reason) {
  return complain(fmt::format("stdout = full (must take what is printed: {})", reason), kBadUsage);
}

/// The exit code of a command that is done, once all that it printed has arrived.
int delivered(int code) {
  if (std::fflush(stdout) != 0) return complain_of_output(std::strerror(errno));
  return std::ferror(stdout) == 0 ? code : complain_of_output("a part is missing");
}

/// Reports a path of the wrong kind (a file for a folder) or without the permission that is needed.
int complain_of_file(const std::filesystem::filesystem_error& error) {
  return complain(
      fmt::format("path = {} (must be usable: {})", error.path1().string(), error.code().message()),
      kBadUsage);
}

/// Names the commands where the first word, after those of --plugin, is none; the parser would only say that
/// a command is missing. \throws UsageError
void require_known_command(const Command& program, const std::vector<std::string>& words) {
  std::size_t place = 1;
  while (place < words.size() && words[place].starts_with("--plugin"))
    place += words[place] == "--plugin" ? 2 : 1;  // "--plugin FILE" or "--plugin=FILE"
  if (place >= words.size() || words[place].starts_with('-')) return;
  std::string names;
  for (const Command& command : program.commands()) {
    if (command.name() == words[place]) return;
    names += (names.empty() ? "" : ", ") + command.name();
  }
  throw UsageError(fmt::format("command = {} (must be one of {})", words[place], names));
}

/// "signorini help solve" is "signorini solve --help".
std::vector<std::string> without_help_command(std::vector<std::string> words) {
  if (words.size() < 2 || words[1] != "help") return words;
  words.erase(words.begin() + 1);
  words.emplace_back("--help");
  return words;
}

/// --plugin, before the command and after it.
void add_plugin_options(const Command& program, std::vector<std::string>& plugins) {
  const auto add = [&](const Command& command) {
    // Words before a command and after it come one after the other, so that none replaces the others.
    command.words_option(
        "--plugin",
        [&plugins](const std::vector<std::string>& files) {
          plugins.insert(plugins.end(), files.begin(), files.end());
        },
        "load methods from a shared object or a command's description (*.toml), beside those in "
        "the folders of $SIGNORINI_PLUGIN_PATH; repeatable, before the command or after it",
        {.type_name = "FILE", .one_word = true});
  };
  add(program);
  for (const Command& command : program.commands()) {
    const std::vector<Command> inner = command.commands();
    std::ranges::for_each(inner.empty() ? std::vector{command} : inner, add);
  }
}

}  // namespace

std::vector<OptionSetting> parse_settings(const std::vector<std::string>& texts) {
  std::vector<OptionSetting> settings;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw UsageError(fmt::format("set = {} (must look like key=value)", text));
    }
    settings.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return settings;
}

void add_plot_option(const Command& command, std::string& file, const std::string& what) {
  command.option("--plot", file, what + ", as a picture in FILE.svg, .pdf or .png; needs gnuplot",
                 {.type_name = "FILE", .complaint = plot_obstacle});
}

void add_column_option(const Command& command, Column& column, const std::string& of) {
  command.word_option(
      "--column",
      [&column](const std::string& word) { column = word == "single" ? Column::single : Column::both; },
      fmt::format("width of {} for a journal: single ({} cm) or double ({} cm); letters keep their size", of,
                  kSingleColumn, kBothColumns),
      {.one_of = {"single", "double"}});
}

int run_command_line(int argc, char** argv) {
  take_default_signals();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes is an error of the write, which names the file
  open_standard_files();
  compute_on_one_thread();  // may initialise a library that writes files
  // Not argv[0]: local paths stay out of the manifest.
  std::vector<std::string> words{"signorini"};
  words.insert(words.end(), argv + std::min(1, argc), argv + argc);
  words = without_help_command(std::move(words));
  ArgumentParser parser(
      words,
      "Computes periodic vibrations of linear structures with unilateral contacts, and compares methods.",
      version_text);
  const Command program = parser.program();
  program.require_command();
  for (const auto add : {add_list_command,    add_show_command,   add_solve_command,      add_orbits_command,
                         add_motion_command,  add_reduce_command, add_completion_command, add_man_command,
                         add_sweep_command,   add_run_command,    add_report_command,     add_compare_command,
                         add_history_command, add_verify_command, add_pack_command,       add_fetch_command,
                         add_doctor_command,  add_new_command,    add_check_command,      add_submit_command,
                         add_status_command,  add_merge_command})
    add(program);
  guide_commands(program);
  std::vector<std::string> plugins;
  add_plugin_options(program, plugins);
  try {
    require_known_command(program, words);
    return delivered(parser.run([&plugins] { load_plugins(plugins); }));
  } catch (const BadArguments& error) {
    return complain(error.what(), kBadUsage);
  } catch (const NothingMatched& error) {
    return complain(error.what(), kNothingMatched);
  } catch (const UsageError& error) {
    return complain(with_hint(error.what()), kBadUsage);
  } catch (const SceneError& error) {
    return complain(with_hint(error.what()), kBadUsage);
  } catch (const InvalidProblem& error) {
    return complain(error.what(), kBadUsage);
  } catch (const InvalidOption& error) {
    return complain(with_hint(error.what()), kBadUsage);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain_of_file(error);
  } catch (const std::bad_alloc&) {
    return complain("machine = full (must allow more memory)", kBadUsage);
  } catch (const std::system_error& error) {  // of fmt::print among others
    if (std::ferror(stdout) != 0 || std::ferror(stderr) != 0)
      return complain_of_output(error.code().message());
    return complain(std::string("internal error: ") + error.what(), kInternalError);
  } catch (...) {
    return complain("internal error: " + current_exception_text(), kInternalError);
  }
}

void add_completion_command(const Command& program) {
  const Command command =
      program.command("completion", "A script that completes commands and options in a shell.");
  const auto shell = std::make_shared<std::string>();
  command.option("shell", *shell, "bash or zsh", {.required = true, .one_of = {"bash", "zsh"}});
  command.on_run([program, shell] {
    fmt::print("{}", *shell == "bash" ? bash_completion(program) : zsh_completion(program));
    return kDone;
  });
}

void add_man_command(const Command& program) {
  const Command command =
      program.command("man", "This description as a page for man: signorini man | man -l -");
  command.on_run([program] {
    fmt::print("{}", man_page(program));
    return kDone;
  });
}

}  // namespace signorini
