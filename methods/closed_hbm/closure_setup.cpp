#include "methods/closed_hbm/closure_setup.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/hat_functions/hat_contact.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

// Harmonics that the response to impacts has at least, what is neglected beyond the last falling with its
// third power, and at most, where modes that an impact excites lie higher.
constexpr int kClosedResponse = 128, kMostClosedResponse = 1024;

bool any_has_mass(const ContactReceptance& response, int harmonic) {
  for (int c = 0; c < response.contacts(); ++c) {
    if (is_mass_beyond(response, c, harmonic)) return true;
  }
  return false;
}

/// C_n, n = 0..L; nothing where an undamped mode answers to one of these harmonics.
std::optional<ContactReceptance> receptance_of_damped(const Problem& problem, int harmonics) {
  try {
    return fourier_receptance(problem, harmonics);
  } catch (const SingularStiffness&) {
    return std::nullopt;
  }
}

/// Whether a response shows the mass of each contact that answers like one: the impulse of an impact errs by
/// as much as that. Modes beyond its last harmonic are missing.
bool shows_masses(const ContactReceptance& response, const Eigen::MatrixXd& inertance, int harmonic) {
  constexpr double kMissing = 1e-4;  // below what a series of 160 harmonics leaves of x
  const Eigen::MatrixXd shown = inertial_limit(response).a;
  for (int c = 0; c < response.contacts(); ++c) {
    const double missing = std::abs(shown(c, c) - inertance(c, c));
    if (missing > kMissing * inertance(c, c) && is_mass_beyond(response, c, harmonic)) return false;
  }
  return true;
}

/// `response` with as many harmonics as it takes to show the masses of the contacts, as far as contacts
/// answer like masses there.
ContactReceptance with_modes_of_impacts(const Problem& problem, ContactReceptance response, int harmonic) {
  if (!is_definite(problem.mass())) return response;
  const double base = problem.base_frequency();
  const Eigen::MatrixXd inertance = delassus_matrix(problem) / (base * base);
  while (2 * response.harmonics() <= kMostClosedResponse && !shows_masses(response, inertance, harmonic)) {
    std::optional<ContactReceptance> longer = receptance_of_damped(problem, 2 * response.harmonics());
    if (!longer || !any_has_mass(*longer, harmonic)) break;
    response = *std::move(longer);
  }
  return response;
}

/// The response beyond the harmonics of `kept`; nothing where no contact answers like a mass there.
std::optional<ContactReceptance> response_to_impacts(const Problem& problem, const ContactReceptance& kept) {
  const int harmonics = kept.harmonics();
  // A look at the harmonics at hand spares most structures with higher modes the search for more.
  if (!any_has_mass(kept, harmonics - std::max(1, harmonics / 8))) return std::nullopt;
  std::optional<ContactReceptance> extended =
      receptance_of_damped(problem, std::max(2 * harmonics, kClosedResponse));
  if (!extended || !any_has_mass(*extended, harmonics)) return std::nullopt;
  return with_modes_of_impacts(problem, *std::move(extended), harmonics);
}

}  // namespace

std::optional<ClosureSetup> closure_setup(const HarmonicSetup& setup, const ClosureSettings& settings) {
  const Problem& problem = *setup.problem;
  if (!std::holds_alternative<Restitution>(problem.law())) return std::nullopt;
  if (setup.receptance.rigid_count() > 0)
    // Impulses of a closure are free; those of a loose part add up to its mean load.
    return ClosureSetup{
        .obstacle =
            "they are of a part that no spring holds: a closure takes each impulse as an unknown of "
            "its own, but the mean load fixes their sum and leaves the mean of the part open; "
            "hat-lcp and exact-orbit take both"};
  ClosureSetup closure{.restitution = settings.restitution,
                       .stiffness_factor = settings.constant_is_chosen ? 1.0 : 8.0,
                       .response = response_to_impacts(problem, setup.receptance)};
  if (!closure.response && closure.restitution == 1.0) return std::nullopt;
  if (closure.response && coarsest_hat_grid(problem) * problem.contact_count() <= kMostHatUnknowns)
    closure.hat_grids = hat_grids(problem, {.max_iterations = setup.options.max_iterations},
                                  NodalRestitution(problem.contacts.size(), closure.restitution));
  return closure;
}

}  // namespace signorini
