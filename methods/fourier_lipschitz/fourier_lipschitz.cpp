#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"

#include <utility>

#include "methods/harmonic_balance/harmonics_option.hpp"
#include "methods/harmonic_balance/projected_contact.hpp"

namespace signorini {

FourierLipschitz::FourierLipschitz(const Options& options) : options_(options) {
  validate_harmonic_options(options_);
  require_option(!options_.c || *options_.c > 0.0, "c", options_.c, "must be positive, or auto");
}

Support FourierLipschitz::supports(const Problem& problem) const {
  return supports_harmonics(problem, first_harmonics(options_.harmonics, problem), options_.samples);
}

RepresentedLaw FourierLipschitz::law(const Problem& problem) const { return projected_method_law(problem); }

std::unique_ptr<PreparedMethod> FourierLipschitz::prepare(const Problem& problem) const {
  const auto law = [&problem, c = options_.c](const ContactReceptance& receptance) {
    return lipschitz_law(problem, c, receptance);
  };
  return prepare_harmonics(options_, problem, [&problem, law, options = options_](int harmonics) {
    return projected_contact(problem, harmonics, law, options);
  });
}

}  // namespace signorini
