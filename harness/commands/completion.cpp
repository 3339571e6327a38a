#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "harness/build_info.hpp"
#include "harness/commands/command_line.hpp"
#include "harness/commands/description.hpp"

namespace signorini {

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
    fmt::print("{}", man_page(app, std::string(build_info().version)));
    exit_code = kDone;
  });
}

}  // namespace signorini
