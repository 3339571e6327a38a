#pragma once
// A named set of scenes with, where needed, settings of methods and limits: problems/suites/*.toml.

#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// Which branches a case is about.
enum class ResponseWay {
  exact,       ///< those of exact orbits, which all others are measured against
  arc_length,  ///< the method's own, each step along the branch
  steps        ///< its answers at one frequency after the other, up and down
};

/// A frequency response that is asked for.
struct ResponseQuestion {
  double from = 1.0, to = 2.0;                ///< ends of the interval of frequencies of the load [rad/s]
  int orders = 2;                             ///< longest period of a motion [forcing periods]
  ResponseWay way = ResponseWay::arc_length;  ///< whose branches
};

/// Most instances of a scene in one run.
inline constexpr int kMostInstances = 100000;

/// What one run of a method may use, and how often it is timed.
struct Limits {
  double timeout = 30.0;              ///< processor time of set-up and first solve [s]
  int memory_mb = 2048;               ///< address space beyond that of the program [MiB]
  int repetitions = 3;                ///< rounds of timing
  double certificate_timeout = 10.0;  ///< processor time to find the orbit behind an answer [s]
  double reference_timeout = 60.0;    ///< processor time to march to a scene's reference; 0: not at all [s]
};

/// A case that is known to fail, and why: it is run and recorded, but does not spoil the exit code.
struct ExpectedFailure {
  std::string case_glob = {};
  std::string reason = {};
};

/// A frequency response to follow, in place of a scene to solve.
struct SuiteResponse {
  std::string scene = {};       ///< of the catalogue, or a scene file
  double from = 1.0, to = 2.0;  ///< ends of the interval of frequencies of the load [rad/s]
  int orders = 2;               ///< longest period of a motion [forcing periods]
};

/// Every method of the catalogue joins every suite with its own ladder, unless `methods` says otherwise.
struct Suite {
  std::string name = {};
  std::string title = {};
  std::vector<std::string> scenes = {};        ///< globs on scene names
  std::vector<std::string> files = {};         ///< scene files, folders and globs of files of its own
  std::vector<std::string> tags = {};          ///< a scene that carries one of these belongs too
  std::vector<std::string> without_tags = {};  ///< a scene that carries one of these does not, whatever else
  int instances = 0;                           ///< of each scene with ranges; 0: the scene as it is written
  std::vector<std::string> methods = {};  ///< `name[key=value|value]`: replaces the ladder of what it names
  std::vector<SuiteResponse> responses = {};  ///< whole responses, beside the scenes if any
  /// For responses: methods whose answers are taken at one frequency after the other, up and down.
  std::vector<std::string> by_steps = {};
  std::vector<ExpectedFailure> expected_failures = {};
  Limits limits = {};
};

/// \throws SceneError in the form `FILE:LINE: field = value (what is required)`
Suite parse_suite(std::string_view text, const std::string& file);

/// A suite by catalogue name ("quick") or path. \throws UsageError if there is none; SceneError if it is bad
Suite load_suite(const std::string& name_or_path);

}  // namespace signorini
