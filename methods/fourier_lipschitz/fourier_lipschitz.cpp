#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"

#include "methods/kernels/projected_contact.hpp"

namespace signorini {

FourierLipschitz::FourierLipschitz(const Options& options) : options_(options) {
  validate_harmonic_options(options_);
  require_option(!options_.c || *options_.c > 0.0, "c", options_.c, "must be positive, or auto");
}

Support FourierLipschitz::supports(const Problem& problem) const {
  return supports_harmonics(problem, options_.harmonics);
}

RepresentedLaw FourierLipschitz::law(const Problem& problem) const { return projected_method_law(problem); }

std::unique_ptr<PreparedMethod> FourierLipschitz::prepare(const Problem& problem) const {
  const SolverSettings solver{options_.solver, options_.tolerance, options_.max_iterations};
  const auto law = [&problem, c = options_.c](const ContactReceptance& receptance) {
    return lipschitz_law(problem, c, receptance);
  };
  return std::make_unique<ProjectedContact>(contact_gaps(problem),
                                            fourier_receptance(problem, options_.harmonics), law,
                                            ProjectedOptions{options_.samples, options_.quadrature, solver});
}

}  // namespace signorini
