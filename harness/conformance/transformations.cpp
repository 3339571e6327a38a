#include "harness/conformance/transformations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini {

namespace {

void scale_load(Problem& problem, double factor) {
  for (ForceTerm& term : problem.force) {
    term.cos *= factor;
    term.sin *= factor;
  }
}

/// Every k-th row, beginning with row `first` of a periodic whole.
Eigen::MatrixXd every(const Eigen::MatrixXd& rows, Eigen::Index first, Eigen::Index k) {
  Eigen::MatrixXd result(rows.rows() / k, rows.cols());
  for (Eigen::Index i = 0; i < result.rows(); ++i) result.row(i) = rows.row((first + i * k) % rows.rows());
  return result;
}

}  // namespace

Problem with_load_scaled(Problem problem, double factor) {
  scale_load(problem, factor);
  for (Contact& contact : problem.contacts) contact.gap *= factor;
  return problem;
}

Problem with_structure_scaled(Problem problem, double factor) {
  problem.edit_structure([&](Structure& s) {
    s.mass *= factor;
    s.damping *= factor;
    s.stiffness *= factor;
  });
  scale_load(problem, factor);
  if (auto* stop = std::get_if<Penalty>(&problem.law)) {
    for (double& stiffness : stop->stiffness) stiffness *= factor;
  }
  return problem;
}

Problem with_time_scaled(Problem problem, double factor) {
  problem.edit_structure([&](Structure& s) {
    s.mass *= factor * factor;
    s.damping *= factor;
  });
  problem.frequency /= factor;
  return problem;
}

Problem with_load_delayed(Problem problem, double shift) {
  for (ForceTerm& term : problem.force) {
    // cos(h w (t - s)) = cos(h w s) cos(h w t) + sin(h w s) sin(h w t), and so on.
    const double angle = term.harmonic * problem.frequency * shift;
    const double cosine = term.cos, sine = term.sin;
    if (term.harmonic == 0) continue;
    term.cos = cosine * std::cos(angle) - sine * std::sin(angle);
    term.sin = cosine * std::sin(angle) + sine * std::cos(angle);
  }
  return problem;
}

Problem with_coordinates_reversed(const Problem& problem) {
  Problem result = problem;
  const int last = problem.size() - 1;
  const Eigen::PermutationMatrix<Eigen::Dynamic> reversal(Eigen::VectorXi::LinSpaced(last + 1, last, 0));
  result.edit_structure([&](Structure& s) {
    s.mass = problem.mass().twistedBy(reversal);
    s.damping = problem.damping().twistedBy(reversal);
    s.stiffness = problem.stiffness().twistedBy(reversal);
  });
  for (ForceTerm& term : result.force) term.dof = last - term.dof;
  for (Contact& contact : result.contacts) {
    for (auto& [dof, coefficient] : contact.normal) dof = last - dof;
  }
  return result;
}

Problem with_stops_at(Problem problem, double gap) {
  for (Contact& contact : problem.contacts) contact.gap = gap;
  return problem;
}

MotionMap MotionMap::inverse() const {
  return {.displacement = 1.0 / displacement,
          .force = 1.0 / force,
          .time = 1.0 / time,
          .delay = -delay,
          .grid = grid};
}

Samples MappedMotion::sample(int count) const {
  // Instants of the delayed motion are instants of a finer grid: no interpolation.
  const int fine = map_.delay == 0 ? 1 : map_.grid / std::gcd(map_.grid, count * map_.delay);
  const int total = count * fine;
  const auto turn = static_cast<long>(total) * map_.delay / map_.grid % total;
  const auto first = static_cast<Eigen::Index>((total - turn) % total);
  const Samples motion = motion_->sample(total);
  return {every(motion.x, first, fine) * map_.displacement,
          every(motion.velocity, first, fine) * (map_.displacement / map_.time),
          every(motion.force, first, fine) * map_.force};
}

std::vector<Impulse> MappedMotion::impulses() const {
  std::vector<Impulse> impulses = motion_->impulses();
  const double whole = period();
  for (Impulse& impulse : impulses) {
    const double time = impulse.time * map_.time + whole * map_.delay / map_.grid;
    impulse.time = time - whole * std::floor(time / whole);
    if (impulse.time >= whole) impulse.time = 0.0;  // a rounded remainder
    impulse.value *= map_.force * map_.time;
  }
  std::ranges::sort(impulses, [](const auto& a, const auto& b) { return a.time < b.time; });
  return impulses;
}

}  // namespace signorini
