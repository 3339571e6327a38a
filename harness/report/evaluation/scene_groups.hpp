#pragma once
// Which method for which scene: scenes by what they ask of a method, and the order of methods on each kind.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// What a scene asks of a method, in the order of reports. Contacts of different laws are that whatever the
/// structure, else a large structure is one whatever its contacts; many contacts are that whatever their law.
/// What a motion that touches nothing solves is of no other kind.
enum class SceneKind {
  rigid_stop,
  restitution,
  spring,
  massless,
  mixed_laws,
  many_contacts,
  large_structure,
  contact_free
};

/// "Rigid stop (e = 1)" and so on.
std::string_view kind_title(SceneKind kind);
/// What the scenes of a kind have, as a sentence names it: "rigid stops".
std::string_view kind_words(SceneKind kind);

/// Contacts from which on they are many, and coordinates from which on a structure is large.
inline constexpr int kManyContacts = 5, kLargeStructure = 100;

/// The kind of a scene, whatever its motions; nothing where it has no contact or its law is not known. Where
/// the numbers of coordinates and contacts are not known, as in records of earlier versions, it goes by the
/// law.
std::optional<SceneKind> kind_of(const CaseScene& scene);
/// The kind of a scene of an evaluation: contact_free where it is that (Evaluation::is_contact_free).
std::optional<SceneKind> kind_of(const Evaluation& evaluation, const std::string& scene);

/// Errors of x that scene groups tell the times to [-].
inline constexpr std::span kGroupErrors = std::span(kErrorLevels).first<4>();
/// By which of them methods are ordered.
inline constexpr std::size_t kRankingError = 1;
/// Median times within this factor of the least are equal: less is noise of the machine and of the scenes.
inline constexpr double kEqualTimes = 1.1;
/// Groups of fewer scenes recommend nothing.
inline constexpr std::size_t kFewestScenes = 3;
/// What stands in the place of a recommendation there.
inline constexpr std::string_view kTooFewScenes = "too few scenes to recommend";

/// What a configuration does on the scenes of a kind.
struct Standing {
  std::string configuration = {}, method = {};
  /// Configurations with the same result: the same answers to the last bit on every scene, or the same
  /// equations (has_equations_of) on as many solved scenes. They have no standing of their own.
  std::vector<std::string> same = {};
  /// At each of kGroupErrors. A scene of which it represents another law is not reached.
  std::array<Reach, kGroupErrors.size()> reach = {};
  bool recommended = false;
  std::string reason = {};  ///< of a recommendation: what decides, a clause

  /// "aft-hbm = fourier-lipschitz": the configuration, and those with the same result.
  [[nodiscard]] std::string names() const;
};

/// The scenes of a kind that rankings take in (`Evaluation::is_ranked`), and the configurations that
/// represent the law of one of them at least.
struct SceneGroup {
  SceneKind kind = SceneKind::rigid_stop;
  std::vector<std::string> scenes = {};
  /// Best first: by the number of scenes with an error of x of at most kGroupErrors[kRankingError] and a
  /// motion not known to be unstable (Reach::lasting), then by that with any motion, by the median time to
  /// it, by name. Recommended are the first and those that reach it on as many scenes within kEqualTimes of
  /// its time; and of those that reach it on one scene fewer the soonest, where it is sooner by more than
  /// that: a single scene decides between them. None where none reaches it, or of fewer scenes than
  /// kFewestScenes.
  std::vector<Standing> standings = {};

  /// Whether there are too few scenes to recommend anything.
  [[nodiscard]] bool is_too_small() const { return scenes.size() < kFewestScenes; }
};

/// Groups with scenes, by kind.
std::vector<SceneGroup> scene_groups(const Evaluation& evaluation);

}  // namespace signorini
