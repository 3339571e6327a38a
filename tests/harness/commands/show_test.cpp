// `signorini show`.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "tests/harness/program.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::show_test {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandShow, ShowsScenesAndMethods) {
  EXPECT_EQ(run("show sdof-stop-e08").out,
            "sdof-stop-e08: One mass, one stop, driven above resonance, restitution 0.8\n"
            "reference         closed form of the one-impact orbit\n"
            "tags              sdof, single-point, impact, above-resonance\n"
            "system            sdof, 1 coordinate; nonzero entries: M 1, D 1, K 1\n"
            "eigenfrequencies  1 rad/s\n"
            "                  0.159155 Hz\n"
            "damping ratios    0.05\n"
            "suggested sweep   mode 1: 0.8 to 2 rad/s (0.1273 to 0.3183 Hz)\n"
            "forcing           omega 2.2 rad/s (0.3501 Hz), 1 term; period sought 2.85599 s\n"
            "contact 0         u[0] <= 0.2 m\n"
            "law               rigid stops, e = 0.8\n");
  const std::string method = run("show fourier-lipschitz").out;
  EXPECT_NE(method.find("harmonics"), std::string::npos);
  EXPECT_NE(method.find("order             1, of the error of x"), std::string::npos) << method;
  EXPECT_NE(method.find("\nlimits            On a rigid stop"), std::string::npos) << method;
}

// The first two frequencies of a clamped bar of N linear elements, w^2 = 6 (1 - c) / (2 + c) N^2 with
// c = cos((2 k - 1) pi / (2 N)) for c = L = 1 m, under D = beta K: ratios beta w / 2. Of 1200 coordinates.
TEST(CommandShow, HasTheLowestModesOfLargeStructures) {
  constexpr int kElements = 1200;
  const test::TemporaryFolder folder;
  const std::string file =
      folder
          .write("bar.toml",
                 "schema = 1\nname = \"bar\"\n[system]\nkind = \"bar\"\nelements = 1200\n"
                 "length = 1.0\narea = 1.0\nyoung = 1.0\ndensity = 1.0\n"
                 "damping = { beta = 0.01 }\n[forcing]\nfrequency_hz = 1.0\n")
          .string();
  const std::string text = run("show " + file).out;
  std::string frequencies = "\neigenfrequencies  ", ratios = "\ndamping ratios    ";
  for (int k = 1; k <= 2; ++k) {
    const double c = std::cos((2 * k - 1) * std::numbers::pi / (2 * kElements));
    const double w = std::sqrt(6.0 * (1.0 - c) / (2.0 + c)) * kElements;
    frequencies += fmt::format("{:.6g}, ", w);
    ratios += fmt::format("{:.3g}, ", 0.005 * w);
  }
  EXPECT_NE(text.find(frequencies), std::string::npos) << text << frequencies;
  EXPECT_NE(text.find(ratios), std::string::npos) << text << ratios;
  EXPECT_NE(text.find("rad/s, the lowest\n"), std::string::npos) << text;
  EXPECT_NE(text.find("omega 6.28319 rad/s (1 Hz)"), std::string::npos) << text;
}

// Nothing holds the chain: the square of its first frequency is rounding of the others'.
TEST(CommandShow, TellsTheFrequencyOfARigidMotionAsZero) {
  const test::TemporaryFolder folder;
  const std::string file =
      folder
          .write("free.toml",
                 "schema = 1\nname = \"free\"\n[system]\nkind = \"chain\"\nmasses = [2.1, 0.7, 0.9, 1.1]\n"
                 "dampers = [0.0, 0.0, 0.0, 0.0]\nsprings = [0.0, 1.7e4, 2.3e4, 0.9e4]\n[forcing]\n"
                 "frequency = 1.0\n")
          .string();
  const std::string text = run("show " + file).out;
  EXPECT_NE(text.find("\neigenfrequencies  0, "), std::string::npos) << text;
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
