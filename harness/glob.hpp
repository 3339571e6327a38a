#pragma once
// Names chosen by gtest globs, `hat*:fourier*-*penalty*`.

#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// True if the whole text matches; `*` is any run of characters, `?` any one, all else itself, brackets too.
/// By fnmatch(3), whose sets of characters no filter needs.
bool glob_match(std::string_view pattern, std::string_view text);

/// Whether a word for a scene or a suite is a path rather than a name: it contains a slash or ".toml".
bool looks_like_path(std::string_view word);

/// The pieces of a filter: POSITIVE[:POSITIVE...][-NEGATIVE[:NEGATIVE...]].
struct GlobPieces {
  std::vector<std::string> positive;  ///< "*" where none is given
  std::vector<std::string> negative;
};

/// Splits a filter; what stands in brackets is never split. Names contain dashes, so the one that
/// begins the negative pieces is the first at the start of the filter or after `*`, `?`, `:` or `]`.
GlobPieces split_globs(std::string_view filter);

/// True if some positive piece matches and no negative one does.
bool filter_matches(std::string_view filter, std::string_view name);

/// glob_match on names of scenes, where a level of a family may be spelt in any way: "grazing@1e-2" is
/// "grazing@0.01".
bool scene_glob_match(std::string_view pattern, std::string_view name);
/// filter_matches on names of scenes, by scene_glob_match.
bool scene_filter_matches(std::string_view filter, std::string_view name);

}  // namespace signorini
