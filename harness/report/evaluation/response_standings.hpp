#pragma once
// Which method for whole frequency responses: sums of length for each kind of scene, and the order of
// methods. Records here are those of responses (Record::response).

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/evaluation/scene_groups.hpp"

namespace signorini {

/// How a method for frequency responses is recommended.
inline constexpr std::string_view kResponseRule =
    "Score of a method: the harmonic mean of two shares, of the exact branches that it finds and of its own "
    "branches that are not false. Recommended, over all responses of the kind: of the methods whose score is "
    "within 0.05 of the best, the one of the least time per length. A response counts as not found where a "
    "method does not apply or represents another law. Kinds of fewer than three responses recommend nothing. "
    "The method that computes the exact branches is the reference and is not ranked.";

/// Whether it is the exact response of its scene.
bool is_exact(const Record& record);
/// The method as it is compared over all responses: "aft-hbm[harmonics=20] by steps".
std::string response_label(const Record& record);
/// The same with the law that the method represents, where that is another than the scene's: "aft-hbm, e =
/// 1".
std::string label_with_law(const Record& record);
/// Labels of all methods, in the order of their first records; no exact response has one.
std::vector<std::string> response_labels(std::span<const Record> records);

/// The sums of one method over the responses of a kind, by length. Responses of which the method represents
/// another law add to nothing.
struct ResponseStanding {
  std::string label = {};
  bool makes_the_exact = false;            ///< the exact responses are of the same method
  std::ptrdiff_t followed = 0, asked = 0;  ///< responses with a branch, of those that it applies to
  double found = 0.0;        ///< share of the exact length of all responses, within kCloseTolerance
  double false_share = 0.0;  ///< of the method's own length, beyond kWideTolerance
  std::ptrdiff_t located = 0, points = 0, invented = 0;  ///< special points: located, of those there are
  std::optional<double> largest_error = {};              ///< of their frequencies, relative
  std::optional<double> seconds = {};                    ///< processor time of all [s]
  std::optional<double> cost = {};                       ///< the same per length within kWideTolerance [s]
  bool recommended = false;                              ///< by kResponseRule

  /// The harmonic mean of the shares found and not false.
  [[nodiscard]] double score() const;
};

/// The responses of scenes of a kind, and the methods that represent the law of one of them at least.
struct ResponseGroup {
  std::optional<SceneKind> kind = {};  ///< none where the records do not know it
  std::vector<std::string> scenes = {};
  /// The recommended one, none of too few scenes, then by falling score, then as in response_labels; methods
  /// that make the exact responses last.
  std::vector<ResponseStanding> standings = {};

  /// Whether there are too few scenes to recommend anything: fewer than kFewestScenes.
  [[nodiscard]] bool is_too_small() const { return scenes.size() < kFewestScenes; }
};

/// Groups by kind, of the responses that a method was compared with.
std::vector<ResponseGroup> response_groups(std::span<const Record> records);

/// "Spring, 5 responses".
std::string group_title(const ResponseGroup& group);

/// Special points that a comparison finds located.
std::ptrdiff_t located_points(const CurveComparison& comparison);
/// The relative error of the frequency at which a point was located; empty where it was not.
std::optional<double> error_of(const PointMatch& match);
/// The largest of them; empty where none was located.
std::optional<double> largest_error(const CurveComparison& comparison);

}  // namespace signorini
