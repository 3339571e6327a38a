#pragma once
// What continuation finds: branches of orbits, exact ones or those of a method, with their special points.

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "methods/orbit/orbit_equations.hpp"

namespace signorini {

/// What the multipliers say of an orbit.
enum class OrbitStability {
  stable,     ///< all inside the circle
  unstable,   ///< one outside
  elliptic,   ///< of a motion without loss: all on the circle, to 1e-8
  undefined,  ///< an impact grazes
  unknown,    ///< the equations of the method do not tell
};

/// "stable", "unstable", "elliptic", "undefined", "unknown".
inline std::string describe(OrbitStability stability) {
  constexpr const char* kWords[] = {"stable", "unstable", "elliptic", "undefined", "unknown"};
  return kWords[static_cast<std::size_t>(stability)];
}

/// One orbit of a branch.
struct BranchPoint {
  double parameter = 0.0;              ///< p
  double frequency = 0.0;              ///< omega [rad/s]
  int order = 1;                       ///< forcing periods per period [-]
  OrbitGuess orbit = {};               ///< of an exact orbit: state at a section, and the events
  std::vector<double> x_max = {};      ///< largest x_j over the period, exact, Nc [m]
  std::vector<double> amplitude = {};  ///< half of largest less least x_j, exact, Nc [m]
  /// x_j at `phases` equidistant instants of each forcing period, the first at t = 0, order phases x Nc [m];
  /// empty unless phases were asked for.
  Eigen::MatrixXd motion = {};
  int impacts = 0;  ///< in a period; of springs, massless contacts and methods their closings
  std::optional<double> energy = {};  ///< of a free motion, kinetic and of all springs [J]
  OrbitStability stability = OrbitStability::undefined;
  Eigen::VectorXcd multipliers = {};  ///< Floquet, 2 Nd; empty where undefined or unknown
};

/// A point at which a branch turns, changes its stability or its sequence of events, or meets another one.
enum class SpecialKind { fold, period_doubling, neimark_sacker, branch_point, grazing, contact_change };

/// "fold", "period-doubling", "neimark-sacker", "branch-point", "grazing", "contact-change".
inline std::string describe(SpecialKind kind) {
  constexpr const char* kWords[] = {"fold",         "period-doubling", "neimark-sacker",
                                    "branch-point", "grazing",         "contact-change"};
  return kWords[static_cast<std::size_t>(kind)];
}

/// One of them, located.
struct SpecialPoint {
  SpecialKind kind = SpecialKind::fold;
  BranchPoint point;      ///< the orbit there
  std::string text = {};  ///< of a change of the sequence what happens, of a fold what turns; else empty
  std::size_t after = 0;  ///< points of the branch before it
};

/// Orbits of one sequence of events, neighbours next to each other.
struct Branch {
  std::string sequence = {};               ///< "order 2, events I0"; of a method "order 2, 40 harmonics"
  std::string began = {}, ended = {};      ///< why there, one clause each
  std::vector<BranchPoint> points = {};    ///< at least two
  std::vector<SpecialPoint> special = {};  ///< in the order of the branch
};

/// Called with each branch as soon as it is known.
using TakeBranch = std::function<void(const Branch& branch)>;

/// Branches that belong together, and whether that is all.
struct BranchDiagram {
  std::vector<Branch> branches = {};
  std::string unfinished = {};          ///< what a limit has left undone; empty where nothing
  std::vector<std::string> notes = {};  ///< what was found and not followed, each with its reason
};

}  // namespace signorini
