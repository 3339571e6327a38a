#include "harness/conformance/review.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace signorini {

namespace {

std::size_t count_of(std::span<const CheckFinding> findings, CheckOutcome outcome) {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [&](const CheckFinding& finding) { return finding.result.outcome == outcome; }));
}

std::string scenes_text(std::size_t count) { return fmt::format("{} scene{}", count, count == 1 ? "" : "s"); }

/// "passed on 7 scenes, nothing to look at on 2".
std::string summary(std::span<const CheckFinding> findings) {
  if (findings.front().scene.empty()) return std::string(outcome_name(findings.front().result.outcome));
  const std::size_t failed = count_of(findings, CheckOutcome::failed);
  const std::size_t nothing = count_of(findings, CheckOutcome::not_applicable);
  const std::size_t passed = findings.size() - failed - nothing;
  std::string text;
  const auto add = [&](std::string part) { text += (text.empty() ? "" : ", ") + part; };
  if (failed > 0) add("FAILED on " + scenes_text(failed));
  if (passed > 0) add("passed on " + scenes_text(passed));
  if (nothing > 0) add("nothing to look at on " + scenes_text(nothing));
  return text;
}

std::string reproduction(const MethodEntry& entry, const CheckFinding& finding) {
  if (!finding.result.reproduce.empty()) return finding.result.reproduce;
  const std::string scene = finding.scene.empty() ? "" : " --scenes " + finding.scene;
  return fmt::format("signorini check {} --checks {}{}", entry.name, finding.check, scene);
}

std::string remark(const MethodEntry& entry, const CheckFinding& finding) {
  const std::string where = finding.scene.empty() ? "" : finding.scene + ": ";
  std::string text = fmt::format("    {}{}\n", where, finding.result.why);
  if (finding.result.outcome == CheckOutcome::failed)
    text += fmt::format("      {}\n", reproduction(entry, finding));
  return text;
}

std::string paragraph(const MethodEntry& entry, std::span<const CheckFinding> findings) {
  std::string text =
      fmt::format("  {:<18} {}: {}\n", findings.front().check, findings.front().promise, summary(findings));
  for (const CheckOutcome outcome : {CheckOutcome::failed, CheckOutcome::remarked}) {
    for (const CheckFinding& finding : findings) {
      if (finding.result.outcome == outcome) text += remark(entry, finding);
    }
  }
  return text;
}

}  // namespace

std::string review_text(const MethodEntry& entry, const std::vector<CheckFinding>& findings) {
  std::string text = fmt::format("{}: {}\n", entry.name, entry.title);
  const std::span all(findings);
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && all[end].check == all[begin].check) ++end;
    text += paragraph(entry, all.subspan(begin, end - begin));
    begin = end;
  }
  return text + fmt::format("{}: {} passed, {} failed, {} remarks, {} had nothing to look at\n", entry.name,
                            count_of(all, CheckOutcome::passed), count_of(all, CheckOutcome::failed),
                            count_of(all, CheckOutcome::remarked),
                            count_of(all, CheckOutcome::not_applicable));
}

}  // namespace signorini
