#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <nlohmann/json.hpp>

#include "harness/judge/orbit.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "harness/records/record.hpp"
#include "harness/records/record_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

/// The largest difference of two orbits in units of the tolerance, and where it is.
struct Gap {
  double size = 0.0;
  std::string where = {};

  void widen(double by, const std::string& text) {
    if (by <= size) return;
    size = by;
    where = text;
  }
};

double allowed(const FoundOrbit& a, const FoundOrbit& b) {
  return kErrorBars * (a.certified.error_bar + b.certified.error_bar) + kInstantFloor;
}

/// The events strong enough to be compared, shifted in time; in order.
std::vector<OrbitEvent> strong_events(const FoundOrbit& orbit, double shift) {
  const double largest = largest_impulse(orbit.certified.events);
  std::vector<OrbitEvent> events;
  for (OrbitEvent event : orbit.certified.events) {
    if (event.kind == ContactEvent::Kind::impact &&
        std::abs(event.value.value_or(0.0)) < kWeakEvent * largest)
      continue;
    event.time = std::fmod(event.time + shift, orbit.period);
    events.push_back(event);
  }
  std::ranges::stable_sort(events, {}, [](const OrbitEvent& e) { return std::pair(e.time, e.contact); });
  return events;
}

double apart_on_circle(double a, double b, double period) {
  return std::abs(std::remainder(a - b, period)) / period;
}

/// Pairs each event with the nearest of its kind and contact.
Gap event_gap(const FoundOrbit& kept, const FoundOrbit& now, double shift) {
  Gap gap;
  const std::vector<OrbitEvent> before = strong_events(kept, 0.0);
  std::vector<OrbitEvent> after = strong_events(now, shift);
  if (before.size() != after.size()) {
    gap.widen(std::numeric_limits<double>::infinity(),
              fmt::format("{} events became {}", before.size(), after.size()));
    return gap;
  }
  const double tolerance = allowed(kept, now);
  const double largest = largest_impulse(before);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const OrbitEvent& event = before[i];
    const auto nearest = std::ranges::min_element(after, {}, [&](const OrbitEvent& e) {
      return std::pair(e.kind != event.kind || e.contact != event.contact,
                       apart_on_circle(e.time, event.time, kept.period));
    });
    const std::string name =
        fmt::format("event {} ({} at contact {})", i + 1, enum_name(event.kind), event.contact);
    if (nearest->kind != event.kind || nearest->contact != event.contact) {
      gap.widen(std::numeric_limits<double>::infinity(), name + " is gone");
      return gap;
    }
    gap.widen(apart_on_circle(nearest->time, event.time, kept.period) / tolerance,
              fmt::format("{}: time {:.12g} s became {:.12g} s", name, event.time, nearest->time));
    if (event.value && nearest->value) {
      gap.widen(
          std::abs(*event.value - *nearest->value) / (largest * tolerance),
          fmt::format("{}: impulse {:.12g} N s became {:.12g} N s", name, *event.value, *nearest->value));
    }
    after.erase(nearest);
  }
  return gap;
}

Gap gap_between(const FoundOrbit& kept, const FoundOrbit& now) {
  Gap best{.size = std::numeric_limits<double>::infinity(), .where = "no shift brings them together"};
  for (int shift = 0; shift < kept.order; ++shift) {
    const Gap gap = event_gap(kept, now, shift * kept.period / kept.order);
    if (shift == 0 || gap.size < best.size) best = gap;
  }
  if (kept.amplitude != now.amplitude) {  // both 0 where a contact stays closed
    best.widen(std::abs(kept.amplitude - now.amplitude) /
                   (std::max(kept.amplitude, now.amplitude) * allowed(kept, now)),
               fmt::format("amplitude {:.12g} m became {:.12g} m", kept.amplitude, now.amplitude));
  }
  return best;
}

/// Multipliers of one orbit, each paired with the nearest of the other. A long stay in contact makes several
/// of them zero, which are known to the root of the round-off only.
std::string multiplier_difference(const FoundOrbit& kept, const FoundOrbit& now) {
  constexpr double kRoot = 1e-6;
  if (kept.certified.floquet.has_value() != now.certified.floquet.has_value())
    return "multipliers are there in one of the two only";
  if (!kept.certified.floquet) return {};
  auto left = *now.certified.floquet;
  if (left.size() != kept.certified.floquet->size()) return "another number of multipliers";
  const double tolerance = allowed(kept, now) + kRoot;
  for (const auto& [re, im] : *kept.certified.floquet) {
    const std::complex<double> one(re, im);
    const auto distance = [&](const auto& other) {
      return std::abs(std::complex<double>(other.first, other.second) - one);
    };
    const auto nearest = std::ranges::min_element(left, {}, distance);
    if (distance(*nearest) > tolerance * std::max(1.0, std::abs(one))) {
      return fmt::format("multiplier {:.9g}{:+.9g}i became {:.9g}{:+.9g}i", re, im, nearest->first,
                         nearest->second);
    }
    left.erase(nearest);
  }
  return {};
}

std::string stability(const FoundOrbit& orbit) {
  const std::string word = stability_word(orbit.certified.stable, orbit.certified.undefined);
  return word.empty() ? "of unknown stability" : word == "undefined" ? "of undefined stability" : word;
}

/// Adds a line for each difference between an orbit kept and the one found again.
void compare_pair(const std::string& name, const FoundOrbit& kept, const FoundOrbit& now,
                  std::vector<std::string>& differences) {
  const auto differ = [&](const std::string& what) { differences.push_back(name + ": " + what); };
  if (const Gap gap = gap_between(kept, now); gap.size > 1.0) {
    differ(fmt::format("{}, {:.2g} times what is allowed", gap.where, gap.size));
  } else if (kept.fingerprint != now.fingerprint) {
    differ("fingerprint became " + now.fingerprint);
  }
  if (const std::string text = multiplier_difference(kept, now); !text.empty()) differ(text);
  if (stability(kept) != stability(now)) differ(stability(kept) + " became " + stability(now));
  if (kept.from_rest != now.from_rest)
    differ(kept.from_rest ? "is no longer the one reached from rest" : "became the one reached from rest");
}

/// The orbit found that corresponds to `kept`: the nearest of its order within the tolerance, else the one
/// with its fingerprint.
std::vector<FoundOrbit>::iterator counterpart(const FoundOrbit& kept, std::vector<FoundOrbit>& found) {
  auto best = found.end();
  double least = 1.0;
  for (auto it = found.begin(); it != found.end(); ++it) {
    if (it->order != kept.order) continue;
    const double size = gap_between(kept, *it).size;
    if (size > least) continue;
    least = size;
    best = it;
  }
  if (best != found.end()) return best;
  return std::ranges::find_if(found, [&](const FoundOrbit& orbit) {
    return orbit.order == kept.order && orbit.fingerprint == kept.fingerprint;
  });
}

std::string name_of(const std::string& scene, const FoundOrbit& orbit) {
  return fmt::format("{}: orbit {} of order {}", scene, orbit.fingerprint, orbit.order);
}

}  // namespace

OrbitDifferences compare_orbits(const OrbitFile& kept, const OrbitFile& now) {
  OrbitDifferences result;
  if (kept.scene_sha256 != now.scene_sha256) {
    result.differences.push_back(fmt::format(
        "{}: the scene file has changed since its orbits were kept (verify --update keeps new ones)",
        kept.scene));
    return result;
  }
  const auto law = JsonForm<RepresentedLaw>::write(now.law);
  if (JsonForm<RepresentedLaw>::write(kept.law) != law) {
    result.differences.push_back(fmt::format("{}: the law became {}", kept.scene, json_text(law)));
    return result;
  }
  std::vector<FoundOrbit> found = now.orbits;
  for (const FoundOrbit& orbit : kept.orbits) {
    const std::string name = name_of(kept.scene, orbit);
    const auto again = counterpart(orbit, found);
    if (again == found.end()) {
      result.differences.push_back(name + ": not found again");
      continue;
    }
    compare_pair(name, orbit, *again, result.differences);
    found.erase(again);
  }
  for (const FoundOrbit& orbit : found) {
    result.fresh.push_back(fmt::format("{}, {}: new, amplitude {:.6g} m", name_of(now.scene, orbit),
                                       stability(orbit), orbit.amplitude));
  }
  return result;
}

}  // namespace signorini
