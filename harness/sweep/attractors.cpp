#include "harness/sweep/attractors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/interrupt.hpp"
#include "harness/isolation/isolation.hpp"
#include "harness/motion/followed_scene.hpp"
#include "harness/orbits/listed_motion.hpp"
#include "harness/orbits/orbit_candidate.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/plan/plan.hpp"
#include "harness/records/record_json.hpp"
#include "harness/sweep/frequency_response.hpp"
#include "harness/text/json.hpp"

namespace signorini {

using Json = nlohmann::ordered_json;

void visit_fields(Either<Attractor> auto& one, auto&& field) {
  field(required("verdict"), one.verdict);
  field(required("order"), one.order);
  field(required("starts"), one.starts);
  field(required("share"), one.share);
  field(required("from_rest"), one.from_rest);
  field(required("x_min", "m"), one.least);
  field(required("x_max", "m"), one.largest);
  field(required("once_a_period", "m"), one.once_a_period);
  field(required("events"), one.events);
  field(required("pushing"), one.pushing);
  field(required("reason"), one.reason);
  field(Field{"on_branch"}, one.on_branch);
}

void visit_fields(Either<AttractorsAt> auto& at, auto&& field) {
  field(required("value"), at.value);
  field(required("starts"), at.starts);
  field(required("failure"), at.failure);
  field(required("attractors"), at.attractors);
}

namespace {

constexpr std::size_t kDrawn = 300;  // instants of a motion that does not repeat
constexpr int kPushing = 64;         // instants of a period at which a contact that pushes throughout does
constexpr double kSame = 1e-5;       // of the largest extreme: what a motion that settles slowly is off

std::size_t most_moved(const Attractor& attractor) {
  std::size_t most = 0;
  const auto width = [&](std::size_t j) { return attractor.largest[j] - attractor.least[j]; };
  for (std::size_t j = 1; j < attractor.least.size(); ++j)
    if (width(j) > width(most)) most = j;
  return most;
}

/// x of one contact at t = 0 of forcing periods.
std::vector<double> once_a_period(const LongMotion& motion, std::size_t contact) {
  std::vector<double> x;
  if (motion.trajectory) {
    const Samples samples = motion.trajectory->sample(motion.order);
    for (int n = 0; n < motion.order; ++n) x.push_back(samples.x(n, static_cast<Eigen::Index>(contact)));
    return x;
  }
  const std::size_t count = std::min(kDrawn, motion.section.size());
  for (std::size_t n = motion.section.size() - count; n < motion.section.size(); ++n)
    x.push_back(motion.section[n][2 * contact]);
  return x;
}

Attractor attractor_of(const LongMotion& motion) {
  Attractor found{.verdict = motion.verdict, .order = motion.order, .starts = 1, .reason = motion.reason};
  for (const StopStatistics& stop : motion.stops) {
    found.least.push_back(stop.x_min);
    found.largest.push_back(stop.x_max);
  }
  if (!found.least.empty()) found.once_a_period = once_a_period(motion, most_moved(found));
  if (!motion.trajectory) return found;
  for (const ContactEvent& event : motion.trajectory->events().value_or(std::vector<ContactEvent>{}))
    found.events.push_back(
        {.time = event.time, .contact = event.contact, .kind = event.kind, .value = event.impulse});
  const Samples samples = motion.trajectory->sample(kPushing);
  for (const auto& force : samples.force.colwise()) found.pushing.push_back(force.maxCoeff() < 0.0);
  return found;
}

/// The largest magnitude of an extreme of x: the unit in which attractors are compared [m].
double extent(const Attractor& one) {
  double most = 0.0;
  for (const auto* extremes : {&one.least, &one.largest})
    for (const double x : *extremes) most = std::max(most, std::abs(x));
  return most;
}

bool equal_extremes(const Attractor& a, const Attractor& b) {
  const double accepted = kSame * std::max(extent(a), extent(b));
  const auto equal = [accepted](double one, double other) { return std::abs(one - other) <= accepted; };
  return std::ranges::equal(a.least, b.least, equal) && std::ranges::equal(a.largest, b.largest, equal);
}

bool repeats(const Attractor& one) {
  return one.verdict == LongRun::periodic || one.verdict == LongRun::at_rest;
}

bool passes(const Branch& branch, double value, const Attractor& one) {
  constexpr double kSameValue = 1e-10;
  const double scale = extent(one);
  return std::ranges::any_of(branch.points, [&](const SolutionPoint& point) {
    if (std::abs(point.parameter - value) > kSameValue * std::abs(value) || point.order != one.order)
      return false;
    for (std::size_t j = 0; j < one.least.size(); ++j) {
      const double amplitude = 0.5 * (one.largest[j] - one.least[j]);
      if (std::abs(point.x_max[j] - one.largest[j]) > kSame * scale ||
          std::abs(point.amplitude[j] - amplitude) > kSame * scale)
        return false;
    }
    return true;
  });
}

bool same_attractor(const Attractor& a, const Attractor& b) {
  if (a.verdict != b.verdict || a.order != b.order) return false;
  return !repeats(a) || equal_extremes(a, b);
}

void add_attractor(Attractor found, AttractorsAt& at) {
  const auto known =
      std::ranges::find_if(at.attractors, [&](const Attractor& one) { return same_attractor(one, found); });
  if (known == at.attractors.end()) {
    at.attractors.push_back(std::move(found));
    return;
  }
  ++known->starts;
}

AttractorsAt follow_starts(const Problem& problem, double value, const AttractorOptions& options) {
  constexpr LongMotionOptions kFollowed{.transient = 2000, .periods = 1000, .exponents = 1};
  const Deadline deadline = Deadline::after(options.timeout);
  const FollowedScene followed(problem);
  const EventFlow placing = placing_flow(followed.dynamics());
  AttractorsAt at{.value = value};
  for (int i = 0; i < options.starts; ++i) {
    const FlowState start =
        i == 0 ? placing.place(0.0, followed.dynamics().at_rest()) : random_state(placing, 1U, i - 1);
    const double share = deadline.left() / (options.starts - i);
    Attractor found = attractor_of(followed.follow(start, kFollowed, Deadline::after(std::max(0.0, share))));
    found.from_rest = i == 0;
    ++at.starts;
    add_attractor(std::move(found), at);
  }
  for (Attractor& one : at.attractors) one.share = static_cast<double>(one.starts) / at.starts;
  std::ranges::stable_sort(at.attractors, std::greater<>(), &Attractor::starts);
  return at;
}

}  // namespace

double Attractor::amplitude() const {
  if (least.empty()) return 0.0;
  const std::size_t most = most_moved(*this);
  return 0.5 * (largest[most] - least[most]);
}

std::vector<AttractorsAt> attractors_over(const ParametrisedScene& scene, const std::vector<double>& values,
                                          const AttractorOptions& options,
                                          const std::function<void()>& on_done) {
  std::vector<IsolatedWork> work;
  for (const double value : values) {
    work.emplace_back([&scene, &options, value](const LineSender& send) {
      AttractorsAt at{.value = value};
      try {
        at = follow_starts(scene.at(value), value, options);
      } catch (const std::exception& error) {
        at.failure = error.what();
      }
      send(json_line(write_fields(at)));
    });
  }
  const std::vector<ChildEnd> ends = run_isolated_together(
      work, {.stage_seconds = {enforced(options.timeout) + kQuickSeconds}, .memory_mb = Limits{}.memory_mb},
      options.jobs, [&](std::size_t, const ChildEnd&) {
        if (on_done) on_done();
      });
  std::vector<AttractorsAt> all;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!ends[i].lines.empty()) {
      read_fields(parse_json(ends[i].lines.front()), all.emplace_back());
    } else if (ends[i].kind != ChildEnd::Kind::interrupted && !interrupted()) {
      all.push_back({.value = values[i], .failure = describe(ends[i])});
    }
  }
  return all;
}

std::vector<KnownMotion> motions_of(const ParametrisedScene& scene, const std::vector<AttractorsAt>& all,
                                    int max_order) {
  std::vector<KnownMotion> motions;
  for (const AttractorsAt& at : all) {
    for (const Attractor& one : at.attractors) {
      if (!repeats(one) || one.order < 1 || one.order > max_order) continue;
      const double period = one.order * scene.at(at.value).forcing_period();
      motions.push_back(
          {at.value, std::make_shared<ListedMotion>(period, contact_events(one.events), one.pushing)});
    }
  }
  return motions;
}

std::vector<std::string> off_branches(std::vector<AttractorsAt>& all, const std::vector<Branch>& branches,
                                      const std::string& unit, int max_order) {
  std::vector<std::string> lines;
  for (AttractorsAt& at : all) {
    for (Attractor& one : at.attractors) {
      if (!repeats(one)) continue;
      one.on_branch =
          std::ranges::any_of(branches, [&](const Branch& branch) { return passes(branch, at.value, one); });
      if (*one.on_branch) continue;
      const std::string motion =
          one.verdict == LongRun::at_rest
              ? "a state of rest"
              : fmt::format("a motion of {} period{}", one.order, one.order == 1 ? "" : "s");
      lines.push_back(fmt::format("at {:.6g} {} {} of {} starts settle to {} that lies on no branch{}",
                                  at.value, unit, one.starts, at.starts, motion,
                                  one.order > max_order ? " (--max-order goes on)" : ""));
    }
  }
  return lines;
}

namespace {

std::string describe_from_rest(const Attractor& one) {
  switch (one.verdict) {
    case LongRun::periodic:
      return fmt::format("settles to a motion of {} period{} with {} event{}", one.order,
                         one.order == 1 ? "" : "s", one.events.size(), one.events.size() == 1 ? "" : "s");
    case LongRun::at_rest:
      return "stays at rest";
    case LongRun::undecided:
      return "does not settle in the time that it was given";
    default:
      return fmt::format("is {}", name_of(one.verdict));
  }
}

}  // namespace

std::vector<std::string> motions_from_rest(const ParametrisedScene& scene, std::vector<ParameterRange> parts,
                                           const std::string& unit, double timeout) {
  constexpr std::size_t kMost = 3;
  const auto width = [](const ParameterRange& part) { return part.high - part.low; };
  std::ranges::stable_sort(parts, std::greater<>(), width);
  if (parts.size() > kMost) parts.resize(kMost);
  if (parts.empty() || !(timeout > 0.0)) return {};
  std::vector<double> values;
  for (const ParameterRange& part : parts) values.push_back(part.low + 0.5 * width(part));
  std::vector<std::string> lines;
  const AttractorOptions options{.starts = 1, .timeout = timeout / static_cast<double>(values.size())};
  for (const AttractorsAt& at : attractors_over(scene, values, options)) {
    for (const Attractor& one : at.attractors)
      lines.push_back(
          fmt::format("at {:.6g} {} the motion from rest {}", at.value, unit, describe_from_rest(one)));
  }
  return lines;
}

Table attractor_table(const std::vector<AttractorsAt>& all, const std::string& parameter) {
  Table table{.header = {parameter, "goes to", "order", "share", "starts", "amplitude [m]", "from rest",
                         "on a branch"},
              .rows = {}};
  for (const AttractorsAt& at : all) {
    const Cell value = number_cell(at.value);
    if (!at.failure.empty()) table.rows.push_back({value, at.failure, "-", "-", "-", "-", "-", "-"});
    for (const Attractor& one : at.attractors) {
      table.rows.push_back({value, std::string(name_of(one.verdict)),
                            one.order > 0 ? std::to_string(one.order) : "-",
                            Cell(fmt::format("{:.2f}", one.share), one.share), std::to_string(one.starts),
                            number_cell(one.amplitude(), 6), one.from_rest ? "yes" : "no",
                            !one.on_branch   ? "-"
                            : *one.on_branch ? "yes"
                                             : "no"});
    }
  }
  return table;
}

Json to_json(const AttractorsAt& at) {
  Json json = write_fields(at);
  for (Json& one : json["attractors"]) {
    if (one["order"] == 0) one["order"] = nullptr;
    if (!one.contains("on_branch")) one["on_branch"] = nullptr;
  }
  return json;
}

}  // namespace signorini
