#include "harness/responses/response_record.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/files.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/line_file.hpp"
#include "harness/records/record_check.hpp"
#include "harness/records/record_json.hpp"
#include "harness/sweep/branch_json.hpp"
#include "harness/text/json.hpp"
#include "problems/files/kebab_case.hpp"

namespace signorini {

void visit_fields(Either<LocatedPoint> auto& point, auto&& field) {
  field(required("kind"), point.kind);
  field(required("omega", "rad/s"), point.frequency);
  field(required("order"), point.order);
  field(Field{"amplitude", "m"}, point.amplitude);
}

void visit_fields(Either<CurveShares> auto& shares, auto&& field) {
  field(required("covered"), shares.covered);
  field(Field{"covered_stable"}, shares.covered_stable);
  field(required("false"), shares.false_share);
}

void visit_fields(Either<PointMatch> auto& match, auto&& field) {
  field(required("exact"), match.exact);
  field(Field{"omega", "rad/s"}, match.frequency);
}

void visit_fields(Either<CurveComparison> auto& comparison, auto&& field) {
  field(required("within_0.02"), comparison.close);
  field(required("within_0.05"), comparison.wide);
  field(required("exact_length"), comparison.exact_length);
  field(required("length"), comparison.length);
  field(required("right_length"), comparison.right_length);
  field(Field{"points", "", Presence::always}, comparison.points);
  field(Field{"invented", "", Presence::always}, comparison.invented);
}

void visit_fields(Either<DrawnBranch> auto& branch, auto&& field) {
  field(required("omega", "rad/s"), branch.frequency);
  field(required("amplitude", "m"), branch.amplitude);
  field(required("stable"), branch.stable);
}

void visit_fields(Either<ResponseRecord> auto& record, auto&& field) {
  field(required("case"), record.case_id);
  field(required("key"), record.key);
  field(required("scene"), record.scene);
  field(Field{"method"}, record.method);
  field(required("by_steps"), record.by_steps);
  field(required("from", "rad/s"), record.from);
  field(required("to", "rad/s"), record.to);
  field(required("orders"), record.orders);
  field(Field{"law"}, record.law);
  field(Field{"scene_law"}, record.scene_law);
  field(Field{"law_matches_scene"}, record.law_matches_scene);
  field(Field{"coordinates"}, record.coordinates);
  field(Field{"contacts"}, record.contacts);
  field(required("status"), record.status);
  field(Field{"message"}, record.message);
  field(Field{"seconds", "s"}, record.seconds);
  field(required("points"), record.points);
  field(Field{"comparison"}, record.comparison);
  field(Field{"located"}, record.located);
  field(Field{"open_ends"}, record.open_ends);
  field(Field{"branches"}, record.branches);
}

bool is_exact(const ResponseRecord& record) { return record.method.empty(); }

bool of_another_law(const ResponseRecord& record) { return record.law_matches_scene == false; }

std::string label_of(const ResponseRecord& record) {
  return record.method + (record.by_steps ? " by steps" : "");
}

std::vector<std::string> labels_of(std::span<const ResponseRecord> records) {
  std::vector<std::string> found;
  for (const ResponseRecord& record : records) {
    const std::string label = label_of(record);
    if (!is_exact(record) && std::ranges::find(found, label) == found.end()) found.push_back(label);
  }
  return found;
}

std::vector<DrawnBranch> drawn(const ResponseCurve& curve) {
  std::vector<DrawnBranch> branches;
  for (const ResponseBranch& branch : curve.branches) {
    DrawnBranch& lines = branches.emplace_back();
    for (const ResponsePoint& point : branch.points) {
      lines.frequency.push_back(point.frequency);
      lines.amplitude.push_back(half_range(point.motion));
      lines.stable.push_back(!point.stable ? -1 : *point.stable ? 1 : 0);
    }
  }
  return branches;
}

std::string response_line(const ResponseRecord& record) { return json_line(write_fields(record)); }

ResponseRecord response_from_line(std::string_view line) {
  try {
    const auto json = parse_json(line);
    require_plain_texts(json);
    ResponseRecord record;
    read_fields(json, record);
    if (!is_scene_name(record.scene))
      throw BadRecord(fmt::format("scene = {} (must be the name of a scene)", record.scene));
    return record;
  } catch (const nlohmann::json::exception& error) {
    throw BadRecord(fmt::format("response = unreadable (must be one as run writes it: {})", error.what()));
  }
}

std::vector<ResponseRecord> read_responses(const std::filesystem::path& folder) {
  std::vector<ResponseRecord> records;
  if (!std::filesystem::exists(folder / kResponsesFile)) return records;
  read_lines(
      folder / kResponsesFile, [&](const Line& line) { records.push_back(response_from_line(line.text)); },
      "`run --resume` runs its case again");
  return records;
}

void write_responses(const std::filesystem::path& folder, const std::vector<ResponseRecord>& records) {
  std::string lines;
  for (const ResponseRecord& record : records) lines += response_line(record) + "\n";
  write_whole(folder / kResponsesFile, lines);
}

}  // namespace signorini
