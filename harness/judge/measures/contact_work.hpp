#pragma once
// The work that contact forces do on a motion, without a spectrum.

#include <Eigen/Core>

#include "harness/judge/measures/motion.hpp"
#include "methods/method.hpp"

namespace signorini {

/// Work of the contact forces per period on a motion that is integrated from event to event [J],
///
///     integral of lambda^T x' dt + sum over impulses p of p (x'_- + x'_+) / 2.
///
/// Where a force jumps x' vanishes, so that the sum over the samples has no floor; the speeds beside an
/// impulse are `speeds_beside_impulses`, that of one side through the represented restitution where it has
/// none. Of a penalty law the work of its spring, a total differential, is left out. It says nothing of a
/// force that is not that of the motion: requires motion.integrated.
double contact_work(const Motion& motion, const RepresentedLaw& law, const Eigen::VectorXd& gaps);

}  // namespace signorini
