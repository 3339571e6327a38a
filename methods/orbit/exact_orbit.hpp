#pragma once
// The exact periodic orbit behind any motion of a scene.

#include <functional>
#include <memory>

#include "methods/orbit/orbit_guess.hpp"
#include "methods/orbit/polish.hpp"

namespace signorini {

/// What a search found, and what was tried on the way.
struct OrbitSearch {
  ExactOrbit orbit;     ///< the certified one, or the attempt that came furthest
  int attempts = 0;     ///< sequences polished
  long iterations = 0;  ///< Newton steps in all
};

/// How far a search goes.
struct SearchOptions {
  PolishOptions polish = {};  ///< of each attempt
  int rounds = 4;             ///< simulations from what the polish left
  int shootings = 25;         ///< Newton steps of the shooting at the end; 0: none
  int marched = 0;            ///< forcing periods marched at the very end, for stable orbits; 0: none
  std::function<bool()> expired = [] { return false; };  ///< true ends the search
};

/// Exact orbits of one scene of period Problem::period(). Not thread-safe: flows are made when first needed.
class OrbitFinder {
 public:
  /// \throws std::runtime_error with flow_obstacle(problem) if there is one
  explicit OrbitFinder(const Problem& problem);

  /// Candidates in order, until one polishes to an admissible orbit: the sequence read off the contact force
  /// (`orbit_guess`); the one met in one period's flow from its state (`simulated_sequence`); those from the
  /// states that inadmissible solutions left, for several rounds; those along Newton's method on the
  /// stroboscopic map (`find_fixed_point`, whose sequence may change at each step); those met while marching.
  OrbitSearch find(const Trajectory& trajectory, const SearchOptions& options = {});
  /// The same from a sequence.
  OrbitSearch find(const OrbitGuess& guess, const SearchOptions& options = {});

  /// The scene as its orbits see it.
  [[nodiscard]] const std::shared_ptr<OrbitModel>& model() const { return model_; }

 private:
  class Search;
  std::shared_ptr<OrbitModel> model_;
};

}  // namespace signorini
