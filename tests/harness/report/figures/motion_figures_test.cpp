#include <gtest/gtest.h>

#include "harness/report/figures/figures.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

TEST(MotionFigures, DrawTheCoarsestSolvedAnswerOnItsOrbit) {
  std::vector<Record> records = test::records_of_two_methods();
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

}  // namespace
}  // namespace signorini
