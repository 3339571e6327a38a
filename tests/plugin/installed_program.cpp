#include "tests/plugin/installed_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "harness/files.hpp"
#include "harness/records/record_json.hpp"

namespace signorini::test {

std::filesystem::path python_package() { return SIGNORINI_PYTHON; }

std::filesystem::path installed_tree() { return SIGNORINI_INSTALLED_TREE; }

std::string plugin_path(const std::string& name) { return (installed_tree() / "plugins" / name).string(); }

Outcome run_program(const TemporaryFolder& folder, const std::filesystem::path& program,
                    const std::string& arguments, const std::string& before) {
  const std::string out = (folder.path() / "out").string(), err = (folder.path() / "err").string();
  const int status = std::system(fmt::format("cd '{}' && {} {} {} >{} 2>{}", folder.path().string(), before,
                                             program.string(), arguments, out, err)
                                     .c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
}

Outcome run_installed(const TemporaryFolder& folder, const std::string& arguments,
                      const std::string& before) {
  return run_program(folder, installed_tree() / "prefix" / "bin" / "signorini", arguments, before);
}

std::map<std::string, Record> records_in(const std::filesystem::path& run) {
  std::map<std::string, Record> records;
  std::istringstream lines(read_file(run / "records.jsonl"));
  for (std::string line; std::getline(lines, line);) {
    const Record record = record_from_json(nlohmann::ordered_json::parse(line));
    records[record.case_id] = record;
  }
  return records;
}

void expect_refusal(const Outcome& outcome, const std::vector<std::string>& parts) {
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  for (const std::string& part : parts) EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
}

}  // namespace signorini::test
