#include "harness/failure.hpp"

#include <gtest/gtest.h>

namespace signorini::failure_test {
namespace {

struct Complaint {};

template <class Thrown>
std::string text_of(const Thrown& thrown) {
  try {
    throw thrown;
  } catch (...) {
    return current_exception_text();
  }
}

TEST(ExceptionText, IsTheMessageOfAStandardException) {
  EXPECT_EQ(text_of(std::runtime_error("the message")), "the message");
  EXPECT_EQ(text_of(UsageError("suite = x (must be a suite)")), "suite = x (must be a suite)");
}

TEST(ExceptionText, NamesTheTypeOfAnyOtherObject) {
  EXPECT_EQ(text_of(3), "an object of type int, which is no std::exception");
  EXPECT_NE(text_of(Complaint{}).find("Complaint"), std::string::npos);
}

}  // namespace
}  // namespace signorini::failure_test
