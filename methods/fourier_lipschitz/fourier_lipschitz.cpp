#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"

#include "methods/complementarity/projected_law.hpp"

namespace signorini {

FourierLipschitz::FourierLipschitz(const Options& options)
    : FollowedMethod(options.common), options_(options) {
  validate(options_.common, options_.solver);
  validate_constant(options_.c);
}

HarmonicMethod FourierLipschitz::preset(const Problem& problem) const {
  const bool by_pivots = options_.solver == ComplementaritySolver::pivoting;
  const auto law = [&problem, c = common().lipschitz_constant(options_.c, by_pivots)](
                       const ContactReceptance& level) { return lipschitz_law(problem, c, level); };
  return by_complementarity(law, common(), options_.solver);
}

}  // namespace signorini
