#include "problems/moving_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/validation.hpp"

namespace signorini {

namespace {

// Dense arrays of one group of stops have at most so many entries.
constexpr std::size_t kMostEntries = 4'000'000;

// gamma at each harmonic, of the contacts whose stop moves: cosine and sine.
using StopMotion = std::map<int, Eigen::RowVector2d>;
using StopMotions = std::map<int, StopMotion>;

StopMotions by_harmonic(const std::vector<StopTerm>& terms) {
  StopMotions motions;
  for (const StopTerm& term : terms) {
    if (term.cos == 0.0 && term.sin == 0.0) continue;
    const auto [entry, fresh] = motions[term.harmonic].try_emplace(term.contact, Eigen::RowVector2d::Zero());
    entry->second += Eigen::RowVector2d(term.cos, term.sin);
  }
  return motions;
}

// Each harmonic is a load on all coordinates.
void require_few_harmonics(const StopMotions& motions, const Problem& problem) {
  if (static_cast<double>(motions.size()) * problem.size() <= kMostLoads) return;
  throw InvalidProblem(
      fmt::format("contact[{}].gap_term", motions.begin()->second.begin()->first),
      fmt::format("one of {} harmonics", motions.size()),
      fmt::format("harmonics of moving stops times coordinates must be at most {:g}", kMostLoads));
}

// The directions of some contacts on the coordinates they touch.
struct Group {
  Group(const Problem& problem, std::vector<int> members) : contacts(std::move(members)) {
    std::vector<Contact> stops;
    for (const int j : contacts) stops.push_back(problem.contacts[static_cast<std::size_t>(j)]);
    dofs = contact_coordinates(stops);
    if (contacts.size() * dofs.size() > kMostEntries) {
      throw InvalidProblem(
          fmt::format("contact[{}].gap", contacts.front()), fmt::format("one of {} stops", contacts.size()),
          fmt::format("moving stops that share coordinates must be fewer: stops times coordinates at most {}",
                      kMostEntries));
    }
    directions = Eigen::MatrixXd::Zero(std::ssize(contacts), std::ssize(dofs));
    for (std::size_t row = 0; row < stops.size(); ++row) {
      for (const auto& [dof, coefficient] : stops[row].normal) {
        const auto place = std::ranges::lower_bound(dofs, dof) - dofs.begin();
        if (coefficient != 0.0) directions(static_cast<Eigen::Index>(row), place) = coefficient;
      }
    }
  }

  std::vector<int> contacts;
  std::vector<int> dofs;
  Eigen::MatrixXd directions;  // W^T, contacts x dofs
};

// r on the coordinates of a group, of least norm.
Eigen::MatrixX2d carried(const Group& group, const StopMotion& motion) {
  constexpr double kRounding = 1e-9;  // of the largest motion
  Eigen::MatrixX2d asked = Eigen::MatrixX2d::Zero(std::ssize(group.contacts), 2);
  for (std::size_t row = 0; row < group.contacts.size(); ++row) {
    const auto moves = motion.find(group.contacts[row]);
    if (moves != motion.end()) asked.row(static_cast<Eigen::Index>(row)) = moves->second;
  }
  Eigen::MatrixX2d r = least_norm_solve(group.directions, Eigen::MatrixXd(asked));
  const Eigen::VectorXd missed = (group.directions * r - asked).rowwise().lpNorm<Eigen::Infinity>();
  Eigen::Index worst = 0;
  if (missed.maxCoeff(&worst) > kRounding * asked.lpNorm<Eigen::Infinity>()) {
    throw InvalidProblem(fmt::format("contact[{}].gap_term", group.contacts[static_cast<std::size_t>(worst)]),
                         "a motion of its own",
                         "stops on the same coordinates must move as one body: none may approach another");
  }
  constexpr double kNothing = 1e-15;  // of the largest motion: rounding of the decomposition
  const double least = kNothing * r.lpNorm<Eigen::Infinity>();
  return r.unaryExpr([least](double value) { return std::abs(value) <= least ? 0.0 : value; });
}

// Adds amplitudes of cosine and sine as loads.
void add_load(Problem& problem, int harmonic, int power, const Eigen::MatrixX2d& load) {
  for (int dof = 0; dof < problem.size(); ++dof) {
    if (load(dof, 0) == 0.0 && load(dof, 1) == 0.0) continue;
    problem.force.push_back(
        {.dof = dof, .harmonic = harmonic, .cos = load(dof, 0), .sin = load(dof, 1), .omega_power = power});
  }
}

}  // namespace

void move_stops(Problem& problem, const std::vector<StopTerm>& terms) {
  const StopMotions motions = by_harmonic(terms);
  if (motions.empty()) return;
  require_few_harmonics(motions, problem);
  std::vector<Group> groups;
  for (std::vector<int>& members : contact_groups(problem.contacts)) {
    const auto moves = [&](int j) {
      return std::ranges::any_of(motions, [&](const auto& entry) { return entry.second.contains(j); });
    };
    if (std::ranges::any_of(members, moves)) groups.emplace_back(problem, std::move(members));
  }
  for (const auto& [harmonic, motion] : motions) {
    Eigen::MatrixX2d r = Eigen::MatrixX2d::Zero(problem.size(), 2);
    for (const Group& group : groups) r(group.dofs, Eigen::all) = carried(group, motion);
    for (int dof = 0; dof < problem.size(); ++dof) {
      if (r(dof, 0) != 0.0 || r(dof, 1) != 0.0)
        problem.frame.push_back({.dof = dof, .harmonic = harmonic, .cos = r(dof, 0), .sin = r(dof, 1)});
    }
    // r' = h omega (r_s cos - r_c sin)
    const double h = harmonic;
    Eigen::MatrixX2d rate(r.rows(), 2);
    rate << h * r.col(1), -h * r.col(0);
    Eigen::MatrixX2d of_springs = problem.stiffness() * r, of_dampers = problem.damping() * rate;
    Eigen::MatrixX2d of_inertia = -h * h * (problem.mass() * r);
    if (const SpeedTerms* speed = problem.structure->speed.get()) {
      of_springs = speed->stiffness * r;
      of_dampers = speed->damping * rate + speed->circulatory * r;
      of_inertia += speed->gyroscopic * rate;
    }
    add_load(problem, harmonic, 0, -of_springs);
    add_load(problem, harmonic, 1, -of_dampers);
    add_load(problem, harmonic, 2, -of_inertia);
  }
}

void move_base(Problem& problem, const Eigen::VectorXd& direction, const std::vector<BaseTerm>& terms) {
  const Eigen::VectorXd momentum = problem.mass() * direction;
  for (const BaseTerm& term : terms) {
    const double h = term.harmonic;
    const double factor = term.acceleration ? -1.0 : h * h;
    Eigen::MatrixX2d load(problem.size(), 2);
    load << factor * term.cos * momentum, factor * term.sin * momentum;
    add_load(problem, term.harmonic, term.acceleration ? 0 : 2, load);
  }
}

}  // namespace signorini
