#include "harness/report/figures/profile_figure.hpp"

#include <gtest/gtest.h>

#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

TEST(ProfileFigures, EndEveryCurveAtTheShareSolved) {
  std::vector<Record> records = test::records_of_two_methods();
  records[0].status = records[1].status = Status::timeout;  // a on s1
  const Evaluation evaluation(records);
  const std::vector<Figure> figures = profile_figures(evaluation, 0);
  ASSERT_EQ(figures.size(), 1U);
  const std::string& data = figures[0].data;
  EXPECT_NE(data.find("# a, error 1e-02\n1 0.500000\n"), std::string::npos) << data;
  EXPECT_NE(data.find("# b, error 1e-06\n1 0.000000\n"), std::string::npos) << data;
}

}  // namespace
}  // namespace signorini
