#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <limits>

#include "harness/extend/plugins/command_method.hpp"
#include "harness/extend/plugins/curve_exchange.hpp"
#include "harness/files.hpp"
#include "harness/text/words.hpp"
#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_field.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

constexpr int kMost = std::numeric_limits<int>::max();

struct LawOnScene {
  const RepresentedLaws& laws;
  std::optional<RepresentedLaw> operator()(std::monostate) const {
    return laws.no_contact ? std::optional<RepresentedLaw>(std::monostate{}) : std::nullopt;
  }
  std::optional<RepresentedLaw> operator()(const Penalty& law) const {
    return laws.penalty ? std::optional<RepresentedLaw>(law) : std::nullopt;
  }
  std::optional<RepresentedLaw> operator()(Massless law) const {
    return laws.massless ? std::optional<RepresentedLaw>(law) : std::nullopt;
  }
  std::optional<RepresentedLaw> operator()(const Restitution& law) const {
    if (std::holds_alternative<RepresentedLaws::SceneRestitution>(laws.restitution)) return law;
    if (std::holds_alternative<Undetermined>(laws.restitution)) return Undetermined{};
    if (const auto* own = std::get_if<Restitution>(&laws.restitution)) return *own;
    return std::nullopt;
  }
  std::optional<RepresentedLaw> operator()(const MixedLaws& mixed) const {
    if (!laws.mixed) return std::nullopt;
    MixedLaws own;
    for (const ContactLaw& one : mixed.laws) {
      if (std::holds_alternative<Spring>(one) ? !laws.penalty
                                              : std::holds_alternative<Massless>(one) && !laws.massless)
        return std::nullopt;
      own.laws.push_back(one);
      const auto* restitution = std::get_if<Restitution>(&one);
      if (restitution == nullptr) continue;
      const auto represented = (*this)(*restitution);
      if (!represented || std::holds_alternative<Undetermined>(*represented)) return represented;
      own.laws.back() = std::get<Restitution>(*represented);
    }
    return own;
  }
};

/// The program as it can be run: a file of the folder, or found on the PATH by its name.
std::string runnable(const std::string& program, const fs::path& folder) {
  if (program.empty()) return {};
  const auto can_run = [](const fs::path& file) {
    std::error_code none;
    return fs::is_regular_file(file, none) && access(file.c_str(), X_OK) == 0;
  };
  if (program.find('/') != std::string::npos || can_run(folder / program)) {
    const fs::path file = folder / program;
    return can_run(file) ? file.string() : "";
  }
  const auto holds_it = [&](const std::string& place) { return can_run(fs::path(place) / program); };
  return std::ranges::any_of(folders_of("PATH"), holds_it) ? program : std::string();
}

/// Reads `command` and `files`; `hashed` takes the bytes of every file that answers may depend on.
std::vector<std::string> read_words(const SceneField& root, const fs::path& folder, std::string& hashed) {
  constexpr const char* kWords = "must be a list of words: a program and its arguments";
  std::error_code none;
  std::vector<std::string> words;
  for (const SceneField& item : root["command"].items(kWords)) {
    std::string word = item.text(kWords);
    if (words.empty()) {
      const std::string program = runnable(word, folder);
      if (program.empty()) item.refuse("must be a program on the PATH, or one in the folder of this file");
      word = program;
    } else if (!word.empty() && fs::is_regular_file(folder / word, none)) {
      word = (folder / word).string();
    }
    if (word.find('/') != std::string::npos && fs::is_regular_file(word, none))
      hashed += "\n" + sha256_of_file(word);
    words.push_back(std::move(word));
  }
  if (!root["files"].given()) return words;
  for (const SceneField& item : root["files"].items("must be a list of files")) {
    const fs::path file = folder / item.text("must be a file in the folder of this file");
    if (!fs::is_regular_file(file, none)) item.refuse("must be a file in the folder of this file");
    hashed += "\n" + sha256_of_file(file);
  }
  return words;
}

/// Reads `branches`, with which nothing is run.
std::shared_ptr<const std::vector<ExchangedBranch>> read_recorded(const SceneField& root,
                                                                  const fs::path& folder,
                                                                  std::string& hashed) {
  constexpr const char* kFile = "must be a file in the folder of this file, a branch per line";
  for (const char* key : {"command", "persistent", "curves", "option"}) {
    if (root[key].given()) root[key].refuse("must be left out beside branches: nothing is run");
  }
  const fs::path file = folder / root["branches"].text(kFile);
  if (!fs::is_regular_file(file)) root["branches"].refuse(kFile);
  hashed += "\n" + sha256_of_file(file);
  return std::make_shared<const std::vector<ExchangedBranch>>(read_branches(file));
}

OptionValue read_preset(const SceneField& field) {
  constexpr const char* kPreset = "must be true or false, a finite number or a word";
  if (!field.given()) field.refuse(kPreset);
  if (const bool* flag = std::get_if<bool>(&field.node().value)) return *flag;
  if (std::holds_alternative<std::string>(field.node().value)) return field.text(kPreset);
  if (std::holds_alternative<std::int64_t>(field.node().value)) {
    return static_cast<long>(field.whole("must be a whole number of at most ten digits", -kMost, kMost));
  }
  return field.number(kPreset);
}

CommandOption read_option(const SceneField& field) {
  field.allow_only({"name", "default", "unit", "meaning", "least", "most", "choices"}, "must be a table");
  CommandOption option{.name = field["name"].text("must be a name"),
                       .value = read_preset(field["default"]),
                       .unit = field["unit"].text("must be a unit in brackets, as [N/m], or [-]"),
                       .meaning = field["meaning"].text("must be one line of text")};
  const std::string& unit = option.unit;
  if (!unit.starts_with('[') || !unit.ends_with(']'))
    field["unit"].refuse("must be a unit in brackets, as [N/m], or [-]");
  if (option.name.empty() || option.name.find_first_of("=,|[] ") != std::string::npos)
    field["name"].refuse("must be a name without =,|[] and blanks");
  if (option.meaning.empty()) field["meaning"].refuse("must be one line of text");
  const bool number =
      std::holds_alternative<long>(option.value) || std::holds_alternative<double>(option.value);
  const bool word = std::holds_alternative<std::string>(option.value);
  if (field["least"].given()) option.least = field["least"].number("must be a finite number");
  if (field["most"].given()) option.most = field["most"].number("must be a finite number");
  if (!number && option.least) field["least"].refuse("must be left out unless the default is a number");
  if (!number && option.most) field["most"].refuse("must be left out unless the default is a number");
  if (!field["choices"].given()) return option;
  if (!word) field["choices"].refuse("must be left out unless the default is a word");
  for (const SceneField& item : field["choices"].items("must be a list of words"))
    option.choices.push_back(item.text("must be a list of words"));
  return option;
}

/// True for "scene", false for what is left out.
bool represents_scene(const SceneField& field) {
  if (!field.given()) return false;
  if (field.text("must be \"scene\", or left out") != "scene") field.refuse("must be \"scene\", or left out");
  return true;
}

RepresentedLaws read_represented(const SceneField& field) {
  constexpr const char* kRestitution = "must be a number in 0..1, \"scene\" or \"undetermined\"";
  field.allow_only({"restitution", "penalty", "massless", "mixed", "no_contact"},
                   "must be a table of the laws that the answers obey");
  RepresentedLaws laws{.penalty = represents_scene(field["penalty"]),
                       .massless = represents_scene(field["massless"]),
                       .mixed = represents_scene(field["mixed"]),
                       .no_contact = represents_scene(field["no_contact"])};
  const SceneField restitution = field["restitution"];
  if (!restitution.given()) return laws;
  if (!std::holds_alternative<std::string>(restitution.node().value)) {
    const double e = restitution.number(kRestitution, 0.0);
    if (e > 1.0) restitution.refuse(kRestitution);
    laws.restitution = Restitution{e};
    return laws;
  }
  const std::string word = restitution.text(kRestitution);
  if (word != "scene" && word != "undetermined") restitution.refuse(kRestitution);
  if (word == "scene") laws.restitution = RepresentedLaws::SceneRestitution{};
  if (word == "undetermined") laws.restitution = Undetermined{};
  return laws;
}

std::optional<int> read_limit(const SceneField& field) {
  if (!field.given()) return std::nullopt;
  return field.whole("must be a whole number, 1 or more", 1, kMost);
}

}  // namespace

std::optional<RepresentedLaw> RepresentedLaws::on(const Law& scene) const {
  return std::visit(LawOnScene{*this}, scene);
}

std::string RepresentedLaws::text() const {
  std::vector<std::string> texts;
  if (std::holds_alternative<SceneRestitution>(restitution)) texts.emplace_back("restitution 0..1");
  if (const auto* own = std::get_if<Restitution>(&restitution))
    texts.push_back(fmt::format("restitution {:g}", own->e));
  if (std::holds_alternative<Undetermined>(restitution)) texts.emplace_back("restitution undetermined");
  if (penalty) texts.emplace_back("penalty");
  if (massless) texts.emplace_back("massless");
  if (mixed) texts.emplace_back("mixed");
  if (texts.empty()) texts.emplace_back("none: scenes without contact only");
  return joined(texts, ", ");
}

CommandDescription read_command_file(const fs::path& file) {
  const std::string text = read_file(file, kLargestScene);
  const std::string name = file.string();
  const TomlNode document = parse_toml(text, name);
  const SceneField root(document, name);
  static_cast<void>(root["schema"].whole("must be 1", 1, 1));  // first: another schema may have other keys
  root.allow_only({"schema", "name", "title", "ladder", "command", "files", "persistent", "curves",
                   "branches", "most_coordinates", "most_contacts", "represents", "option"},
                  "must be a table");
  CommandDescription description;
  std::string hashed = text;
  description.name = root["name"].text("must be a name in lower-kebab-case");
  description.title = root["title"].text("must be one line of text");
  description.ladder = root["ladder"].text("must look like key=value|value");
  if (root["branches"].given())
    description.branches = read_recorded(root, file.parent_path(), hashed);
  else
    description.words = read_words(root, file.parent_path(), hashed);
  description.represents = read_represented(root["represents"]);
  if (root["option"].given()) {
    for (const SceneField& item : root["option"].items("must be tables [[option]]")) {
      CommandOption option = read_option(item);
      const auto same = [&](const CommandOption& known) { return known.name == option.name; };
      if (std::ranges::any_of(description.options, same)) item["name"].refuse("must be declared once");
      description.options.push_back(std::move(option));
    }
  }
  const auto flag = [&](const char* key) {
    return root[key].given() && root[key].truth("must be true or false");
  };
  description.persistent = flag("persistent");
  description.curves = flag("curves");
  description.most_coordinates = read_limit(root["most_coordinates"]);
  description.most_contacts = read_limit(root["most_contacts"]);
  description.sha256 = sha256(hashed);
  return description;
}

}  // namespace signorini
