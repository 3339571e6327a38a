#pragma once
// The ContactSpace of a scene, made once for all that is asked of it.

#include <memory>
#include <vector>

#include "methods/reduction/contact_space.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The space of the structure that was asked for last. What is costly in it, the factors of K and the Krylov
/// space, depends on the structure, the directions of contact and the shapes of the load alone: scenes that
/// differ in gaps, law, frequency or order of the motion share one. A process that is forked has what its
/// parent had. Not thread-safe.
class KeptSpace {
 public:
  /// That of a scene; one with an obstacle is kept, too. Never null.
  std::shared_ptr<const ContactSpace> of(const Problem& problem);
  /// Lets go of it.
  void forget() { space_.reset(); }
  /// How many spaces were made.
  [[nodiscard]] int made() const { return made_; }

 private:
  [[nodiscard]] bool fits(const Problem& problem) const;

  Problem of_;  // that the space was made for, or asked for last
  std::shared_ptr<const ContactSpace> space_;
  int made_ = 0;
};

}  // namespace signorini
