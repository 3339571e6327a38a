#pragma once
// Known names that a slip of the fingers may have meant.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// Those of `known` within two edits of `word`, or a quarter of its length if that is more (Levenshtein's
/// distance: insertions, deletions, replacements), nearest first, at most three. None for an empty word.
std::vector<std::string> close_names(std::string_view word, std::span<const std::string> known);

/// "; did you mean A, B?" of these, for the end of a refusal; empty where there is none.
std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace signorini
