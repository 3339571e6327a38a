#include "harness/judge/measures/exact_motion.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "methods/flow/integrated_trajectory.hpp"
#include "methods/linear_flow/linear_flow.hpp"
#include "methods/structure/bases/condensation.hpp"
#include "methods/structure/state.hpp"

namespace signorini {

bool is_integrated(const Trajectory& motion) {
  return dynamic_cast<const IntegratedTrajectory*>(&motion) != nullptr;
}

std::optional<ExactMotion> ExactMotion::of(const Problem& problem, const Trajectory& motion) {
  const auto* integrated = dynamic_cast<const IntegratedTrajectory*>(&motion);
  // Larger structures are reduced, and their states are those of other coordinates.
  if (integrated == nullptr || problem.size() > kMostInDenseFlow) return std::nullopt;
  const std::optional<State> start = integrated->state(0.0);
  ExactMotion known(problem, *integrated);
  if (!start || start->v.size() != std::ssize(known.kept_)) return std::nullopt;
  return known;
}

ExactMotion::ExactMotion(const Problem& problem, const IntegratedTrajectory& motion)
    : motion_(&motion), contacts_(problem.contacts), kept_(condense(problem).kept) {}

Eigen::Index ExactMotion::place_of(int dof) const {
  const auto place = std::ranges::lower_bound(kept_, dof);
  return place != kept_.end() && *place == dof ? place - kept_.begin() : -1;
}

Eigen::Index ExactMotion::contact_on(int dof) const {
  const auto alone = std::ranges::find_if(contacts_, [dof](const Contact& contact) {
    return contact.normal.size() == 1 && contact.normal.front().first == dof;
  });
  return alone != contacts_.end() ? alone - contacts_.begin() : -1;
}

std::vector<SpeedsBeside> ExactMotion::speeds_beside_impulses() const {
  // The arcs of both sides are told apart beyond the rounding of an instant.
  const double aside = 8.0 * std::numeric_limits<double>::epsilon() * motion_->period();
  std::vector<SpeedsBeside> speeds;
  for (const Impulse& impulse : motion_->impulses()) {
    const State before = motion_->state(impulse.time - aside).value(),
                after = motion_->state(impulse.time + aside).value();
    double approach = 0.0, departure = 0.0;
    for (const auto& [dof, coefficient] : contacts_[static_cast<std::size_t>(impulse.contact)].normal) {
      const Eigen::Index place = place_of(dof);
      if (place < 0) return {};
      approach += coefficient * before.v[place];
      departure += coefficient * after.v[place];
    }
    speeds.push_back({approach, departure});
  }
  return speeds;
}

Eigen::MatrixXcd ExactMotion::force_coefficients(int count) const { return motion_->force_spectrum(count); }

ExactMotion::Coordinates ExactMotion::coordinates(std::span<const int> dofs, int count) const {
  const auto columns = static_cast<Eigen::Index>(dofs.size());
  Coordinates found{Eigen::MatrixXd(count, columns), Eigen::MatrixXd(count, columns)};
  std::vector<std::pair<Eigen::Index, Eigen::Index>> places;  // of columns
  std::optional<Samples> samples;                             // of the contacts, where one is asked for
  for (Eigen::Index column = 0; column < columns; ++column) {
    const int dof = dofs[static_cast<std::size_t>(column)];
    if (const Eigen::Index place = place_of(dof); place >= 0) {
      places.emplace_back(column, place);
      continue;
    }
    const Eigen::Index contact = contact_on(dof);
    const double factor = contacts_[static_cast<std::size_t>(contact)].normal.front().second;
    if (!samples) samples = motion_->sample(count);
    found.u.col(column) = samples->x.col(contact) / factor;
    found.v.col(column) = samples->velocity.col(contact) / factor;
  }
  for (int i = 0; i < count && !places.empty(); ++i) {
    const State state = motion_->state(i * (motion_->period() / count)).value();
    for (const auto& [column, place] : places) {
      found.u(i, column) = state.u[place];
      found.v(i, column) = state.v[place];
    }
  }
  return found;
}

}  // namespace signorini
