#pragma once
// The command line described for shells and for man, from what CLI11 knows of it: it cannot go stale.

#include <string>

namespace CLI {
class App;
}

namespace signorini {

/// A script for bash that completes commands and options, file names elsewhere.
std::string bash_completion(const CLI::App& app);

/// The same for zsh, with descriptions.
std::string zsh_completion(const CLI::App& app);

/// A page for man, section 1.
std::string man_page(const CLI::App& app, const std::string& version);

}  // namespace signorini
