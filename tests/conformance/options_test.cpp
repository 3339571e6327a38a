// Options of every method: echoed, documented, and no value whatever does worse than be refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

#include "methods/catalogue.hpp"
#include "tests/conformance/method_case.hpp"

namespace signorini {
namespace {

using Settings = std::vector<OptionSetting>;

void expect_readable(const InvalidOption& refusal, const std::string& key) {
  const std::string what = refusal.what();
  EXPECT_EQ(what.rfind(key + " = ", 0), 0U) << what;
  EXPECT_EQ(what.back(), ')') << what;
  EXPECT_EQ(what.find('\n'), std::string::npos) << what;
}

class OptionsOf : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] std::unique_ptr<Method> make(const Settings& settings) const {
    return find_method(GetParam()).make(settings);
  }
};

TEST_P(OptionsOf, AreAllEchoedWithUnitAndMeaning) {
  std::set<std::string> names;
  for (const OptionEcho& option : make({})->options()) {
    EXPECT_TRUE(names.insert(option.name).second) << option.name << " twice";
    EXPECT_FALSE(option.meaning.empty()) << option.name;
    EXPECT_TRUE(option.unit.starts_with('[') && option.unit.ends_with(']'))
        << option.name << ": " << option.unit;
  }
  EXPECT_TRUE(names.contains("tolerance"));
  EXPECT_TRUE(names.contains("max_iterations"));
}

TEST_P(OptionsOf, TheCheapOnesOfThisSuiteAreEchoedAsGiven) {
  const Settings settings = test::traits_of(GetParam()).settings;
  const auto echo = make(settings)->options();
  for (const auto& [key, text] : settings) {
    const auto found =
        std::find_if(echo.begin(), echo.end(), [&, &name = key](const auto& o) { return o.name == name; });
    ASSERT_NE(found, echo.end()) << key;
    const auto* whole = std::get_if<long>(&found->value);
    const auto* number = std::get_if<double>(&found->value);
    ASSERT_TRUE(whole != nullptr || number != nullptr) << key;
    EXPECT_EQ(whole != nullptr ? static_cast<double>(*whole) : *number, std::stod(text));
  }
}

TEST_P(OptionsOf, UnknownOnesAreRefusedWithAListOfTheKnown) {
  try {
    (void)make({{"flux_capacitance", "1"}});
    FAIL() << "accepted";
  } catch (const InvalidOption& refusal) {
    expect_readable(refusal, "flux_capacitance");
    for (const OptionEcho& option : make({})->options()) {
      EXPECT_NE(std::string(refusal.what()).find(option.name), std::string::npos) << option.name;
    }
  }
}

TEST_P(OptionsOf, EveryBadValueIsRefusedInOneLineOrAcceptedAndEchoed) {
  const char* values[] = {"0",          "-0",         "-1",       "1",     "nan",
                          "-nan",       "inf",        "-inf",     "1e300", "-1e300",
                          "1e-300",     "1e999",      "0x10",     "1.5",   "99999999999999999999",
                          "2147483648", "4294967301", "10000001", "",      " ",
                          "auto",       "text",       "1e6x",     "nanx",  "-1x",
                          "true",       "1 ",         "1,5"};
  for (const OptionEcho& option : make({})->options()) {
    for (const char* value : values) {
      SCOPED_TRACE(testing::Message() << option.name << " = '" << value << "'");
      try {
        const auto method = make({{option.name, value}});
        EXPECT_EQ(method->options().size(), make({})->options().size());
      } catch (const InvalidOption& refusal) {
        expect_readable(refusal, option.name);
      }
      // Anything else that is thrown fails the test.
    }
  }
}

TEST_P(OptionsOf, NumbersThatAreNotFiniteAreNeverAccepted) {
  for (const OptionEcho& option : make({})->options()) {
    for (const char* value : {"nan", "-nan", "inf", "-inf", "infx", "1e999"}) {
      EXPECT_THROW((void)make({{option.name, value}}), InvalidOption) << option.name << " = " << value;
    }
  }
}

TEST_P(OptionsOf, WordsAreAcceptedBackAsEchoed) {
  for (const OptionEcho& option : make({})->options()) {
    const auto* word = std::get_if<std::string>(&option.value);
    if (word == nullptr) continue;
    const auto method = make({{option.name, *word}});
    for (const OptionEcho& echo : method->options()) {
      if (echo.name != option.name) continue;
      EXPECT_EQ(std::get<std::string>(echo.value), *word);
    }
  }
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodEntry& entry : method_catalogue()) names.emplace_back(entry.name);
  return names;
}

std::string camel_case(const testing::TestParamInfo<std::string>& info) {
  const std::string name = test::MethodCase{info.param, ""}.name();
  return name.substr(0, name.size() - 1);
}

INSTANTIATE_TEST_SUITE_P(Conformance, OptionsOf, testing::ValuesIn(method_names()), camel_case);

TEST(MethodCatalogue, NamesAreUniqueAndInKebabCase) {
  std::set<std::string> seen;
  for (const MethodEntry& entry : method_catalogue()) {
    EXPECT_TRUE(seen.insert(std::string(entry.name)).second) << entry.name;
    EXPECT_EQ(entry.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string_view::npos);
    EXPECT_FALSE(entry.title.empty());
    EXPECT_FALSE(entry.laws.empty());
    EXPECT_NE(entry.ladder.find('='), std::string_view::npos) << entry.name;
  }
}

TEST(MethodCatalogue, AnUnknownNameIsRefusedWithTheNamesThereAre) {
  try {
    (void)find_method("time-machine");
    FAIL() << "accepted";
  } catch (const InvalidOption& refusal) {
    for (const MethodEntry& entry : method_catalogue()) {
      EXPECT_NE(std::string(refusal.what()).find(entry.name), std::string::npos);
    }
  }
}

// The resolutions a benchmark runs must be options the method accepts.
TEST(MethodCatalogue, LaddersAreAccepted) {
  for (const MethodEntry& entry : method_catalogue()) {
    std::istringstream ladder{std::string(entry.ladder)};
    for (std::string option; std::getline(ladder, option, ',');) {
      const auto equals = option.find('=');
      ASSERT_NE(equals, std::string::npos) << entry.name << ": " << entry.ladder;
      std::istringstream values(option.substr(equals + 1));
      for (std::string value; std::getline(values, value, '|');) {
        const Settings settings{{option.substr(0, equals), value}};
        EXPECT_NO_THROW((void)entry.make(settings)) << entry.name << ": " << entry.ladder;
      }
    }
  }
}

}  // namespace
}  // namespace signorini
