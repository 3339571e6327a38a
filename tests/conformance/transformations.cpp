#include "tests/conformance/transformations.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace signorini::test {

namespace {

void scale_load(Problem& problem, double factor) {
  for (ForceTerm& term : problem.force) {
    term.cos *= factor;
    term.sin *= factor;
  }
}

SparseMatrix reversed(const SparseMatrix& matrix) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto last_row = static_cast<int>(matrix.rows()) - 1, last_col = static_cast<int>(matrix.cols()) - 1;
  for (int k = 0; k < matrix.outerSize(); ++k) {
    for (SparseMatrix::InnerIterator it(matrix, k); it; ++it) {
      entries.emplace_back(last_row - static_cast<int>(it.row()), last_col - static_cast<int>(it.col()),
                           it.value());
    }
  }
  SparseMatrix result(matrix.rows(), matrix.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::MatrixXd rolled(const Eigen::MatrixXd& rows, Eigen::Index by) {
  Eigen::MatrixXd result(rows.rows(), rows.cols());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) result.row((i + by) % rows.rows()) = rows.row(i);
  return result;
}

}  // namespace

Problem with_load_scaled(Problem problem, double factor) {
  scale_load(problem, factor);
  for (Contact& contact : problem.contacts) contact.gap *= factor;
  return problem;
}

Problem with_structure_scaled(Problem problem, double factor) {
  problem.mass *= factor;
  problem.damping *= factor;
  problem.stiffness *= factor;
  scale_load(problem, factor);
  if (auto* stop = std::get_if<Penalty>(&problem.law)) {
    for (double& stiffness : stop->stiffness) stiffness *= factor;
  }
  return problem;
}

Problem with_time_scaled(Problem problem, double factor) {
  problem.mass *= factor * factor;
  problem.damping *= factor;
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
  result.mass = reversed(problem.mass);
  result.damping = reversed(problem.damping);
  result.stiffness = reversed(problem.stiffness);
  for (ForceTerm& term : result.force) term.dof = last - term.dof;
  for (Contact& contact : result.contacts) {
    for (auto& [dof, coefficient] : contact.normal) dof = last - dof;
  }
  return result;
}

Samples DelayedTrajectory::sample(int count) const {
  if (count * steps_ % grid_ == 0) {
    const int by = ((count * steps_ / grid_) % count + count) % count;
    const Samples samples = motion_->sample(count);
    return {rolled(samples.x, by), rolled(samples.velocity, by), rolled(samples.force, by)};
  }
  throw std::invalid_argument("count does not meet the grid of the delay");
}

std::vector<Impulse> DelayedTrajectory::impulses() const {
  std::vector<Impulse> impulses = motion_->impulses();
  for (Impulse& impulse : impulses) {
    const double time = impulse.time + steps_ * period() / grid_;
    impulse.time = time - period() * std::floor(time / period());
  }
  std::sort(impulses.begin(), impulses.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return impulses;
}

}  // namespace signorini::test
