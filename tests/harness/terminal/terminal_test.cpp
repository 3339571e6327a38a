#include "harness/terminal/terminal.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>

#include "harness/isolation/child_process.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::terminal_test {
namespace {

/// The program's end of a pseudo-terminal (pty(7)).
struct PseudoTerminal {
  PseudoTerminal() : master(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (grantpt(master.number()) == 0 && unlockpt(master.number()) == 0)
      end = Descriptor(open(ptsname(master.number()), O_RDWR | O_NOCTTY));
  }
  Descriptor master, end;
};

TEST(TakesColour, OnATerminalUnlessItIsDeclinedOrUnknown) {
  const PseudoTerminal terminal;
  ASSERT_TRUE(terminal.end.is_open());
  EXPECT_TRUE(is_terminal(terminal.end.number()));
  unsetenv("NO_COLOR");
  setenv("TERM", "xterm", 1);
  EXPECT_TRUE(takes_colour(terminal.end.number()));
  setenv("NO_COLOR", "1", 1);
  EXPECT_FALSE(takes_colour(terminal.end.number()));
  setenv("NO_COLOR", "", 1);
  EXPECT_TRUE(takes_colour(terminal.end.number()));
  setenv("TERM", "dumb", 1);
  EXPECT_FALSE(takes_colour(terminal.end.number()));
  unsetenv("TERM");
  EXPECT_FALSE(takes_colour(terminal.end.number()));
}

TEST(TakesColour, NeverIntoAPipe) {
  const Pipe pipe = make_pipe();
  setenv("TERM", "xterm", 1);
  EXPECT_FALSE(is_terminal(pipe.write.number()));
  EXPECT_FALSE(takes_colour(pipe.write.number()));
}

TEST(TypedProgram, IsAPathUnlessTheNameLeadsToIt) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::absolute(test::fresh_folder("typed-program")), before = fs::current_path();
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const std::string path = getenv("PATH");
  setenv("PATH", folder.c_str(), 1);
  EXPECT_TRUE(fs::equivalent(typed_program(), program)) << typed_program();
  fs::create_symlink("/bin/true", folder / "signorini");
  EXPECT_TRUE(fs::equivalent(typed_program(), program)) << typed_program();
  fs::current_path(program.parent_path());
  EXPECT_EQ(typed_program(), "./" + program.filename().string());
  fs::current_path("/");
  EXPECT_EQ(typed_program(), program.string().substr(1));
  fs::remove(folder / "signorini");
  fs::create_symlink(program, folder / "signorini");
  EXPECT_EQ(typed_program(), "signorini");
  setenv("PATH", path.c_str(), 1);
  fs::current_path(before);
}
TEST(WithHint, TellsTheKnownKeysThatAnUnknownOneMayMean) {
  EXPECT_EQ(with_hint("sample = 3 (unknown option; known: samples, scheme, plain)"),
            "sample = 3 (unknown option; known: samples, scheme, plain; did you mean samples?)");
  EXPECT_EQ(with_hint("own.toml:7: system.mas = 3 (unknown key; known: kind, mass)"),
            "own.toml:7: system.mas = 3 (unknown key; known: kind, mass; did you mean mass?)");
}

TEST(WithHint, TellsTheValuesThatAWrongOneMayMean) {
  EXPECT_EQ(with_hint("method = hatlcp (must be one of hat-lcp, aft-hbm)"),
            "method = hatlcp (must be one of hat-lcp, aft-hbm; did you mean hat-lcp?)");
  EXPECT_EQ(with_hint("suite = quik (must be a TOML file or one of easy, quick)"),
            "suite = quik (must be a TOML file or one of easy, quick; did you mean quick?)");
}

TEST(WithHint, LeavesAllElseAsItIs) {
  for (const char* text :
       {"", "internal error: x = (", "samples = few (must be a whole number)",
        "one of --method and --methods is required", "method = rotor (must be one of hat-lcp, aft-hbm)",
        "x = y (must be one of", "(one of a) = b (c)"})
    EXPECT_EQ(with_hint(text), text);
}

}  // namespace
}  // namespace signorini::terminal_test
