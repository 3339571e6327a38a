#include "problems/admissible_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

namespace {

constexpr double kRoundingOfSum = 1e-12;  // of the largest term of a sum
constexpr double kNearer = 1e-6;  // of the largest gap: stops that meet are found by moving them together
constexpr int kMostRows = 200;    // of a group that is decided by least squares
constexpr std::size_t kMostStops = 3000;

using Normal = std::vector<std::pair<int, double>>;
using Stops = std::vector<int>;  // contacts, by their number

// How far the stops along one line let the structure go, d^T u between `least` and `most`.
struct Room {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  int least_by = 0, most_by = 0;  // contacts
};

std::vector<Contact> chosen(const std::vector<Contact>& contacts, const Stops& stops) {
  std::vector<Contact> result;
  for (const int stop : stops) result.push_back(contacts[static_cast<std::size_t>(stop)]);
  return result;
}

bool leaves_room_about_zero(const std::vector<Contact>& contacts) {
  return std::ranges::all_of(contacts, [](const Contact& contact) { return contact.gap > 0.0; });
}

Normal nonzero(const Contact& contact) {
  Normal normal = contact.normal;
  std::erase_if(normal, [](const auto& entry) { return entry.second == 0.0; });
  std::ranges::sort(normal);
  return normal;
}

// A normal w = a d with the first nonzero coefficient of d one: a, and d as text that is equal for parallel
// normals, whatever their last digits.
std::pair<double, std::string> line_of(const Contact& contact) {
  const Normal normal = nonzero(contact);
  const double first = normal.front().second;
  std::string direction;
  for (const auto& [dof, coefficient] : normal)
    direction += fmt::format("{}:{:.12g} ", dof, coefficient / first);
  return {first, direction};
}

using Rooms = std::map<std::string, Room>;

// Adds the stops to the rooms of their lines, up to the first that leaves none.
std::optional<StopConflict> conflict_along_a_line(const std::vector<Contact>& contacts, Rooms& rooms) {
  for (int j = 0; j < std::ssize(contacts); ++j) {
    const Contact& contact = contacts[static_cast<std::size_t>(j)];
    const auto [factor, line] = line_of(contact);
    const double bound = contact.gap / factor;
    Room& room = rooms[line];
    if (factor > 0.0 && bound < room.most) room.most = bound, room.most_by = j;
    if (factor < 0.0 && bound > room.least) room.least = bound, room.least_by = j;
    const double rounding = kRoundingOfSum * std::max(std::abs(room.least), std::abs(room.most));
    if (!std::isfinite(rounding) || room.most - room.least > rounding) continue;
    return StopConflict{.contact = j,
                        .key = "gap",
                        .found = contact.gap,
                        .requirement = fmt::format(
                            "must leave room: contact {} holds its coordinate at {:g} or less, contact "
                            "{} at {:g} or more",
                            room.most_by, room.most, room.least_by, room.least)};
  }
  return std::nullopt;
}

// The nearest stops of every line, at most one on each side.
Stops nearest_stops(const Rooms& rooms) {
  Stops nearest;
  for (const auto& [line, room] : rooms) {
    if (std::isfinite(room.most)) nearest.push_back(room.most_by);
    if (std::isfinite(room.least)) nearest.push_back(room.least_by);
  }
  return nearest;
}

/// Stops and the coordinates that they hold.
class StopGraph {
 public:
  StopGraph(const std::vector<Contact>& contacts, const Stops& stops) {
    for (const int stop : stops) {
      normals_[stop] = nonzero(contacts[static_cast<std::size_t>(stop)]);
      for (const auto& [dof, coefficient] : normals_[stop]) {
        coordinates_[dof].stops.push_back(stop);
        ++coordinates_[dof].on_side(coefficient);
      }
    }
  }

  /// Sets aside the stops at a coordinate that is held on one side only, until there is none: far enough on
  /// the other side it satisfies them, wherever the rest of the structure is.
  void retreat() {
    std::vector<int> open;
    for (const auto& [dof, held] : coordinates_) open.push_back(dof);
    while (!open.empty()) {
      const Coordinate& held = coordinates_[open.back()];
      open.pop_back();
      if (held.above > 0 && held.below > 0) continue;
      for (const int stop : held.stops) {
        const auto found = normals_.find(stop);
        if (found == normals_.end()) continue;
        for (const auto& [dof, coefficient] : found->second) {
          if (--coordinates_[dof].on_side(coefficient) == 0) open.push_back(dof);
        }
        normals_.erase(found);
      }
    }
  }

  /// What is left, rising.
  [[nodiscard]] Stops left() const {
    Stops stops;
    for (const auto& [stop, normal] : normals_) stops.push_back(stop);
    return stops;
  }

 private:
  struct Coordinate {
    Stops stops = {};          // all that ever held it
    int above = 0, below = 0;  // how many still do, on each side
    int& on_side(double coefficient) { return coefficient > 0.0 ? above : below; }
  };

  std::map<int, Normal> normals_;  // of the stops that are left
  std::map<int, Coordinate> coordinates_;
};

// u >= 0 that minimises |E u - f|, the algorithm NNLS of [lawson1995], ch. 23. Columns of E and f are of size
// one.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& E, const Eigen::VectorXd& f) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(E.cols());
  std::vector<Eigen::Index> passive;  // entries that may be positive
  // Each round ends at a lower residual, so that no set of passive entries comes again; rounding may break
  // that.
  for (Eigen::Index round = 0; round < 3 * E.cols() + 10; ++round) {
    Eigen::VectorXd slope = E.transpose() * (f - E * u);
    for (const Eigen::Index j : passive) slope[j] = 0.0;
    Eigen::Index steepest = 0;
    if (slope.maxCoeff(&steepest) <= kRoundingOfSum) break;
    passive.push_back(steepest);
    while (true) {
      const Eigen::VectorXd z = pivoted_least_squares(E(Eigen::all, passive), f);
      const Eigen::VectorXd from = u(passive);
      double step = 1.0;
      Eigen::Index first = -1;  // entry to reach zero on the way from u to z
      for (Eigen::Index p = 0; p < z.size(); ++p) {
        if (z[p] >= 0.0 || from[p] / (from[p] - z[p]) >= step) continue;
        step = from[p] / (from[p] - z[p]);
        first = p;
      }
      u(passive) = (from + step * (z - from)).cwiseMax(0.0);
      if (first < 0) break;
      if (step == 0.0 && passive[static_cast<std::size_t>(first)] == steepest)
        return u;  // a slope of rounding
      u[passive[static_cast<std::size_t>(first)]] = 0.0;
      passive.erase(passive.begin() + first);
    }
  }
  return u;
}

/// The stops of a group in units of their normals' lengths, of the coordinates' largest coefficients and of
/// the largest gap.
struct GroupEquations {
  Eigen::MatrixXd W;  // coordinates x stops
  Eigen::VectorXd g;  // stops

  GroupEquations(const std::vector<Contact>& group, const std::vector<int>& dofs)
      : W(Eigen::MatrixXd::Zero(std::ssize(dofs), std::ssize(group))), g(std::ssize(group)) {
    for (Eigen::Index j = 0; j < g.size(); ++j) {
      const Contact& contact = group[static_cast<std::size_t>(j)];
      for (const auto& [dof, coefficient] : nonzero(contact))
        W(std::ranges::lower_bound(dofs, dof) - dofs.begin(), j) = coefficient;
      g[j] = contact.gap;
    }
    for (Eigen::Index i = 0; i < W.rows(); ++i) W.row(i) /= W.row(i).cwiseAbs().maxCoeff();
    for (Eigen::Index j = 0; j < g.size(); ++j) {
      g[j] /= W.col(j).norm();
      W.col(j).normalize();
    }
    if (const double largest = g.cwiseAbs().maxCoeff(); largest > 0.0) g /= largest;
  }

  /// y with W y = 0 and g^T y <= 0 where stops that stand nearer by `margin` exclude each other and these do;
  /// empty otherwise. u >= 0 that makes W u = 0 and g^T u = -1 is one, and where there is none the residual
  /// of these equations is, up to its length, a displacement that satisfies all stops.
  [[nodiscard]] Eigen::VectorXd certificate(double margin) const {
    Eigen::MatrixXd E(W.rows() + 1, W.cols());
    E << W, (g.array() - margin).matrix().transpose();
    const Eigen::VectorXd y = nonnegative_least_squares(E, -Eigen::VectorXd::Unit(E.rows(), W.rows()));
    const double forces = (W.cwiseAbs() * y).maxCoeff();
    const bool balanced = forces > 0.0 && (W * y).cwiseAbs().maxCoeff() <= kRoundingOfSum * forces;
    const bool crossed = g.dot(y) <= kRoundingOfSum * g.cwiseAbs().dot(y);
    return balanced && crossed ? y : Eigen::VectorXd();
  }
};

// The stops of a group that exclude each other, by their places in it; none where it leaves room or is too
// large.
Stops contradiction(const std::vector<Contact>& stops) {
  if (leaves_room_about_zero(stops) || stops.size() > kMostStops) return {};
  const std::vector<int> dofs = contact_coordinates(stops);
  if (std::ssize(dofs) > kMostRows) return {};
  const GroupEquations equations(stops, dofs);
  for (const double margin : {0.0, kNearer}) {
    const Eigen::VectorXd y = equations.certificate(margin);
    Stops found;
    for (Eigen::Index j = 0; j < y.size(); ++j) {
      if (y[j] > 0.0) found.push_back(static_cast<int>(j));
    }
    if (!found.empty()) return found;
  }
  return {};
}

// "0, 1 and 2".
std::string listed(const Stops& stops) {
  constexpr std::size_t kShown = 8;
  if (stops.size() > kShown)
    return fmt::format("{} and {} more", fmt::join(stops.begin(), stops.begin() + kShown, ", "),
                       stops.size() - kShown);
  return fmt::format("{} and {}", fmt::join(stops.begin(), stops.end() - 1, ", "), stops.back());
}

// Whether two bounds along one line are the same.
bool meet(double a, double b) {
  return std::abs(a - b) <= kRoundingOfSum * std::max(std::abs(a), std::abs(b));
}

bool have_one_restitution(const std::vector<Contact>& contacts) {
  const Restitution* first = nullptr;
  return std::ranges::all_of(contacts, [&](const Contact& contact) {
    const auto* law = std::get_if<Restitution>(&contact.law);
    if (first == nullptr) first = law;
    return law == nullptr || *law == *first;
  });
}

}  // namespace

std::optional<StopConflict> restitution_conflict(const std::vector<Contact>& contacts) {
  if (have_one_restitution(contacts)) return std::nullopt;
  struct Stop {
    int contact = 0;
    double bound = 0.0, e = 1.0;
  };
  std::map<std::pair<std::string, bool>, std::vector<Stop>> sides;  // of lines; their nearest stops
  for (int j = 0; j < std::ssize(contacts); ++j) {
    const Contact& contact = contacts[static_cast<std::size_t>(j)];
    const auto* law = std::get_if<Restitution>(&contact.law);
    if (law == nullptr) continue;
    const auto [factor, line] = line_of(contact);
    const Stop stop{.contact = j, .bound = contact.gap / std::abs(factor), .e = law->e};
    std::vector<Stop>& nearest = sides[{line, factor > 0.0}];
    if (!nearest.empty() && !meet(stop.bound, nearest.front().bound)) {
      if (stop.bound > nearest.front().bound) continue;
      nearest.clear();
    }
    nearest.push_back(stop);
  }
  for (const auto& [side, stops] : sides) {
    const Stop& first = stops.front();
    const auto rival = std::ranges::find_if(stops, [&](const Stop& stop) { return stop.e != first.e; });
    if (rival == stops.end()) continue;
    return StopConflict{
        .contact = rival->contact,
        .key = "restitution",
        .found = rival->e,
        .requirement = fmt::format(
            "must be {:g} as contact {} has it, or its gap another one: contacts {} and {} stop the "
            "same motion at the same place, and Newton's law of impact takes one restitution",
            first.e, first.contact, first.contact, rival->contact)};
  }
  return std::nullopt;
}

std::optional<StopConflict> stop_conflict(std::vector<Contact> contacts) {
  // A spring gives way: far from its stop, on a coordinate of its own, it excludes nothing.
  int own = std::numeric_limits<int>::max();
  for (Contact& contact : contacts)
    if (std::holds_alternative<Spring>(contact.law)) contact = {.normal = {{own--, 1.0}}, .gap = 1.0};
  if (leaves_room_about_zero(contacts)) return {};
  Rooms rooms;
  if (auto conflict = conflict_along_a_line(contacts, rooms)) return conflict;
  StopGraph graph(contacts, nearest_stops(rooms));
  graph.retreat();
  const Stops left = graph.left();
  const std::vector<Contact> of_left = chosen(contacts, left);
  for (const Stops& group : contact_groups(of_left)) {
    Stops stops = contradiction(chosen(of_left, group));
    if (stops.empty()) continue;
    for (int& stop : stops) stop = left[static_cast<std::size_t>(group[static_cast<std::size_t>(stop)])];
    return StopConflict{
        .contact = stops.back(),
        .key = "gap",
        .found = contacts[static_cast<std::size_t>(stops.back())].gap,
        .requirement = fmt::format("must leave room: contacts {} exclude each other", listed(stops))};
  }
  return std::nullopt;
}

}  // namespace signorini
