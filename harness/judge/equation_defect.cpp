#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <variant>

#include "harness/judge/certificate.hpp"
#include "harness/judge/measures/contact_response.hpp"
#include "harness/judge/measures/impacts.hpp"
#include "methods/structure/dynamic_stiffness.hpp"

namespace signorini {

namespace {

double root_mean_square(const Eigen::MatrixXd& values) { return std::sqrt(values.array().square().mean()); }

double fluctuating(const Eigen::MatrixXd& values) {
  return root_mean_square(values.rowwise() - values.colwise().mean());
}

double motion_defect(const Problem& problem, const Motion& answer, const ContactSpace* space) {
  constexpr double kForceError = 0.1;
  const double size = std::max(fluctuating(answer.samples.x), answer.least);
  if (!(size > 0.0)) return 0.0;
  try {
    const ContactResponse response(problem, force_series(problem, answer, kMeasuredHarmonics), space);
    const Eigen::MatrixXd r = response.displacement(answer.count());
    const Eigen::MatrixXd free = response.free_displacement(answer.count());
    Eigen::MatrixXd difference = answer.samples.x - r;
    if (response.mean_is_free()) {
      const Eigen::VectorXd mean = difference.colwise().mean().transpose();
      difference.rowwise() -=
          (contact_directions(problem).transpose() * rigid_offset(problem, mean)).transpose();
    }
    const double off = root_mean_square(difference);
    const double explained = kForceError * (root_mean_square(r - free) + fluctuating(free));
    return std::max(0.0, off - explained) / size;
  } catch (const std::bad_alloc&) {
    throw;  // the child's memory limit is told apart
  } catch (const std::exception&) {
    return 0.0;  // no unique response
  }
}

/// Over which an answer may be late or early [s].
double shown_in(const Motion& answer) {
  constexpr double kMost = 0.05;  // of the forcing period
  double resolution = time_resolution(answer);
  if (answer.nodes) resolution = std::max(resolution, answer.period() / *answer.nodes);
  return std::min(resolution, kMost * answer.forcing_period);
}

double penetration_defect(const Problem& problem, const Motion& answer) {
  constexpr double kLate = 2.0;  // resolutions
  const double scale = std::max(amplitude(answer), answer.least);
  if (!(scale > 0.0) || (has_springs(problem) && !has_impacts(problem) && !answer.impulses.empty()))
    return 0.0;
  const Eigen::VectorXd gaps = contact_gaps(problem);
  const double explained_steps = kLate * shown_in(answer) / answer.step();
  const Eigen::Index last = answer.samples.x.rows() - 1;
  double largest = 0.0;
  for (Eigen::Index c = 0; c < gaps.size(); ++c) {
    const Eigen::ArrayXd x = answer.samples.x.col(c);
    Eigen::ArrayXd depth = x - gaps[c];
    if (const auto* spring = std::get_if<Spring>(&problem.contacts[static_cast<std::size_t>(c)].law))
      depth += answer.samples.force.col(c).array() / spring->stiffness;
    const double step = last > 0 ? (x.tail(last) - x.head(last)).abs().maxCoeff() : 0.0;
    largest = std::max(largest, depth.maxCoeff() - explained_steps * step);
  }
  return largest / scale;
}

}  // namespace

EquationDefect equation_defect(const Problem& problem, const Motion& answer, KeptSpace& spaces) {
  if (answer.samples.x.size() == 0) return {};
  const std::shared_ptr<const ContactSpace> space =
      problem.size() > kMostFactorised ? spaces.of(problem) : nullptr;
  return {.motion = motion_defect(problem, answer, space.get()),
          .penetration = penetration_defect(problem, answer)};
}

}  // namespace signorini
