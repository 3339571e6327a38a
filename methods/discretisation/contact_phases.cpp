#include "methods/discretisation/contact_phases.hpp"

#include "methods/discretisation/periodic_time.hpp"

namespace signorini {

std::vector<std::vector<ContactInterval>> contact_phases(const std::vector<ContactInterval>& pushing,
                                                         double resolution) {
  std::vector<std::vector<ContactInterval>> phases;
  for (const ContactInterval& interval : pushing) {
    if (!phases.empty() && interval.begin - phases.back().back().end < resolution) {
      phases.back().push_back(interval);
    } else {
      phases.push_back({interval});
    }
  }
  if (phases.size() < 2 || phases.front().front().begin + 1.0 - phases.back().back().end >= resolution)
    return phases;
  // The first phase continues the last one of the period before.
  for (const ContactInterval& interval : phases.front())
    phases.back().push_back({interval.begin + 1.0, interval.end + 1.0});
  phases.erase(phases.begin());
  return phases;
}

std::vector<SampledPhase> contact_phases(const Eigen::Ref<const Eigen::VectorXd>& force, double threshold,
                                         int resolution) {
  const auto count = static_cast<int>(force.size());
  const auto pushes = [&](int i) { return -force[i % count] > threshold; };
  std::vector<SampledPhase> phases;
  // Begin after a break that separates phases, so that none is cut by the end of the period.
  int start = 0;
  for (int free = 0; start < 2 * count && !(free >= resolution && pushes(start)); ++start)
    free = pushes(start) ? 0 : free + 1;
  if (start == 2 * count) {
    if ((-force.array() > threshold).any()) phases.push_back({.first = 0, .length = count});
    return phases;
  }
  for (int i = start; i < start + count; ++i) {
    if (!pushes(i)) continue;
    if (!phases.empty() && i - (phases.back().first + phases.back().length) < resolution) {
      phases.back().length = i + 1 - phases.back().first;
    } else {
      phases.push_back({.first = i, .length = 1});
    }
  }
  for (SampledPhase& phase : phases) phase.first %= count;
  std::sort(phases.begin(), phases.end(),
            [](const SampledPhase& a, const SampledPhase& b) { return a.first < b.first; });
  return phases;
}

std::vector<ListedContact> listed_contacts(const std::vector<ContactEvent>& events, double period) {
  using Kind = ContactEvent::Kind;
  std::vector<ListedContact> contacts;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].kind != Kind::open) continue;
    // Back in time, across the beginning of the period, to the event before it that is no impact.
    for (std::size_t back = 1; back < events.size(); ++back) {
      const ContactEvent& before = events[(i + events.size() - back) % events.size()];
      if (before.contact != events[i].contact || before.kind == Kind::impact) continue;
      if (before.kind == Kind::close)
        contacts.push_back({.opening = i,
                            .contact = before.contact,
                            .begin = before.time,
                            .end = before.time + wrapped_time(events[i].time - before.time, period)});
      break;
    }
  }
  return contacts;
}

}  // namespace signorini
