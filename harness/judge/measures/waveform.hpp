#pragma once
// Motions as they are drawn: the few points of a polyline that looks like the motion.

#include "harness/judge/measures/motion.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// Contacts of a motion that are kept at most.
inline constexpr int kDrawnContacts = 4;

/// The instants of a polyline that stays within `tolerance` of every signal's range: row i of `signals` is
/// instant i. First and last row are kept. By the algorithm of Douglas and Peucker [douglas1973].
/// \param signals  instants x signals, at least two instants
std::vector<int> polyline(const Eigen::MatrixXd& signals, double tolerance);

/// Distance of a motion's polyline from its signals as records keep it, share of each range.
inline constexpr double kKeptTolerance = 0.002;

/// An answer and, unless null, the certified orbit behind it, over the least period common to both, at the
/// contacts that exchange most impulse. \param tolerance  of the polylines, share of each signal's range
Waveforms draw_waveforms(const Motion& answer, const Motion* orbit, double tolerance = kKeptTolerance);

}  // namespace signorini
