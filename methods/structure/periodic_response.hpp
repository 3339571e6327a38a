#pragma once
// The structure's exact linear response to a periodic contact force: the full field behind a
// trajectory that knows only its contacts.

#include <Eigen/Core>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/solution.hpp"
#include "methods/structure/state.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The contact force of a trajectory in harmonics of the trajectory's own period.
struct ForceSeries {
  int order = 1;                ///< forcing periods in the period
  double base_frequency = 1.0;  ///< 2 pi / period [rad/s]
  Eigen::MatrixXcd lambda;      ///< (H+1) x Nc [N]
};

/// H is the trajectory's bandwidth where it has one, `max_harmonics` otherwise, never more but for harmonics
/// of the load. The trajectory's period must be a whole multiple of the forcing period (to 1e-6 relative).
/// \throws std::invalid_argument otherwise
ForceSeries force_series(const Problem& problem, const Trajectory& trajectory, int max_harmonics);

/// u(t) = sum_{|n|<=H} Z_n^{-1} (f_n + W lambda_n) e^{i n w t}, Z_n = K - (n w)^2 M + i n w D,
/// w = 2 pi / period of the trajectory, lambda_n the Fourier coefficients of its force and impulses.
/// See [shi2015, eq. 41 and 45, corrected]. Keeps the whole field, (H+1) x Nd numbers,
/// which `ContactResponse` does without.
class PeriodicResponse {
 public:
  /// H and the period as in `force_series`. The mean of a structure with rigid motions is that of the
  /// trajectory's contacts, and 0 along motions that these do not feel.
  /// \throws std::invalid_argument for a foreign period; std::runtime_error if some Z_n is singular
  PeriodicResponse(const Problem& problem, const Trajectory& trajectory, int max_harmonics = 512);
  /// The same to a contact force that is given in harmonics; rigid motions have the mean of HeldStructure.
  /// \throws std::runtime_error as above
  PeriodicResponse(const Problem& problem, const ForceSeries& series);

  /// u and v at any time; v is the mean of its sides where it jumps.
  [[nodiscard]] State at(double time) const;
  /// u at count instants, count x Nd [m].
  [[nodiscard]] Eigen::MatrixXd displacement(int count) const;

 private:
  double base_frequency_ = 0.0;
  Eigen::MatrixXcd u_;    // (H+1) x Nd
  Eigen::MatrixXd free_;  // rigid motions R where K is singular, else empty
};

/// Fourier coefficients n = 0..count of the contact force, impulses included, (count+1) x Nc [N]:
/// lambda_n = (1/T) integral over a period of lambda e^{-i n w t}. The trajectory's own coefficients where it
/// has them, zero beyond its bandwidth; else by a fine transform of its samples.
Eigen::MatrixXcd force_spectrum(const Trajectory& trajectory, int count);

/// Fourier coefficients n = 0..count of a force sampled at equidistant instants of its period, instants x Nc,
/// and of impulses. From `samples_for_spectrum(count)` instants on each is better than a hundredth, jumps of
/// the force included; beyond half the instants only the impulses have a part in them.
Eigen::MatrixXcd force_spectrum(const Eigen::MatrixXd& force, const std::vector<Impulse>& impulses,
                                double period, int count);

/// Instants at which a force is sampled for its coefficients n = 0..count: a power of two, 16 per harmonic.
int samples_for_spectrum(int count);

/// The pressure -lambda >= 0 at `count` equidistant instants in units of `unit` [N] per contact, contact by
/// contact, count Nc: z of a nearby complementarity problem. An impulse J presses as J count / T on the
/// instant nearest to it.
Eigen::VectorXd pressure_samples(const Trajectory& trajectory, int count, const Eigen::VectorXd& unit);

}  // namespace signorini
