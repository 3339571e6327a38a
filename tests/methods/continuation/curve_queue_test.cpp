#include "methods/continuation/curve_queue.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace signorini::curve_queue_test {
namespace {

struct Named {
  int period = 1;
  std::string name = {};
  [[nodiscard]] int periods() const { return period; }
};

TEST(CurveQueue, FollowsShortPeriodsFirstAndInTheOrderOfTheirComing) {
  const CurveLimits limits;
  CurveQueue<Named> queue(limits);
  queue.add({2, "a"});
  queue.add({1, "b"});
  queue.add({1, "c"});
  std::string order;
  while (const auto start = queue.next()) order += start->name;
  EXPECT_EQ(order, "bca");
}

TEST(CurveQueue, FollowsWhatIsRankedFirst) {
  const CurveLimits limits;
  CurveQueue<Named> queue(limits);
  queue.add({1, "short"});
  queue.add({3, "wanted"});
  const auto wanted = [](const Named& start) { return start.name == "wanted"; };
  const auto rank = [&](const Named& start) { return wanted(start) ? 0 : start.period; };
  EXPECT_TRUE(queue.holds(wanted));
  EXPECT_EQ(queue.next(rank).value().name, "wanted");
  EXPECT_FALSE(queue.holds(wanted));
  EXPECT_EQ(queue.next(rank).value().name, "short");
}

TEST(CurveQueue, SaysOnceWhatIsNotFollowed) {
  const CurveLimits limits;
  CurveQueue<Named> queue(limits);
  for (const char* text : {"a corner", "an end", "a corner"}) queue.note(text);
  EXPECT_EQ(queue.finish<BranchDiagram>().notes, (std::vector<std::string>{"a corner", "an end"}));
}

TEST(CurveQueue, SaysWhichLimitLeftSomethingUndone) {
  std::vector<std::string> taken;
  CurveLimits limits{.max_branches = 1, .take = [&](const Branch& b) { taken.push_back(b.sequence); }};
  CurveQueue<Named> queue(limits);
  EXPECT_FALSE(queue.is_full());
  queue.keep({.sequence = "one"});
  EXPECT_EQ(taken, std::vector<std::string>{"one"});
  EXPECT_TRUE(queue.is_full());
  queue.note("a corner");
  const auto diagram = queue.finish<BranchDiagram>();
  EXPECT_EQ(diagram.branches.size(), 1U);
  EXPECT_EQ(diagram.unfinished, "limit of 1 branches");
  EXPECT_EQ(diagram.notes.size(), 1U);
}

TEST(CurveQueue, EndsWhereTheTimeIsUp) {
  CurveLimits limits{.stopped = [] { return true; }};
  CurveQueue<Named> queue(limits);
  queue.add({});
  EXPECT_FALSE(queue.next());
  EXPECT_EQ(queue.finish<BranchDiagram>().unfinished, "the time is up");
}

}  // namespace
}  // namespace signorini::curve_queue_test
