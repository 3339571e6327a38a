#include "tests/support/expected_failure.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace signorini::test {

namespace {

/// Whether an expectation of the body fails.
bool fails(const std::function<void()>& body) {
  testing::TestPartResultArray results;
  {
    // Reports of this thread go to `results` instead of to the running test for as long as this object lives.
    const testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    body();
  }
  for (int i = 0; i < results.size(); ++i) {
    if (results.GetTestPartResult(i).failed()) return true;
  }
  return false;
}

}  // namespace

void expect_failure(std::string_view reason, const std::function<void()>& body) {
  EXPECT_TRUE(fails(body)) << "known to fail, and passes now: " << reason
                           << "\nTake its expect_failure away, and assert what holds.";
}

void expect_pass_unless_known(const std::string& name, bool passed, const std::string& message,
                              const KnownFailures& known) {
  const auto failure = known.find(name);
  if (failure == known.end()) {
    EXPECT_TRUE(passed) << name << ": " << message;
  } else {
    EXPECT_FALSE(passed) << name << " is known to fail, and passes now: " << failure->second
                         << "\nTake it off the list of known failures.";
  }
}

}  // namespace signorini::test
