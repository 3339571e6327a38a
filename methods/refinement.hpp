#pragma once
// One scene at several resolutions, from coarse to fine.

#include <cstddef>
#include <functional>
#include <memory>
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

/// Whether an answer is worth the next resolution.
using WorthChecking = std::function<bool(const Solution&)>;

/// Solves at one resolution after another until two that converge agree: their motions are within 5 % of
/// their size of each other. Where none do, the finest answer is claimed unless it is nowhere near the one
/// before (`near_by`); an answer that is not worth the next resolution is taken as it is; one that could not
/// be checked because the time was up is not claimed. The answer is the finest found. The first resolution is
/// prepared at once, the others anew in every solve, whose part they are; the work is that of all. The
/// message names the resolution of the answer, "N = 1024". Motions smaller than `least` [m] are at rest.
std::unique_ptr<PreparedMethod> refined_until_agreed(Resolutions resolutions, WorthChecking worth_checking,
                                                     double least);

/// A motion farther from another than this, relative root mean square of x over the period, is not an
/// approximation of it: the judge certifies no answer by an orbit so far away, and a method claims no motion
/// so far from the one on the next coarser grid.
inline constexpr double kNearOrbit = 0.5;

/// Motions within this distance are told to be the same one by a method that chooses its resolution itself.
inline constexpr double kOwnMotion = 0.1;

/// |x_a - x_b| over the largest of the sizes of x_a and x_b about their means and `least` [m], root mean
/// squares at so many instants [-].
double relative_distance(const Trajectory& a, const Trajectory& b, int instants, double least = 0.0);

/// Whether motions at this relative distance may be the same one, found with different errors: coarse answers
/// may be off by 0.3 and are near the same orbit all the same.
bool near_by(double distance);

/// Pivots, iterations and factorisations of a part, added to those of the whole.
void add_effort(const Work& part, Work& whole);

}  // namespace signorini
