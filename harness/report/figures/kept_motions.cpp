#include "harness/report/figures/kept_motions.hpp"

#include <algorithm>

#include "harness/report/figures/drawn_waveform.hpp"

namespace signorini {

namespace {

/// The coarsest answer of a study with a certified orbit whose motion is kept; null if there is none.
const CaseResult* coarsest_kept(const ResolutionStudy& study) {
  for (const ScoredRun& run : study.runs)
    if (run.error && run.result->keeps_motion) return run.result;
  return nullptr;
}

/// The contact that exchanges most impulse, by its place among those kept.
std::size_t place_of_most_impulse(const Waveform& orbit) {
  const auto total = [](const std::vector<double>& impulse) { return impulse.back(); };
  return static_cast<std::size_t>(std::ranges::min_element(orbit.impulse, {}, total) - orbit.impulse.begin());
}

/// Where this contact is kept in a record of the scene; the first if it is not.
std::size_t place_of_contact(const Waveforms& waveforms, int contact) {
  const auto found = std::ranges::find(waveforms.contacts, contact);
  return found == waveforms.contacts.end() ? 0 : static_cast<std::size_t>(found - waveforms.contacts.begin());
}

}  // namespace

KeptMotions kept_motions(const Evaluation& evaluation, const std::string& scene) {
  KeptMotions kept;
  for (const ResolutionStudy& study : evaluation.studies_of(scene)) {
    if (study.eligibility != Eligibility::ranked) continue;
    const CaseResult* result = coarsest_kept(study);
    if (result == nullptr) continue;
    const Record record = evaluation.record_of(*result);
    const Waveforms& own = *record.waveforms;
    if (!kept.leader) {
      kept.leader = record;
      kept.place = place_of_most_impulse(*own.orbit);
      kept.contact = own.contacts[kept.place];
    }
    const std::size_t place = place_of_contact(own, kept.contact);
    kept.answers.push_back({.result = result,
                            .place = place,
                            .motion = in_phase_with(kept.orbit(), kept.place, own, place,
                                                    record.certificate.order.value_or(1))});
  }
  return kept;
}

}  // namespace signorini
