#include "harness/report/formats/screen.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "harness/run_folder/record_store.hpp"
#include "tests/harness/sample_records.hpp"
#include "tests/harness/stored_records.hpp"
#include "tests/support/data_folder.hpp"

namespace signorini::screen_test {
namespace {

/// Of a run in the folder `out`, without colour.
const ScreenContext kContext{.heading = "14 cases run, 0 already there; records and manifest are in out",
                             .folder = "out",
                             .program = "signorini"};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Says so where it is more than a screen.
void expect_one_screen(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  EXPECT_LE(lines.size(), kScreenLines) << text;
  EXPECT_TRUE(text.ends_with('\n'));
  for (const std::string& line : lines) EXPECT_LE(line.size(), kTerminalWidth) << line;
  EXPECT_EQ(text.find('\033'), std::string::npos) << text;
}

/// Three scenes with a rigid stop and one with a spring. On the stops `fast` needs 1 ms to 0.5 % and, but for
/// one, 20 ms to 1e-7; `exact` is always exact after 50 ms, `rough` never better than 5 %.
std::vector<Record> records_with_known_winners() {
  std::vector<Record> records;
  for (const char* scene : {"s1", "s2", "s3"}) {
    records.push_back(test::good_record(scene, "fast", "n=1", 5e-3, 1e-3));
    records.push_back(test::good_record(scene, "fast", "n=2", 1e-7, 20e-3));
    records.push_back(test::good_record(scene, "exact", "n=1", 1e-9, 50e-3));
    records.push_back(test::good_record(scene, "rough", "n=1", 5e-2, 100e-6));
  }
  records[9].status = Status::timeout;
  records[2].certificate.stable = false;
  for (const auto& [method, error, seconds] :
       {std::tuple{"fast", 5e-2, 1e-3}, std::tuple{"exact", 1e-9, 50e-3}}) {
    records.push_back(test::good_record("k1", method, "n=1", error, seconds));
    records.back().scene_law = records.back().law = Penalty{{1e3}};
  }
  return records;
}

TEST(Screen, SaysWhichMethodToTakeForWhichScenes) {
  EXPECT_EQ(screen_report(Evaluation(records_with_known_winners()), kContext),
            R"(14 cases run, 0 already there; records and manifest are in out
4 scenes, 14 cases, 13 certified, 1 failed
Certified: an exact motion lies within 10 % of the result and has the same
contacts (1 unstable, 12 not determined). Refuted: the result is wrong.
Unproven: not decided. Failed: no result.

For rigid stops use fast: its error is at most 1 % on 3 of 3 scenes, the median
time 1 ms.
Other methods reach 1 % on these scenes, of those whose law they represent:
exact 3 of 3.

Which method? * marks the method that reaches 1 % on the most scenes with a
stable motion; if tied, those within 10 % of the least time. A second * marks a
faster method that does so on one scene fewer. Each cell: median time to that
error, number of scenes; - if half or more do not reach it. Last column:
unstable motions among those found to 10 %:
                               10 %         1 %       0.1 %        1e-6    unst.
Rigid stop (e = 1), 3 scenes: fast
* fast                         1 ms  3     1 ms  3    20 ms  2    20 ms  2     0
  exact                       50 ms  3    50 ms  3    50 ms  3    50 ms  3     1
  rough                      100 us  3        -  0        -  0        -  0     0

Failed or refuted: fast 1 of 7
Limits of the methods: signorini list methods
All tables, and why cases failed: out/table.md
A page with figures: signorini report out --format html
)");
}

TEST(Screen, SaysWhatTheTimesOfCommandsLeaveOut) {
  std::vector<Record> records = records_with_known_winners();
  records[0].seconds->exchange = 2e-3;
  const std::string screen = screen_report(Evaluation(records), kContext);
  EXPECT_NE(screen.find("\nTimes leave out to hand over problem and answer: fast 2 ms a solve\n"),
            std::string::npos)
      << screen;
  expect_one_screen(screen);
}

TEST(Screen, OfAnEmptyRunSaysThatThereIsNothing) {
  const std::string screen = screen_report(Evaluation({}), kContext);
  EXPECT_NE(screen.find("\n0 scenes, 0 cases\n"), std::string::npos) << screen;
  EXPECT_EQ(screen.find("Which method?"), std::string::npos) << screen;
  EXPECT_EQ(screen.find("Failed"), std::string::npos) << screen;
  expect_one_screen(screen);
}

TEST(Screen, RecommendsNobodyWhereAllFailed) {
  std::vector<Record> records = records_with_known_winners();
  for (Record& record : records) {
    record.status = Status::crashed;
    record.certificate = {};
  }
  const std::string screen = screen_report(Evaluation(records), kContext);
  EXPECT_NE(screen.find("Rigid stop (e = 1), 3 scenes: no method gets to 1 %\n"), std::string::npos)
      << screen;
  EXPECT_EQ(screen.find("\n* "), std::string::npos) << screen;
  EXPECT_NE(screen.find("\n4 scenes, 14 cases, 14 failed\n"), std::string::npos) << screen;
  EXPECT_NE(screen.find("Failed or refuted: fast 7 of 7, exact 4 of 4, rough 3 of 3\n"), std::string::npos)
      << screen;
  expect_one_screen(screen);
}

TEST(Screen, SaysOnceWhatIsBestForSeveralKinds) {
  std::vector<Record> records;
  for (const auto& [kind, law] : {std::pair<std::string, RepresentedLaw>{"r", Restitution{1.0}},
                                  {"e", Restitution{0.5}},
                                  {"p", Penalty{{1e3}}}}) {
    for (const char* scene : {"1", "2", "3"}) {
      records.push_back(test::good_record(kind + scene, "fast", "n=1", 1e-3, kind == "e" ? 2e-3 : 1e-3));
      if (kind == "p") records.back().status = Status::crashed;
      records.back().scene_law = records.back().law = law;
    }
  }
  const std::string screen = screen_report(Evaluation(records), kContext);
  EXPECT_NE(screen.find("For rigid stops and restitution use fast: its error is at most 1 % on 6 of 6\n"
                        "scenes, the median time 1 ms to 2 ms, by kind.\n"
                        "For springs no method reaches 1 % on a stable motion.\n"),
            std::string::npos)
      << screen;
}

TEST(Screen, NamesAllThatTie) {
  std::vector<Record> records;
  for (const char* method : {"a", "b"}) {
    for (const char* scene : {"s", "t", "u"})
      records.push_back(test::good_record(scene, method, "n=1", 1e-3, 1e-3));
  }
  const std::string screen = screen_report(Evaluation(records), kContext);
  EXPECT_NE(screen.find("Rigid stop (e = 1), 3 scenes: a or b (as many scenes, within 10 %)\n* a "),
            std::string::npos)
      << screen;
  EXPECT_NE(screen.find("\n* b "), std::string::npos) << screen;
}

TEST(Screen, NamesTheFirstCasesThatWereNotExpectedToFail) {
  ScreenContext context = kContext;
  context.unexpected = {"s3/fast[n=2]"};
  const Evaluation evaluation(records_with_known_winners());
  EXPECT_NE(screen_report(evaluation, context)
                .find("1 case failed or was refuted, unexpectedly:\n  s3/fast[n=2]: timeout\n"),
            std::string::npos);
  context.unexpected.assign(9, "s3/" + std::string(100, 'x'));
  const std::string screen = screen_report(evaluation, context);
  EXPECT_NE(screen.find("9 cases failed or were refuted, unexpectedly:\n"), std::string::npos) << screen;
  EXPECT_NE(screen.find("\n  and 6 more\n"), std::string::npos) << screen;
  expect_one_screen(screen);
}

/// Every kind of scene, 40 configurations each, with names up to some 130 characters, `scenes` scenes a kind.
std::vector<Record> crowded_records(int scenes) {
  std::vector<Record> records;
  const std::vector<RepresentedLaw> laws{Restitution{1.0}, Restitution{0.5}, Penalty{{1.0}},
                                         Massless{},       Penalty{{1.0}},   Massless{}};
  for (std::size_t kind = 0; kind < laws.size(); ++kind) {
    for (int s = 0; s < scenes; ++s) {
      for (int c = 0; c < 40; ++c) {
        const std::string method = fmt::format("method-{}", c % 10),
                          plain(static_cast<std::size_t>(3 * c), 'w');
        records.push_back(test::good_record(fmt::format("scene-{}-{}", kind, s), method,
                                            c < 10 ? "n=1" : "n=1,word=" + plain, 1e-4, 1234.5 * (c + 1)));
        Record& record = records.back();
        record.scene_law = record.law = laws[kind];
        if (kind == 4) record.contacts = 5;
        if (kind == 5) record.coordinates = 100;
        if (c % 3 == 2) record.status = Status::inaccurate;
      }
    }
  }
  return records;
}

TEST(Screen, IsOneWhateverTheRun) {
  const std::string crowded = screen_report(Evaluation(crowded_records(2)), kContext);
  expect_one_screen(crowded);
  for (const char* kind :
       {"Rigid stop", "Restitution", "Spring", "Massless", "Many contacts", "Large structure"})
    EXPECT_NE(crowded.find(fmt::format("\n{}", kind)), std::string::npos) << crowded;
  EXPECT_GE(lines_of(crowded).size(), kScreenLines - 1) << crowded;  // room is used
  expect_one_screen(screen_report(Evaluation(crowded_records(120)), kContext));
  expect_one_screen(screen_report(Evaluation(test::records_of_a_run()), kContext));
  for (const char* run : {"article", "catalogue", "hard", "structures"}) {
    const std::filesystem::path records = test::data_folder() / "../../results" / run / "records.jsonl";
    expect_one_screen(screen_report(Evaluation(read_records(records)), kContext));
  }
}

// Ten methods, forty configurations: the second configurations of a method wait until each has its first.
TEST(Screen, GivesEachMethodALineBeforeAnyHasTwo) {
  std::vector<Record> records = crowded_records(1);
  std::erase_if(records, [](const Record& record) { return !record.scene.starts_with("scene-0"); });
  const std::string screen = screen_report(Evaluation(records), kContext);
  for (int method = 0; method < 10; ++method)
    EXPECT_TRUE(std::regex_search(screen, std::regex(fmt::format("\n[* ] method-{}[ \\[]", method))))
        << screen;
  expect_one_screen(screen);
}

TEST(Screen, IsTheSameInColourButForTheColours) {
  const Evaluation evaluation(records_with_known_winners());
  ScreenContext context = kContext;
  context.unexpected = {"s3/fast[n=2]"};
  const std::string plain = screen_report(evaluation, context);
  context.colour = true;
  const std::string coloured = screen_report(evaluation, context);
  EXPECT_NE(coloured.find("\033[32m* fast "), std::string::npos) << coloured;
  EXPECT_EQ(std::regex_replace(coloured, std::regex("\033\\[[0-9]+m"), ""), plain);
}

TEST(Screen, BreaksALongCommandWhereAShellGoesOnReading) {
  ScreenContext context = kContext;
  context.folder = std::string(40, 'f') + " of mine";
  context.program = std::string(60, 'p');
  const std::string screen = screen_report(Evaluation({}), context);
  EXPECT_NE(screen.find("A page with figures:\n  " + context.program + " report \\\n  '" +
                        std::string(40, 'f') + " of mine' --format html\n"),
            std::string::npos)
      << screen;
  expect_one_screen(screen);
}

TEST(Screen, SaysThatTimesOfCasesRunTogetherAreNotComparable) {
  std::vector<Record> records = records_with_known_winners();
  EXPECT_EQ(screen_report(Evaluation(records), kContext).find("not comparable"), std::string::npos);
  records[0].seconds->jobs = 2;
  EXPECT_NE(screen_report(Evaluation(records), kContext).find("not comparable"), std::string::npos);
}

TEST(Screen, SaysWhyTimesAreNotComparableAndHowManyAreUnsteady) {
  std::vector<Record> records = records_with_known_winners();
  records[0].seconds->unsteady = true;
  const Evaluation evaluation(
      test::results_of(records), [](std::size_t) { return Record(); }, {},
      "Times of this run are not comparable: because.");
  const std::string screen = screen_report(evaluation, kContext);
  EXPECT_NE(screen.find("\nTimes of this run are not comparable: because.\n1 case has unsteady times: "),
            std::string::npos)
      << screen;
  expect_one_screen(screen);
}

TEST(SceneLine, CountsWhatBecameOfTheCases) {
  OutcomeCounts counts;
  for (const Record& record : test::records_of_every_status()) counts.add(outcome_of(record));
  EXPECT_EQ(scene_line("s", counts),
            "s: 10 cases, 1 certified, 1 unproven, 1 refuted, 6 failed, 1 not applicable");
  EXPECT_EQ(scene_line(std::string(200, 's'), counts).size(), kTerminalWidth);
}

}  // namespace
}  // namespace signorini::screen_test
