#pragma once
// What is kept of a frequency response: one line of DIR/responses.jsonl each.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "harness/records/record.hpp"
#include "harness/responses/curve_comparison.hpp"

namespace signorini {

/// A branch as it is drawn.
struct DrawnBranch {
  std::vector<double> frequency = {};  ///< [rad/s]
  std::vector<double> amplitude = {};  ///< largest of the contacts: half of largest less least x_j [m]
  std::vector<int> stable = {};        ///< 1 stable, 0 unstable, -1 unknown
};

/// A response: that of a method on a scene, or the exact one, which names no method and compares with
/// nothing.
struct ResponseRecord {
  std::string case_id = {};  ///< "sdof-stop/aft-hbm[harmonics=20] by steps"; of the exact one "sdof-stop/"
  std::string key = {};      ///< identifies the case for --resume
  std::string scene = {}, method = {};
  bool by_steps = false;        ///< of the frequency, up and down, instead of by arc length
  double from = 0.0, to = 0.0;  ///< [rad/s]
  int orders = 1;               ///< longest period looked for [forcing periods]
  /// The law that the method represents, and the scene's.
  std::optional<RepresentedLaw> law = {}, scene_law = {};
  std::optional<bool> law_matches_scene = {};
  std::optional<int> coordinates = {}, contacts = {};  ///< of the scene
  Status status = Status::not_converged;               ///< converged: there is at least one branch
  std::string message = {};
  Measure seconds = {};  ///< processor time of the whole response [s]
  int points = 0;        ///< that the method gave
  std::optional<CurveComparison> comparison = {};
  std::vector<LocatedPoint> located = {};   ///< folds and the like
  std::vector<std::string> open_ends = {};  ///< what was not followed to its end, and why
  std::vector<DrawnBranch> branches = {};
};

/// Whether it is the exact response of its scene.
bool is_exact(const ResponseRecord& record);
/// Whether the method represents another law than the scene's, as harmonic balance does where restitution is
/// below 1: its branches are then right or wrong about another scene.
bool of_another_law(const ResponseRecord& record);
/// The method as tables name it: "aft-hbm[harmonics=20] by steps"; empty of an exact one.
std::string label_of(const ResponseRecord& record);
/// Labels of all methods, in the order of their first records.
std::vector<std::string> labels_of(std::span<const ResponseRecord> records);

/// The branches of a response as they are drawn.
std::vector<DrawnBranch> drawn(const ResponseCurve& curve);

/// One line of JSON.
std::string response_line(const ResponseRecord& record);
/// Of a file that anybody may have written. \throws BadRecord also for control characters in any text of it,
/// and unless the scene is the name of one
ResponseRecord response_from_line(std::string_view line);

/// The name of the file in a results folder.
inline constexpr const char* kResponsesFile = "responses.jsonl";

/// All responses of a folder, in order; none where there is no such file. A line that is none is left out
/// with a warning. \throws UsageError if the file is unreadable
std::vector<ResponseRecord> read_responses(const std::filesystem::path& folder);
/// Writes them in one piece. \throws UsageError if the folder cannot be written
void write_responses(const std::filesystem::path& folder, const std::vector<ResponseRecord>& records);

}  // namespace signorini
