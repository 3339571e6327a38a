#include "harness/run_folder/side_by_side.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/report/evaluation/evaluation.hpp"
#include "harness/run_folder/manifest_check.hpp"
#include "harness/run_folder/record_store.hpp"
#include "harness/text/json.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::side_by_side_test {
namespace {

namespace fs = std::filesystem;

/// A run of one case, on a machine with this processor.
fs::path run_in(const std::string& name, const std::string& cpu, const std::string& scene_digest = "one") {
  fs::path folder = test::fresh_folder("side-by-side-" + name) / name;
  {
    RecordStore store(folder, false);
    Record record = test::good_record("sdof-stop", "hat-lcp", "samples=64", 0.1, 2.0);
    record.scene_sha256 = scene_digest;
    store.append(record);
  }
  nlohmann::ordered_json manifest = test::part_of_a_run(name, {}).manifest;
  manifest["machine"]["cpu"] = cpu;
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

TEST(SideBySide, RefusesTwoRunsOfOneNameAndScenesThatDiffer) {
  const fs::path out = test::fresh_folder("side-by-side-out");
  const fs::path mine = run_in("mine", "a");
  EXPECT_THROW(put_side_by_side(std::vector<fs::path>{mine, mine}, out), UsageError);
  EXPECT_THROW(put_side_by_side(std::vector<fs::path>{mine, run_in("theirs", "a", "another")}, out),
               UsageError);
}

}  // namespace
}  // namespace signorini::side_by_side_test
