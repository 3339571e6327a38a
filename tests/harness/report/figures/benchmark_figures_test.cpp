#include <gtest/gtest.h>

#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

TEST(WorkPrecisionFigure, KeepsTheCaseBesideEveryPoint) {
  const Evaluation evaluation(test::records_of_two_methods());
  const std::vector<Figure> figures = work_precision_figures(evaluation, "s1");
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "s1-work-precision");
  EXPECT_NE(figures[0].data.find("1.000000e-02 1.000000e-03  # b[n=2]"), std::string::npos);
  EXPECT_EQ(figures[0].data.find("nan"), std::string::npos);
}

TEST(WorkPrecisionFigure, ShowsMethodsOfAnotherLawApartAndBoundsHollow) {
  std::vector<Record> records = test::records_of_two_methods();
  for (Record& record : records) {
    if (record.method == "b") record.law_matches_scene = false;
  }
  records[1].errors.x_l2 = 1e-15;
  const Evaluation evaluation(records);
  const std::vector<Figure> figures = work_precision_figures(evaluation, "s1");
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].data.find("# b,"), std::string::npos);
  EXPECT_EQ(figures[1].data.find("# a,"), std::string::npos);
  EXPECT_NE(figures[0].script.find(line_style(0).hollow), std::string::npos);
  EXPECT_EQ(figures[1].script.find(line_style(1).hollow), std::string::npos);
}

TEST(WorkPrecisionFigure, IsNoneWhereNobodySolvesTheScene) {
  std::vector<Record> records = test::records_of_two_methods();
  for (Record& record : records) record.status = Status::timeout;
  EXPECT_TRUE(work_precision_figures(Evaluation(records), "s1").empty());
}

TEST(ProfileFigure, EndsEveryCurveAtTheShareSolved) {
  std::vector<Record> records = test::records_of_two_methods();
  records[0].status = records[1].status = Status::timeout;  // a on s1
  const Evaluation evaluation(records);
  const std::string data = profile_figure(evaluation, 0).data;
  EXPECT_NE(data.find("# a, error 1e-02\n1 0.500000\n"), std::string::npos) << data;
  EXPECT_NE(data.find("# b, error 1e-06\n1 0.000000\n"), std::string::npos) << data;
}

}  // namespace
}  // namespace signorini
