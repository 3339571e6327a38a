#include "methods/penalty_hbm/penalty_hbm.hpp"

#include "methods/complementarity/projected_law.hpp"

namespace signorini {

PenaltyHbm::PenaltyHbm(const Options& options)
    : FollowedMethod(options.common, options.penalty), options_(options) {
  validate(options_.common, options_.solver);
}

HarmonicMethod PenaltyHbm::preset(const Problem& problem) const {
  const bool by_pivots = options_.solver == ComplementaritySolver::pivoting;
  const auto law = [&problem, penalty = common().penalty(options_.penalty, by_pivots)](
                       const ContactReceptance& level) { return penalty_law(problem, penalty, level); };
  return by_complementarity(law, common(), options_.solver);
}

}  // namespace signorini
