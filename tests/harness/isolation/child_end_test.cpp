#include "harness/isolation/child_end.hpp"

#include <gtest/gtest.h>

#include <set>

namespace signorini {
namespace {

using Kind = ChildEnd::Kind;

TEST(DescribeChildEnd, QuotesTheLastWordsWhereTheProcessDied) {
  EXPECT_EQ(describe({.kind = Kind::signalled, .code = 11, .last_words = "x > 0 failed"}),
            "signal 11 (Segmentation fault): x > 0 failed");
  EXPECT_EQ(describe({.kind = Kind::exited, .code = 3}), "the process ended with code 3 before an answer");
  EXPECT_EQ(describe({.kind = Kind::exited, .code = 3, .last_words = "no licence"}),
            "the process ended with code 3 before an answer: no licence");
}

TEST(DescribeChildEnd, HasAPhraseOfItsOwnForEachKind) {
  std::set<std::string> phrases;
  for (const Kind kind : {Kind::finished, Kind::threw, Kind::out_of_memory, Kind::exited, Kind::signalled,
                          Kind::timed_out, Kind::out_of_processor_time, Kind::interrupted}) {
    const std::string phrase = describe({.kind = kind, .code = 6, .detail = "text"});
    EXPECT_NE(phrase, "");
    EXPECT_TRUE(phrases.insert(phrase).second) << phrase;
  }
  EXPECT_TRUE(phrases.contains("exception: text"));
}

}  // namespace
}  // namespace signorini
