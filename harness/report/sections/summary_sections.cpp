#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/plan/case_name.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/case_result.hpp"
#include "harness/report/evaluation/ranking.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/statistics.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// Errors at which the summary gives a time [-].
constexpr std::span kSummaryErrors = std::span(kErrorLevels).first<3>();

/// What a configuration, or one of its resolutions, makes of the scenes.
struct Account {
  int own = 0, solved = 0;       ///< scenes of its law
  int stable = 0, unstable = 0;  ///< of the solved ones, by the motion found
  int free = 0,
      free_solved = 0;  ///< scenes of its law that a motion without contact solves, in no other figure
  int other = 0, other_solved = 0;  ///< scenes of which it represents another law
  // On scenes of its law, infinite where it does not solve them.
  std::vector<double> errors = {}, impulses = {}, seconds = {}, ratios = {};
  std::array<Reach, kSummaryErrors.size()> to_error = {};
};

constexpr const char* kManyFailed = "half or more failed";  // in place of a median

Cell error_median(const std::vector<double>& errors) {
  return errors.empty() ? Cell("-", kNeverReached) : number_cell(median(errors), "{:.1e}", kManyFailed);
}

/// "3 of 5", other words where there is none of which to solve any.
Cell share_cell(int solved, int of, const char* none = "-") {
  return of == 0 ? Cell(none, 0.0) : count_cell(solved, of);
}

/// The error of the impulse, but not below what is known of the orbit.
Measure bounded_impulse_error(const CaseResult& result) {
  const Measure& error = result.impulse_error;
  return error ? std::max(*error, result.measurable) : error;
}

/// Counts a scene with its certified answer, null if there is none; without errors if the law is another, and
/// apart if a motion without contact solves it.
void add_scene(bool another_law, bool contact_free, const CaseResult* certified, Account& account) {
  if (contact_free) {
    account.free += another_law ? 0 : 1;
    account.free_solved += !another_law && certified != nullptr ? 1 : 0;
    return;
  }
  ++(another_law ? account.other : account.own);
  if (certified != nullptr) ++(another_law ? account.other_solved : account.solved);
  if (another_law) return;
  if (certified != nullptr && certified->outcome.stable)
    ++(*certified->outcome.stable ? account.stable : account.unstable);
  const auto add = [](const Measure& error, std::vector<double>& errors) {
    if (error) errors.push_back(*error);  // else the notion does not exist: no contact takes an impulse, say
  };
  add(certified != nullptr ? bounded_error(*certified) : kNeverReached, account.errors);
  add(certified != nullptr ? bounded_impulse_error(*certified) : kNeverReached, account.impulses);
}

/// The most accurate of the certified runs; null if there is none.
const CaseResult* best_of(const ResolutionStudy& study) {
  const CaseResult* best = nullptr;
  const auto error_of = [](const CaseResult& result) {
    return bounded_error(result).value_or(kNeverReached);
  };
  for (const ScoredRun& run : study.runs) {
    if (claim_of(run.result->outcome) != Claim::certified) continue;
    if (best == nullptr || error_of(*run.result) < error_of(*best)) best = run.result;
  }
  return best;
}

void add_study(bool contact_free, const ResolutionStudy& study, Account& account) {
  const bool another_law = study.eligibility == Eligibility::another_law;
  add_scene(another_law, contact_free, best_of(study), account);
  for (std::size_t i = 0; !contact_free && !another_law && i < kSummaryErrors.size(); ++i)
    account.to_error[i].add(study, kSummaryErrors[i]);
}

Cell reach_cell(const Reach& reach) {
  return reach.seconds.empty() ? Cell("-", kNeverReached)
                               : count_cell(reach.scenes, std::ssize(reach.seconds), reach.median_seconds());
}

Cell stability_cell(const Account& account) {
  return {stability_text(account.stable, account.unstable, account.solved),
          static_cast<double>(account.unstable)};
}

Cell solved_cell(const Account& account) {
  return share_cell(account.solved, account.own, "none of its law");
}

/// How many studies state a problem that counts elsewhere, in words.
std::string repeated_remark(std::ptrdiff_t repeated) {
  if (repeated == 0) return {};
  return fmt::format(
      "{} duplicate{} left out: two scenes that differ only in their restitution are one problem to a method "
      "that ignores it.",
      repeated, repeated == 1 ? " was" : "s were");
}

/// Time of a certified answer; infinite for any other.
double solved_time(const CaseResult& result) {
  return is_solved(result.outcome) ? result.seconds.value_or(kNeverReached) : kNeverReached;
}

/// Whether a case is one of a scene of which its method represents another law; where it does not apply, its
/// other resolutions tell.
bool is_of_another_law(const Evaluation& evaluation, const CaseResult& result) {
  if (result.outcome.status != Status::not_applicable) return has_another_law(result.outcome);
  const auto studies = evaluation.studies_of(result.scene->name);
  return std::ranges::find(studies, result.choice->configuration, &ResolutionStudy::configuration)
             ->eligibility == Eligibility::another_law;
}

/// By name of the resolution, in natural order.
std::vector<std::pair<std::string, Account>> accounts_by_resolution(const Evaluation& evaluation) {
  std::map<std::string_view, double> baseline;  // by scene
  for (const CaseResult& r : evaluation.results()) {
    if (r.choice->resolution == kTimeBaseline && std::isfinite(solved_time(r)))
      baseline[r.scene->name] = solved_time(r);
  }
  std::vector<std::pair<std::string, Account>> result;
  std::map<std::string, std::size_t> places;
  for (const CaseResult& r : evaluation.results()) {
    if (evaluation.is_repeated(r)) continue;
    const auto [place, fresh] = places.try_emplace(r.choice->resolution, result.size());
    if (fresh) result.push_back({place->first, {}});
    Account& account = result[place->second].second;
    const bool another_law = is_of_another_law(evaluation, r);
    const bool contact_free = evaluation.is_contact_free(r.scene->name);
    add_scene(another_law, contact_free, claim_of(r.outcome) == Claim::certified ? &r : nullptr, account);
    if (another_law || contact_free) continue;
    account.seconds.push_back(solved_time(r));
    if (const auto found = baseline.find(r.scene->name); found != baseline.end())
      account.ratios.push_back(solved_time(r) / found->second);
  }
  std::ranges::stable_sort(result, natural_less, &std::pair<std::string, Account>::first);
  return result;
}

/// "92 of 100 (85 to 96 %)", or per thousand.
Cell share_cell(int count, int of, double unit, std::string_view sign) {
  if (of == 0) return Cell{"none"};
  const Interval share = proportion(count, of);
  return Cell{
      fmt::format("{} of {} ({:.3g} to {:.3g}{})", count, of, unit * share.low, unit * share.high, sign)};
}

}  // namespace

Sections summary_sections(const Evaluation& evaluation) {
  std::vector<Account> accounts(evaluation.configurations().size());
  std::ptrdiff_t repeated = 0;
  for (const ResolutionStudy& study : evaluation.studies()) {
    if (evaluation.is_repeated(study))
      ++repeated;
    else
      add_study(evaluation.is_contact_free(study.scene), study,
                accounts[evaluation.place_of(study.configuration)]);
  }
  Section section{.id = "summary", .title = "What is solved, how well, and how fast"};
  section.text = R"(Of the scenes whose law a method represents: on how many it is
certified to have found a motion of that scene at any of its resolutions, and how many of these motions are
stable, for no experiment shows an unstable one; its least error of x,
and the error of the contact impulse of that answer, medians over these scenes; then how many it solves with
errors of x, of the worst contact and of the force of at most 1e-1, 1e-2 and 1e-3, and the median time of the cheapest resolution that does. A scene that
is not solved counts as infinite, an error that is only known to be below a bound as that bound. Under another
law: scenes that the method solves with another restitution than they ask for, and how many it solves so.
Without contact: scenes that a motion solves which touches nothing, and how many of those; they count in no other
column.)";
  if (!evaluation.times_remark().empty()) section.text += " " + evaluation.times_remark();
  section.table.header = {"method", "solved", "stability", "error of x", "error of impulse"};
  for (const double error : kSummaryErrors) section.table.header.push_back(fmt::format("to {:.0e}", error));
  section.table.header.insert(section.table.header.end(), {"without contact", "under another law"});
  for (std::size_t place = 0; place < accounts.size(); ++place) {
    const Account& account = accounts[place];
    std::vector<Cell> row{evaluation.configurations()[place], solved_cell(account), stability_cell(account),
                          error_median(account.errors), error_median(account.impulses)};
    for (const Reach& reach : account.to_error) row.push_back(reach_cell(reach));
    row.push_back(share_cell(account.free_solved, account.free));
    row.push_back(share_cell(account.other_solved, account.other));
    section.table.rows.push_back(std::move(row));
  }
  section.note = repeated_remark(repeated);
  return {std::move(section)};
}

Sections outcome_sections(const Evaluation& evaluation) {
  std::vector<OutcomeCounts> counts(evaluation.configurations().size());
  for (const CaseResult& result : evaluation.results())
    counts[evaluation.place_of(result.choice->configuration)].add(result.outcome);
  Section section{.id = "outcomes", .title = "Outcomes of every run"};
  section.text = R"(Every run, of whatever law. A method that says converged is
certified (the harness has found the exact orbit of its answer), refuted (it has found the answer wrong), or
unproven (neither). Stable and unstable: certified, by the multipliers of the orbit; of the rest they are not
determined. Another orbit: certified, but not the motion reached from rest.)";
  section.table.header = {"method", "runs",     "not applicable", "failed",  "says converged", "certified",
                          "stable", "unstable", "unproven",       "refuted", "another orbit"};
  for (std::size_t place = 0; place < counts.size(); ++place) {
    const OutcomeCounts& n = counts[place];
    section.table.rows.push_back({evaluation.configurations()[place], count_cell(n.cases),
                                  count_cell(n.not_applicable), count_cell(n.failed), count_cell(n.claims()),
                                  count_cell(n.certified), count_cell(n.stable), count_cell(n.unstable),
                                  count_cell(n.unproven), count_cell(n.refuted), count_cell(n.other_orbit)});
  }
  return {std::move(section)};
}

Sections speed_sections(const Evaluation& evaluation) {
  Section section{.id = "speed", .title = "Speed beside error"};
  section.text = R"(Each resolution over the scenes whose law the method represents.
Scenes that a motion without contact solves are left out. Medians are over all others, and failures count as infinite time: more failures mean a larger median. Methods of other laws have
other scenes, so that rows rank nothing: time at equal error and on equal scenes is in the sections on time to
error.)";
  section.table.header = split(fmt::format("method|solved|stability|error of x, median|error of impulse, "
                                           "median|time, median|time / {}, median|under another law",
                                           kTimeBaseline),
                               '|');
  for (const auto& [method, account] : accounts_by_resolution(evaluation)) {
    section.table.rows.push_back(
        {method, solved_cell(account), stability_cell(account), error_median(account.errors),
         error_median(account.impulses),
         account.seconds.empty() ? "-" : time_cell(median(account.seconds), kManyFailed),
         account.ratios.empty() ? "not measured" : number_cell(median(account.ratios), "{:.2g}", kManyFailed),
         share_cell(account.other_solved, account.other)});
  }
  return {std::move(section)};
}

Sections population_sections(const Evaluation& evaluation) {
  std::vector<OutcomeCounts> counts(evaluation.configurations().size());
  std::set<std::string> drawn;
  for (const CaseResult& result : evaluation.results()) {
    if (!result.scene->instance) continue;
    drawn.insert(result.scene->name);
    counts[evaluation.place_of(result.choice->configuration)].add(result.outcome);
  }
  if (drawn.empty()) return {};
  Section section{.id = "population", .title = fmt::format("{} scenes drawn at random", drawn.size())};
  section.text = R"(The scenes are drawn from ranges of their numbers. No method was tuned to
them, and another seed draws others. Solved: certified under the scene's own law. False: claims to have converged that
are refuted, of a thousand claims. In brackets the intervals of 95 % confidence of the shares of the whole population
that the ranges describe (Wilson's). Rows whose intervals overlap may differ by chance.)";
  section.table.header = {"method", "solved", "claims", "false claims, per thousand"};
  for (std::size_t place = 0; place < counts.size(); ++place) {
    const OutcomeCounts& n = counts[place];
    if (n.cases == 0) continue;
    section.table.rows.push_back({evaluation.configurations()[place],
                                  share_cell(n.solved, n.own_law(), 100.0, " %"), count_cell(n.claims()),
                                  share_cell(n.refuted, n.claims(), 1000.0, "")});
  }
  return {std::move(section)};
}

}  // namespace signorini
