#include "harness/report/evaluation/case_result.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "harness/plan/plan.hpp"
#include "harness/records/record_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

constexpr char kFieldEnd = '\n';  // no text of a record holds one

std::string law_key(const std::optional<RepresentedLaw>& law) {
  return law ? json_text(JsonForm<RepresentedLaw>::write(*law)) : std::string();
}

std::string choice_key(const Record& record) {
  std::string key = record.method + kFieldEnd + record.run + kFieldEnd + record.same_equations_as + kFieldEnd;
  for (const auto& [name, value] : record.settings) key += name + "=" + value + kFieldEnd;
  key += kFieldEnd;
  // The kind of a value first: 1 and "1" are two.
  for (const auto& [name, value] : record.options)
    key += name + std::to_string(value.index()) + print_option(value) + kFieldEnd;
  return key;
}

std::string scene_key(const Record& record) {
  std::string key = record.scene + kFieldEnd + law_key(record.scene_law) + kFieldEnd;
  for (const std::optional<int>& number : {record.coordinates, record.contacts})
    key += number ? std::to_string(*number) + kFieldEnd : std::string(1, kFieldEnd);
  if (record.family) key += json_text(write_fields(*record.family));
  if (record.instance) key += json_text(write_fields(*record.instance));
  return key;
}

CaseChoice case_choice_of(const Record& record) {
  return {.method = record.method,
          .settings = record.settings,
          .options = record.options,
          .same_equations_as = record.same_equations_as,
          .resolution = resolution_of(record),
          .configuration = configuration_of(record),
          .from_plugin = !record.plugin.empty()};
}

/// What is kept under a key; made where nothing is.
template <class Values, class Make>
auto* kept(Values& values, const std::string& key, const Make& make) {
  const auto [place, fresh] = values.try_emplace(key);
  if (fresh) place->second = make();
  return &place->second;
}

}  // namespace

bool is_numeric(const std::string& value) {
  char* end = nullptr;
  std::strtod(value.c_str(), &end);
  return !value.empty() && end == value.c_str() + value.size();
}

bool is_resolution(const OptionSetting& setting) {
  return setting.first != kStartSetting && setting.first != "c" && is_numeric(setting.second);
}

std::string configuration_of(const Record& record) {
  Settings words = record.settings;
  std::erase_if(words, is_resolution);
  return label_of(record, words);
}

CaseScene case_scene_of(const Record& record) {
  return {.name = record.scene,
          .family = record.family,
          .instance = record.instance,
          .law = record.scene_law,
          .coordinates = record.coordinates,
          .contacts = record.contacts};
}

bool is_contact_free(const Record& record) {
  // A contact that is closed throughout has no event either: it pushes all the time.
  constexpr double kLeastPush = 0.5;  // of the period; an answer that is near may push for a moment
  return record.certificate.status == CertificateStatus::certified && record.certificate.events.empty() &&
         record.physics.contact_ratio && *record.physics.contact_ratio < kLeastPush;
}

CaseOutcome outcome_of(const Record& record) {
  return {.status = record.status,
          .certificate = record.certificate.status,
          .law_matches_scene = record.law_matches_scene,
          .same_orbit = record.certificate.same_orbit,
          .stable = record.certificate.stable,
          .contact_free = is_contact_free(record),
          .response = record.response.has_value()};
}

void CaseResults::add(const Record& record) {
  if (record.response) {
    responses.push_back(record);
    response_sources_.push_back(count_++);
    return;
  }
  CaseResult result{.case_id = record.case_id,
                    .choice = kept(choices_, choice_key(record), [&] { return case_choice_of(record); }),
                    .scene = kept(scenes_, scene_key(record), [&] { return case_scene_of(record); }),
                    .outcome = outcome_of(record),
                    .error = record.errors.x_l2 ? record.errors.x_l2 : record.errors.u_l2,
                    .level = level_error(record),
                    .impulse_error = record.errors.impulse,
                    .measurable = measurable_error(record),
                    .condition = record.condition,
                    .work = record.work.counts,
                    .repeats = record.repeats,
                    .source = count_++};
  if (record.law) result.law = kept(laws_, law_key(record.law), [&] { return *record.law; });
  if (record.seconds) {
    result.seconds = record.seconds->median;
    result.exchange = record.seconds->exchange;
    result.together = record.seconds->jobs.has_value();
    result.unsteady = record.seconds->unsteady == true;
  }
  if (record.certificate.orbit) result.orbit = name_of(*record.certificate.orbit);
  if (!record.problem.empty()) result.problem = name_of(record.problem);
  if (!record.answer.empty()) result.answer = name_of(record.answer);
  result.keeps_motion = record.waveforms && record.waveforms->orbit && !record.waveforms->contacts.empty();
  // Growing by a quarter: while it is doubled, a list takes three times its own memory.
  if (all.size() == all.capacity()) all.reserve(all.size() + all.size() / 4 + 1);
  all.push_back(std::move(result));
}

bool CaseChoice::is_plain() const { return signorini::is_plain(settings); }

// In place: a second list would be half of the memory that the evaluation of a large run takes.
void CaseResults::keep(const std::vector<std::size_t>& sources) {
  constexpr std::size_t kDropped = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> places(count_, kDropped);  // by number
  for (std::size_t i = 0; i < sources.size(); ++i) places[sources[i]] = i;
  const auto place = [&](const CaseResult& result) { return places[result.source]; };
  std::erase_if(all, [&](const CaseResult& result) { return place(result) == kDropped; });
  std::ranges::sort(all, {}, place);
  std::size_t i = 0;
  std::erase_if(responses, [&](const Record&) { return places[response_sources_[i++]] == kDropped; });
  std::erase_if(response_sources_, [&](std::size_t source) { return places[source] == kDropped; });
}

std::optional<Claim> claim_of(const CaseOutcome& outcome) {
  return outcome.response ? std::nullopt : claim_of(outcome.status, outcome.certificate);
}

bool has_another_law(const CaseOutcome& outcome) { return outcome.law_matches_scene == false; }

bool is_solved(const CaseOutcome& outcome) {
  return claim_of(outcome) == Claim::certified && !has_another_law(outcome);
}

std::vector<bool> repeated_problems(const std::vector<CaseResult>& results) {
  std::vector<bool> repeated(results.size(), false);
  std::set<std::pair<std::string_view, std::string_view>> seen;  // resolution and problem
  for (const bool another_law : {false, true}) {
    for (std::size_t i = 0; i < results.size(); ++i) {
      const CaseResult& result = results[i];
      if (result.problem == nullptr || has_another_law(result.outcome) != another_law) continue;
      repeated[i] = !seen.emplace(result.choice->resolution, *result.problem).second;
    }
  }
  return repeated;
}

Measure bounded_error(const CaseResult& result) {
  return result.error ? std::max(*result.error, result.measurable) : result.error;
}

Measure certified_error(const CaseResult& result) {
  return claim_of(result.outcome) == Claim::certified ? bounded_error(result) : std::nullopt;
}

Measure certified_level(const CaseResult& result) {
  if (claim_of(result.outcome) != Claim::certified || !result.level) return std::nullopt;
  return std::max(*result.level, result.measurable);
}

void OutcomeCounts::add(const CaseOutcome& outcome) {
  const std::optional<Claim> claim = claim_of(outcome);
  const bool refused = outcome.status == Status::not_applicable;
  const bool is_followed = outcome.response && outcome.status == Status::converged;
  ++cases;
  not_applicable += refused ? 1 : 0;
  followed += is_followed ? 1 : 0;
  failed += !claim && !refused && !is_followed ? 1 : 0;
  refuted += claim == Claim::refuted ? 1 : 0;
  unproven += claim == Claim::unproven ? 1 : 0;
  certified += claim == Claim::certified ? 1 : 0;
  another_law += !refused && has_another_law(outcome) ? 1 : 0;
  solved += is_solved(outcome) ? 1 : 0;
  if (claim != Claim::certified) return;
  if (const auto same = outcome.same_orbit) ++(*same ? same_orbit : other_orbit);
  if (outcome.stable) ++(*outcome.stable ? stable : unstable);
}

OutcomeCounts counts_of(std::span<const CaseResult> results) {
  OutcomeCounts counts;
  for (const CaseResult& result : results) counts.add(result.outcome);
  return counts;
}

}  // namespace signorini
