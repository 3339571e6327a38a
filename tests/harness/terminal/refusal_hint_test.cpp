#include <gtest/gtest.h>

#include "harness/terminal/terminal.hpp"

namespace signorini::refusal_hint_test {
namespace {

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
}  // namespace signorini::refusal_hint_test
