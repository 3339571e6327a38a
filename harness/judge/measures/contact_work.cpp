#include "harness/judge/measures/contact_work.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

#include "harness/judge/measures/impacts.hpp"

namespace signorini {

namespace {

/// (x'_- + x'_+) / 2 at an impulse; of one side where the other cannot be told, 0 where neither can.
double mean_speed(const SpeedsBeside& speeds, double restitution) {
  const auto& [before, after] = speeds;
  if (before && after) return 0.5 * (*before + *after);
  if (before) return 0.5 * (1.0 - restitution) * *before;
  if (after && restitution > 0.0) return 0.5 * (1.0 - 1.0 / restitution) * *after;
  return 0.0;
}

}  // namespace

double contact_work(const Motion& motion, const RepresentedLaw& law, const Eigen::VectorXd& gaps) {
  Eigen::ArrayXXd force = motion.samples.force.array();
  for (Eigen::Index c = 0; c < force.cols(); ++c) {
    const ContactLaw own = law_of_contact(law, static_cast<int>(c));
    if (const auto* spring = std::get_if<Spring>(&own))
      force.col(c) += spring->stiffness * (motion.samples.x.col(c).array() - gaps[c]).max(0.0);
  }
  double work = motion.step() * (force * motion.samples.velocity.array()).sum();
  const std::vector<SpeedsBeside> speeds = speeds_beside_impulses(motion);
  for (std::size_t i = 0; i < speeds.size(); ++i)
    work += motion.impulses[i].value *
            mean_speed(speeds[i], restitution_of(law_of_contact(law, motion.impulses[i].contact)));
  return work;
}

}  // namespace signorini
