#pragma once
// The orbits that the harness computes for one scene before it judges answers on it.

#include <map>
#include <span>
#include <string>

#include "harness/judge/reference.hpp"
#include "harness/plan/plan.hpp"
#include "harness/run/applicability.hpp"

namespace signorini {

/// References of one scene, one for each law that a method represents and one for the scene's own.
class References {
 public:
  /// Finds those that are missing, each in a process of its own: the one under the scene's own law as
  /// results/references keeps it, the others, and where it is not kept, by marching from rest within
  /// limits.reference_timeout (0: not at all). None if no method applies.
  void compute(const Scene& scene, std::span<const Applicability> methods, const OrbitTools& tools,
               const Limits& limits);
  /// The reference under a law, the scene's own where the law is undetermined; one without an orbit if it was
  /// not computed.
  [[nodiscard]] const Reference& under(const RepresentedLaw& law, const Problem& problem) const;
  /// Keeps the orbit behind a record's answer, if CVODE has confirmed it, for the judging of later answers.
  void keep_confirmed(const Problem& problem, const Record& record);
  /// To be called before another scene's turn.
  void clear() { by_law_.clear(); }

 private:
  std::map<std::string, Reference> by_law_;  ///< key: the law as JSON
};

}  // namespace signorini
