#include <fmt/format.h>

#include <cctype>

#include "harness/extend/scaffold/scaffold.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

using TextLine = std::vector<std::string>::const_iterator;

/// Before the first include of a method that comes later in the alphabet, else behind the last.
TextLine place_of_include(const std::vector<std::string>& lines, const std::string& include) {
  TextLine place = lines.end();
  for (auto line = lines.begin(); line != lines.end(); ++line) {
    if (!line->starts_with("#include \"methods/") || *line == "#include \"methods/catalogue.hpp\"") continue;
    if (*line > include) return line;
    place = line + 1;
  }
  return place;
}

/// Behind the last entry.
TextLine place_of_entry(const std::vector<std::string>& lines) {
  TextLine place = lines.end();
  for (auto line = lines.begin(); line != lines.end(); ++line) {
    if (line->find("method_entry<") != std::string::npos && line->ends_with(',')) place = line + 1;
  }
  return place;
}

/// Whether the text holds this word or these words, with no letter before or after them.
bool holds_words(const std::string& text, const std::string& words) {
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
    const std::size_t end = at + words.size();
    if ((at == 0 || !is_letter(text[at - 1])) && (end == text.size() || !is_letter(text[end]))) return true;
  }
  return false;
}

/// Whether a source declares a type of this name.
bool declares(const std::string& source, const std::string& type) {
  return holds_words(source, "class " + type) || holds_words(source, "struct " + type) ||
         holds_words(source, "using " + type);
}

}  // namespace

std::optional<fs::path> find_tree(const fs::path& folder) {
  for (fs::path tree = fs::absolute(folder).lexically_normal();; tree = tree.parent_path()) {
    if (fs::is_regular_file(tree / "methods" / "catalogue.cpp")) return tree;
    if (tree == tree.parent_path()) return std::nullopt;
  }
}

std::optional<fs::path> header_declaring(const fs::path& tree, const std::string& type) {
  for (const char* part : {"problems", "methods", "harness"}) {
    if (!fs::is_directory(tree / part)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tree / part)) {
      if (entry.path().extension() == ".hpp" && declares(read_file(entry.path()), type))
        return fs::relative(entry.path(), tree);
    }
  }
  return std::nullopt;
}

std::string with_entry(const std::string& catalogue, const std::string& folder, const std::string& type) {
  std::vector<std::string> lines = split(catalogue, '\n');
  const std::string include = fmt::format("#include \"methods/{0}/{0}.hpp\"", folder);
  const TextLine entry_place = place_of_entry(lines);
  if (entry_place == lines.end())
    throw UsageError(
        "catalogue = methods/catalogue.cpp (must list methods as method_entry<Class>(), one per line)");
  // The entry first: it stands below the include, whose place stays the same.
  const std::string& neighbour = *(entry_place - 1);
  const std::string indent = neighbour.substr(0, neighbour.find_first_not_of(' '));
  lines.insert(entry_place, fmt::format("{}method_entry<{}>(),", indent, type));
  lines.insert(place_of_include(lines, include), include);
  return joined(lines, "\n") + (catalogue.ends_with('\n') ? "" : "\n");
}

}  // namespace signorini
