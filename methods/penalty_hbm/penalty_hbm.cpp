#include "methods/penalty_hbm/penalty_hbm.hpp"

#include <utility>

#include "methods/harmonic_balance/harmonics_option.hpp"
#include "methods/harmonic_balance/projected_contact.hpp"

namespace signorini {

PenaltyHbm::PenaltyHbm(const Options& options) : options_(options) {
  validate_harmonic_options(options_);
  require_option(!options_.penalty || options_.penalty->value > 0.0, "penalty", options_.penalty,
                 "must be positive, or auto");
}

Support PenaltyHbm::supports(const Problem& problem) const {
  return supports_harmonics(problem, first_harmonics(options_.harmonics, problem), options_.samples);
}

RepresentedLaw PenaltyHbm::law(const Problem& problem) const {
  return projected_method_law(problem, options_.penalty);
}

std::unique_ptr<PreparedMethod> PenaltyHbm::prepare(const Problem& problem) const {
  const auto law = [&problem, penalty = options_.penalty](const ContactReceptance& receptance) {
    return penalty_law(problem, penalty, receptance);
  };
  return prepare_harmonics(options_, problem, [&problem, law, options = options_](int harmonics) {
    return projected_contact(problem, harmonics, law, options);
  });
}

}  // namespace signorini
