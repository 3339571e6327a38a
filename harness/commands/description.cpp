#include <fmt/format.h>

#include <memory>
#include <string>

#include "harness/arguments/command_description.hpp"
#include "harness/commands/command_line.hpp"

namespace signorini {

void add_completion_command(const Command& program, int& exit_code) {
  const Command command =
      program.command("completion", "A script that completes commands and options in a shell.");
  const auto shell = std::make_shared<std::string>();
  command.option("shell", *shell, "bash or zsh").required().one_of({"bash", "zsh"});
  command.on_run([program, shell, &exit_code] {
    fmt::print("{}", *shell == "bash" ? bash_completion(program) : zsh_completion(program));
    exit_code = kDone;
  });
}

void add_man_command(const Command& program, int& exit_code) {
  const Command command =
      program.command("man", "This description as a page for man: signorini man | man -l -");
  command.on_run([program, &exit_code] {
    fmt::print("{}", man_page(program));
    exit_code = kDone;
  });
}

}  // namespace signorini
