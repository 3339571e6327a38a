#include "tests/harness/program.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "harness/files.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::test {

Outcome run_program(const std::string& arguments, const std::string& folder) {
  static const std::filesystem::path logs = fresh_folder("program");
  const std::filesystem::path out = logs / "out", err = logs / "err";
  const std::string command = "cd '" + folder + "' && " + SIGNORINI_BINARY + " " + arguments + " >" +
                              out.string() + " 2>" + err.string();
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
}

}  // namespace signorini::test
