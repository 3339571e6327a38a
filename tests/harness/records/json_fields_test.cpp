#include "harness/records/json_fields.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace signorini::json_fields_test {

namespace {
enum class Colour { red, green };
struct Point {
  double x = 0.0;
};
struct Sample {
  int count = 7;
  std::string word = {};
  std::optional<double> number = {};
  Colour colour = Colour::red;
  Point group = {};
  std::optional<Point> point = {};
  std::vector<Point> points = {};
  std::vector<double> numbers = {};
};

void visit_fields(Either<Point> auto& point, auto&& field) { field(required("x", "m"), point.x); }

void visit_fields(Either<Sample> auto& sample, auto&& field) {
  field(required("count"), sample.count);
  field(Field{"word"}, sample.word);
  field(Field{"number"}, sample.number);
  field(Field{"colour"}, sample.colour);
  field(Field{"group"}, sample.group);
  field(Field{"point"}, sample.point);
  field(Field{"points", "", Presence::always}, sample.points);
  field(Field{"numbers"}, sample.numbers);
}
}  // namespace
}  // namespace signorini::json_fields_test

template <>
struct signorini::EnumNames<signorini::json_fields_test::Colour> {
  static constexpr std::array<std::string_view, 2> values{"red", "green"};
};

namespace signorini::json_fields_test {
namespace {

using Json = nlohmann::ordered_json;

Sample read(const char* text) {
  Sample sample;
  read_fields(Json::parse(text), sample);
  return sample;
}

TEST(WriteFields, LeaveOutWhatIsEmptyUnlessItIsAlwaysThere) {
  EXPECT_EQ(write_fields(Sample{}).dump(), R"({"count":7,"colour":"red","group":{"x":0.0},"points":[]})");
}

TEST(WriteFields, HaveTheOrderOfTheVisit) {
  const Sample sample{.count = 1,
                      .word = "w",
                      .number = 0.5,
                      .colour = Colour::green,
                      .group = {1.0},
                      .point = Point{2.0},
                      .points = {{3.0}, {4.0}},
                      .numbers = {5.0}};
  EXPECT_EQ(write_fields(sample).dump(),
            R"({"count":1,"word":"w","number":0.5,"colour":"green","group":{"x":1.0},"point":{"x":2.0},)"
            R"("points":[{"x":3.0},{"x":4.0}],"numbers":[5.0]})");
  EXPECT_EQ(write_fields(read(write_fields(sample).dump().c_str())), write_fields(sample));
}

TEST(WriteFields, TakeANumberThatIsNotFiniteForNone) {
  for (const double number :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(write_fields(Sample{.number = number}).contains("number"));
}

TEST(ReadFields, KeepWhatTheObjectDoesNotHold) {
  const Sample sample = read(R"({"count": 3})");
  EXPECT_EQ(sample.count, 3);
  EXPECT_FALSE(sample.number.has_value());
  EXPECT_TRUE(sample.points.empty());
}

TEST(ReadFields, TakeWholeNumbersAndNoOthers) {
  EXPECT_EQ(read(R"({"count":3.0})").count, 3);
  EXPECT_EQ(read(R"({"count":-2147483648})").count, std::numeric_limits<int>::min());
  for (const char* text : {R"({"count":2.44e49})", R"({"count":-1e300})", R"({"count":2147483648})",
                           R"({"count":18446744073709551615})", R"({"count":3.5})"})
    EXPECT_THROW(read(text), BadRecord) << text;
  EXPECT_THROW(read(R"({"count":"3"})"), BadRecord);
  EXPECT_EQ(whole_number<long>("n", Json::parse("9007199254740993")), 9007199254740993);
  EXPECT_THROW(whole_number<long>("n", Json::parse("9223372036854775808")), BadRecord);
  EXPECT_THROW(whole_number<unsigned>("n", Json::parse("-1")), BadRecord);
}

TEST(ReadFields, TakeNothingButAListForAList) {
  for (const char* text : {R"({"count":1,"points":5})", R"({"count":1,"points":{"a":{"x":1}}})"})
    EXPECT_THROW(read(text), nlohmann::json::exception) << text;
}

TEST(ReadFields, RefuseAMissingKeyAWrongTypeAndAnUnknownName) {
  EXPECT_THROW(read("{}"), nlohmann::json::exception);
  EXPECT_THROW(read(R"({"count": 1, "point": {}})"), nlohmann::json::exception) << "x is missing";
  EXPECT_THROW(read(R"({"count": "many"})"), BadRecord);
  try {
    read(R"({"count": 1, "colour": "blue"})");
    ADD_FAILURE() << "must be refused";
  } catch (const BadRecord& error) {
    EXPECT_STREQ(error.what(), "colour = blue (must be one of red, green)");
  }
}

}  // namespace
}  // namespace signorini::json_fields_test
