#include "methods/orbit/reduced/closing_orbit.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace signorini {

std::vector<int> pushing_contacts(const Trajectory& motion) {
  std::vector<int> pushing;
  for (const ContactEvent& event : motion.events().value_or(std::vector<ContactEvent>{}))
    pushing.push_back(event.contact);
  for (const Impulse& impulse : motion.impulses()) pushing.push_back(impulse.contact);
  const Eigen::MatrixXd force = motion.sample(motion.nodes().value_or(kFineInstants)).force;
  for (int j = 0; j < static_cast<int>(force.cols()); ++j) {
    if (!force.col(j).isZero(0.0)) pushing.push_back(j);
  }
  std::ranges::sort(pushing);
  pushing.erase(std::unique(pushing.begin(), pushing.end()), pushing.end());
  return pushing;
}

OrbitSearch find_closing_orbit(const Problem& problem, const CondensedStructure& structure,
                               std::vector<int>& closing, const Trajectory& motion,
                               const SearchOptions& options, const std::shared_ptr<SharedModes>& shared) {
  constexpr int kMostActing = 150;  // where it is not known which close
  std::vector<int> all(static_cast<std::size_t>(structure.normals.cols()));
  std::iota(all.begin(), all.end(), 0);
  OrbitSearch result;
  std::shared_ptr<const ExactTrajectory> before;  // the orbit of fewer contacts
  for (;;) {
    OrbitFinder finder(problem, with_open_contacts(structure, closing), shared);
    OrbitSearch found = finder.find(before ? *before : motion, options);
    if (result.attempts > 0 && found.attempts == 0) return result;  // the time is up
    result.attempts += found.attempts;
    result.iterations += found.iterations;
    result.orbit = std::move(found.orbit);
    const std::vector<int>& reached = result.orbit.admissibility.reached;
    if (!reached.empty()) {
      std::vector<int> joined;
      std::ranges::set_union(closing, reached, std::back_inserter(joined));
      closing = std::move(joined);
      before = result.orbit.trajectory;
    } else if (!result.orbit.certified() && closing != all && std::ssize(all) <= kMostActing) {
      closing = all;
      before = nullptr;
    } else {
      return result;
    }
  }
}

}  // namespace signorini
