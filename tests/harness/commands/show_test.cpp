// `signorini show`.

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/harness/program.hpp"

namespace signorini::show_test {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandShow, ShowsScenesAndMethods) {
  EXPECT_EQ(run("show sdof-stop-e08").out,
            "sdof-stop-e08: One mass, one stop, driven above resonance, restitution 0.8\n"
            "reference         closed form of the one-impact orbit\n"
            "tags              sdof, single-point, impact, above-resonance\n"
            "system            sdof, 1 coordinate; entries in M 1, D 1, K 1\n"
            "eigenfrequencies  1 rad/s\n"
            "forcing           omega 2.2 rad/s, 1 term; motion of period 2.85599 s\n"
            "contact 0         u[0] <= 0.2 m\n"
            "law               rigid stops, e = 0.8\n");
  const std::string method = run("show fourier-lipschitz").out;
  EXPECT_NE(method.find("harmonics"), std::string::npos);
  EXPECT_NE(method.find("order             1, of the error of x"), std::string::npos) << method;
  EXPECT_NE(method.find("\nlimits            On a rigid stop"), std::string::npos) << method;
}

TEST(CommandShow, FitsEightyColumnsAndLeavesFurtherContactsOut) {
  for (const char* name : {"rotor-48-facets", "bar200-massless", "beam-pair", "hat-lcp", "aft-hbm"}) {
    const std::string text = run(std::string("show ") + name).out;
    std::istringstream lines(text);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80U) << line;
    EXPECT_LE(count, 60) << text;
  }
  EXPECT_NE(run("show rotor-48-facets").out.find("and 37 more\n"), std::string::npos);
}

}  // namespace
}  // namespace signorini::show_test
