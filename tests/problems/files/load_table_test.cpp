#include "problems/files/load_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/files/toml_tree.hpp"

namespace signorini::load_table_test {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

std::vector<double> sampled(int count, double (*f)(double)) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(f(kTurn * i / count));
  return values;
}

std::string refusal(std::string_view text) {
  try {
    parse_load_table(text, "f.csv", 4.0);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

TEST(LoadOfSamples, FindsTheHarmonicsOfASumOfThem) {
  const auto f = [](double a) { return 0.5 + 2.0 * std::cos(a) - 3.0 * std::sin(4.0 * a); };
  for (const int count : {9, 10, 64}) {
    const SampledLoad load = load_of_samples(sampled(count, f), std::nullopt);
    ASSERT_EQ(load.harmonics(), 4) << count;
    const std::vector<double> cos{0.5, 2.0, 0.0, 0.0, 0.0}, sin{0.0, 0.0, 0.0, 0.0, -3.0};
    for (std::size_t h = 0; h < 5; ++h) {
      EXPECT_NEAR(load.cos[h], cos[h], 1e-14) << count << " " << h;
      EXPECT_NEAR(load.sin[h], sin[h], 1e-14) << count << " " << h;
    }
    EXPECT_NEAR(load.rms, std::sqrt(6.5), 1e-14);
    EXPECT_LT(load.left_out_max, 1e-14);
  }
}

// Of a sawtooth, f = pi - a on (0, 2 pi), the harmonic h is 2 sin(h a) / h, and Parseval's sum is the rest.
TEST(LoadOfSamples, StatesWhatFewHarmonicsLeaveOut) {
  constexpr int kCount = 20001, kKept = 10;
  const SampledLoad load =
      load_of_samples(sampled(kCount, [](double a) { return a == 0.0 ? 0.0 : std::numbers::pi - a; }), kKept);
  ASSERT_EQ(load.harmonics(), kKept);
  double kept = 0.0;
  for (int h = 1; h <= kKept; ++h) {
    EXPECT_NEAR(load.sin[static_cast<std::size_t>(h)], 2.0 / h, 1e-4);
    kept += 2.0 / (h * h);
  }
  EXPECT_NEAR(load.rms, std::numbers::pi / std::sqrt(3.0), 1e-3);
  EXPECT_NEAR(load.left_out_rms, std::sqrt(std::numbers::pi * std::numbers::pi / 3.0 - kept), 1e-3);
  EXPECT_GT(load.left_out_max, 2.0) << "a series of few harmonics cannot jump by 2 pi";
}

TEST(LoadOfSamples, SaysThatAnAlternatingLoadIsBeyondItsSamples) {
  const SampledLoad load = load_of_samples({1.0, -1.0, 1.0, -1.0}, std::nullopt);
  EXPECT_EQ(load.harmonics(), 1);
  EXPECT_NEAR(load.left_out_rms, 1.0, 1e-15);
}

TEST(ParseLoadTable, ReadsValuesWithAndWithoutInstants) {
  const std::vector<double> expected{1.0, -2.5, 3e2, 0.0};
  EXPECT_EQ(parse_load_table("1\n-2.5\n+3e2\n0\n", "f", 4.0), expected);
  EXPECT_EQ(parse_load_table("# measured\nt [s], f [N]\n0, 1\n1, -2.5\n\n2; 3e2\r\n3\t0", "f", 4.0),
            expected);
  EXPECT_EQ(parse_load_table("\xEF\xBB\xBF"
                             "1\n-2.5\n3e2\n0\n",
                             "f", 4.0),
            expected)
      << "a byte order mark";
}

TEST(ParseLoadTable, NamesCommonMistakes) {
  EXPECT_EQ(refusal("0;1,5\n1;2,5\n2;1,0\n"),
            "f.csv:1: columns = 3 (must be 1, the samples, or 2, instants [s] and samples, in every line; a "
            "decimal comma: write a point, as in 1.5)");
  EXPECT_EQ(refusal("\xE2\x88\x92"
                    "1.5\n2\n3\n"),
            "f.csv:1: value = \"\xE2\x88\x92"
            "1.5\" (must be a finite number; the minus sign is one of a text "
            "processor: write -)");
}

TEST(ParseLoadTable, RefusesWhatIsNoTableOfThePeriod) {
  EXPECT_EQ(refusal("1\nx\n2"), "f.csv:2: value = \"x\" (must be a finite number)");
  EXPECT_EQ(refusal("1\n2\nnan\n4"), "f.csv:3: value = \"nan\" (must be a finite number)");
  EXPECT_EQ(refusal("1\n2"), "f.csv:2: samples = 2 (must be at least 3)");
  EXPECT_EQ(refusal(""), "f.csv:1: samples = 0 (must be at least 3)");
  EXPECT_EQ(refusal("1\n2 3\n"),
            "f.csv:2: columns = 2 (must be 1, the samples, or 2, instants [s] and samples, in every line)");
  EXPECT_EQ(
      refusal("0 1\n1 1\n2 1"),
      "f.csv:3: instant 1 = 1 s (must be 1.33333 s: 3 samples, equidistant from 0, fill the period of the "
      "load, 4 s)");
}

}  // namespace
}  // namespace signorini::load_table_test
