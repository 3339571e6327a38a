#include "harness/responses/response_report.hpp"

#include <gtest/gtest.h>

#include "harness/files.hpp"
#include "tests/harness/responses/sample_responses.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::response_report_test {
namespace {

TEST(ResponseFigures, DrawTheExactBranchesByStabilityUnderTheMethods) {
  const std::vector<ResponseRecord> records{test::exact_response("a"),
                                            test::response_of("a", "m'; system('x')", 1.0, 1.0)};
  const std::vector<Figure> figures = response_figures(records);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "a-response");
  EXPECT_NE(figures[0].script.find("set title 'm''; system(''x'')' noenhanced"), std::string::npos)
      << figures[0].script;
  EXPECT_EQ(figures[0].script.find("index 3"), std::string::npos);  // stable, unstable, the method's
  EXPECT_NE(figures[0].script.find("index 2 with lines"), std::string::npos);
  EXPECT_TRUE(response_figures({}).empty());
}

TEST(ResponseFigures, StackTheirPanelsInASingleColumn) {
  const std::vector<ResponseRecord> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0),
                                            test::response_of("a", "n", 1.0, 1.0)};
  const Figure narrow = response_figures(records, Column::single).at(0);
  EXPECT_EQ(narrow.width, kSingleColumn);
  EXPECT_NE(narrow.script.find("layout 2,1 "), std::string::npos);
  EXPECT_NE(response_figures(records).at(0).script.find("layout 1,3 "), std::string::npos);
}

TEST(WriteResponseReport, WritesWhatIsAskedForAlone) {
  const test::TemporaryFolder folder;
  const std::vector<ResponseRecord> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0)};
  EXPECT_TRUE(write_response_report(folder.path(), records, {"csv"}).empty());
  EXPECT_EQ(write_response_report(folder.path(), records, {"md"}).size(), 1U);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "report.html"));
  const auto files = write_response_report(folder.path(), records, {"html"});
  ASSERT_EQ(files.size(), 1U);
  EXPECT_NE(read_file(files[0]).find("The run has no manifest."), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "figures"));
}

}  // namespace
}  // namespace signorini::response_report_test
