#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::ranking_sections_test {
namespace {

/// The line of a section's table that begins with these cells.
std::vector<std::string> row_of(const std::vector<Section>& sections, const std::string& id,
                                const std::vector<std::string>& begin) {
  for (const Section& section : sections) {
    if (section.id != id) continue;
    for (const auto& row : section.table.rows) {
      std::vector<std::string> texts;
      for (const Cell& cell : row) texts.push_back(cell.text);
      if (std::equal(begin.begin(), begin.end(), texts.begin())) return texts;
    }
  }
  return {};
}

TEST(RankingSections, SaySuccessBeforeAnyTime) {
  std::vector<Record> records;
  for (int i = 0; i < 8; ++i) {
    Record fragile = test::good_record("s" + std::to_string(i), "fragile", "n=1", 0.001, 1e-3);
    if (i >= 3) fragile.status = Status::timeout;
    records.push_back(fragile);
    records.push_back(test::good_record("s" + std::to_string(i), "robust", "n=1", 0.001, 2.0));
  }
  const std::vector<Section> sections = sections_of(Evaluation(records, {.timeout = 10.0}));
  EXPECT_EQ(row_of(sections, "time-to-error-1", {"fragile"})[1], "3 of 8");
  EXPECT_EQ(row_of(sections, "time-to-error-1", {"robust"})[1], "8 of 8, 2 s");
  const std::vector<std::string> means = row_of(sections, "means-1", {"1e-02", "fragile"});
  ASSERT_EQ(means.size(), 10U);
  EXPECT_EQ(means[2], "3 of 8");
  EXPECT_EQ(means[6], "12.5 s");  // PAR2: (3 * 1 ms + 5 * 20 s) / 8
  EXPECT_EQ(means[7], "38 %");
  EXPECT_EQ(means[9], "38 %");
}

TEST(RankingSections, NameTheKindOfScenesAndTheFewWhoDoNotRepresentTheirLaw) {
  std::vector<Record> records;
  for (const std::string method : {"a", "b", "c"}) {
    records.push_back(test::good_record("s1", method, "n=1", 0.001, 1.0));
    records.push_back(test::good_record("s2", method, "n=1", 0.001, 1.0));
    records.push_back(test::good_record("s3", method, "n=1", 0.001, 1.0));
  }
  records[4].law_matches_scene = false;  // b on s2
  records[5].law_matches_scene = false;  // b and c on s3
  records[8].law_matches_scene = false;
  for (Record& record : records)
    if (record.scene == "s3") record.scene_law = Penalty{{1e3}};
  std::vector<std::string> titles, texts;
  for (const Section& section : sections_of(Evaluation(records))) {
    if (!section.id.starts_with("time-to-error-")) continue;
    titles.push_back(section.title);
    texts.push_back(section.text.substr(0, section.text.find('.') + 1));
  }
  std::ranges::sort(titles);
  std::ranges::sort(texts);
  EXPECT_EQ(titles, (std::vector<std::string>{"Time to error: rigid stop (e = 1), 1 scene",
                                              "Time to error: rigid stop (e = 1), 1 scene",
                                              "Time to error: spring, 1 scene"}));
  EXPECT_EQ(texts, (std::vector<std::string>{
                       "All methods are ranked: all solve the impact law of these scenes.",
                       "Ranked are the methods that solve the impact law of these scenes: all but b.",
                       "Ranked is a: no other method solves the impact law of these scenes."}));
}

TEST(RankingSections, CallNobodySlowWhoWasNotTimed) {
  Record record = test::good_record("s", "m", "n=1", 0.005, 1.0);
  record.seconds.reset();
  record.not_timed = "not a Release build";
  Record other = record;  // of one scene there are no tables over scenes
  other.scene = "t";
  other.case_id = "t/m[n=1]";
  const std::vector<Section> sections = sections_of(Evaluation({record, other}));
  EXPECT_TRUE(row_of(sections, "time-to-error-1", {"m"}).empty());
  EXPECT_TRUE(row_of(sections, "means-1", {"1e-02"}).empty());
  const std::vector<std::string> work = row_of(sections, "work-1", {"1e-02", "m"});
  ASSERT_EQ(work.size(), 7U);
  EXPECT_EQ(work[2], "12");
  const std::vector<std::string> study = row_of(sections, "scenes", {"s"});
  ASSERT_EQ(study.size(), 10U);
  EXPECT_EQ(study[6], "not timed");
  EXPECT_EQ(study[7], "not reached");
}

TEST(RankingSections, SayWhereTheShiftDecidesTheOrder) {
  std::vector<Record> records;
  for (int i = 0; i < 4; ++i) {
    const std::string scene = "s" + std::to_string(i);
    records.push_back(test::good_record(scene, "mostly-fast", "n=1", 0.05, i < 3 ? 1e-5 : 0.5));
    records.push_back(test::good_record(scene, "even", "n=1", 0.05, 0.01));
  }
  const auto note = [&] {
    for (const Section& section : sections_of(Evaluation(records))) {
      if (section.id == "means-1") return section.note;
    }
    return std::string();
  };
  EXPECT_NE(note().find("changes with the shift at error 1e-01, "), std::string::npos) << note();
  for (Record& record : records) record.seconds->median = record.method == "even" ? 1.0 : 2.0;
  EXPECT_NE(note().find("the same with all three shifts"), std::string::npos) << note();
}

// Times of twelve scenes that vary by a factor of 100 between scenes and by 3 % of noise, of b those of a
// times a factor.
std::vector<Section> sections_of_pair(double factor) {
  std::vector<Record> records;
  for (int i = 0; i < 12; ++i) {
    const std::string scene = "s" + std::to_string(i);
    const double time = std::pow(10.0, i / 6.0), noise = 1.0 + 0.03 * std::sin(7.0 * i);
    records.push_back(test::good_record(scene, "a", "n=1", 0.001, time));
    records.push_back(test::good_record(scene, "b", "n=1", 0.001, factor * time * noise));
    records.push_back(test::good_record(scene, "c", "n=1", 0.001, 50.0 * time));
  }
  return sections_of(Evaluation(records));
}

std::vector<std::string> pair_row(double factor) {
  return row_of(sections_of_pair(factor), "pairs-1", {"1e-02", "a"});
}

TEST(RankingSections, TellADifferenceFromChance) {
  EXPECT_EQ(pair_row(1.2)[3], "100 % (0.83)");
  EXPECT_NE(pair_row(1.02)[3].find(" ="), std::string::npos) << pair_row(1.02)[3];
  EXPECT_EQ(pair_row(1.2)[4], "100 % (0.02)");
}

// A method made 20 % slower is told apart from the best, one made 2 % slower is not.
TEST(RankingSections, SayHowSureSharesAndTimesAre) {
  // Twelve times 10^(i / 6) s: the median is the mean of 6.81 s and 10 s. Wilson's interval of 12 of 12
  // begins at 1 / (1 + 1.96^2 / 12). That a sample of 12 draws has its 6th smallest value at most the 3rd of
  // all has the probability 5.4 %, at most the 2nd 0.79 %; the ends of the median's interval are so the 3rd
  // and the 10th.
  const std::vector<Section> slower = sections_of_pair(1.2), alike = sections_of_pair(1.02);
  EXPECT_EQ(row_of(slower, "intervals-1", {"a"}),
            (std::vector<std::string>{"a", "12 of 12", "76 to 100 %", "8.41 s", "2.15 s to 31.6 s", "-"}));
  EXPECT_EQ(row_of(slower, "intervals-1", {"b"})[5], "1.2 times as long");
  // With its noise b has the least median there.
  EXPECT_EQ(row_of(alike, "intervals-1", {"b"})[5], "-");
  EXPECT_EQ(row_of(alike, "intervals-1", {"a"})[5], "no difference");
  EXPECT_EQ(row_of(alike, "intervals-1", {"c"})[5], "49 times as long");
}

TEST(RankingSections, SayHowManyScenesFewerAMethodSolvesThanTheBest) {
  std::vector<Record> records;
  for (int i = 0; i < 12; ++i) {
    const std::string scene = "s" + std::to_string(i);
    records.push_back(test::good_record(scene, "a", "n=1", 0.001, 1.0));
    records.push_back(test::good_record(scene, "b", "n=1", i < 4 ? 0.001 : 0.05, 2.0));
  }
  EXPECT_EQ(row_of(sections_of(Evaluation(records)), "intervals-1", {"b"}),
            (std::vector<std::string>{"b", "4 of 12", "14 to 61 %", "not reached", "2 s to not reached",
                                      "2 times as long, 8 fewer solved"}));
}

TEST(RankingSections, CountTargetsReachedWithinATime) {
  std::vector<Record> records;
  for (int i = 0; i < 4; ++i) {
    const std::string scene = "s" + std::to_string(i);
    records.push_back(test::good_record(scene, "a", "n=1", 0.005, i < 2 ? 2e-3 : 0.5));  // to 1e-1 and 1e-2
    records.push_back(test::good_record(scene, "b", "n=1", 0.005, 2.0));
  }
  // 8 of 20 targets in the end, half of them within 10 ms.
  EXPECT_EQ(row_of(sections_of(Evaluation(records)), "distribution-1", {"a"}),
            (std::vector<std::string>{"a", "0 %", "0 %", "20 %", "40 %", "40 %"}));
}

}  // namespace
}  // namespace signorini::ranking_sections_test
