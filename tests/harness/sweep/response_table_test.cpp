#include "harness/sweep/response_table.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace signorini {
namespace {

TEST(ResponseTable, HasARowPerPointAndTheColumnOfStabilityIfAskedFor) {
  const std::vector<SweepPoint> points{{.frequency = 1.5, .status = Status::converged, .x_max = {0.1, 0.2}},
                                       {.frequency = 1.0, .back = true, .status = Status::timeout}};
  const Table table = response_table(points, true);
  EXPECT_EQ(table.header.size(), 7U);
  EXPECT_EQ(response_table(points, false).header.size(), 6U);
  EXPECT_EQ(to_csv(response_table(points, false)),
            "omega [rad/s],way,status,x max [m],amplitude [m],contact ratio\n"
            "1.5,there,converged,0.2,-,-\n1,back,timeout,-,-,-\n");
  EXPECT_EQ(to_json(points[1]).dump(), R"({"frequency":1.0,"way":"back","status":"timeout"})");
}

}  // namespace
}  // namespace signorini
