#include "harness/responses/exact_response.hpp"

#include <nlohmann/json.hpp>

#include "harness/files.hpp"
#include "harness/records/record_check.hpp"
#include "harness/records/record_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

std::filesystem::path file_of(const std::filesystem::path& run, const std::string& scene) {
  return run / "exact" / (scene + ".json");
}

}  // namespace

bool ExactResponse::read(const std::string& scene, const std::string& key) {
  curve_ = {};
  const std::filesystem::path file = file_of(run_, scene);
  if (run_.empty() || !std::filesystem::exists(file)) return false;
  try {
    const Record record = checked_record(parse_json(read_file(file)));
    if (record.key != key || !record.response) return false;
    curve_ = curve_of(*record.response);
    return true;
  } catch (const BadRecord&) {  // as if it were not there: it is computed again
    return false;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

void ExactResponse::take(Record& record) {
  if (!record.response) return;
  curve_ = curve_of(*record.response);
  if (!run_.empty()) {
    folder_inside(run_, "exact");
    write_whole(file_of(run_, record.scene), json_line(to_json(record)) + "\n");
  }
  for (DrawnBranch& branch : record.response->branches) {
    branch.motion.clear();
    branch.by_steps.reset();
  }
}

}  // namespace signorini
