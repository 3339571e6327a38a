#pragma once
// Continuation in the frequency of the load, as practice has it: from where nothing touches to the scene's
// own.

#include <vector>

#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/method.hpp"

namespace signorini {

/// Frequencies of the load, near that of the scene, at which the motion without contact forces stays off
/// every stop at N samples of its period: the scene's own where it is one; else at most one below and one
/// above, the nearest of w 1.1^{-k} and w 1.1^k, k = 1..32, the nearer one first. Empty where there is none:
/// a stop that presses in the mean, or has no gap, is touched at every frequency. \param budget  its deadline
/// alone counts \return [rad/s]
std::vector<double> contact_free_frequencies(const Problem& problem, int samples, const Start& budget);

/// Follows the solution of the sampled equations from a contact-free frequency w_0, where it is lambda = 0,
/// to the scene's own w_1: at w(s) = w_0 + s (w_1 - w_0) with s rising from 0 to 1, the method's own Newton
/// iteration starts from the forces of the point before. A step is at first, and at most, a sixteenth of the
/// way; it is halved where Newton's method fails and doubled where it does not (follow_path), and the path is
/// given up below 1/4096 of the way or after 200 trials. Then the other contact-free frequency is tried.
/// There is no arc length: a path that turns back in frequency is lost at its fold.
///
/// Needs a setup of a scene whose options fix the samples (`plain`). Always gives an answer, of
/// solve_on_grids at the end of the path, or one that has not converged and says where the path ended. Its
/// work, that of failed trials included, is added to `work`.
Solution continue_in_frequency(const HarmonicSetup& setup, const Start& start, Work& work);

}  // namespace signorini
