// Frequency responses on a screen.

#include <gtest/gtest.h>

#include <string>

#include "harness/report/formats/screen.hpp"
#include "tests/harness/responses/sample_responses.hpp"

namespace signorini::screen_groups_test {
namespace {

TEST(ResponseLines, HoldAMethodEachWithin80Columns) {
  std::vector<Record> records{test::exact_response("a"), test::exact_response("b"),
                              test::exact_response("c")};
  test::add_method(records, "exact-orbit[samples=64]", 1.0, 0.0, 9.0);
  test::add_method(records, "a-method-of-a-long-name[with=many,settings=indeed]", 0.5, 0.0, 8.0);
  const ScreenLines lines = response_lines(Evaluation(records), 40);
  int starred = 0;
  std::string screen;
  for (const ScreenLine& line : lines) {
    EXPECT_LE(line.text.size(), kTerminalWidth) << line.text;
    if (line.text.starts_with("* ")) ++starred;
    screen += line.text + "\n";
  }
  EXPECT_EQ(starred, 1);
  EXPECT_LT(lines.size(), 20U);
  EXPECT_NE(screen.find("\nRigid stop (e = 1), 3 responses\n"
                        "* a-method-of-a-long-name[with=many,setti...  50.0 %   0.0 %      3/6    5.33 s\n"
                        "= exact-orbit[samples=64]                    100.0 %   0.0 %      3/6       6 s\n"),
            std::string::npos)
      << screen;
}

TEST(ResponseLines, SayWhereNothingWasCompared) {
  const ScreenLines lines = response_lines(Evaluation(std::vector{test::exact_response("a")}), 40);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].text, "No method was compared with an exact response.");
  EXPECT_TRUE(response_lines(Evaluation(std::vector<Record>()), 40).empty());
}

}  // namespace
}  // namespace signorini::screen_groups_test
