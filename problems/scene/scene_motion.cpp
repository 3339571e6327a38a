#include <fmt/format.h>

#include <array>

#include "problems/scene/scene_system.hpp"

namespace signorini {

namespace {

// A term of a motion: harmonic, cosine and sine.
struct MotionTerm {
  int harmonic = 1;
  double cos = 0.0, sin = 0.0;
};

int read_motion_harmonic(const SceneField& term, int least) {
  const SceneField harmonic = term["harmonic"];
  return harmonic.given() ? harmonic.in_range("a whole number", least, kMostLoadHarmonic) : 1;
}

std::vector<MotionTerm> read_motion(const SceneField& terms, int least_harmonic,
                                    std::string_view requirement) {
  std::vector<MotionTerm> motion;
  for (const SceneField& term : terms.items_or_none(requirement)) {
    term.allow_only({"harmonic", "cos", "sin"}, requirement);
    motion.push_back({.harmonic = read_motion_harmonic(term, least_harmonic),
                      .cos = term["cos"].number_or(0.0, "must be a finite number"),
                      .sin = term["sin"].number_or(0.0, "must be a finite number")});
    if (motion.back().harmonic == 0 && motion.back().sin != 0.0)
      term["sin"].refuse("must be 0 or absent: at harmonic 0 a sine is nothing");
  }
  return motion;
}

// A motion of `terms` terms makes as many loads for each of `places`.
void require_few(const SceneField& field, std::size_t terms, int places) {
  if (static_cast<double>(terms) * places > kMostLoads)
    field.refuse(fmt::format("{} terms for {} contacts or coordinates", terms, places),
                 fmt::format("must make at most {:g} loads", kMostLoads));
}

// x and y of the centre of a ring.
std::array<double, 2> read_place(const SceneField& field) {
  if (!field.given()) return {0.0, 0.0};
  constexpr std::string_view kPlace = "must be a pair of numbers, along the two coordinates of the ring [m]";
  const std::vector<SceneField> pair = field.items(kPlace, 2);
  return {pair[0].number(kPlace), pair[1].number(kPlace)};
}

// The stops of one table, contacts first..last - 1.
void read_gap_terms(const SceneField& contact, int first, int last, std::vector<StopTerm>& stops) {
  const std::vector<MotionTerm> motion = read_motion(
      contact["gap_term"], 1,
      "must be a list of tables { harmonic = .., cos = .., sin = .. }, the motion of the stop [m]");
  require_few(contact["gap_term"], motion.size(), last - first);
  for (const MotionTerm& term : motion) {
    for (int j = first; j < last; ++j)
      stops.push_back({.contact = j, .harmonic = term.harmonic, .cos = term.cos, .sin = term.sin});
  }
}

void read_centre_terms(const SceneField& contact, const FromTables<Contact>& made, int first, int last,
                       std::vector<StopTerm>& stops) {
  const SceneField terms = contact["centre_term"];
  if (!terms.given()) return;
  constexpr std::string_view kTerms =
      "must be a list of tables { harmonic = .., cos = [x, y], sin = [x, y] }, the motion of the ring's "
      "centre";
  if (!contact["facets"].given()) terms.refuse("must be absent: only a ring of facets has a centre");
  const std::vector<SceneField> items = terms.items(kTerms);
  require_few(terms, items.size(), last - first);
  for (const SceneField& term : items) {
    term.allow_only({"harmonic", "cos", "sin"}, kTerms);
    const int harmonic = read_motion_harmonic(term, 1);
    const auto cos = read_place(term["cos"]), sin = read_place(term["sin"]);
    for (int j = first; j < last; ++j) {
      const auto& normal = made.things[static_cast<std::size_t>(j)].normal;
      const double along = normal[0].second, across = normal[1].second;
      stops.push_back({.contact = j,
                       .harmonic = harmonic,
                       .cos = along * cos[0] + across * cos[1],
                       .sin = along * sin[0] + across * sin[1]});
    }
  }
}

// What the coordinates of a kind do when its base moves by one along its axis, where that is clear.
Eigen::VectorXd usual_direction(const SceneField& direction, const SystemDescription& system) {
  Eigen::VectorXd d = Eigen::VectorXd::Ones(system.size);
  if (system.kind == "beam") {
    for (int rotation = 1; rotation < system.size; rotation += 2) d[rotation] = 0.0;
  } else if (system.kind != "sdof" && system.kind != "chain" && system.kind != "bar") {
    direction.refuse(
        fmt::format("is required of a {}: what its coordinates do when the base moves by 1", system.kind));
  }
  return d;
}

Eigen::VectorXd read_base_direction(const SceneField& direction, const SystemDescription& system) {
  if (!direction.given()) return usual_direction(direction, system);
  Eigen::VectorXd d = Eigen::VectorXd::Zero(system.size);
  if (system.kind == "block" || system.kind == "mesh") {
    for (int dof = read_axis(direction); dof < system.size; dof += 3) d[dof] = 1.0;
    return d;
  }
  constexpr std::string_view kPairs = "must be a list of pairs [dof, displacement]";
  for (const SceneField& entry : direction.items(kPairs)) {
    const std::vector<SceneField> pair = entry.items(kPairs, 2);
    d[read_dof(pair[0], system.size)] += pair[1].number("must be a finite number");
  }
  return d;
}

// What a support that is held pulls along through M went with it: the base's acceleration would act without.
void require_inertia(const SceneField& base, const SystemDescription& system, const SparseMatrix& mass) {
  if (system.held.empty()) return;
  bool couples = false;
  for_each_entry(
      mass, [&](int row, int column, double value) { couples = couples || (row != column && value != 0.0); });
  if (couples)
    base.refuse(
        "a motion",
        fmt::format("must be left out where the mass matrix is not diagonal beside a support by penalty: "
                    "leave coordinate {} out, or support it less stiffly",
                    system.held.front()));
}

}  // namespace

std::vector<StopTerm> read_stop_motion(const SceneField& contacts, const FromTables<Contact>& made) {
  std::vector<StopTerm> stops;
  int last = 0;
  const int count = static_cast<int>(made.tables.size());
  while (last < count) {
    const int first = last, table = made.tables[static_cast<std::size_t>(first)];
    while (last < count && made.tables[static_cast<std::size_t>(last)] == table) ++last;
    const SceneField contact = contacts.at(fmt::format("[{}]", table));
    read_gap_terms(contact, first, last, stops);
    read_centre_terms(contact, made, first, last, stops);
  }
  return stops;
}

void read_base(const SceneField& base, const SystemDescription& system, Problem& problem) {
  if (!base.given()) return;
  base.allow_only({"direction", "displacement", "acceleration"}, "must be a table");
  if (!base.has_any({"displacement", "acceleration"})) base.refuse("must hold displacement or acceleration");
  std::vector<BaseTerm> terms;
  for (const bool acceleration : {false, true}) {
    for (const MotionTerm& term :
         read_motion(base[acceleration ? "acceleration" : "displacement"], acceleration ? 0 : 1,
                     "must be a list of tables { harmonic = .., cos = .., sin = .. }"))
      terms.push_back(
          {.harmonic = term.harmonic, .cos = term.cos, .sin = term.sin, .acceleration = acceleration});
  }
  require_few(base, terms.size(), system.size);
  require_inertia(base, system, problem.mass());
  move_base(problem, read_base_direction(base["direction"], system), terms);
}

}  // namespace signorini
