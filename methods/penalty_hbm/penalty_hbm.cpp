#include "methods/penalty_hbm/penalty_hbm.hpp"

#include "methods/kernels/projected_contact.hpp"

namespace signorini {

PenaltyHbm::PenaltyHbm(const Options& options) : options_(options) {
  validate_harmonic_options(options_);
  require_option(!options_.penalty || options_.penalty->value > 0.0, "penalty", options_.penalty,
                 "must be positive, or auto");
}

Support PenaltyHbm::supports(const Problem& problem) const {
  return supports_harmonics(problem, options_.harmonics);
}

RepresentedLaw PenaltyHbm::law(const Problem& problem) const {
  return projected_method_law(problem, options_.penalty);
}

std::unique_ptr<PreparedMethod> PenaltyHbm::prepare(const Problem& problem) const {
  const SolverSettings solver{options_.solver, options_.tolerance, options_.max_iterations};
  const auto law = [&problem, penalty = options_.penalty](const ContactReceptance& receptance) {
    return penalty_law(problem, penalty, receptance);
  };
  return std::make_unique<ProjectedContact>(contact_gaps(problem),
                                            fourier_receptance(problem, options_.harmonics), law,
                                            ProjectedOptions{options_.samples, options_.quadrature, solver});
}

}  // namespace signorini
