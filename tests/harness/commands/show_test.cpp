// `signorini show`.

#include <gtest/gtest.h>

#include <string>

#include "tests/harness/program.hpp"

namespace signorini {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandShow, ShowsScenesAndMethods) {
  EXPECT_NE(run("show sdof-stop").out.find("eigenfrequencies"), std::string::npos);
  const std::string method = run("show fourier-lipschitz").out;
  EXPECT_NE(method.find("harmonics"), std::string::npos);
  EXPECT_NE(method.find("order             1, of the error of x"), std::string::npos) << method;
}

}  // namespace
}  // namespace signorini
