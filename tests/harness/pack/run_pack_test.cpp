#include "harness/pack/run_pack.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/run_folder/record_store.hpp"
#include "harness/text/json.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::run_pack_test {
namespace {

namespace fs = std::filesystem;

/// A run of two cases, and a record of a third one that its plan does not have.
RunFolder run_in(const fs::path& folder) {
  RunFolder run = test::part_of_a_run(folder.string(), {});
  {
    RecordStore store(folder, false);
    for (const char* resolution : {"samples=64", "samples=128", "samples=256"}) {
      Record record = test::good_record("sdof-stop", "hat-lcp", resolution, 0.1, 2.0);
      record.key = resolution;
      store.append(record);
      if (run.plan.size() < 2) run.plan.push_back({record.key, record.case_id, record.method});
    }
  }
  write_whole(folder / "manifest.json", json_text(run.manifest, 2) + "\n");
  write_plan(folder, run.plan);
  return read_run(folder);
}

fs::path pack_in(const fs::path& folder, const std::string& name, const std::string& bytes) {
  write_whole(folder / name, bytes);
  return folder / name;
}

std::string refusal(const fs::path& file) {
  try {
    const OpenedRun opened(file);
    return {};
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(RunPack, IsTheRunWithoutItsStaleRecords) {
  const fs::path folder = test::fresh_folder("pack");
  const RunFolder run = run_in(folder / "mine");
  ASSERT_EQ(run.stale.size(), 1U);
  const fs::path file = pack_in(folder, "theirs.tar.gz", pack_run(run));
  fs::path unpacked;
  {
    const OpenedRun opened(file);
    unpacked = opened.folder();
    EXPECT_TRUE(opened.was_packed());
    EXPECT_EQ(run_name(unpacked), "theirs");
    const RunFolder again = read_run(unpacked);
    EXPECT_EQ(again.manifest, run.manifest);
    ASSERT_EQ(again.plan.size(), 2U);
    ASSERT_EQ(again.records.size(), 2U);
    EXPECT_TRUE(again.stale.empty());
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(again.plan[i].case_id, run.plan[i].case_id);
      EXPECT_EQ(again.records[i].key, run.records[i].key);
      EXPECT_EQ(StoredRecords(unpacked / "records.jsonl").at(again.records[i].place).errors.x_l2, 0.1);
    }
  }
  EXPECT_FALSE(fs::exists(unpacked));
}

TEST(RunPack, IsCheckedByTarAndSha256sum) {
  const fs::path folder = test::fresh_folder("pack-tar");
  const std::vector<PluginDescriptionFile> descriptions{{"march", "schema = 1\n"}};
  pack_in(folder, "p.tar.gz", pack_run(run_in(folder / "mine"), descriptions));
  const std::string command = fmt::format(
      "cd '{}' && tar -xzf p.tar.gz && sha256sum --check --strict SHA256SUMS >checked", folder.string());
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(read_file(folder / "checked"),
            "manifest.json: OK\nplan.txt: OK\nrecords.jsonl: OK\nplugins/march.toml: OK\n");
}

TEST(RunPack, IsTheSameOfTheSameRun) {
  const fs::path folder = test::fresh_folder("pack-same");
  const std::string bytes = pack_run(run_in(folder / "mine"));
  EXPECT_EQ(pack_run(read_run(folder / "mine")), bytes);
}

/// A pack whose files were changed before the sums were made (`sums`), or after.
std::string changed_pack(const std::function<void(std::vector<ArchivedFile>& files)>& change, bool sums) {
  const fs::path folder = test::fresh_folder("pack-changed");
  std::vector<ArchivedFile> files = read_tar(gunzipped(pack_run(run_in(folder / "mine")), kLargestPack));
  change(files);
  if (sums) {
    files.front().text.clear();
    for (std::size_t i = 1; i < files.size(); ++i)
      files.front().text += fmt::format("{}  {}\n", sha256(files[i].text), files[i].name);
  }
  return gzipped(write_tar(files));
}

TEST(OpenedRun, RefusesFilesThatAreNotThoseOfAPack) {
  for (const char* name : {"../outside", "/tmp/outside", "plugins/../../outside.toml", "plugins/.toml",
                           "plugins/a.sh", "plugins/A b.toml", "unfinished.jsonl", "manifest.json.new"}) {
    const fs::path folder = test::fresh_folder("pack-foreign");
    const fs::path file = pack_in(folder, "p.tar.gz",
                                  changed_pack(
                                      [&](auto& files) {
                                        files.push_back({name, "x\n"});
                                      },
                                      true));
    const std::string found = refusal(file);
    EXPECT_EQ(found,
              fmt::format("file = {} (must be the folder of a run, or a file that `signorini pack` made: "
                          "it must hold the files of a pack alone)",
                          file.string()))
        << name;
  }
}

TEST(OpenedRun, RefusesOtherTextsThanThoseOfTheSums) {
  const fs::path folder = test::fresh_folder("pack-sums");
  const auto change = [](auto& files) { files.back().text.back() = ' '; };
  EXPECT_NE(refusal(pack_in(folder, "a", changed_pack(change, false))).find("SHA256SUMS"), std::string::npos);
  EXPECT_EQ(refusal(pack_in(folder, "b", changed_pack(change, true))), "");
  const auto drop = [](auto& files) { files.erase(files.begin() + 1); };
  EXPECT_NE(refusal(pack_in(folder, "c", changed_pack(drop, true))).find("must hold manifest.json"),
            std::string::npos);
}

TEST(OpenedRun, NamesItsFolderByTheFileAndNeverLeavesIt) {
  const fs::path folder = test::fresh_folder("pack-names");
  const std::string bytes = pack_run(run_in(folder / "mine"));
  for (const auto& [file, name] :
       {std::pair{"a.b.tar.gz", "a.b"}, std::pair{"a.tgz", "a"}, std::pair{"plain", "plain"},
        std::pair{"...tar.gz", "pack"}, std::pair{".tar.gz", "pack"}}) {
    EXPECT_EQ(run_name(OpenedRun(pack_in(folder, file, bytes)).folder()), name) << file;
  }
}

TEST(OpenedRun, LeavesFoldersAsTheyAre) {
  const fs::path folder = test::fresh_folder("pack-folder");
  const OpenedRun opened(folder);
  EXPECT_EQ(opened.folder(), folder);
  EXPECT_FALSE(opened.was_packed());
}

TEST(OpenedRun, RefusesWhatIsNoPackInOneLine) {
  const fs::path folder = test::fresh_folder("pack-none");
  EXPECT_EQ(
      refusal(pack_in(folder, "text", "hello\n")),
      fmt::format("file = {} (must be the folder of a run, or a file that `signorini pack` made: it must "
                  "be a whole gzip stream)",
                  (folder / "text").string()));
}

}  // namespace
}  // namespace signorini::run_pack_test
