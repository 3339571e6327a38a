#pragma once
// The work that contact forces do on a motion, without a spectrum.

#include <Eigen/Core>

#include "harness/judge/measures/motion.hpp"
#include "methods/method.hpp"

namespace signorini {

/// Work of the contact forces per period on a motion that lists its events [J],
///
///     integral of lambda^T x' dt + sum over impulses p of p (x'_- + x'_+) / 2.
///
/// Where a force jumps x' vanishes, so that the sum over the samples has no floor; the speeds beside an
/// impulse are extrapolated from up to six samples without an event between, of one side alone through the
/// represented restitution where the other has none. Of a penalty law the work of its spring, a total
/// differential, is left out. Requires motion.events.
double contact_work(const Motion& motion, const RepresentedLaw& law, const Eigen::VectorXd& gaps);

}  // namespace signorini
