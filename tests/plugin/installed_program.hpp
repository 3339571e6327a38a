#pragma once
// The program of the installed tree, run as a user would.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "harness/records/record.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::test {

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// `PROGRAM ARGUMENTS`, with VARIABLE=VALUE words before it if need be.
Outcome run_program(const TemporaryFolder& folder, const std::filesystem::path& program,
                    const std::string& arguments, const std::string& before = "");

/// The same with the program of the installed tree.
Outcome run_installed(const TemporaryFolder& folder, const std::string& arguments,
                      const std::string& before = "");

/// The folder that install_tree.sh made.
std::filesystem::path installed_tree();

/// The folder of the Python package, for PYTHONPATH.
std::filesystem::path python_package();

/// A plugin of tests/plugin/plugins.
std::string plugin_path(const std::string& name);

/// Records of a run, by case.
std::map<std::string, Record> records_in(const std::filesystem::path& run);

/// Refused with exit code 2 and one line that holds all of these.
void expect_refusal(const Outcome& outcome, const std::vector<std::string>& parts);

}  // namespace signorini::test
