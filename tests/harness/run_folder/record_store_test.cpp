#include "harness/run_folder/record_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"
#include "tests/harness/stored_records.hpp"

namespace signorini::record_store_test {
namespace {

class RecordStores : public testing::Test {
 protected:
  std::filesystem::path folder_ = test::fresh_folder("store");
  std::filesystem::path file_ = folder_ / "records.jsonl";

  void write(bool resume, std::initializer_list<const char*> resolutions) const {
    RecordStore store(folder_, resume);
    for (const char* resolution : resolutions)
      store.append(test::good_record("s", "m", resolution, 0.1, 0.1));
  }
};

TEST_F(RecordStores, WriteOneLinePerRecord) {
  write(false, {"n=1", "n=2"});
  const std::string text = read_file(file_);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_EQ(read_records(file_).size(), 2U);
}

TEST_F(RecordStores, ResumeWithoutDuplicates) {
  write(false, {"n=1", "n=2"});
  const std::string before = read_file(file_);
  {
    RecordStore store(folder_, true);
    EXPECT_TRUE(store.contains("key of s/m[n=1]"));
    EXPECT_FALSE(store.contains("key of s/m[n=3]"));
    store.append(test::good_record("s", "m", "n=2", 0.1, 0.1));
  }
  EXPECT_EQ(read_file(file_), before);
  write(true, {"n=2", "n=3"});
  EXPECT_EQ(read_records(file_).size(), 3U);
}

TEST_F(RecordStores, DropALineThatAKillTore) {
  write(false, {"n=1", "n=2", "n=3"});
  const std::string whole = read_file(file_);
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  // Torn at every byte of the last line, its line break included.
  for (std::size_t length = last; length < whole.size(); length += 37) {
    std::ofstream(file_, std::ios::binary) << whole.substr(0, length);
    EXPECT_EQ(read_records(file_).size(), 2U) << length;
    write(true, {"n=1", "n=2", "n=3"});
    EXPECT_EQ(read_file(file_), whole) << length;
  }
}

TEST_F(RecordStores, KeepTheOldRecordsOfARunThatStartsAnew) {
  write(false, {"n=1", "n=2"});
  write(false, {"n=9"});
  EXPECT_EQ(read_records(file_).size(), 1U);
  EXPECT_EQ(read_records(folder_ / "records.previous.jsonl").size(), 2U);
}

TEST_F(RecordStores, LeaveOutALineThatIsNoRecordAndNameIt) {
  write(false, {"n=1", "n=2"});
  const std::string good = read_file(file_);
  const std::size_t first = good.find('\n') + 1;
  for (const char* line : {"{\"schema\": 1}", "3", "null", "{ torn", "\x1b[2J"}) {
    std::ofstream(file_) << good.substr(0, first) << line << "\n" << good.substr(first);
    testing::internal::CaptureStderr();
    EXPECT_EQ(read_records(file_).size(), 2U) << line;
    const std::string warning = testing::internal::GetCapturedStderr();
    EXPECT_NE(warning.find("records.jsonl:2: record = unreadable (must be"), std::string::npos) << warning;
    EXPECT_EQ(warning.find("json.exception"), std::string::npos) << warning;
    EXPECT_EQ(warning.find('\x1b'), std::string::npos) << warning;
  }
  testing::internal::CaptureStderr();
  const RecordStore resumed(folder_, true);
  EXPECT_TRUE(resumed.contains(read_records(file_)[1].key));
  testing::internal::GetCapturedStderr();
}

TEST_F(RecordStores, ReadTheLastOfSeveralRecordsOfOneKey) {
  write(false, {"n=1"});
  const std::string line = read_file(file_);
  std::string second = line;
  second.replace(second.find("converged"), 9, "crashed");
  std::ofstream(file_, std::ios::app) << second;
  const std::vector<Record> records = read_records(file_);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].status, Status::crashed);
}

TEST_F(RecordStores, KeepTheLastOfWhatIsUnfinishedForTheNextRun) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.1);
  {
    RecordStore store(folder_, false);
    store.keep_unfinished(record);
    record.message = "later";
    store.keep_unfinished(record);
  }
  std::ofstream(folder_ / "unfinished.jsonl", std::ios::app) << "{\"torn";
  {
    RecordStore store(folder_, true);
    EXPECT_EQ(store.unfinished(record.key).value().message, "later");
    EXPECT_FALSE(store.contains(record.key));
    EXPECT_FALSE(store.unfinished("another").has_value());
    store.append(test::good_record("s", "m", "n=2", 0.1, 0.1));
    store.clear_unfinished();
  }
  EXPECT_EQ(RecordStore(folder_, true).unfinished(record.key).value().message, "later") << "not run yet";
  {
    RecordStore store(folder_, true);
    store.append(record);
    store.clear_unfinished();
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "unfinished.jsonl"));
  EXPECT_FALSE(RecordStore(folder_, true).unfinished(record.key).has_value());
}

TEST_F(RecordStores, ForgetWhatIsUnfinishedWhenStartingAnew) {
  const Record record = test::good_record("s", "m", "n=1", 0.1, 0.1);
  RecordStore(folder_, false).keep_unfinished(record);
  EXPECT_FALSE(RecordStore(folder_, false).unfinished(record.key).has_value());
}

TEST_F(RecordStores, RefuseAFolderThatAnotherRunWritesTo) {
  {
    const RecordStore first(folder_, true);
    EXPECT_THROW(RecordStore(folder_, true), UsageError);
  }
  EXPECT_NO_THROW(RecordStore(folder_, true));
}

TEST_F(RecordStores, RefuseAFolderThatCannotBeMade) {
  EXPECT_THROW(RecordStore("/proc/no-such-folder", false), UsageError);
}

}  // namespace
}  // namespace signorini::record_store_test
