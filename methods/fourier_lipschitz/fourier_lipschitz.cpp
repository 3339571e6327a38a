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
  const auto law = [&problem, c = options_.c](const ContactReceptance& receptance) {
    return lipschitz_law(problem, c, receptance);
  };
  ContactReceptance receptance = fourier_receptance(problem, options_.harmonics);
  ProjectedOptions options = projected_options(problem, receptance, options_);
  return std::make_unique<ProjectedContact>(contact_gaps(problem), std::move(receptance), law,
                                            std::move(options));
}

}  // namespace signorini
