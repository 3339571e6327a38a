// --help in groups with examples, and the examples themselves.

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "harness/arguments/arguments.hpp"
#include "tests/harness/program.hpp"

namespace signorini::command_guide_test {
namespace {

TEST(CommandGuide, HasTheCommandsInFourGroups) {
  const std::string help = test::run_program("--help").out;
  std::size_t last = 0;
  for (const char* part : {"\nUse:\n", "\n  solve ", "\nJudge:\n", "\n  run ", "\nExtend:\n", "\n  check ",
                           "\nCluster:\n", "\n  submit ", "\nExamples "}) {
    const std::size_t at = help.find(part);
    ASSERT_NE(at, std::string::npos) << part << help;
    EXPECT_GT(at, last) << part;
    last = at;
  }
  EXPECT_EQ(help.find("\nSubcommands:"), std::string::npos) << "a command without a group\n" << help;
}

TEST(CommandGuide, PrintsHelpInLinesOfEightyColumns) {
  for (const char* command : {"", "solve", "run", "verify", "compare", "sweep", "submit slurm"}) {
    std::istringstream lines(test::run_program(std::string(command) + " --help").out);
    for (std::string line; std::getline(lines, line);) {
      const bool breaks = line.find(' ', 30) != std::string::npos;
      if (breaks && line.find("  signorini ") != 0) {
        EXPECT_LE(line.size(), 80U) << command << ": " << line;
      }
    }
  }
}

TEST(CommandGuide, HasAnExampleInTheHelpOfEachCommand) {
  const std::string man = test::run_program("man").out;
  for (const CommandExample& example : command_examples()) {
    const std::string help = test::run_program(std::string(example.command) + " --help").out;
    EXPECT_NE(help.find("\n  " + std::string(example.line) + "\n"), std::string::npos) << example.command;
  }
  for (const char* section :
       {"\n.SH EXAMPLES\n", "\n.SH EXIT STATUS\n", "\n.SH FILES\n", "\n.SH ENVIRONMENT\n"})
    EXPECT_NE(man.find(section), std::string::npos) << section;
}

// Those that need nothing but the program are taken at their word.
TEST(CommandGuide, HasExamplesThatTheProgramTakes) {
  int tried = 0;
  for (const CommandExample& example : command_examples()) {
    const std::string line = example.line, command = example.command;
    if (command != "list" && command != "show" && command != "orbits" && command != "motion" &&
        line.find("solve sdof-stop") == std::string::npos)
      continue;
    const test::Outcome outcome = test::run_program(line.substr(std::string("signorini ").size()));
    EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
    ++tried;
  }
  EXPECT_EQ(tried, 6);
}

TEST(CommandHelp, IsThatOfTheCommandNamed) {
  EXPECT_EQ(test::run_program("help solve").out, test::run_program("solve --help").out);
  EXPECT_EQ(test::run_program("help").out, test::run_program("--help").out);
}

}  // namespace
}  // namespace signorini::command_guide_test
