#pragma once
// Curves that other programs followed, as JSON: the answer of a command, or a file of branches.
// docs/plugins.md has every key.

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "methods/curve.hpp"
#include "methods/method.hpp"

namespace signorini {

/// A motion on a curve: x_j(t) at N equidistant instants of its period from t = 0, or its Fourier series.
struct ExchangedPoint {
  double omega = 0.0;                                  ///< of the load [rad/s]
  int order = 1;                                       ///< forcing periods per period [-]
  std::vector<std::vector<double>> x = {};             ///< per contact, N values [m]
  std::vector<std::vector<double>> coefficients = {};  ///< per contact a_0, a_1, b_1, a_2, b_2, .. [m]
  std::optional<bool> stable = {};                     ///< empty where that is not known
  int impacts = 0;                                     ///< in a period, or closings
};

/// A point that was located.
struct ExchangedSpecial {
  SpecialKind kind = SpecialKind::fold;  ///< what happens there
  ExchangedPoint point = {};             ///< its motion
  std::string text = {};                 ///< more about it
  int after = 0;                         ///< points of the branch before it
};

/// Points that follow each other.
struct ExchangedBranch {
  std::string scene = {};     ///< in a file of branches: which one it is of; else empty
  std::string sequence = {};  ///< of what kind its motions are
  std::string began = {}, ended = {};
  bool by_steps = false;  ///< Branch::by_steps
  std::vector<ExchangedPoint> points = {};
  std::vector<ExchangedSpecial> special = {};
};

/// All that a program makes of an interval.
struct ExchangedCurve {
  std::vector<ExchangedBranch> branches = {};
  std::string unfinished = {};          ///< why that is not all; empty where it is
  std::vector<std::string> notes = {};  ///< BranchDiagram::notes
  std::optional<double> seconds = {};   ///< that it says it took [s]
};

/// What a request for a curve holds beside problem and options: `parameter`, `from`, `to`, `max_order`,
/// `max_branches`, `max_points`, `phases` and `at`, as CurveLimits has them.
nlohmann::ordered_json follow_request(const ParametrisedScene& scene, const CurveLimits& limits);

/// The answer of a command. \throws BadRecord, and the exceptions of nlohmann for missing keys and other
/// types
ExchangedCurve curve_from_json(const nlohmann::ordered_json& json);

/// One line of a file of branches, likewise.
ExchangedBranch branch_from_line(const std::string& line);

/// The part of the branches that lies in the interval, with no more points and branches than the limits
/// allow; what is cut off is told as ends of branches and in `unfinished`. x_max and amplitude are those of
/// the instants given, of a series of 32 per harmonic; the motion at `limits.phases` instants is read between
/// them by linear interpolation. Points alone have no neighbour and are left out with a note. \param contacts
/// of the scene \throws BadRecord for motions of another number of contacts, numbers that are not finite, or
/// a frequency or
///         order out of range
BranchDiagram diagram_of(const ExchangedCurve& curve, const ParametrisedScene& scene, int contacts,
                         const CurveLimits& limits);

/// The branches of a file, one per line; empty lines are passed over. \throws SceneError, `FILE:LINE: what`;
/// UsageError for a file that cannot be read
std::vector<ExchangedBranch> read_branches(const std::filesystem::path& file);

/// A method that follows, over the frequency of the load, the scenes whose names stand with the branches.
/// \param represents  the law that the branches obey, by the scene's own; empty where there is none
std::unique_ptr<Method> method_of_branches(
    std::shared_ptr<const std::vector<ExchangedBranch>> branches,
    std::function<std::optional<RepresentedLaw>(const Law&)> represents);

}  // namespace signorini
