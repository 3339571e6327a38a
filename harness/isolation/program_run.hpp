#pragma once
// A program of the machine that is run to its end, without a shell.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace signorini {

/// Runs a program that is looked for in $PATH, in a folder, and waits for its end. What it writes to standard
/// error becomes the file `log` of the folder, which must not be there: no link is followed.
/// \param words  its name and its arguments
/// \return its exit code, -1 where a signal ended it; nothing if there is none of that name
/// \throws MachineFull where the machine cannot start it
std::optional<int> run_to_end(std::vector<std::string> words, const std::filesystem::path& folder,
                              const std::string& log);

}  // namespace signorini
