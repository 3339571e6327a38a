#include "harness/report/document/figure.hpp"

#include <gtest/gtest.h>

#include <set>

#include "harness/report/document/section.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

std::vector<Record> two_methods() {
  std::vector<Record> records;
  for (const char* scene : {"s1", "s2"}) {
    for (const char* method : {"a", "b"}) {
      records.push_back(test::good_record(scene, method, "n=1", 0.1, 1e-3));
      records.push_back(test::good_record(scene, method, "n=2", 1e-3, 1e-2));
    }
  }
  return records;
}

TEST(LineStyle, TellsContestantsApartByColourAndByMark) {
  std::set<std::string> lines, marks;
  for (std::size_t c = 0; c < 6; ++c) {
    lines.insert(line_style(c).line);
    marks.insert(line_style(c).mark);
    EXPECT_NE(line_style(c).filled, line_style(c).hollow);
  }
  EXPECT_EQ(lines.size(), 6U);
  EXPECT_EQ(marks.size(), 6U);
}

TEST(WorkPrecisionFigure, KeepsTheCaseBesideEveryPoint) {
  const Evaluation evaluation(two_methods());
  const std::vector<Figure> figures = work_precision_figures(evaluation, "s1");
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "s1-work-precision");
  EXPECT_NE(figures[0].data.find("1.000000e-02 1.000000e-03  # b[n=2]"), std::string::npos);
  EXPECT_EQ(figures[0].data.find("nan"), std::string::npos);
}

TEST(WorkPrecisionFigure, ShowsMethodsOfAnotherLawApartAndBoundsHollow) {
  std::vector<Record> records = two_methods();
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
  std::vector<Record> records = two_methods();
  for (Record& record : records) record.status = Status::timeout;
  EXPECT_TRUE(work_precision_figures(Evaluation(records), "s1").empty());
}

TEST(MotionFigures, DrawTheCoarsestSolvedAnswerOnItsOrbit) {
  std::vector<Record> records = two_methods();
  EXPECT_TRUE(motion_figures(Evaluation(records), "s1").empty());  // no motions kept
  for (Record& record : records) record.waveforms = test::full_record().waveforms;
  records[0].status = Status::inaccurate;
  const std::vector<Figure> figures = motion_figures(Evaluation(records), "s1");
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].name, "s1-waveforms");
  EXPECT_EQ(figures[1].name, "s1-phase");
  EXPECT_NE(figures[0].script.find("title 'a[n=2]'"), std::string::npos);
  EXPECT_NE(figures[0].script.find("title 'b[n=1]'"), std::string::npos);
  EXPECT_NE(figures[0].data.find("# certified orbit"), std::string::npos);
}

TEST(ProfileFigures, EndEveryCurveAtTheShareSolved) {
  std::vector<Record> records = two_methods();
  records[0].status = records[1].status = Status::timeout;  // a on s1
  const Evaluation evaluation(records);
  const std::vector<Figure> figures = profile_figures(evaluation, 0);
  ASSERT_EQ(figures.size(), 1U);
  const std::string& data = figures[0].data;
  EXPECT_NE(data.find("# a, error 1e-02\n1 0.500000\n"), std::string::npos) << data;
  EXPECT_NE(data.find("# b, error 1e-06\n1 0.000000\n"), std::string::npos) << data;
}

TEST(WithoutDate, ChangesNothingButTheDate) {
  const std::string pdf = "%PDF /CreationDate (D:20261121213658Z) rest";
  EXPECT_EQ(without_date(pdf), "%PDF /CreationDate (D:19700101000000Z) rest");
  EXPECT_EQ(without_date("none"), "none");
}

}  // namespace
}  // namespace signorini
