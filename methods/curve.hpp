#pragma once
// Curves of solutions over a number of the scene: what a method that follows them is asked, and what it
// answers. Plain data.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "methods/method.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The place of the frequency of the load in a scene file: the parameter that is followed by default.
inline constexpr std::string_view kFrequency = "forcing.frequency";

/// A scene as a function of one of its numbers.
struct ParametrisedScene {
  std::string parameter;  ///< its place in the scene file: kFrequency, "law.restitution", ...
  double from = 0.0;      ///< one end of the interval looked at, in the unit of the parameter
  double to = 1.0;        ///< the other end, above or below
  std::function<Problem(double)> at = {};  ///< the scene at a value

  [[nodiscard]] double low() const { return std::min(from, to); }   ///< lower end
  [[nodiscard]] double high() const { return std::max(from, to); }  ///< upper end
  /// Its middle, or, as zero is a special value of most numbers, halfway from there to an end.
  [[nodiscard]] double middle() const { return from + to == 0.0 ? 0.5 * to : 0.5 * (from + to); }
  /// In the interval, both ends included.
  [[nodiscard]] bool contains(double value) const { return value >= low() && value <= high(); }
};

/// The scene with the frequency of its load left free [rad/s].
ParametrisedScene over_frequency(const Problem& problem, double from, double to);

/// A scene as a function of two of its numbers: over the first for each value of the second.
struct ScenePlane {
  std::function<ParametrisedScene(double)> at = {};  ///< the interval of the first is the same for all
  std::string second;                                ///< the place of the second number
  double from = 0.0;                                 ///< where curves begin, in its unit
  double to = 1.0;                                   ///< where they end, above or below

  /// In the interval, both ends included.
  [[nodiscard]] bool contains(double value) const {
    return value >= std::min(from, to) && value <= std::max(from, to);
  }
};

/// What rounding makes of a multiplier, relative to 1 [-]
inline constexpr double kMultiplierRounding = 1e-9;
/// How near to the circle the multipliers of a motion without loss are [-]
inline constexpr double kOnCircle = 1e-8;

/// What the multipliers say of a motion.
enum class OrbitStability {
  stable,     ///< all inside the circle
  unstable,   ///< one outside
  elliptic,   ///< of a motion without loss: all on the circle, to kOnCircle
  undefined,  ///< an impact grazes, or impacts of one instant feel each other
  unknown,    ///< the equations of the method do not tell
};

/// The names of these, in files too.
template <>
struct EnumNames<OrbitStability> {
  /// In order.
  static constexpr std::array<std::string_view, 5> values{"stable", "unstable", "elliptic", "undefined",
                                                          "unknown"};
};

/// "stable", "unstable", "elliptic", "undefined", "unknown".
std::string describe(OrbitStability stability);

/// One motion of a curve. What is called a branch point is a SpecialPoint, where curves cross.
struct SolutionPoint {
  double parameter = 0.0;              ///< its value, in its unit
  double frequency = 0.0;              ///< omega of the load [rad/s]
  int order = 1;                       ///< forcing periods per period [-]
  std::vector<double> x_max = {};      ///< largest x_j over the period, Nc [m]
  std::vector<double> amplitude = {};  ///< half of largest less least x_j, Nc [m]
  /// x_j at `phases` equidistant instants of each forcing period, the first at t = 0, order phases x Nc [m];
  /// empty unless phases were asked for.
  Eigen::MatrixXd motion = {};
  int impacts = 0;  ///< in a period; of springs, massless contacts and methods their closings
  std::optional<double> energy = {};  ///< of a free motion, kinetic and of all springs [J]
  /// Of a phase resonance: of the linear mode that takes the same power at the same first harmonic [-].
  std::optional<double> damping_ratio = {};
  std::optional<double> second = {};  ///< of a curve over two numbers the second one, in its unit
  OrbitStability stability = OrbitStability::undefined;  ///< as the method has it
  std::string undefined = {};                            ///< why it is, one clause, where that is known
  Eigen::VectorXcd multipliers = {};  ///< Floquet, 2 Nd or the largest; empty where undefined or unknown
};

/// What happens where a branch turns, changes its stability or its sequence of events, or crosses another; of
/// a response to a load of one harmonic, where that is in quadrature with the displacement (LoadPhase).
enum class SpecialKind {
  fold,
  period_doubling,
  neimark_sacker,
  branch_point,
  phase_resonance,
  grazing,
  contact_change
};

/// The names of these, in files too.
template <>
struct EnumNames<SpecialKind> {
  /// In order.
  static constexpr std::array<std::string_view, 7> values{
      "fold",    "period-doubling", "neimark-sacker", "branch-point", "phase-resonance",
      "grazing", "contact-change"};
};

/// "fold", "period-doubling", "neimark-sacker", "branch-point", "phase-resonance", "grazing",
/// "contact-change".
std::string describe(SpecialKind kind);

/// Where something happens, located.
struct SpecialPoint {
  SpecialKind kind = SpecialKind::fold;  ///< what
  SolutionPoint point;                   ///< the motion there
  /// Of a change of the sequence what happens, of a fold what turns, of a phase resonance how it is damped;
  /// else empty.
  std::string text = {};
  std::size_t after = 0;  ///< points of the branch before it
};

/// Motions of one kind, neighbours next to each other.
struct Branch {
  std::string sequence = {};               ///< the kind: "order 2, events I0", "order 2, 40 harmonics"
  std::string began = {};                  ///< why there, one clause
  std::string ended = {};                  ///< likewise
  std::vector<SolutionPoint> points = {};  ///< at least two
  std::vector<SpecialPoint> special = {};  ///< in the order of the branch
  bool by_steps = false;  ///< neighbours are steps of the parameter, and may lie on different curves
};

/// Called with each branch as soon as it is known.
using TakeBranch = std::function<void(const Branch& branch)>;

/// Branches that belong together, and whether that is all.
struct BranchDiagram {
  std::vector<Branch> branches = {};    ///< in the order in which they were found
  std::string unfinished = {};          ///< what a limit has left undone; empty where nothing
  std::vector<std::string> notes = {};  ///< what was found and not followed, each with its reason
  std::optional<double> seconds = {};  ///< of a method that works in processes of its own: what they took [s]
};

/// A motion at a value of the parameter, at which branches may begin.
struct KnownMotion {
  double parameter = 0.0;                              ///< the value
  std::shared_ptr<const Trajectory> motion = nullptr;  ///< one period of it
};

/// How much of a diagram is asked for. Cascades of doublings are infinite; without limits it would not end.
struct CurveLimits {
  int max_order = 2;        ///< forcing periods per period; the scene's order where that is larger
  int max_branches = 60;    ///< in all
  int max_points = 2000;    ///< of one branch
  double step_share = 1.0;  ///< of the longest steps that the method takes by itself [-]
  int phases = 0;           ///< of a forcing period at which the points keep their motion; 0: it is not kept
  std::vector<double> at = {};             ///< values of the parameter at which every branch has points
  std::vector<KnownMotion> begin_at = {};  ///< beside what a method begins at by itself, where it can
  TakeBranch take = {};                    ///< called with each branch as soon as it is known
  /// The end of the time budget.
  Deadline deadline = {};
  std::function<bool()> stopped = {};  ///< true ends it at once, with what there is

  /// Whether it is over; methods ask between steps.
  [[nodiscard]] bool expired() const { return (stopped && stopped()) || deadline.passed(); }
};

/// A method that follows the solutions of its own equations by arc length: `Method::curve` returns it.
class CurveMethod {
 public:
  virtual ~CurveMethod() = default;
  /// Whether it follows them over this parameter between both ends.
  [[nodiscard]] virtual Support follows(const ParametrisedScene& scene) const = 0;
  /// The branches that hang together with its answers at both ends of the interval. Each point is a solution
  /// of what a solve at its value of the parameter solves. Every end of a branch has its reason; where
  /// nothing could be followed, `unfinished` says why. Numerical failure is a diagram too, never an
  /// exception. \param scene  that `follows` accepts
  [[nodiscard]] virtual BranchDiagram follow(const ParametrisedScene& scene,
                                             const CurveLimits& limits) const = 0;
  /// Curves of the special points of a kind, one from each at plane.from towards plane.to, their points with
  /// the second number; `unfinished` says why there is none. Empty: it follows none of this kind.
  /// \param plane  whose scenes `follows` accepts
  [[nodiscard]] virtual std::optional<BranchDiagram> follow_bifurcations(
      [[maybe_unused]] const ScenePlane& plane, [[maybe_unused]] SpecialKind kind,
      [[maybe_unused]] const CurveLimits& limits) const {
    return std::nullopt;
  }
};

/// What a method says whose curves are over the frequency of the load: whether that is the parameter, and the
/// method applies at both ends.
Support follows_frequency(const Method& method, const ParametrisedScene& scene);

}  // namespace signorini
