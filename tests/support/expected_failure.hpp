#pragma once
// Failures that are known: they stay in the tests with their reason, and a test fails when they disappear.

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace signorini::test {

/// Runs `body` and fails if all of its expectations hold: then the reason is gone, and so should be this
/// call. Failures of the body on this thread are swallowed; exceptions are not. ASSERT_... in the body ends
/// the body alone.
void expect_failure(std::string_view reason, const std::function<void()>& body);

/// Cases of a test that are known to fail: name of the case -> reason.
using KnownFailures = std::map<std::string, std::string>;

/// Expects that the case passes, or, if it is known to fail, that it fails.
/// \param passed   whether it passed
/// \param message  why it failed, printed where it should have passed
void expect_pass_unless_known(const std::string& name, bool passed, const std::string& message,
                              const KnownFailures& known);

}  // namespace signorini::test
