#pragma once
// The independent solutions kept in tests/data/reference, and their series in this project's form.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "methods/discretisation/trajectories.hpp"
#include "methods/method.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

/// One periodic motion at the contacts, as somebody else computed it.
struct ReferenceMotion {
  double omega = 1.0;        ///< [rad/s]
  double stiffness = 0.0;    ///< of the stop, where it varies from row to row [N/m]
  double restitution = 1.0;  ///< of a rigid stop [-]
  int samples = 0;           ///< N of a harmonic balance; 0 for an exact motion
  double close = 0.0;        ///< start of the only contact, or time of the only impact [s]
  double open = 0.0;         ///< end of the only contact [s]
  double impulse = 0.0;      ///< of the only impact, > 0 [N s]
  Eigen::MatrixXcd x = {};   ///< (H+1) x Nc, x(t) = sum_{|n|<=H} x_n e^{i n omega t} [m]

  [[nodiscard]] int harmonics() const { return static_cast<int>(x.rows()) - 1; }
};

/// A structure with spring stops and the motions known of it.
struct ReferenceStructure {
  Problem problem;                     ///< frequency still to be set
  std::vector<ReferenceMotion> nlvib;  ///< harmonic balance by NLvib 1.3
  std::vector<ReferenceMotion> exact;  ///< closed-form piecewise-linear shooting
};

/// Every motion in a file of one-mass motions ("nlvib_sdof.json", ...).
std::vector<ReferenceMotion> load_oscillator_motions(const std::string& file);

/// "nlvib_ex03_2dof", "chain10_multi", "rod_tip", "beam_tip".
ReferenceStructure load_structure(const std::string& name);

/// The mass m = k = F = gap = 1, d = 0.1 of the one-mass files, driven at `omega`.
Problem reference_oscillator(double omega, Law law);

/// The motion as a start for a method on that problem: a spring stop's force follows from x.
std::shared_ptr<const Trajectory> start_from(const ReferenceMotion& motion, const Problem& problem);

/// Coefficients n = 0..H of x of a Fourier method's answer, (H+1) x Nc [m]. \throws std::bad_cast for others
Eigen::MatrixXcd coefficients_of(const Solution& solution);

/// |x - reference| / |reference| in L2(0, T) over the harmonics 0..`harmonics`; missing ones are zero.
double relative_l2(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& reference, int harmonics);

}  // namespace signorini::test
