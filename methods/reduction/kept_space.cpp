#include "methods/reduction/kept_space.hpp"

#include <algorithm>

namespace signorini {

bool KeptSpace::fits(const Problem& problem) const {
  const auto same_shape = [](const ForceTerm& a, const ForceTerm& b) {
    return a.dof == b.dof && a.harmonic == b.harmonic && a.cos == b.cos && a.sin == b.sin;
  };
  return space_ && of_.structure == problem.structure &&
         std::ranges::equal(of_.force, problem.force, same_shape) &&
         std::ranges::equal(of_.contacts, problem.contacts, {}, &Contact::normal, &Contact::normal);
}

std::shared_ptr<const ContactSpace> KeptSpace::of(const Problem& problem) {
  if (!fits(problem)) {
    space_.reset();  // two at once may be more than the memory
    space_ = std::make_shared<const ContactSpace>(problem);
    ++made_;
  } else if (of_.law().index() != problem.law().index() || of_.frequency != problem.frequency) {
    space_ = std::make_shared<const ContactSpace>(space_->of(problem));
  }
  of_ = problem;
  return space_;
}

}  // namespace signorini
