#include <fmt/format.h>

#include <algorithm>

#include "harness/glob.hpp"
#include "harness/plan/plan.hpp"
#include "harness/text/words.hpp"
#include "problems/files/close_names.hpp"

namespace signorini {

namespace {

[[noreturn]] void refuse_selection(std::string_view text, std::string_view requirement) {
  throw UsageError("methods = {} ({})", text, requirement);
}

/// \throws UsageError for a few words that stand for more than a run ever solves
void require_few(std::size_t sets, std::string_view text) {
  constexpr std::size_t kMost = 10000;
  if (sets > kMost) refuse_selection(text, fmt::format("must be at most {} settings of methods", kMost));
}

constexpr std::string_view kForm = "must look like name[key=value,key=value|value]";

struct Piece {
  std::string glob;
  bool bracketed = false;
  std::vector<Settings> settings = {};
};

Piece parse_piece(const std::string& text) {
  const std::size_t open = text.find('[');
  if (open == std::string::npos) {
    if (text.find(']') != std::string::npos) refuse_selection(text, kForm);
    return {.glob = text};
  }
  const std::string_view inside = std::string_view(text).substr(open + 1);
  if (open == 0 || inside.empty() || inside.find('[') != std::string_view::npos ||
      inside.find(']') != inside.size() - 1) {
    refuse_selection(text, kForm);
  }
  return {.glob = text.substr(0, open),
          .bracketed = true,
          .settings = expand_settings(inside.substr(0, inside.size() - 1))};
}

/// The settings of a method that a piece without brackets names.
std::vector<Settings> usual_settings(const MethodEntry& entry, std::span<const MethodChoice> prescribed) {
  std::vector<Settings> settings;
  for (const MethodChoice& choice : prescribed) {
    if (choice.entry->name == entry.name) settings.push_back(choice.settings);
  }
  return settings.empty() ? ladder_of(entry) : settings;
}

}  // namespace

std::string MethodChoice::label() const { return method_label(entry->name, settings); }

std::unique_ptr<Method> MethodChoice::make() const {
  Settings own = settings;
  std::erase_if(own, [](const OptionSetting& setting) { return setting.first == kStartSetting; });
  return entry->make(own);
}

std::optional<double> MethodChoice::start() const {
  for (const auto& [key, value] : settings) {
    if (key != kStartSetting) continue;
    const double late = option_detail::parse_double(key, value);
    require_option(late >= 0.0 && late < 1.0, key, late, "must be in [0, 1), a share of the period");
    return late;
  }
  return std::nullopt;
}

std::vector<OptionEcho> MethodChoice::options() const {
  std::vector<OptionEcho> all = make()->options();
  if (const std::optional<double> late = start()) {
    all.push_back({.name = std::string(kStartSetting),
                   .value = *late,
                   .unit = "[-]",
                   .meaning = "from the scene's orbit, late by this share of its period"});
  }
  return all;
}

std::vector<Settings> expand_settings(std::string_view text) {
  std::vector<Settings> sets{{}};
  if (text.empty()) return sets;
  for (const std::string& item : split(text, ',')) {
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos || equals == 0) refuse_selection(text, kForm);
    const std::string key = item.substr(0, equals);
    for (const auto& [known, value] : sets.front()) {
      if (known == key) refuse_selection(text, "must set each option once");
    }
    std::vector<Settings> longer;
    const std::vector<std::string> alternatives = split(item.substr(equals + 1), '|');
    require_few(sets.size() * alternatives.size(), text);
    for (const Settings& set : sets) {
      for (const std::string& value : alternatives) {
        if (value.empty()) refuse_selection(text, kForm);
        longer.push_back(set);
        longer.back().emplace_back(key, value);
      }
    }
    sets = std::move(longer);
  }
  return sets;
}

std::vector<Settings> ladder_of(const MethodEntry& entry) { return expand_settings(entry.ladder); }

NothingMatched no_method(std::string_view filter, std::span<const MethodEntry> catalogue) {
  std::vector<std::string> names;
  for (const MethodEntry& entry : catalogue) names.push_back(entry.name);
  return NothingMatched("methods = {} (matches no method{}; see `signorini list methods`)", filter,
                        suggestion(filter.substr(0, filter.find('[')), names));
}

std::vector<MethodChoice> select_methods(std::string_view filter, std::span<const MethodEntry> catalogue,
                                         std::span<const MethodChoice> prescribed) {
  const GlobPieces pieces = split_globs(filter);
  std::vector<Piece> positive;
  std::size_t sets = 0;
  for (const std::string& text : pieces.positive) {
    positive.push_back(parse_piece(text));
    require_few(sets += positive.back().settings.size(), filter);
    const auto matches = [&](const MethodEntry& entry) {
      return glob_match(positive.back().glob, entry.name);
    };
    if (std::ranges::none_of(catalogue, matches)) throw no_method(text, catalogue);
  }
  std::vector<MethodChoice> choices;
  for (const MethodEntry& entry : catalogue) {
    const auto matches = [&](const std::string& glob) { return glob_match(glob, entry.name); };
    if (std::ranges::any_of(pieces.negative, matches)) continue;
    std::vector<std::string> labels;
    for (const Piece& piece : positive) {
      if (!glob_match(piece.glob, entry.name)) continue;
      for (Settings& settings :
           piece.bracketed ? std::vector(piece.settings) : usual_settings(entry, prescribed)) {
        MethodChoice choice{&entry, std::move(settings)};
        if (std::ranges::find(labels, choice.label()) != labels.end()) continue;
        labels.push_back(choice.label());
        choices.push_back(std::move(choice));
      }
    }
  }
  if (choices.empty()) throw no_method(filter, catalogue);
  return choices;
}

}  // namespace signorini
