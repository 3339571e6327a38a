#pragma once
// The exact orbit of a whole structure by orbits of a reduced one, and an error bar for it.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "methods/orbit/exact_orbit.hpp"
#include "methods/reduction/contact_space.hpp"

namespace signorini {

/// When corrections end, and how their bar is measured.
struct OrbitCorrectionSettings {
  SearchOptions search = {};  ///< of every orbit
  int corrections = 8;        ///< at most, >= 1 [-]
  double tolerance = 1e-8;  ///< on the bar as far as corrections reduce it, relative to x about its mean [-]
  int harmonics = 4096;     ///< H, of force and defect, per forcing period >= 64 [-]
  int shifted = 192;        ///< harmonics of the displacements that are added, per forcing period, <= H [-]
  int fewest_shifted = 25;  ///< the same at least, the constant included [-]
  double slowest = 0.5;     ///< rate of the corrections beyond which they are not trusted to converge [-]
  double typical = 0.1;     ///< rate at which corrections make defects fall at least, where they converge [-]
  double negligible = 0.05;  ///< part of the other terms of the bar below which a defect tells nothing [-]
  double safety = 2.0;       ///< of the bar [-]
  double rounding = 1e-13;   ///< defects below are rounding, and so is what they change, relative to x [-]
  int probes = 4;            ///< displacements by which the amplification is measured [-]
  double least_probe = 1e-10, largest_probe = 1e-6;  ///< between which they are as large as what is left [-]
  int resonances = 32;  ///< harmonics of the response to a change of K looked at for resonances [-]
  int instants = 1024;  ///< at which two orbits are compared, per forcing period [-]
  /// Part of the tolerance that the vectors to solve on may leave out of the motion they are chosen for [-]
  double left_by_solved = 1e-3;
};

/// An orbit of the reduced structure with displacements added to its contacts, and what the whole structure
/// makes of its forces. Lengths are root mean squares over contacts and time, relative to that of x about its
/// mean: after a jump of a force a defect has a peak of short duration, which says little of the motion.
struct CorrectedOrbit {
  ExactOrbit orbit = {};    ///< the last one; its x contains the displacements added
  long iterations = 0;      ///< Newton steps of the corrections
  Eigen::Index solved = 0;  ///< vectors that the orbit is one of
  /// Of the space that checks, grown for these forces where that was needed.
  Eigen::Index vectors = 0;
  /// |x_whole[lambda] - x| after each orbit in the harmonics that can be added: backward errors, as far as
  /// the whole space knows [-].
  std::vector<double> defects = {};
  double unshifted = 0.0;  ///< the last one in all other harmonics up to H [-]
  double peak = 0.0;       ///< the last defect in all harmonics at its largest instant and contact [-]
  /// Largest |change of x| / |displacement| that corrections and probes made, at least 1 [-].
  double amplification = 1.0;
  double outside = 0.0;   ///< bound of what the whole space leaves out of x_whole [-]
  double tail = 0.0;      ///< estimate of what harmonics above H do to the defect [-]
  double rounding = 0.0;  ///< of K, in x [-]
  /// On |x - x_true|; empty: none can be given [-].
  std::optional<double> bar = {};
  std::string refusal = {};  ///< why there is no bar, one clause
  /// With a bar: the space given, grown and with the vectors to solve on that this orbit's force needs.
  std::optional<ContactSpace> space = {};
};

/// Deferred correction of exact orbits. With lambda of an orbit, in closed form its Fourier coefficients, and
/// x_whole = free + C lambda by the many vectors of a ContactSpace, d = x_whole - x is by what the few
/// vectors are wrong under these forces: x_whole and lambda satisfy the structure's equations against stops
/// moved by d. Added to x of the next orbit (as a shift that relaxes, d + beta d'), it leads to the orbit of
/// the whole structure, whatever the few vectors. Where the space's bound would be the largest part of the
/// bar it is grown (`ContactSpace::grown_for`); the next orbit is one of the vectors that these forces need
/// (`ContactSpace::solved_for`), so that what is not added falls too. Each orbit is polished from the events
/// of the one before, and admissible. Corrections end where the bar is as small as is wanted, or the next one
/// does not promise half of what is left; none is made where the bar of the first orbit, by its probes, is
/// so.
///
/// The bar is 2 A (d / (1 - theta) + unshifted + tail + outside + rounding) + the orbit's own: d the last
/// defect, theta <= 1/2 the rate at which defects fell, or without a correction the largest |change of
/// x_whole - x| / |displacement| of the probes, of which one is the defect itself; A the amplification,
/// rounding the measured one of the factors of K over the distance from resonance. A is the largest that
/// corrections show, in which the displacement is what they take away of the defect in all harmonics, and
/// four probes: orbits with displacements added as large as what is left, the first of them in proportion to
/// x, each other one to what the one before has changed (power iteration on the response of the orbit).
/// Refused: without the forces in closed form; where a correction finds no admissible orbit, or contacts that
/// close more or less often in the end, or a probe does; where defects do not fall by half.
///
/// \param first  an orbit of `space.small()` with the displacements `added`
/// \param added  d_n, n = 0.., per harmonic and contact; none by default [m]
CorrectedOrbit correct_orbit(const Problem& problem, const ContactSpace& space, ExactOrbit first,
                             const OrbitCorrectionSettings& settings = {}, Eigen::MatrixXcd added = {});

/// How many harmonics of displacements are to be added, the constant included: 25 doubled until the root mean
/// square over time of the others is at most `least` [m], no more than the settings allow.
/// \param missing  d_n, n = 0..H, per harmonic and contact [m]
Eigen::Index harmonics_to_add(const Eigen::MatrixXcd& missing, double least, int order,
                              const OrbitCorrectionSettings& settings);

/// The root mean square over time and contacts of x about its mean, 1 if that is zero: the scale of defects.
/// \param x  at equidistant instants of the period, instants x Nc [m]
double size_about_mean(const Eigen::MatrixXd& x);

/// `condensed(reduction)` with displacements added to the contacts.
/// \param added  d_n, n = 0.., per harmonic and contact [m]
/// \param base   rate of harmonic 1, a whole part of the load's [rad/s]
CondensedStructure displaced(const ContactReduction& reduction, const Eigen::MatrixXcd& added, double base);

}  // namespace signorini
