#pragma once
// One scene at several resolutions, from coarse to fine.

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "methods/method.hpp"

namespace signorini {

/// A scene prepared at a resolution (nodes, harmonics).
using AtResolution = std::function<std::unique_ptr<PreparedMethod>(int resolution)>;

/// `first`, and on by `factor` while not above `finest`.
std::vector<int> rising_resolutions(int first, int factor, int finest);

/// A scene at resolutions in rising order, each prepared when it is first asked for.
class Resolutions {
 public:
  /// \param values  in rising order, at least one
  Resolutions(std::vector<int> values, AtResolution prepare);

  /// How many there are.
  [[nodiscard]] std::size_t count() const { return values_.size(); }
  /// The k-th, from the coarsest.
  [[nodiscard]] int value(std::size_t k) const { return values_[k]; }
  /// The scene prepared for it. \throws std::runtime_error if the structure cannot be factorised
  PreparedMethod& at(std::size_t k);
  /// One solve at the k-th; where it cannot be prepared, the structure being singular or memory short, there
  /// is no motion.
  Solution solve_at(std::size_t k, const Start& start);
  /// Drops what was prepared from the k-th on, so that the next solve pays for it again.
  void forget_from(std::size_t k);

 private:
  std::vector<int> values_;
  AtResolution prepare_;
  std::vector<std::unique_ptr<PreparedMethod>> prepared_;
};

/// What is asked of answers at several resolutions, and which of them are claimed.
struct RefinementRule {
  std::string resolution = "N";  ///< its name in messages, "N = 1024"
  /// Whether the end of a solve is worth the next resolution; empty: always. An answer that is not is taken
  /// as it is.
  std::function<bool(const Solution&)> worth_refining = {};
  /// Only an answer that another resolution confirms is claimed; else the finest one is, unless it is nowhere
  /// near the one before (kNearOrbit).
  bool only_confirmed = false;
  double least = 0.0;  ///< motions smaller than this are at rest [m]
};

/// Solves at one resolution after another until two that converge agree: their motions are within 5 % of
/// their size of each other (relative_distance). Where errors fall in proportion to the step and resolutions
/// double, that is the error of the finer one. The answer is the finest found; one that could not be checked
/// because the time was up is not claimed. The first resolution is prepared at once, the others anew in every
/// solve, whose part they are; the work is that of all. The message names the resolution of the answer, and
/// what was not reached where it is not claimed.
std::unique_ptr<PreparedMethod> refined_until_agreed(Resolutions resolutions, RefinementRule rule);

/// A motion farther from another than this, relative root mean square of x over the period, is not an
/// approximation of it: the judge certifies no answer by an orbit so far away, and a method claims no motion
/// so far from the one on the next coarser grid. Coarse answers may be off by 0.3 and are near the same
/// orbit.
inline constexpr double kNearOrbit = 0.5;

/// |x_a - x_b| over the larger of the sizes of x_a and x_b about their means, root mean squares at so many
/// instants; of two motions smaller than `least`, which are at rest, over the deflection of which `least` is
/// 1e-6 (size_at_rest) [-].
double relative_distance(const Trajectory& a, const Trajectory& b, int instants, double least = 0.0);

/// Deflection of the softest contact under the load at its largest, held still [m].
double static_deflection(const Problem& problem);

/// What is rounding in motions of a scene with contacts: 1e-6 of the static deflection [m].
double size_at_rest(const Problem& problem);

/// Pivots, iterations and factorisations of a part, added to those of the whole.
void add_effort(const Work& part, Work& whole);

}  // namespace signorini
