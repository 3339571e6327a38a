#include <gtest/gtest.h>

#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::profile_figure_test {
namespace {

TEST(ProfileFigure, EndsEveryCurveAtTheShareSolved) {
  std::vector<Record> records = test::records_of_two_methods();
  records[0].status = records[1].status = Status::timeout;  // a on s1
  const Evaluation evaluation(records);
  const std::string data = profile_figure(evaluation, 0).data;
  EXPECT_NE(data.find("# a, error 1e-02\n1 0.500000\n"), std::string::npos) << data;
  EXPECT_NE(data.find("# b, error 1e-06\n1 0.000000\n"), std::string::npos) << data;
}

TEST(ProfileFigure, StacksItsPanelsInASingleColumn) {
  const Evaluation evaluation(test::records_of_two_methods());
  const Figure usual = profile_figure(evaluation, 0), narrow = profile_figure(evaluation, 0, Column::single);
  EXPECT_NE(usual.script.find("layout 1,3"), std::string::npos);
  EXPECT_NE(narrow.script.find("layout 3,1"), std::string::npos);
  EXPECT_EQ(narrow.width, kSingleColumn);
  EXPECT_GT(narrow.height, 2.0 * usual.height);
  EXPECT_EQ(narrow.script.find("set format y ''"), std::string::npos);  // every panel has its numbers
  EXPECT_NO_THROW((void)drawn(narrow, "svg"));
}

}  // namespace
}  // namespace signorini::profile_figure_test
