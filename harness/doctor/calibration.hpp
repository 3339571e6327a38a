#pragma once
// How fast this machine is: the time of a fixed solve, by which times of different machines stand side by
// side. Scene and method are written out here and never change: a method of the catalogue would become
// faster one day, and every other one slower beside it (docs/decisions/0064-calibration.md).

#include <vector>

namespace signorini {

/// Which solve it is: times of different versions say nothing about machines.
inline constexpr int kCalibrationVersion = 1;

/// How often it is timed: in all a tenth of a second, in which one solve is likely to be undisturbed.
inline constexpr int kCalibrationSolves = 25;

/// Where the stop of the calibration solve is [m].
inline constexpr double kCalibrationGap = 2.0;

/// The calibration solve: 32 masses of 1 kg in a row on springs of 1 N/m, damped by 0.05 M + 0.2 K, the last
/// one driven by cos(0.1 t) N behind a rigid stop with restitution 0.8, followed from rest over 20 periods of
/// 100 steps by Moreau's midpoint rule [moreau1988], its matrix inverted anew each period. No library takes
/// part. \param gap  of the stop [m] \return displacement of the last mass after each step [m]
std::vector<double> calibration_solve(double gap = kCalibrationGap);

/// The least processor time of kCalibrationSolves calibration solves [s].
double calibration_seconds();

}  // namespace signorini
