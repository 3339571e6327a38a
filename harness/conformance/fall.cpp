#include "harness/conformance/fall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

namespace signorini {

namespace {

std::optional<double> as_number(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size() || !(number > 0.0)) return std::nullopt;
  return number;
}

std::string words_of(const Settings& settings) {
  std::string words;
  for (const OptionSetting& setting : settings) {
    if (as_number(setting.second)) continue;
    words += (words.empty() ? "" : ",") + setting.first + "=" + setting.second;
  }
  return words;
}

/// The key of the only number that varies between the settings, empty if there are none or several.
std::string varying_key(const std::vector<Settings>& ladder, const std::vector<std::size_t>& places) {
  std::map<std::string, std::set<double>> values;
  for (const std::size_t place : places) {
    for (const OptionSetting& setting : ladder[place]) {
      if (const auto number = as_number(setting.second)) values[setting.first].insert(*number);
    }
  }
  std::string key;
  for (const auto& [name, numbers] : values) {
    if (numbers.size() < 2) continue;
    if (!key.empty()) return {};
    key = name;
  }
  return key;
}

double value_of(const Settings& settings, const std::string& key) {
  for (const OptionSetting& setting : settings) {
    if (setting.first == key) return as_number(setting.second).value_or(1.0);
  }
  return 1.0;
}

void add_sizes(const std::vector<Settings>& ladder, LadderBranch& branch) {
  const std::string key = varying_key(ladder, branch.places);
  if (key.empty()) {
    for (std::size_t i = 0; i < branch.places.size(); ++i)
      branch.sizes.push_back(1.0 / static_cast<double>(i + 1));
    return;
  }
  const bool grows =
      value_of(ladder[branch.places.front()], key) < value_of(ladder[branch.places.back()], key);
  for (const std::size_t place : branch.places) {
    const double value = value_of(ladder[place], key);
    branch.sizes.push_back(grows ? 1.0 / value : value);
  }
}

}  // namespace

std::vector<LadderBranch> branches_of(const std::vector<Settings>& ladder) {
  std::vector<LadderBranch> branches;
  for (std::size_t place = 0; place < ladder.size(); ++place) {
    const std::string words = words_of(ladder[place]);
    const auto known = std::find_if(branches.begin(), branches.end(),
                                    [&](const LadderBranch& branch) { return branch.words == words; });
    (known == branches.end() ? branches.emplace_back(LadderBranch{.words = words}) : *known)
        .places.push_back(place);
  }
  for (LadderBranch& branch : branches) add_sizes(ladder, branch);
  return branches;
}

std::optional<double> observed_order(const std::vector<LadderStep>& steps) {
  if (steps.size() < 2) return std::nullopt;
  const double refinement = steps.front().size / steps.back().size;
  if (!(refinement > 1.0) || !(steps.front().error > 0.0) || !(steps.back().error > 0.0)) return std::nullopt;
  return std::log(steps.front().error / steps.back().error) / std::log(refinement);
}

CheckResult judge_fall(const std::vector<LadderStep>& steps, std::optional<double> order, double floor) {
  if (steps.empty()) return not_applicable("there is no error to judge");
  const double first = steps.front().error, last = steps.back().error;
  if (last <= floor) return passed();
  if (steps.size() < 2) return not_applicable(fmt::format("a single error, {:.1e}, says nothing", last));
  const std::optional<double> observed = observed_order(steps);
  if (order && observed) {
    if (*observed >= kOrderShare * *order) return passed();
    return failed(fmt::format("the error goes from {:.1e} to {:.1e}: order {:.2f}, and {:g} is declared",
                              first, last, *observed, *order));
  }
  if (last <= kFall * first) return passed();
  return failed(fmt::format("the error goes from {:.1e} to {:.1e} along the ladder (must at least halve)",
                            first, last));
}

}  // namespace signorini
