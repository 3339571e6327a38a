#include <gtest/gtest.h>

#include "harness/report/figures/figures.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

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
