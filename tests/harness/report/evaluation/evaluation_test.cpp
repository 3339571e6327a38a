#include "harness/report/evaluation/evaluation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "harness/records/record_json.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/responses/sample_responses.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::evaluation_test {
namespace {

using Names = std::vector<std::string>;

TEST(Evaluation, SortsRecordsBySceneMethodAndCaseInNaturalOrder) {
  std::vector<Record> records{
      test::good_record("s10", "a", "n=1", 0.1, 1.0), test::good_record("s9", "b", "n=1", 0.1, 1.0),
      test::good_record("s9", "a", "n=10", 0.1, 1.0), test::good_record("s9", "a", "n=9", 0.1, 1.0)};
  const Names expected{"s9/a[n=9]", "s9/a[n=10]", "s9/b[n=1]", "s10/a[n=1]"};
  std::sort(records.begin(), records.end(),
            [](const Record& a, const Record& b) { return a.case_id < b.case_id; });
  do {
    const Evaluation evaluation(records);
    Names ids;
    for (const CaseResult& result : evaluation.results()) ids.push_back(result.case_id);
    EXPECT_EQ(ids, expected);
    EXPECT_EQ(evaluation.scenes(), (Names{"s9", "s10"}));
    EXPECT_EQ(evaluation.configurations(), (Names{"a", "b"}));
  } while (std::next_permutation(records.begin(), records.end(),
                                 [](const Record& a, const Record& b) { return a.case_id < b.case_id; }));
}

TEST(Evaluation, KeepsResponsesApartTheExactOneOfASceneFirst) {
  Record steps = test::response_of("s9", "m", 0.5, 1.0);
  steps.response->question.way = ResponseWay::steps;
  steps.case_id = "s9/a by steps";
  const Evaluation evaluation({test::response_of("s10", "m", 0.5, 1.0), steps,
                               test::response_of("s9", "m", 0.5, 1.0),
                               test::good_record("s9", "a", "n=1", 0.1, 1.0), test::exact_response("s9")});
  Names ids;
  for (const Record& record : evaluation.responses()) ids.push_back(record.case_id);
  EXPECT_EQ(ids, (Names{"s9/exact response", "s9/m by arc length", "s9/a by steps", "s10/m by arc length"}));
  EXPECT_EQ(evaluation.results().size(), 1U);
  EXPECT_EQ(evaluation.scenes(), Names{"s9"});
  EXPECT_EQ(evaluation.place_of_response(1), 2U);
}

TEST(Evaluation, RanksNoSceneWithoutContactAndNoneThatStatesThePreviousOnesProblem) {
  std::vector<Record> records;
  for (const char* scene : {"s1", "s2", "s3", "s4"}) {
    for (const char* method : {"a", "b"})
      records.push_back(test::good_record(scene, method, "n=1", 1e-3, 1.0));
  }
  records[0].problem = records[2].problem = "one";  // a on s1 and s2
  records[1].problem = records[3].problem = "two";  // b
  records[4].problem = "one";                       // a on s3, where b has a problem of its own
  records[5].problem = "three";
  records[6].scene_law = records[7].scene_law = std::monostate{};
  const auto ranked = [&] {
    const Evaluation evaluation(records);
    Names scenes;
    std::ranges::copy_if(evaluation.scenes(), std::back_inserter(scenes),
                         [&](const std::string& scene) { return evaluation.is_ranked(scene); });
    return scenes;
  };
  EXPECT_EQ(ranked(), (Names{"s1", "s3"}));
  EXPECT_EQ(Evaluation(records).groups().front().scenes, (Names{"s1", "s3"}));
  records[5].status = Status::not_applicable;
  EXPECT_EQ(ranked(), (Names{"s1"}));
  records[4].problem.clear();
  records[4].status = Status::not_applicable;
  EXPECT_EQ(ranked(), (Names{"s1", "s3"})) << "no method has a part in s3, nor in any problem like it";
}

TEST(Evaluation, KnowsThePlacesOfItsResultsAndConfigurations) {
  const Evaluation evaluation(test::records_of_two_methods(), {.timeout = 12.0});
  for (std::size_t i = 0; i < evaluation.results().size(); ++i)
    EXPECT_EQ(evaluation.place_of(evaluation.results()[i]), i);
  EXPECT_EQ(evaluation.place_of("a"), 0U);
  EXPECT_EQ(evaluation.place_of("b"), 1U);
  EXPECT_EQ(evaluation.time_limit(), 12.0);
}

TEST(Evaluation, CountsAStudyElsewhereOnlyIfAllItsRunsDo) {
  std::vector<Record> records = test::records_of_two_methods();  // a at n=1, 2, b at n=1, 2; s1, then s2
  records[0].problem = records[1].problem = "one";
  records[4].problem = records[5].problem = "one";
  records[2].problem = records[6].problem = "one";
  const Evaluation evaluation(records);
  const auto repeated = [&](std::size_t study) {
    return evaluation.is_repeated(evaluation.studies()[study]);
  };
  EXPECT_FALSE(repeated(0)) << "a on s1: the first";
  EXPECT_TRUE(repeated(2)) << "a on s2";
  EXPECT_FALSE(repeated(3)) << "b on s2 at n=2 is not known to be the same";
  EXPECT_TRUE(evaluation.is_repeated(*evaluation.studies()[3].runs[0].result));
}

TEST(Evaluation, PointsIntoItsOwnResults) {
  const Evaluation evaluation(test::records_of_two_methods());
  ASSERT_EQ(evaluation.studies().size(), 4U);
  for (const ResolutionStudy& study : evaluation.studies()) {
    for (const ScoredRun& run : study.runs) EXPECT_LT(evaluation.place_of(*run.result), 8U);
  }
  ASSERT_EQ(evaluation.groups().size(), 1U);
  EXPECT_EQ(evaluation.groups()[0].studies[0][0], &evaluation.studies()[0]);
}

TEST(Evaluation, HasResultsStudiesAndWholeRecordsOfAScene) {
  const std::vector<Record> records = test::records_of_two_methods();
  const Evaluation evaluation(records);
  ASSERT_EQ(evaluation.results_of("s2").size(), 4U);
  ASSERT_EQ(evaluation.studies_of("s2").size(), 2U);
  EXPECT_TRUE(evaluation.results_of("s3").empty());
  EXPECT_TRUE(evaluation.studies_of("s3").empty());
  for (const CaseResult& result : evaluation.results_of("s2")) {
    EXPECT_EQ(result.scene->name, "s2");
    EXPECT_EQ(evaluation.record_of(result).case_id, result.case_id);
  }
}

TEST(EvaluationOfRun, ReadsWholeRecordsAgainWhereTheyStand) {
  const auto folder = test::fresh_folder("evaluation");
  std::vector<Record> records = test::records_of_two_methods();
  std::mt19937 random(5);
  std::shuffle(records.begin(), records.end(), random);
  Record older = records[3];
  older.message = "replaced";
  {
    std::ofstream lines(folder / "records.jsonl");
    lines << json_line(to_json(older)) << "\n";
    for (const Record& record : records) lines << json_line(to_json(record)) << "\n";
  }
  const Evaluation evaluation = evaluation_of_run(folder, {.timeout = 3.0});
  const Evaluation in_memory(records);
  ASSERT_EQ(evaluation.results().size(), records.size());
  EXPECT_EQ(evaluation.time_limit(), 3.0);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(json_line(to_json(evaluation.record_of(evaluation.results()[i]))),
              json_line(to_json(in_memory.record_of(in_memory.results()[i]))));
  }
}

}  // namespace
}  // namespace signorini::evaluation_test
