#include "harness/run_folder/side_by_side.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/report/evaluation/evaluation.hpp"
#include "harness/run_folder/manifest_check.hpp"
#include "harness/run_folder/record_store.hpp"
#include "harness/text/json.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"
#include "tests/harness/stored_records.hpp"

namespace signorini::side_by_side_test {
namespace {

namespace fs = std::filesystem;

/// A run of one case, on a machine with this processor, whose calibration solve took so long [s] (0: its time
/// is not known).
fs::path run_in(const std::string& name, const std::string& cpu, const std::string& scene_digest = "one",
                double calibration = 0.0, int version = 1) {
  fs::path folder = test::fresh_folder("side-by-side-" + name) / name;
  {
    RecordStore store(folder, false);
    Record record = test::good_record("sdof-stop", "hat-lcp", "samples=64", 0.1, 2.0);
    record.scene_sha256 = scene_digest;
    record.seconds->rounds = {{.setup = 0.5, .solve = 1.5}};
    store.append(record);
  }
  nlohmann::ordered_json manifest = test::part_of_a_run(name, {}).manifest;
  manifest["machine"]["cpu"] = cpu;
  if (calibration > 0.0)
    manifest["calibration"] = {{"version", version}, {"seconds", calibration}, {"solves", 25}};
  write_whole(folder / "manifest.json", json_text(manifest, 2) + "\n");
  return folder;
}

TEST(SideBySide, KeepsEachRunUnderItsName) {
  const fs::path out = test::fresh_folder("side-by-side-out");
  put_side_by_side(std::vector<fs::path>{run_in("mine", "a"), run_in("theirs", "a")}, out);
  const Evaluation evaluation = evaluation_of_run(out, {});
  EXPECT_EQ(evaluation.configurations(), (std::vector<std::string>{"hat-lcp (mine)", "hat-lcp (theirs)"}));
  EXPECT_EQ(evaluation.scenes(), (std::vector<std::string>{"sdof-stop"}));
  ASSERT_EQ(evaluation.results().size(), 2U);
  for (const CaseResult& result : evaluation.results()) EXPECT_EQ(result.seconds, 2.0);
  EXPECT_EQ(evaluation.times_remark(), "");
}

TEST(SideBySide, LeavesOutTimesOfAnotherMachine) {
  const fs::path out = test::fresh_folder("side-by-side-out");
  put_side_by_side(std::vector<fs::path>{run_in("mine", "a"), run_in("theirs", "b")}, out);
  const Evaluation evaluation = evaluation_of_run(out, {});
  ASSERT_EQ(evaluation.results().size(), 2U);
  EXPECT_EQ(evaluation.results()[0].seconds, 2.0);
  EXPECT_FALSE(evaluation.results()[1].seconds);
  EXPECT_EQ(evaluation.results()[1].error, 0.1);
  EXPECT_NE(evaluation.times_remark().find("Times of theirs are left out: "), std::string::npos);
  EXPECT_NE(evaluation.times_remark().find("machine.cpu = \"b\""), std::string::npos);
  EXPECT_EQ(read_manifest(out / "manifest.json")["runs"].size(), 2U);
}

TEST(SideBySide, MultipliesTimesOfAnotherMachineByTheRatioOfTheCalibrations) {
  const fs::path out = test::fresh_folder("side-by-side-out");
  put_side_by_side(
      std::vector<fs::path>{run_in("mine", "a", "one", 2e-3), run_in("theirs", "b", "one", 5e-3)}, out);
  const std::vector<Record> records = read_records(out / "records.jsonl");
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].seconds->median, 2.0);
  EXPECT_DOUBLE_EQ(records[1].seconds->median, 0.8);
  EXPECT_DOUBLE_EQ(records[1].seconds->rounds.front().setup, 0.2);
  EXPECT_DOUBLE_EQ(records[1].seconds->rounds.front().solve, 0.6);
  EXPECT_EQ(records[1].errors.x_l2, 0.1);
  EXPECT_EQ(
      evaluation_of_run(out, {}).times_remark(),
      "Times of theirs are multiplied by 0.4, the ratio of the times of a calibration solve on the machine "
      "of mine and on its own.");
}

TEST(SideBySide, LeavesTimesOfOneMachineAsTheyAre) {
  const fs::path out = test::fresh_folder("side-by-side-out");
  put_side_by_side(
      std::vector<fs::path>{run_in("mine", "a", "one", 2e-3), run_in("theirs", "a", "one", 5e-3)}, out);
  EXPECT_EQ(read_records(out / "records.jsonl")[1].seconds->median, 2.0);
}

TEST(SideBySide, LeavesOutTimesWhereOneMachineHasNoCalibrationOrThatOfAnotherSolve) {
  const fs::path out = test::fresh_folder("side-by-side-out");
  const fs::path mine = run_in("mine", "a", "one", 2e-3);
  for (const auto& [calibration, version] : {std::pair{0.0, 1}, std::pair{5e-3, 2}}) {
    put_side_by_side(std::vector<fs::path>{mine, run_in("theirs", "b", "one", calibration, version)}, out);
    EXPECT_FALSE(read_records(out / "records.jsonl")[1].seconds);
    EXPECT_NE(evaluation_of_run(out, {}).times_remark().find(
                  "not both runs have a time of the same calibration solve"),
              std::string::npos);
  }
}

TEST(SideBySide, RefusesTwoRunsOfOneNameAndScenesThatDiffer) {
  const fs::path out = test::fresh_folder("side-by-side-out");
  const fs::path mine = run_in("mine", "a");
  EXPECT_THROW(put_side_by_side(std::vector<fs::path>{mine, mine}, out), UsageError);
  EXPECT_THROW(put_side_by_side(std::vector<fs::path>{mine, run_in("theirs", "a", "another")}, out),
               UsageError);
}

}  // namespace
}  // namespace signorini::side_by_side_test
