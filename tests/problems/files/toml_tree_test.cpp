#include "problems/files/toml_tree.hpp"

#include <gtest/gtest.h>

namespace signorini::toml_tree_test {
namespace {

constexpr std::string_view kText = R"(b = 2
a = [1, "two", 3.5]

[table]
flag = true
day = 2020-02-29
)";

TEST(ParseToml, KeepsTheOrderAndTheLinesOfTheFile) {
  const TomlNode document = parse_toml(kText, "file.toml");
  const auto& entries = std::get<TomlTable>(document.value);
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].key, "b");
  EXPECT_EQ(entries[1].key, "a");
  EXPECT_EQ(entries[2].key, "table");
  EXPECT_EQ(entries[1].line, 2);
  EXPECT_EQ(entries[2].value.line, 4);
  const TomlNode* table = document.find("table");
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->find("day")->line, 6);
  EXPECT_EQ(table->find("night"), nullptr);
  EXPECT_EQ(document.find("b")->find("c"), nullptr) << "a number has no entries";
}

TEST(ParseToml, TellsWholeNumbersFromOthersAndMomentsFromText) {
  const TomlNode document = parse_toml(kText, "file.toml");
  EXPECT_EQ(std::get<std::int64_t>(document.find("b")->value), 2);
  const auto& list = std::get<TomlArray>(document.find("a")->value);
  EXPECT_EQ(std::get<std::string>(list[1].value), "two");
  EXPECT_EQ(std::get<double>(list[2].value), 3.5);
  EXPECT_TRUE(std::get<bool>(document.find("table")->find("flag")->value));
  EXPECT_EQ(std::get<TomlMoment>(document.find("table")->find("day")->value).text, "2020-02-29");
}

TEST(ParseToml, NamesTheLineOfWhatIsNoToml) {
  try {
    parse_toml("a = 1\nb = \n", "file.toml");
    FAIL() << "it is accepted";
  } catch (const SceneError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("file.toml:2: file = not TOML")) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
  }
}

TEST(TakeStep, TakesKeysAndIndicesInTurn) {
  std::string_view path = "forcing.term[12].dof";
  EXPECT_EQ(take_step(path)->key, "forcing");
  EXPECT_EQ(take_step(path)->key, "term");
  EXPECT_EQ(take_step(path)->index, 12U);
  EXPECT_EQ(take_step(path)->key, "dof");
  EXPECT_TRUE(path.empty());
}

TEST(TakeStep, LeavesAMalformedIndexAsItIs) {
  for (const std::string_view malformed : {"[x]", "[0", "[0]gap", "[]"}) {
    std::string_view path = malformed;
    EXPECT_FALSE(take_step(path)) << malformed;
    EXPECT_EQ(path, malformed);
  }
}

TEST(Print, ShowsAValueOnOneLine) {
  EXPECT_EQ(print(*parse_toml(kText, "file.toml").find("a")), "[1, \"two\", 3.5]");
  EXPECT_EQ(print(*parse_toml(kText, "file.toml").find("table")), "{flag = true, day = 2020-02-29}");
  EXPECT_EQ(print(*parse_toml("a = \"x\\ny\"", "file.toml").find("a")), "\"x\\ny\"");
}

TEST(OneLine, CutsLongTextBetweenCharacters) {
  EXPECT_EQ(one_line("abc", 3), "abc");
  EXPECT_EQ(one_line("abcd", 3), "abc...");
  EXPECT_EQ(one_line("ab\u00e9d", 3), "ab\u00e9...") << "a character of two bytes is kept whole";
  EXPECT_EQ(one_line("a\x01"), "a\\x01");
}

TEST(ParseToml, RefusesKeysOfMoreThanAHundredParts) {
  const auto key_of = [](int parts, const std::string& part) {
    std::string key = part;
    for (int i = 1; i < parts; ++i) key += "." + part;
    return key;
  };
  EXPECT_NO_THROW(parse_toml(key_of(100, "a") + " = 1", "f.toml"));
  for (const char* part : {"a", "\"a\"", "\"a,b\"", "'a.b'", "\"\\\"\""}) {
    const std::string deep = key_of(20000, part);
    for (const std::string& text :
         {deep + " = 1", "[" + deep + "]", "[[" + deep + "]]", "x = {" + deep + " = 1}"}) {
      try {
        parse_toml("# a comment, a.b.c\n" + text, "f.toml");
        ADD_FAILURE() << part;
      } catch (const SceneError& error) {
        EXPECT_STREQ(error.what(),
                     "f.toml:2: file = not TOML (must be valid TOML 1.0; a key has more than 100 parts)");
      }
    }
  }
}

TEST(ParseToml, TakesAsManyDotsInTextsNumbersAndCommentsAsThereAre) {
  std::string dots, numbers = "n = [0.5";
  for (int i = 0; i < 300; ++i) dots += "so. ", numbers += ", 1.5";
  const TomlNode document =
      parse_toml("# " + dots + "\na = \"" + dots + "\"\nb = '" + dots + "'\nc = \"\"\"\n" + dots +
                     "\n\"\"\"\nd = \"\\\"" + dots + "\"\n" + numbers + "]\n",
                 "f.toml");
  EXPECT_EQ(std::get<TomlArray>(document.find("n")->value).size(), 301U);
}

TEST(OneLine, LeavesNothingToATerminal) {
  EXPECT_EQ(one_line("\x1b[31m\x7f\xc2\x9b"), "\\x1b[31m\\x7f\\xc2\\x9b");
  EXPECT_EQ(one_line("\xff\xc3(\xe2\x82"), "\\xff\\xc3(\\xe2\\x82") << "bytes that are no UTF-8";
  EXPECT_EQ(one_line("\xc0\xaf"), "\\xc0\\xaf") << "a slash spelt in two bytes";
  EXPECT_EQ(one_line("µ = 3 ‖x‖"), "µ = 3 ‖x‖");
}

}  // namespace
}  // namespace signorini::toml_tree_test
