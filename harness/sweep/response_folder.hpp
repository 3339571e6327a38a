#pragma once
// A folder that keeps a response as it is computed: manifest.json with the question, branches.jsonl with a
// line per branch or step.

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/records/line_file.hpp"
#include "harness/sweep/branch_response.hpp"

namespace signorini {

/// The name of the file with the branches in such a folder.
inline constexpr const char* kBranchesFile = "branches.jsonl";

/// Identifies what a method answers: its options, and the code behind it.
std::string response_key(const MethodChoice& method);

/// The branches or steps of methods that answer one question. The lines of a method are those of
/// `sweep --format jsonl`; after its last one stands
///
///     {"method", "complete": {"key", "branches", "steps", "unfinished", "notes"}},
///
/// without which, or with another number of lines before it, its response is not complete.
class ResponseFolder {
 public:
  /// Opens the folder, making it, and keeps others out of it.
  ///
  /// \param question      an object: all that the answer depends on but methods and code
  /// \param command_line  for the manifest
  /// \param resume        keeps what methods have completed, and drops what was interrupted; otherwise the
  ///                      file that is there becomes branches.previous.jsonl
  /// \throws UsageError if it holds anything else, or the answer to another question, is in use or cannot be
  /// written
  ResponseFolder(const std::filesystem::path& folder, const nlohmann::ordered_json& question,
                 const std::vector<std::string>& command_line, bool resume);

  /// The complete response of a method: branches, and steps without their motions. Empty
  /// where there is none with this key.
  [[nodiscard]] std::optional<MethodResponse> complete(const std::string& method,
                                                       const std::string& key) const;
  /// Appends a branch of a method. \throws UsageError if there is no room
  void add(const MethodResponse& of, const Branch& branch);
  /// Appends a step of a method. \throws UsageError if there is no room
  void add(const MethodResponse& of, const SweepPoint& step);
  /// Marks a response as complete, all of whose branches or steps were added. \throws UsageError if there is
  /// no room, or the disk refuses otherwise
  void finish(const MethodResponse& response, const std::string& key);

 private:
  struct Kept {
    std::string key = {};
    MethodResponse response = {};
    std::vector<std::string> lines = {};
  };
  void require_same(const nlohmann::ordered_json& question) const;
  void read();
  void take(const std::string& line, std::map<std::string, Kept>& begun);

  std::filesystem::path folder_, file_;
  std::map<std::string, Kept> complete_;  // by method
  Descriptor lock_, lines_;
};

}  // namespace signorini
