#pragma once
// What a run consists of: the scenes, the methods chosen with their settings, and the cases made of both.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/failure.hpp"
#include "harness/plan/case_name.hpp"
#include "harness/plan/scene_choice.hpp"
#include "harness/plan/suite.hpp"
#include "methods/catalogue.hpp"
#include "problems/problem.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

/// One method with one set of settings.
struct MethodChoice {
  const MethodEntry* entry = nullptr;
  Settings settings = {};

  /// "penalty-hbm[harmonics=31,penalty=1e4]"; the bare name where nothing is set.
  [[nodiscard]] std::string label() const;
  /// The method with these settings, but for kStartSetting. \throws InvalidOption
  [[nodiscard]] std::unique_ptr<Method> make() const;
  /// What the options are, kStartSetting among them if it is set. \throws InvalidOption
  [[nodiscard]] std::vector<OptionEcho> options() const;
  /// The share of its period, in [0, 1), by which the motion is late that a solve starts from: the orbit that
  /// the scene reaches from rest under the method's law. Empty: a cold start. \throws InvalidOption
  [[nodiscard]] std::optional<double> start() const;
};

/// A setting that the harness applies to any method, see MethodChoice::start.
inline constexpr std::string_view kStartSetting = "start";

/// The cross product of the alternatives, the last key varying fastest:
/// "a=1,b=2|3" -> {a=1,b=2}, {a=1,b=3}. Empty text gives one empty set.
/// \throws UsageError unless every item reads key=value[|value...], each key once, and for more than 10,000
/// sets
std::vector<Settings> expand_settings(std::string_view text);

/// The settings that a method's own ladder prescribes.
std::vector<Settings> ladder_of(const MethodEntry& entry);

/// The refusal of a filter that no method matches, with names it may mean.
NothingMatched no_method(std::string_view filter, std::span<const MethodEntry> catalogue);

/// Methods that a filter of globs, each with optional settings in brackets, chooses; in catalogue
/// order, each (method, settings) once. A piece without brackets gives a method its settings in `prescribed`,
/// or its own ladder if it has none there. Negative pieces are globs on method names.
/// \throws UsageError for bad brackets; NothingMatched if a piece matches no method
std::vector<MethodChoice> select_methods(std::string_view filter, std::span<const MethodEntry> catalogue,
                                         std::span<const MethodChoice> prescribed = {});

/// One run of one method on one scene.
struct Case {
  std::size_t scene = 0;  ///< index into Plan::scenes
  MethodChoice choice = {};
  std::string id = {};  ///< "sdof-stop/fourier-lipschitz[harmonics=40]"; of a response with its way
  std::optional<ResponseQuestion> response = {};  ///< asked for in place of a motion
  std::string measured_by = {};  ///< the method whose branches a response is measured against, if any
};

struct Plan {
  std::vector<Scene> scenes = {};
  std::vector<Case> cases = {};  ///< scene by scene
};

/// One case; validates the settings. \throws InvalidOption
Case make_case(const Scene& scene, std::size_t index, MethodChoice choice);

/// The part of a suite that a user asks for.
struct Narrowing {
  std::optional<std::string> methods = {};  ///< filter with optional settings in brackets
  std::vector<std::string> scenes = {};     ///< words for scenes (SceneFilter); none: all
  std::optional<int> instances = {};        ///< of each scene with ranges; as the suite says if absent
  std::uint64_t seed = 1;                   ///< of the instances
};

/// The cases of a suite, scenes in the order of `choose_scenes`, methods in catalogue order.
/// \throws NothingMatched, UsageError, SceneError, InvalidOption
Plan make_plan(const Suite& suite, const Narrowing& narrowing, std::span<const MethodEntry> catalogue,
               std::span<const SceneSource> sources);

/// Identifies a run for --resume: SHA-256 of scene file, method, complete options, limits and code version,
/// with the files of the plugin that the method comes from, if any, and what answers are compared with
/// (`reference`): the digest of the orbits that are kept of the scene, or of a response the version of the
/// code that makes the exact one.
std::string case_key(const Scene& scene, const Case& planned_case, const Limits& limits,
                     std::string_view code_version, std::string_view reference = {});

/// Rounds of timing that a case whose times differ gets beyond those that are planned, at most.
inline constexpr int kMoreRounds = 3;

/// The cases of a scene take turns, in a random order for each round of timing; several side by side if asked
/// for.
struct Schedule {
  std::uint64_t seed = 1;         ///< of the random orders
  int parallel = 1;               ///< cases at the same time
  int beside = 1;                 ///< such runs on this machine at the same time, this one included
  int more_rounds = kMoreRounds;  ///< of a case whose times differ, beyond those planned, at most

  /// Cases at the same time on this machine. Above 1 they disturb each other's times.
  [[nodiscard]] int together() const { return parallel * beside; }
};

/// The order of `count` cases of a scene in one round: a random permutation of 0..count-1, so that a drift of
/// the machine does not favour the same cases in every round. It depends on seed, scene and round alone, so
/// that a run that is resumed, or run in shards, takes the same order; with another standard library it may
/// be another.
std::vector<std::size_t> round_order(std::size_t count, std::uint64_t seed, std::string_view scene,
                                     int round);

}  // namespace signorini
