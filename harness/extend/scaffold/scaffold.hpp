#pragma once
// The files that `signorini new` writes, all of them known before the first is written.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

struct ScaffoldFile {
  std::filesystem::path path = {};
  std::string text = {};
};

/// Files that are new, and one that changes.
struct Scaffold {
  std::vector<ScaffoldFile> fresh = {};
  std::vector<ScaffoldFile> changed = {};
  std::vector<std::string> next = {};  ///< the user's next steps, a command or a sentence each
};

/// A method as all those of the tree are: methods/NAME with header, source, build and page,
/// tests/methods/NAME with a test and its build, and two lines in methods/catalogue.cpp. \throws UsageError
/// for a bad name, or one that a method, a folder or a class already has
Scaffold method_in_tree(std::string_view name, const std::filesystem::path& tree);

/// A method in the folder `parent`/NAME that is built as a plugin against an installed signorini.
/// \throws UsageError for a bad name, or if something is there already
Scaffold method_out_of_tree(std::string_view name, const std::filesystem::path& parent);

/// A scene in the catalogue of a tree. \throws UsageError for a bad name, or one that is taken
Scaffold scene_in_tree(std::string_view name, const std::filesystem::path& tree);

/// A scene NAME.toml in `folder`. \throws UsageError for a bad name, or one that is taken
Scaffold scene_out_of_tree(std::string_view name, const std::filesystem::path& folder);

/// Writes the files, or none of them: removes those written if one cannot be. \throws
/// std::filesystem::filesystem_error
void write_scaffold(const Scaffold& scaffold);

}  // namespace signorini
