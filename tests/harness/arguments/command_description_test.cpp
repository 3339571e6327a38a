// Completions and the manual: they name every command and option.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include "harness/files.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini::command_description_test {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

/// Long options that --help shows.
std::set<std::string> options_in_help(const std::string& command) {
  std::set<std::string> options;
  const std::string help = run(command + " --help").out;
  for (std::size_t at = help.find("--"); at != std::string::npos; at = help.find("--", at + 2)) {
    const std::size_t end = help.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at);
    if (at > 0 && (help[at - 1] == ' ' || help[at - 1] == ',') && help.rfind('\n', at) + 8 > at)
      options.insert(help.substr(at, end - at));
  }
  return options;
}

TEST(Description, DescribesEveryOptionToShellsAndToMan) {
  const std::string bash = run("completion bash").out, zsh = run("completion zsh").out, man = run("man").out;
  for (const char* command : {"run", "status", "merge", "compare", "submit slurm", "solve", "verify"}) {
    EXPECT_NE(bash.find(fmt::format("'{} '*)", command)), std::string::npos) << command;
    EXPECT_NE(zsh.find(fmt::format("'{} '*)", command)), std::string::npos) << command;
    EXPECT_NE(man.find(fmt::format(".SS {}\n", command)), std::string::npos) << command;
    const std::set<std::string> options = options_in_help(command);
    EXPECT_GE(options.size(), 1U) << command;
    for (const std::string& option : options) {
      EXPECT_NE(bash.find(option), std::string::npos) << option;
      EXPECT_NE(zsh.find("'" + option + ":"), std::string::npos) << option;
      std::string escaped;
      for (const char c : option) escaped += c == '-' ? "\\-" : std::string(1, c);
      EXPECT_NE(man.find(escaped), std::string::npos) << option;
    }
  }
}

TEST(Description, OrdersTheManualAsOneReadsIt) {
  const std::string man = run("man").out;
  EXPECT_LT(man.find(".SS submit\n"), man.find(".SS submit slurm\n"));
  EXPECT_NE(man.find("\nAll other words are those of `signorini run`"), std::string::npos);
}

TEST(Description, CompletesInBash) {
  const auto folder = test::fresh_folder("completion");
  std::ofstream(folder / "signorini.bash") << run("completion bash").out;
  std::ofstream(folder / "try.bash") << "source " << (folder / "signorini.bash").string() << R"(
program=)" << SIGNORINI_BINARY << R"(
try() { COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _signorini; echo "${COMPREPLY[@]}"; }
try signorini comp
try signorini run --sh
try $program solve sdof-stop-ne
try $program run qui
try $program solve sdof-stop --method hat
try $program run quick --scenes chain3-s
try $program check hat-lcp --suite eas
try $program solve sdof-stop --method hat-lcp --set sam
try signorini submit slurm --sh
try signorini report results --format ht
try signorini list sui
)";
  const auto answer = folder / "answer";
  ASSERT_EQ(std::system(fmt::format("bash {0}/try.bash >{0}/answer 2>&1", folder.string()).c_str()), 0);
  EXPECT_EQ(read_file(answer),
            "completion "
            "compare\n--shard\nsdof-stop-near\nquick\nhat-lcp\nchain3-stop\neasy\nsamples=\n--shards\nhtml\n"
            "suites\n");
}

TEST(Description, CompletesInZsh) {
  if (std::system("zsh --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "zsh is not installed";
  const auto folder = test::fresh_folder("completion-zsh");
  std::ofstream(folder / "_signorini") << run("completion zsh").out;
  // zsh's own functions, as far as the script calls them: what begins with the word at the cursor, or
  // "files".
  std::ofstream(folder / "try.zsh") << "fpath=(" << folder.string() << R"( $fpath)
autoload -Uz _signorini
_describe() {
  local -a list=("${(@P)2}")
  list=(${(M)${list%%:*}:#${words[CURRENT]}*})
  (( ${#list} )) && offered+=($list)
}
_files() { offered+=(files) }
try() { local -a words=("$@") offered; local CURRENT=$#; _signorini; print -r -- $offered }
program=)" << SIGNORINI_BINARY << R"(
try signorini comp
try signorini run --sh
try $program solve sdof-stop-ne
try $program run qui
try $program solve sdof-stop --method hat
try $program run quick --scenes chain3-s
try $program check hat-lcp --suite eas
try $program solve sdof-stop --method hat-lcp --set sam
try signorini submit slurm --sh
try signorini report results --format ht
try signorini list sui
try signorini report resu
)";
  const auto answer = folder / "answer";
  ASSERT_EQ(std::system(fmt::format("zsh -f {0}/try.zsh >{0}/answer 2>&1", folder.string()).c_str()), 0);
  EXPECT_EQ(
      read_file(answer),
      "completion compare\n--shard\nsdof-stop-near\nquick\nhat-lcp\nchain3-stop\neasy\nsamples=\n--shards\n"
      "html\nsuites\nfiles\n");
}

}  // namespace
}  // namespace signorini::command_description_test
