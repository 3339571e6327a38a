#pragma once
// What this program was built from and with; filled in by build_info.cmake at every build.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace signorini {

struct BuildInfo {
  std::string_view version;   ///< of the project
  std::string_view commit;    ///< empty where the sources are no git checkout
  bool dirty = false;         ///< the checkout differs from the commit
  std::string_view compiler;  ///< name and version
  std::string_view flags;
  std::string_view build_type;
  std::vector<std::pair<std::string_view, std::string_view>> libraries;  ///< name, version
  /// SHA-256 of the sources: one of what every method's result depends on (""), one per folder of methods/.
  std::vector<std::pair<std::string_view, std::string_view>> sources;
};

const BuildInfo& build_info();

/// False in builds whose times mean nothing: assertions on, no optimiser, or sanitizers.
bool build_may_be_timed();

/// Identifies the code behind a method's records: problems, harness, the rooms that methods share, and the
/// method's own folder.
std::string code_version(std::string_view method);

}  // namespace signorini
