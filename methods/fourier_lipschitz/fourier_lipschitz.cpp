#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"

#include <utility>

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
  ContactReceptance receptance = fourier_receptance(problem, options_.harmonics);
  ProjectedLaw law = lipschitz_law(problem, options_.c, receptance);
  const SolverSettings solver{options_.solver, options_.tolerance, options_.max_iterations};
  return std::make_unique<ProjectedContact>(problem, std::move(receptance), std::move(law),
                                            ProjectedOptions{options_.samples, options_.quadrature, solver});
}

}  // namespace signorini
