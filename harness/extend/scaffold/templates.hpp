#pragma once
// The files below templates/ as strings, and how their places are filled.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace signorini {

extern const std::string_view kMethodHeaderTemplate;
extern const std::string_view kMethodSourceTemplate;
extern const std::string_view kMethodTestTemplate;
extern const std::string_view kMethodTestBuildTemplate;
extern const std::string_view kMethodBuildTemplate;
extern const std::string_view kMethodPageTemplate;
extern const std::string_view kPluginBuildTemplate;
extern const std::string_view kPluginPageTemplate;
extern const std::string_view kSceneTemplate;

/// The text for each `{{place}}`.
using Places = std::vector<std::pair<std::string, std::string>>;

/// The template with every `{{place}}` filled and one line break at its end. Precondition: each place has a
/// value.
std::string filled(std::string_view text, const Places& places);

}  // namespace signorini
