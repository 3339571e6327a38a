#include "methods/options.hpp"

#include <gtest/gtest.h>

namespace signorini::options_test {

namespace {

enum class Colour { red, green };

struct Palette {
  int count = 3;
  double size = 0.5;
  bool loud = false;
  Colour colour = Colour::red;
  std::optional<int> limit = {};
  Scaled weight = {2.0, true};

  void visit(auto&& field) {
    field("count", count, "[-]", "how many");
    field("size", size, "[m]", "how large");
    field("loud", loud, "[-]", "how loud");
    field("colour", colour, "[-]", "which");
    field("limit", limit, "[-]", "at most");
    field("weight", weight, "[N]", "how heavy");
  }
};

}  // namespace
}  // namespace signorini::options_test

template <>
struct signorini::EnumNames<signorini::options_test::Colour> {
  static constexpr std::array<std::string_view, 2> values{"red", "green"};
};

namespace signorini::options_test {
namespace {

Palette with(std::string key, std::string text) {
  Palette options;
  const std::vector<OptionSetting> settings{{std::move(key), std::move(text)}};
  apply_settings(options, settings);
  return options;
}

std::string refusal(const std::string& key, const std::string& text) {
  try {
    with(key, text);
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Options, AreReadByKey) {
  EXPECT_EQ(with("count", "12").count, 12);
  EXPECT_EQ(with("size", "1e-3").size, 1e-3);
  EXPECT_TRUE(with("loud", "true").loud);
  EXPECT_EQ(with("colour", "green").colour, Colour::green);
  EXPECT_EQ(with("limit", "7").limit, 7);
  EXPECT_EQ(with("limit", "auto").limit, std::nullopt);
  EXPECT_EQ(with("weight", "100x").weight, (Scaled{100.0, true}));
  EXPECT_EQ(with("weight", "1e6").weight, (Scaled{1e6, false}));
}

TEST(Options, RefuseWhatTheyCannotRead) {
  EXPECT_EQ(refusal("count", "1.5"), "count = 1.5 (must be a whole number)");
  EXPECT_EQ(refusal("count", "99999999999"), "count = 99999999999 (must be a whole number)");
  EXPECT_EQ(refusal("count", ""), "count =  (must be a whole number)");
  EXPECT_EQ(refusal("size", "nan"), "size = nan (must be a finite number)");
  EXPECT_EQ(refusal("size", "inf"), "size = inf (must be a finite number)");
  EXPECT_EQ(refusal("size", "1 m"), "size = 1 m (must be a finite number)");
  EXPECT_EQ(refusal("loud", "yes"), "loud = yes (must be true or false)");
  EXPECT_EQ(refusal("colour", "blue"), "colour = blue (must be one of red, green)");
  EXPECT_EQ(refusal("weight", "x"), "weight = x (must be a number in SI units, or a multiple such as 100x)");
  EXPECT_EQ(refusal("taste", "1"),
            "taste = 1 (unknown option; known: count, size, loud, colour, limit, weight)");
}

TEST(Options, EchoEveryValueWithUnitAndMeaning) {
  const auto echo = echo_options(with("weight", "3x"));
  ASSERT_EQ(echo.size(), 6U);
  EXPECT_EQ(echo[0].name, "count");
  EXPECT_EQ(std::get<long>(echo[0].value), 3);
  EXPECT_EQ(echo[1].unit, "[m]");
  EXPECT_EQ(std::get<std::string>(echo[3].value), "red");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(echo[4].value));
  EXPECT_EQ(std::get<std::string>(echo[5].value), "3x");
}

TEST(Scaled, IsAMultipleOrAnAbsoluteValue) {
  EXPECT_EQ((Scaled{3.0, true}).in_units_of(2.0), 6.0);
  EXPECT_EQ((Scaled{3.0, false}).in_units_of(2.0), 3.0);
}

}  // namespace
}  // namespace signorini::options_test
