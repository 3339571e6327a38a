#include "harness/isolation/temporary_folder.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <system_error>

#include "harness/failure.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "signorini-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw UsageError(fmt::format("{} (must be a folder for temporary files that can be written)",
                                 fs::temp_directory_path().string()));
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace signorini
