#include "harness/plan/suite.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "harness/failure.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::suite_test {
namespace {

struct BadSuite {
  const char* text;
  const char* complaint;
};

void PrintTo(const BadSuite& suite, std::ostream* stream) { *stream << suite.complaint; }

class ParseSuiteRefuses : public testing::TestWithParam<BadSuite> {};

TEST_P(ParseSuiteRefuses, WithOneLineThatNamesFileLineAndField) {
  try {
    parse_suite(GetParam().text, "x.toml");
    FAIL() << "must be refused";
  } catch (const SceneError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(GetParam().complaint, 0), 0U) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(
    EveryMistake, ParseSuiteRefuses,
    testing::Values(
        BadSuite{"schema = 2\nname=\"s\"\ntitle=\"t\"\nscenes=[\"*\"]", "x.toml:1: schema = 2 (must be 1)"},
        BadSuite{"schema = 1\ntitle=\"t\"\nscenes=[\"*\"]", "x.toml:1: name = missing"},
        BadSuite{"schema = 1\nname=\"Bad Name\"\ntitle=\"t\"\nscenes=[\"*\"]",
                 "x.toml:2: name = \"Bad Name\""},
        BadSuite{"schema = 1\nname=\"s\"\nscenes=[\"*\"]", "x.toml:1: title = missing"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"", "x.toml:1: scenes = missing"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\nscenes=\"*\"", "x.toml:4: scenes = \"*\""},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\n[[response]]\nscene=\"a\"\nfrom=1\nto=2\n"
                 "[[response]]\nscene=\"a\"\nfrom=2\nto=3",
                 "x.toml:9: response[1].scene = \"a\" (must be listed once)"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\n[[response]]\nscene=\"a\"\nfrom=0\nto=1",
                 "x.toml:6: response[0].from = 0"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\n[[response]]\nscene=\"a\"\nfrom=1\nto=1.0",
                 "x.toml:7: response[0].to = 1"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\n[[response]]\nscene=\"a\"\nfrom=1",
                 "x.toml:4: response[0].to = missing"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\n[[response]]\nscene=\"a\"\nfrom=1\nto=2\nstep=1",
                 "x.toml:8: response[0].step = 1"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\nscenes=[\"*\"]\nwithout_tags=\"x\"",
                 "x.toml:5: without_tags = \"x\""},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\nscenes=[1]", "x.toml:4: scenes[0] = 1"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\nscenes=[\"*\"]\nfoo = 1", "x.toml:5: foo = 1"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\nscenes=[\"*\"]\n[limits]\ntimeout = 0",
                 "x.toml:6: limits.timeout = 0"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\nscenes=[\"*\"]\n[limits]\ncertificate_timeout = 0",
                 "x.toml:6: limits.certificate_timeout = 0 (must be a positive"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\nscenes=[\"*\"]\n[limits]\nreference_timeout = -1",
                 "x.toml:6: limits.reference_timeout = -1 (must be a number of seconds >= 0"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\nscenes=[\"*\"]\n[limits]\nmemory = 1.5",
                 "x.toml:6: limits.memory = 1.5"},
        BadSuite{"schema = 1\nname=\"s\"\ntitle=\"t\"\nscenes=[\"*\"]\n[[expected_failure]]\ncase = \"a\"",
                 "x.toml:5: expected_failure[0].reason = missing"},
        BadSuite{"schema = 1\nname = ", "x.toml:2: "}));

TEST(ParseSuite, ReadsLimitsAndExpectedFailures) {
  const Suite suite = parse_suite(
      "schema = 1\nname = \"s\"\ntitle = \"t\"\n"
      "scenes = [\"a*\"]\n[limits]\ntimeout = 5\nreference_timeout = 0\nrepetitions = "
      "7\n[[expected_failure]]\ncase = "
      "\"a/*\"\nreason = \"hard\"\n",
      "s.toml");
  EXPECT_EQ(suite.limits.timeout, 5.0);
  EXPECT_EQ(suite.limits.reference_timeout, 0.0);
  EXPECT_EQ(suite.limits.repetitions, 7);
  EXPECT_EQ(suite.limits.memory_mb, Limits{}.memory_mb);
  ASSERT_EQ(suite.expected_failures.size(), 1U);
  EXPECT_EQ(suite.expected_failures[0].reason, "hard");
}

TEST(ParseSuite, ReadsResponses) {
  const Suite suite = parse_suite(
      "schema = 1\nname=\"s\"\ntitle=\"t\"\nby_steps=[\"event-driven\"]\n[[response]]\nscene=\"sdof-stop\"\n"
      "from=2.0\nto=1.0\norders=3\n[[response]]\nscene=\"own.toml\"\nfrom=1\nto=2\nhz=true\n",
      "suites/x.toml");
  ASSERT_EQ(suite.responses.size(), 2U);
  EXPECT_EQ(suite.responses[0].scene, "sdof-stop");
  EXPECT_EQ(suite.responses[0].from, 2.0);
  EXPECT_EQ(suite.responses[0].to, 1.0);
  EXPECT_EQ(suite.responses[0].orders, 3);
  EXPECT_EQ(suite.responses[1].scene, "suites/own.toml");  // as files of `scenes`
  EXPECT_EQ(suite.responses[1].orders, 2);
  EXPECT_EQ(suite.responses[1].from, 2.0 * std::numbers::pi);
  EXPECT_EQ(suite.responses[1].to, 4.0 * std::numbers::pi);
  EXPECT_EQ(suite.by_steps, (std::vector<std::string>{"event-driven"}));
}

TEST(CatalogueSuites, CanAllBeReadUnderTheirFileNames) {
  ASSERT_GE(shipped_files("suites").size(), 2U);
  for (const auto& file : shipped_files("suites"))
    EXPECT_EQ(load_suite(file.string()).name, file.stem().string());
}

TEST(LoadSuite, NamesTheSuitesThereAreWhereThereIsNone) {
  EXPECT_EQ(load_suite("quick").name, "quick");
  try {
    load_suite("no-such-suite");
    FAIL() << "must be refused";
  } catch (const UsageError& error) {
    const std::string what = error.what();
    EXPECT_TRUE(what.starts_with("suite = no-such-suite (must be a TOML file or one of ")) << what;
    EXPECT_NE(what.find("quick"), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace signorini::suite_test
