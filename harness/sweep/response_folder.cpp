#include "harness/sweep/response_folder.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "harness/build_info.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record_check.hpp"
#include "harness/run_folder/manifest_check.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/sweep/branch_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kManifest = "manifest.json";

/// Whether nothing is there but what a sweep that was killed at once may have left.
bool is_blank(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename() != std::string(kManifest) + ".new") return false;
  }
  return true;
}

}  // namespace

std::string response_key(const MethodChoice& method) {
  return sha256(method.label() + "\n" + code_version(method.entry->name) + method.entry->plugin);
}

ResponseFolder::ResponseFolder(const fs::path& folder, const Json& question,
                               const std::vector<std::string>& command_line, bool resume)
    : folder_(folder), file_(folder / kBranchesFile) {
  make_folder(folder);
  lock_ = lock_folder(folder);
  require_same(question);
  if (resume) {
    read();
  } else if (fs::exists(file_)) {
    std::error_code ignored;  // of a folder that cannot be written the manifest complains next
    fs::rename(file_, folder / "branches.previous.jsonl", ignored);
  }
  Json manifest = program_manifest(command_line);
  manifest["sweep"] = question;
  write_whole(folder / kManifest, json_text(manifest, 2) + "\n");
  // Lines of what was interrupted go, a torn one with them.
  std::string text;
  for (const auto& [method, kept] : complete_) {
    for (const std::string& line : kept.lines) text += line + "\n";
  }
  write_whole(file_, text);
  lines_ = open_to_append(file_);
}

void ResponseFolder::require_same(const Json& question) const {
  if (!fs::exists(folder_ / kManifest) && is_blank(folder_)) return;
  const Json manifest = fs::exists(folder_ / kManifest) ? read_manifest(folder_ / kManifest) : Json::object();
  if (!manifest.contains("sweep"))
    throw UsageError(fmt::format("out = {} (must be new, empty or a folder that sweep --out wrote)",
                                 as_message(folder_.string())));
  const Json& kept = manifest.at("sweep");
  for (const auto& [field, value] : question.items()) {
    const Json before = kept.value(field, Json());
    if (before != value)
      throw UsageError(
          fmt::format("{} = {} (must be {} as in {}, which answers another question; --out takes "
                      "another folder)",
                      field, as_message(json_text(value)), as_message(json_text(before)),
                      as_message((folder_ / kManifest).string())));
  }
}

void ResponseFolder::take(const std::string& line, std::map<std::string, Kept>& begun) {
  const Json json = try_parse_json(line);
  if (!json.is_object() || !json.contains("method") || !json["method"].is_string())
    throw BadRecord("line = unreadable (must be one JSON object with a method)");
  require_plain_texts(json);
  const std::string method = json["method"].get<std::string>();
  Kept& kept = begun[method];
  kept.response.method = method;
  if (json.contains("points")) {
    kept.response.diagram.branches.push_back(branch_from_json(json));
  } else if (!json.contains("complete")) {
    kept.response.steps.push_back(step_from_json(json));
  }
  kept.lines.push_back(line);
  if (!json.contains("complete")) return;
  Kept whole = std::move(kept);
  begun.erase(method);
  const Json& end = json["complete"];
  try {
    whole.key = end.at("key").get<std::string>();
    end.at("unfinished").get_to(whole.response.diagram.unfinished);
    end.at("notes").get_to(whole.response.diagram.notes);
    if (end.at("branches") == whole.response.diagram.branches.size() &&
        end.at("steps") == whole.response.steps.size())
      complete_.insert_or_assign(method, std::move(whole));
  } catch (const Json::exception& error) {
    throw BadRecord(fmt::format("complete = unreadable (must be one as sweep writes it: {})", error.what()));
  }
}

void ResponseFolder::read() {
  if (!fs::exists(file_)) return;
  std::map<std::string, Kept> begun;
  read_lines(
      file_, [&](const Line& line) { take(std::string(line.text), begun); }, "its method is asked again");
}

std::optional<MethodResponse> ResponseFolder::complete(const std::string& method,
                                                       const std::string& key) const {
  const auto found = complete_.find(method);
  if (found == complete_.end() || found->second.key != key) return std::nullopt;
  return found->second.response;
}

void ResponseFolder::add(const MethodResponse& of, const Branch& branch) {
  append_line(lines_, json_line(to_json(branch, of.method, of.other_law)), file_);
}

void ResponseFolder::add(const MethodResponse& of, const SweepPoint& step) {
  append_line(lines_, json_line(to_json(step, of.method, of.other_law)), file_);
}

void ResponseFolder::finish(const MethodResponse& response, const std::string& key) {
  const BranchDiagram& diagram = response.diagram;
  const Json line{{"method", response.method},
                  {"complete",
                   {{"key", key},
                    {"branches", diagram.branches.size()},
                    {"steps", response.steps.size()},
                    {"unfinished", diagram.unfinished},
                    {"notes", diagram.notes}}}};
  append_line(lines_, json_line(line), file_);
  keep_lines(lines_, file_);
}

}  // namespace signorini
