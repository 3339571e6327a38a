#pragma once
// The files that `signorini new` writes, all of them known before the first is written: templates whose
// places are filled with the spellings of a name.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

/// A method in the folder `parent`/NAME that is a Python function, with its description. \throws UsageError
/// for a bad name, or if something is there already
Scaffold method_in_python(std::string_view name, const std::filesystem::path& parent);

/// A scene in the catalogue of a tree. \throws UsageError for a bad name, or one that is taken
Scaffold scene_in_tree(std::string_view name, const std::filesystem::path& tree);

/// A scene NAME.toml in `folder`. \throws UsageError for a bad name, or one that is taken
Scaffold scene_out_of_tree(std::string_view name, const std::filesystem::path& folder);

/// Writes the files, or none of them: removes those written if one cannot be. \throws
/// std::filesystem::filesystem_error
void write_scaffold(const Scaffold& scaffold);

// The files below templates/.
extern const std::string_view kMethodHeaderTemplate;
extern const std::string_view kMethodSourceTemplate;
extern const std::string_view kMethodTestTemplate;
extern const std::string_view kMethodTestBuildTemplate;
extern const std::string_view kMethodBuildTemplate;
extern const std::string_view kMethodPageTemplate;
extern const std::string_view kPluginBuildTemplate;
extern const std::string_view kPluginPageTemplate;
extern const std::string_view kPythonMethodTemplate;
extern const std::string_view kPythonDescriptionTemplate;
extern const std::string_view kPythonPageTemplate;
extern const std::string_view kSceneTemplate;

/// The text for each `{{place}}`.
using Places = std::vector<std::pair<std::string, std::string>>;

/// The template with every `{{place}}` filled and one line break at its end. Precondition: each place has a
/// value.
std::string filled(std::string_view text, const Places& places);

/// "my-method", the name; "my_method", its folder and files; "MyMethod", its class.
struct Spellings {
  std::string name = {};
  std::string folder = {};
  std::string type = {};
};

/// \throws UsageError unless the name is in lower-kebab-case, begins with a letter and has at most 60
/// characters
Spellings spellings_of(std::string_view name);

/// The folder itself or the nearest above it that holds methods/catalogue.cpp; empty if there is none.
std::optional<std::filesystem::path> find_tree(const std::filesystem::path& folder);

/// The header of problems/, methods/ or harness/ that declares a class, struct or alias of that name, if any.
std::optional<std::filesystem::path> header_declaring(const std::filesystem::path& tree,
                                                      const std::string& type);

/// The text of methods/catalogue.cpp with a method's class `type` in methods/`folder`: the include, in its
/// alphabetical place, and the entry, at the end of the list: two lines more. \throws UsageError if it has no
/// list of entries
std::string with_entry(const std::string& catalogue, const std::string& folder, const std::string& type);

}  // namespace signorini
