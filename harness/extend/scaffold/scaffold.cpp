#include "harness/extend/scaffold/scaffold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <initializer_list>
#include <system_error>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "methods/catalogue.hpp"
#include "problems/files/kebab_case.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_name(std::string_view name, const std::string& requirement) {
  throw UsageError("name = {} ({})", name, requirement);
}

void require_no_such_method(std::string_view name) {
  for (const MethodEntry& entry : method_catalogue()) {
    if (entry.name == name) refuse_name(name, "must be new: a method has this name");
  }
}

void require_nothing_at(std::string_view name, const fs::path& path) {
  if (fs::exists(path)) refuse_name(name, fmt::format("must be new: {} is there already", path.string()));
}

Places places_of(const Spellings& spellings, const std::string& include, const std::string& plugin_include,
                 const std::string& plugin_entry) {
  return {{"name", spellings.name}, {"folder", spellings.folder},       {"Class", spellings.type},
          {"include", include},     {"plugin_include", plugin_include}, {"plugin_entry", plugin_entry}};
}

/// Names of files in a folder, and what each is filled in from.
using Templates = std::initializer_list<std::pair<std::string, std::string_view>>;

void add_files(Scaffold& scaffold, const fs::path& folder, const Templates& templates, const Places& places) {
  for (const auto& [file, text] : templates)
    scaffold.fresh.push_back({.path = folder / file, .text = filled(text, places)});
}

/// A method in a new folder of its own, beside no tree.
Scaffold method_in_folder(std::string_view name, const fs::path& folder, const Templates& templates,
                          const Places& places) {
  require_no_such_method(name);
  require_nothing_at(name, folder);
  Scaffold scaffold;
  add_files(scaffold, folder, templates, places);
  scaffold.next = {fmt::format("see {}", (folder / "README.md").string())};
  return scaffold;
}

/// Makes a folder and those above it that are missing; `made` gets those that were.
void make_folders(const fs::path& folder, std::vector<fs::path>& made) {
  if (folder.empty() || fs::exists(folder)) return;
  make_folders(folder.parent_path(), made);
  fs::create_directory(folder);
  made.push_back(folder);
}

constexpr std::size_t kLongest = 60;

bool is_small(char letter) { return letter >= 'a' && letter <= 'z'; }

}  // namespace

Scaffold method_in_tree(std::string_view name, const fs::path& tree) {
  const Spellings spellings = spellings_of(name);
  require_no_such_method(name);
  const fs::path folder = tree / "methods" / spellings.folder, catalogue = tree / "methods" / "catalogue.cpp";
  const fs::path tests = tree / "tests" / "methods" / spellings.folder;
  require_nothing_at(name, folder);
  require_nothing_at(name, tests);
  if (const auto header = header_declaring(tree, spellings.type))
    refuse_name(name, fmt::format("must give a class name that is free: {} declares {}", header->string(),
                                  spellings.type));
  const Places places = places_of(spellings, fmt::format("methods/{0}/{0}.hpp", spellings.folder), "", "");
  Scaffold scaffold;
  add_files(scaffold, folder,
            {{spellings.folder + ".hpp", kMethodHeaderTemplate},
             {spellings.folder + ".cpp", kMethodSourceTemplate},
             {"CMakeLists.txt", kMethodBuildTemplate},
             {"README.md", kMethodPageTemplate}},
            places);
  add_files(
      scaffold, tests,
      {{spellings.folder + "_test.cpp", kMethodTestTemplate}, {"CMakeLists.txt", kMethodTestBuildTemplate}},
      places);
  scaffold.changed.push_back(
      {.path = catalogue, .text = with_entry(read_file(catalogue), spellings.folder, spellings.type)});
  scaffold.next = {
      fmt::format("cmake --build build/release --target signorini test_method_{}", spellings.folder),
      fmt::format("ctest --test-dir build/release -R {}", spellings.type),
      fmt::format("build/release/harness/signorini check {}", spellings.name)};
  return scaffold;
}

Scaffold method_out_of_tree(std::string_view name, const fs::path& parent) {
  const Spellings spellings = spellings_of(name);
  return method_in_folder(
      name, parent / spellings.name,
      {{spellings.folder + ".hpp", kMethodHeaderTemplate},
       {spellings.folder + ".cpp", kMethodSourceTemplate},
       {"CMakeLists.txt", kPluginBuildTemplate},
       {"README.md", kPluginPageTemplate}},
      places_of(spellings, spellings.folder + ".hpp", "#include \"methods/plugin/plugin.hpp\"\n",
                fmt::format("\nSIGNORINI_PLUGIN(signorini::{})\n", spellings.type)));
}

Scaffold method_in_python(std::string_view name, const fs::path& parent) {
  const Spellings spellings = spellings_of(name);
  return method_in_folder(name, parent / spellings.name,
                          {{spellings.folder + ".py", kPythonMethodTemplate},
                           {spellings.name + ".toml", kPythonDescriptionTemplate},
                           {"README.md", kPythonPageTemplate}},
                          {{"name", spellings.name}, {"folder", spellings.folder}});
}

Scaffold scene_in_tree(std::string_view name, const fs::path& tree) {
  const fs::path problems = tree / "problems";
  Scaffold scaffold = scene_out_of_tree(name, problems / "catalogue");
  require_nothing_at(name, problems / "families" / (std::string(name) + ".toml"));
  scaffold.next = {fmt::format("build/release/harness/signorini show {}", name),
                   fmt::format("build/release/harness/signorini solve {} --method exact-orbit", name),
                   fmt::format("build/release/harness/signorini verify --update --scenes {}", name)};
  return scaffold;
}

Scaffold scene_out_of_tree(std::string_view name, const fs::path& folder) {
  const Spellings spellings = spellings_of(name);
  require_no_such_method(name);  // `show NAME` would mean either
  const fs::path file = folder / (spellings.name + ".toml");
  require_nothing_at(name, file);
  Scaffold scaffold;
  scaffold.fresh.push_back({.path = file, .text = filled(kSceneTemplate, {{"name", spellings.name}})});
  scaffold.next = {fmt::format("signorini show {}", file.string()),
                   fmt::format("signorini solve {} --method exact-orbit", file.string())};
  return scaffold;
}

void write_scaffold(const Scaffold& scaffold) {
  std::vector<fs::path> made;
  try {
    for (const ScaffoldFile& file : scaffold.fresh) {
      make_folders(file.path.parent_path(), made);
      made.push_back(file.path);
      write_whole(file.path, file.text);
    }
    for (const ScaffoldFile& file : scaffold.changed) write_whole(file.path, file.text);
  } catch (const std::exception&) {
    std::error_code ignored;
    for (auto path = made.rbegin(); path != made.rend(); ++path) fs::remove(*path, ignored);
    throw;
  }
}

std::string filled(std::string_view text, const Places& places) {
  std::string result;
  while (!text.empty()) {
    const std::size_t open = text.find("{{");
    result += text.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find("}}", open);
    const std::string_view name = text.substr(open + 2, close - open - 2);
    const auto place = std::ranges::find_if(places, [&](const auto& one) { return one.first == name; });
    assert(place != places.end());
    result += place->second;
    text.remove_prefix(close + 2);
  }
  while (result.ends_with("\n\n")) result.pop_back();
  return result;
}

Spellings spellings_of(std::string_view name) {
  if (!is_lower_kebab_case(name) || name.size() > kLongest || !is_small(name.front())) {
    throw UsageError(
        "name = {} (must be lower-kebab-case such as my-method, beginning with a letter, at most "
        "{} characters)",
        name, kLongest);
  }
  Spellings spellings{.name = std::string(name), .folder = std::string(name), .type = {}};
  std::ranges::replace(spellings.folder, '-', '_');
  bool begins = true;
  for (const char letter : name) {
    if (letter != '-')
      spellings.type += begins && is_small(letter) ? static_cast<char>(letter - 'a' + 'A') : letter;
    begins = letter == '-';
  }
  return spellings;
}

}  // namespace signorini
