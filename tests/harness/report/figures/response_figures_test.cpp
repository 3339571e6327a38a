// Figures of frequency responses.

#include <gtest/gtest.h>

#include "harness/report/figures/figures.hpp"
#include "tests/harness/responses/sample_responses.hpp"

namespace signorini::response_figures_test {
namespace {

TEST(ResponseFigures, DrawTheExactBranchesByStabilityUnderTheMethods) {
  const std::vector<Record> records{test::exact_response("a"),
                                    test::response_of("a", "m'; system('x')", 1.0, 1.0)};
  const std::vector<Figure> figures = response_figures(Evaluation(records));
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "a-response");
  EXPECT_NE(figures[0].script.find("set title 'm''; system(''x'')' noenhanced"), std::string::npos)
      << figures[0].script;
  EXPECT_EQ(figures[0].script.find("index 3"), std::string::npos);  // stable, unstable, the method's
  EXPECT_NE(figures[0].script.find("index 2 with lines"), std::string::npos);
  EXPECT_TRUE(response_figures(Evaluation(std::vector<Record>())).empty());
}

TEST(ResponseFigures, StackTheirPanelsInASingleColumn) {
  const std::vector<Record> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0),
                                    test::response_of("a", "n", 1.0, 1.0)};
  const Figure narrow = response_figures(Evaluation(records), Column::single).at(0);
  EXPECT_EQ(narrow.width, kSingleColumn);
  EXPECT_NE(narrow.script.find("layout 2,1 "), std::string::npos);
  EXPECT_NE(response_figures(Evaluation(records)).at(0).script.find("layout 1,3 "), std::string::npos);
}

TEST(ResponseFigures, NameTheLawWhereItIsNotTheScenes) {
  const std::vector<Record> records{test::exact_response("a"),
                                    test::of_another_law(test::response_of("a", "m", 1.0, 1.0))};
  EXPECT_NE(response_figures(Evaluation(records)).at(0).script.find("set title 'm, e = 1'"),
            std::string::npos);
}

}  // namespace
}  // namespace signorini::response_figures_test
