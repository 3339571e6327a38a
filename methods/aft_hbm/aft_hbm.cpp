#include "methods/aft_hbm/aft_hbm.hpp"

#include "methods/aft_hbm/aft_grid_solver.hpp"
#include "methods/complementarity/projected_law.hpp"

namespace signorini {

AftHbm::AftHbm(const Options& options) : FollowedMethod(options.common, options.penalty), options_(options) {
  validate_constant(options_.c);
  require_option(!options_.c || options_.law == ContactLaw::dlft, "c", options_.c,
                 "must be auto unless law = dlft");
  require_option(!options_.penalty || options_.law == ContactLaw::penalty, "penalty", options_.penalty,
                 "must be auto unless law = penalty");
}

HarmonicMethod AftHbm::preset(const Problem& problem) const {
  const bool homotopy = options_.homotopy.value_or(!common().plain);
  const auto law = [&problem, law = options_.law, c = common().lipschitz_constant(options_.c, homotopy),
                    penalty = common().penalty(options_.penalty, homotopy)](const ContactReceptance& level) {
    return law == ContactLaw::penalty ? penalty_law(problem, penalty, level)
                                      : lipschitz_law(problem, c, level);
  };
  return {.law_at = law,
          .grid_solver = aft_grid_solver(
              {.tolerance = common().tolerance, .max_iterations = common().max_iterations}, homotopy),
          .solver_is_open = homotopy,
          .newton_from_guess = false,  // its own Newton method takes the guess, on the first grid
          .counts = {.iterations = 0}};
}

}  // namespace signorini
