#include <gtest/gtest.h>

#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::motion_figures_test {
namespace {

TEST(MotionFigures, DrawTheCoarsestSolvedAnswerOnItsOrbit) {
  std::vector<Record> records = test::records_of_two_methods();
  EXPECT_TRUE(motion_figures(Evaluation(records), "s1").empty());  // no motions kept
  for (Record& record : records) {
    record.waveforms = test::full_record().waveforms;
    record.certificate.events = test::full_record().certificate.events;
  }
  records[0].status = Status::inaccurate;
  const std::vector<Figure> figures = motion_figures(Evaluation(records), "s1");
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].name, "s1-waveforms");
  EXPECT_EQ(figures[1].name, "s1-phase");
  EXPECT_NE(figures[0].script.find("title 'a[n=2]'"), std::string::npos);
  EXPECT_NE(figures[0].script.find("title 'b[n=1]'"), std::string::npos);
  EXPECT_NE(figures[0].data.find("# certified orbit"), std::string::npos);
  // The stop, and the impact on it.
  EXPECT_NE(figures[0].script.find("set arrow 1 from graph 0, first 0.5 to graph 1, first 0.5"),
            std::string::npos);
  EXPECT_NE(figures[1].script.find("set arrow 1 from 0.5, graph 0 to 0.5, graph 1"), std::string::npos);
  EXPECT_NE(figures[0].data.find("# impacts\n0.5 0.5\n\n\n"), std::string::npos) << figures[0].data;
  for (const Figure& figure : figures) EXPECT_NO_THROW((void)drawn(figure, "svg"));
  for (const Figure& narrow : motion_figures(Evaluation(records), "s1", Column::single)) {
    EXPECT_EQ(narrow.width, kSingleColumn);
    EXPECT_NO_THROW((void)drawn(narrow, "svg"));
  }
}

}  // namespace
}  // namespace signorini::motion_figures_test
