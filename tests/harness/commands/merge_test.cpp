// `signorini merge`, and `status` and `compare` of what it merged.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/files.hpp"
#include "harness/run_folder/record_store.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"
#include "tests/harness/stored_records.hpp"

namespace signorini::merge_test {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandMerge, RunsShardsThatMergeToTheWholeRun) {
  const auto folder = test::fresh_folder("shards");
  const std::string out = folder.string();
  const std::string command =
      "run quick --scenes sdof-stop:sdof-far-stop --methods 'hat-lcp[samples=64]' --repetitions 1 ";
  ASSERT_EQ(run(command + "--out " + out + "/whole").code, 0);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const Outcome part =
        run(command + fmt::format("--shard {} --out {}/shards/shard-{}", shard, out, shard[0]));
    EXPECT_EQ(part.code, 0) << part.err;
  }
  const std::string merge =
      fmt::format("merge {0}/shards/shard-1 {0}/shards/shard-2 {0}/shards/shard-3 --out {0}/all", out);
  const Outcome merged = run(merge);
  ASSERT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(run(merge).code, 0) << "a merge may be repeated";
  const auto whole = read_records(folder / "whole" / "records.jsonl");
  const auto all = read_records(folder / "all" / "records.jsonl");
  ASSERT_EQ(all.size(), 2U);
  for (const Record& record : whole) {
    const auto same =
        std::find_if(all.begin(), all.end(), [&](const Record& r) { return r.key == record.key; });
    ASSERT_NE(same, all.end()) << record.case_id;
    EXPECT_EQ(same->errors.x_l2, record.errors.x_l2);
  }
  EXPECT_EQ(run(fmt::format("merge {0}/shards/shard-1 {0}/shards/shard-2 --out {0}/part", out)).code, 2);
  EXPECT_EQ(run(merge.substr(0, merge.rfind(' ')) + " " + out + "/shards/merged").code, 0)
      << "beside the shards, as submit does";
  EXPECT_EQ(run(merge.substr(0, merge.rfind(' ')) + " " + out + "/whole").code, 2)
      << "a run is not written over";

  const Outcome status = run("status --json " + out + "/shards");
  ASSERT_EQ(status.code, 0) << status.err;
  const Json list = Json::parse(status.out);
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[3]["name"], "all");
  EXPECT_EQ(list[3]["converged"], 2);
  EXPECT_EQ(list[3]["pending"], 0);
  EXPECT_NE(run("status " + out + "/all").out.find("done"), std::string::npos);

  const Outcome compared = run(fmt::format("compare {0}/all {0}/all", out));
  EXPECT_EQ(compared.code, 0) << compared.out;
  EXPECT_NE(compared.out.find("2 cases compared, "), std::string::npos) << compared.out;
  Json record = Json::parse(read_file(folder / "whole" / "records.jsonl")
                                .substr(0, read_file(folder / "whole" / "records.jsonl").find('\n')));
  record["status"] = "crashed";
  std::ofstream(folder / "whole" / "records.jsonl") << record.dump() << "\n";
  const Outcome worse = run(fmt::format("compare {0}/all {0}/whole", out));
  EXPECT_EQ(worse.code, 4) << worse.out;
  EXPECT_NE(worse.out.find("broken: "), std::string::npos) << worse.out;
}

}  // namespace
}  // namespace signorini::merge_test
