#include "harness/report/evaluation/variations.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "harness/plan/case_name.hpp"

namespace signorini {

namespace {

/// Numbers in rising order; words as they ran.
void put_in_order(std::vector<std::string>& values) {
  const auto is_number = [](const std::string& value) { return number_in(value).has_value(); };
  if (std::ranges::all_of(values, is_number)) std::ranges::stable_sort(values, {}, number_in);
}

}  // namespace

std::map<Varied, Variation> variations_of(std::span<const CaseResult> results) {
  std::map<Varied, Variation> variations;
  for (const CaseResult& result : results) {
    const CaseChoice& choice = *result.choice;
    for (std::size_t varied = 0; varied < choice.settings.size(); ++varied) {
      Settings others = choice.settings;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(varied));
      const auto numeric = [](const OptionSetting& setting) { return is_numeric(setting.second); };
      if (std::none_of(others.begin(), others.end(), numeric)) continue;
      const auto& [option, value] = choice.settings[varied];
      Variation& variation = variations[{method_label(choice.method, others), option}];
      std::vector<const CaseResult*>& at_value = variation.results[value];
      if (at_value.empty()) variation.values.push_back(value);
      at_value.push_back(&result);
    }
  }
  for (auto& [varied, variation] : variations) put_in_order(variation.values);
  return variations;
}

std::optional<double> number_in(const std::string& value) {
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  const std::string_view rest = end;
  if (end == value.c_str() || !(rest.empty() || rest == "x")) return std::nullopt;
  return number;
}

}  // namespace signorini
