#include "harness/report/formats/screen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "harness/cluster/scripts.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/evaluation/response_standings.hpp"
#include "harness/report/evaluation/rivals.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

std::string counts_text(const OutcomeCounts& counts) {
  std::string text = plural(counts.cases, "case");
  for (const auto& [count, word] :
       {std::pair{counts.certified, "certified"}, std::pair{counts.unproven, "unproven"},
        std::pair{counts.refuted, "refuted"}, std::pair{counts.followed, "followed"},
        std::pair{counts.failed, "failed"}, std::pair{counts.not_applicable, "not applicable"}}) {
    if (count > 0) text += fmt::format(", {} {}", count, word);
  }
  return text;
}

/// `text` and as many of the items, joined by commas, as three lines hold; the rest are counted.
ScreenLines listed(std::string text, const std::vector<std::string>& items) {
  constexpr std::size_t kMostLines = 3;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string item = " " + items[i];
    const std::string rest = i + 1 == items.size() ? "" : fmt::format(" and {} more", items.size() - i - 1);
    if (i > 0 && wrapped_lines(text + "," + item + rest, kTerminalWidth).size() > kMostLines) {
      text += fmt::format(" and {} more", items.size() - i);
      break;
    }
    text += (i == 0 ? "" : ",") + item;
  }
  return wrapped_text(text);
}

constexpr std::size_t kLongestListed = 60;

/// What the times of commands leave out.
ScreenLines hand_over_lines(const Evaluation& evaluation) {
  std::vector<std::string> items;
  for (const HandOver& one : hand_overs(evaluation))
    items.push_back(
        fmt::format("{} {} a solve", clipped(one.configuration, kLongestListed), time_text(one.beside)));
  return items.empty() ? ScreenLines() : listed("Times leave out to hand over problem and answer:", items);
}

/// Failed and refuted cases of each configuration, those with the most first.
ScreenLines failure_lines(const Evaluation& evaluation) {
  std::vector<std::pair<std::string, OutcomeCounts>> counts;
  for (const std::string& configuration : evaluation.configurations())
    counts.emplace_back(configuration, OutcomeCounts{});
  for (const CaseResult& result : evaluation.results())
    counts[evaluation.place_of(result.choice->configuration)].second.add(result.outcome);
  for (const std::string& label : response_labels(evaluation.responses())) {
    OutcomeCounts& own = counts.emplace_back(label, OutcomeCounts{}).second;
    for (const Record& record : evaluation.responses())
      if (!is_exact(record) && response_label(record) == label) own.add(outcome_of(record));
  }
  const auto wrong = [](const auto& entry) { return entry.second.failed + entry.second.refuted; };
  std::erase_if(counts, [&](const auto& entry) { return wrong(entry) == 0; });
  if (counts.empty()) return {};
  std::ranges::stable_sort(counts, [&](const auto& a, const auto& b) { return wrong(a) > wrong(b); });
  std::vector<std::string> items;
  for (const auto& entry : counts)
    items.push_back(
        fmt::format("{} {} of {}", clipped(entry.first, kLongestListed), wrong(entry), entry.second.cases));
  return listed("Failed or refuted:", items);
}

/// ": timeout"; nothing of a case that is not there.
std::string status_of_case(const Evaluation& evaluation, const std::string& case_id) {
  const auto result = std::ranges::find(evaluation.results(), case_id, &CaseResult::case_id);
  const auto record = std::ranges::find(evaluation.responses(), case_id, &Record::case_id);
  if (result != evaluation.results().end()) return fmt::format(": {}", status_name(result->outcome.status));
  return record == evaluation.responses().end() ? "" : fmt::format(": {}", status_name(record->status));
}

ScreenLines unexpected_lines(const Evaluation& evaluation, const std::vector<std::string>& cases) {
  if (cases.empty()) return {};
  constexpr std::size_t kMostCases = 4;
  ScreenLines lines{{fmt::format("{} failed or {} refuted, unexpectedly:",
                                 plural(static_cast<std::ptrdiff_t>(cases.size()), "case"),
                                 cases.size() == 1 ? "was" : "were"),
                     Emphasis::bad}};
  const std::size_t shown = cases.size() <= kMostCases ? cases.size() : kMostCases - 1;
  for (std::size_t i = 0; i < shown; ++i) {
    const std::string status = status_of_case(evaluation, cases[i]);
    lines.push_back({clipped("  " + cases[i], kTerminalWidth - status.size()) + status});
  }
  if (shown < cases.size()) lines.push_back({fmt::format("  and {} more", cases.size() - shown)});
  return lines;
}

/// `command` after `words`, in further lines where there is no room.
ScreenLines command_lines(const std::string& words, const std::string& command) {
  if (words.size() + 1 + command.size() <= kTerminalWidth) return {{words + " " + command}};
  ScreenLines lines{{words}};
  std::vector<std::string> parts = wrapped_lines(command, kTerminalWidth - 4);
  for (std::size_t i = 0; i < parts.size(); ++i)
    lines.push_back({"  " + parts[i] + (i + 1 < parts.size() ? " \\" : "")});
  return lines;
}

/// Of all certified motions, how many are stable.
ScreenLines stability_lines(const Evaluation& evaluation) {
  const OutcomeCounts counts = counts_of(evaluation.results());
  if (counts.certified == 0) return {};
  return wrapped_text(
      fmt::format("Certified: an exact motion lies within 10 % of the result and has the same contacts ({}). "
                  "Refuted: the result is wrong. Unproven: not decided. Failed: no result.",
                  stability_text(counts.stable, counts.unstable, counts.certified)));
}

/// What happened, in one or two sentences.
ScreenLines opening_lines(const Evaluation& evaluation, const ScreenContext& context) {
  const bool together =
      std::ranges::any_of(evaluation.results(), [](const CaseResult& result) { return result.together; }) ||
      std::ranges::any_of(evaluation.responses(),
                          [](const Record& record) { return record.seconds && record.seconds->jobs; });
  ScreenLines lines;
  if (!context.heading.empty()) append(lines, wrapped_text(context.heading));
  append(lines, wrapped_text(counts_line(evaluation)));
  append(lines, stability_lines(evaluation));
  if (together)
    append(lines, wrapped_text("Cases ran at the same time: their times are not comparable.", Emphasis::bad));
  else if (!evaluation.times_remark().empty())
    append(lines, wrapped_text(evaluation.times_remark(), Emphasis::bad));
  if (const std::string unsteady = unsteady_remark(evaluation); !unsteady.empty())
    append(lines, wrapped_text(unsteady));
  return lines;
}

ScreenLines closing_lines(const Evaluation& evaluation, const ScreenContext& context) {
  ScreenLines lines{{}};
  append(lines, hand_over_lines(evaluation));
  append(lines, failure_lines(evaluation));
  append(lines, unexpected_lines(evaluation, context.unexpected));
  append(lines, command_lines("Limits of the methods:", shell_word(context.program) + " list methods"));
  append(lines, command_lines("All tables, and why cases failed:", context.folder + "/table.md"));
  append(lines, command_lines("A page with figures:",
                              fmt::format("{} report {} --format html", shell_word(context.program),
                                          shell_word(context.folder))));
  return lines;
}

std::string painted(const ScreenLine& line, bool colour) {
  if (!colour || line.emphasis == Emphasis::none) return line.text + "\n";
  const char* const code = line.emphasis == Emphasis::title  ? "1"
                           : line.emphasis == Emphasis::good ? "32"
                                                             : "31";
  return fmt::format("\033[{}m{}\033[0m\n", code, line.text);
}

}  // namespace

std::string unsteady_remark(const Evaluation& evaluation) {
  const auto count = std::ranges::count_if(evaluation.results(), &CaseResult::unsteady);
  if (count == 0) return {};
  return plural(count, "case") + (count == 1 ? " has" : " have") +
         " unsteady times: their rounds differ by more than 25 % however often they are measured.";
}

std::string counts_line(const Evaluation& evaluation) {
  OutcomeCounts counts = counts_of(evaluation.results());
  std::set<std::string_view> scenes(evaluation.scenes().begin(), evaluation.scenes().end());
  for (const Record& record : evaluation.responses()) {
    counts.add(outcome_of(record));
    scenes.insert(record.scene);
  }
  return plural(std::ssize(scenes), "scene") + ", " + counts_text(counts);
}

std::string screen_report(const Evaluation& evaluation, const ScreenContext& context) {
  ScreenLines lines = opening_lines(evaluation, context);
  ScreenLines closing = closing_lines(evaluation, context);
  const auto room = [&] { return kScreenLines - std::min(kScreenLines, lines.size() + closing.size()); };
  if (!evaluation.results().empty()) append(lines, group_lines(evaluation, room()));
  append(lines, response_lines(evaluation, room()));
  append(lines, std::move(closing));
  std::string text;
  for (const ScreenLine& line : lines) text += painted(line, context.colour);
  return text;
}

std::string scene_line(const std::string& scenes, const OutcomeCounts& counts) {
  return clipped(scenes + ": " + counts_text(counts), kTerminalWidth);
}

}  // namespace signorini
