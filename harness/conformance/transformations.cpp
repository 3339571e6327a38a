#include "harness/conformance/transformations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace signorini {

namespace {

template <class Term>
void scale(std::vector<Term>& terms, double factor) {
  for (Term& term : terms) {
    term.cos *= factor;
    term.sin *= factor;
  }
}

// cos(h w (t - s)) = cos(h w s) cos(h w t) + sin(h w s) sin(h w t), and so on.
template <class Term>
void delay(std::vector<Term>& terms, double turn) {
  for (Term& term : terms) {
    const double angle = term.harmonic * turn;
    const double cosine = term.cos, sine = term.sin;
    if (term.harmonic == 0) continue;
    term.cos = cosine * std::cos(angle) - sine * std::sin(angle);
    term.sin = cosine * std::sin(angle) + sine * std::cos(angle);
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
  scale(problem.force, factor);
  for (Contact& contact : problem.contacts) contact.gap *= factor;
  scale(problem.frame, factor);
  return problem;
}

Problem with_structure_scaled(Problem problem, double factor) {
  problem.edit_structure([&](Structure& s) {
    s.mass *= factor;
    s.damping *= factor;
    s.stiffness *= factor;
    s.speed = nullptr;  // solved at its one frequency
  });
  scale(problem.force, factor);
  for (Contact& contact : problem.contacts)
    if (auto* spring = std::get_if<Spring>(&contact.law)) spring->stiffness *= factor;
  return problem;
}

Problem with_time_scaled(Problem problem, double factor) {
  problem.edit_structure([&](Structure& s) {
    s.mass *= factor * factor;
    s.damping *= factor;
    s.speed = nullptr;
  });
  problem.frequency /= factor;
  for (ForceTerm& term : problem.force) {  // of the same force
    term.cos *= std::pow(factor, term.omega_power);
    term.sin *= std::pow(factor, term.omega_power);
  }
  return problem;
}

Problem with_load_delayed(Problem problem, double shift) {
  delay(problem.force, problem.frequency * shift);
  delay(problem.frame, problem.frequency * shift);
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
    s.speed = nullptr;
  });
  for (ForceTerm& term : result.force) term.dof = last - term.dof;
  for (FrameTerm& term : result.frame) term.dof = last - term.dof;
  for (Contact& contact : result.contacts) {
    for (auto& [dof, coefficient] : contact.normal) dof = last - dof;
  }
  return result;
}

Problem with_stops_at(Problem problem, double gap) {
  for (Contact& contact : problem.contacts) contact.gap = gap;
  return problem;
}

Eigen::VectorXd origin_before_stops(const Problem& problem, double distance) {
  const Eigen::MatrixXd W = contact_directions(problem);
  Eigen::VectorXd u_0 = Eigen::VectorXd::Zero(problem.size());
  for (const auto& normal : W.colwise()) {
    constexpr double kOrthogonal = 1e-9;
    if (std::abs(normal.dot(u_0)) <= kOrthogonal * normal.norm() * distance)
      u_0 += distance / normal.squaredNorm() * normal;
  }
  return u_0;
}

Problem with_origin_moved(Problem problem, const Eigen::VectorXd& u_0) {
  const Eigen::VectorXd shift = contact_directions(problem).transpose() * u_0;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c)
    problem.contacts[c].gap += shift[static_cast<Eigen::Index>(c)];
  const Eigen::VectorXd load = problem.stiffness() * u_0;
  for (int dof = 0; dof < problem.size(); ++dof) {
    if (load[dof] != 0.0) problem.force.push_back({.dof = dof, .harmonic = 0, .cos = load[dof], .sin = 0.0});
  }
  return problem;
}

MotionMap MotionMap::inverse() const {
  return {.displacement = 1.0 / displacement,
          .force = 1.0 / force,
          .time = 1.0 / time,
          .delay = -delay,
          .grid = grid,
          .origin = -origin / displacement};
}

Samples MappedMotion::sample(int count) const {
  // Instants of the delayed motion are instants of a finer grid: no interpolation.
  const int fine = map_.delay == 0 ? 1 : map_.grid / std::gcd(map_.grid, count * map_.delay);
  const int total = count * fine;
  const auto turn = static_cast<long>(total) * map_.delay / map_.grid % total;
  const auto first = static_cast<Eigen::Index>((total - turn) % total);
  const Samples motion = motion_->sample(total);
  Eigen::MatrixXd x = every(motion.x, first, fine) * map_.displacement;
  if (map_.origin.size() > 0) x.rowwise() += map_.origin.transpose();
  return {std::move(x), every(motion.velocity, first, fine) * (map_.displacement / map_.time),
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
