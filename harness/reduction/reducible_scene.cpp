#include "harness/reduction/reducible_scene.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "problems/matrix_properties.hpp"
#include "problems/scene/scene_family.hpp"
#include "problems/scene/scene_field.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini {

namespace {

/// The entry of that name; null where there is none.
TomlEntry* entry_of(TomlNode* table, std::string_view key) {
  auto* entries = table == nullptr ? nullptr : std::get_if<TomlTable>(&table->value);
  if (entries == nullptr) return nullptr;
  for (TomlEntry& entry : *entries)
    if (entry.key == key) return &entry;
  return nullptr;
}

/// Damping ratios taken out of a document, and where they stood.
struct TakenRatios {
  TomlNode value;
  std::string path;
};

/// Puts no damping in the place of damping ratios, of matrices an entry beside `mass` and `stiffness`, else
/// one of the table `damping`. None where they do not stand there alone: the reader of scenes says what is
/// wrong.
std::optional<TakenRatios> take_ratios(TomlNode& document) {
  TomlEntry* system = entry_of(&document, "system");
  if (system == nullptr) return std::nullopt;
  const TomlNode* kind = system->value.find("kind");
  const auto* word = kind == nullptr ? nullptr : std::get_if<std::string>(&kind->value);
  const TomlTable none{{.key = "alpha", .line = system->line, .value = {.line = system->line, .value = 0.0}}};
  TomlEntry* damping = entry_of(&system->value, "damping");
  if (word != nullptr && *word == "matrices") {
    TomlEntry* modal = entry_of(&system->value, "modal");
    if (modal == nullptr || damping != nullptr || system->value.find("rayleigh") != nullptr)
      return std::nullopt;
    modal->key = "rayleigh";
    return TakenRatios{std::exchange(modal->value, {.line = modal->line, .value = none}), "system.modal"};
  }
  TomlEntry* modal = damping == nullptr ? nullptr : entry_of(&damping->value, "modal");
  if (modal == nullptr || std::get<TomlTable>(damping->value.value).size() > 1) return std::nullopt;
  return TakenRatios{std::exchange(*modal, none.front()).value, "system.damping.modal"};
}

}  // namespace

ReducibleScene read_reducible(const SceneSource& source) {
  const std::string file = source.file.string();
  TomlNode document = parse_toml(read_scene_text(source.file), file);
  const SceneVariant variant = choose_variant(document, file, source.level);
  const std::optional<TakenRatios> taken = take_ratios(document);
  ReducibleScene scene{.problem = read_scene_document(document, file, variant).problem};
  if (!taken) return scene;
  const SceneField field = SceneField(taken->value, file).named(taken->path);
  scene.ratios = read_modal(field, scene.problem.size(), std::numeric_limits<int>::max()).ratios;
  if (largest_entry(scene.problem.damping()) > 0.0)
    field.refuse("must be absent beside dampers in a structure that is to be reduced");
  if (*std::ranges::max_element(scene.ratios) == 0.0) scene.ratios.clear();
  return scene;
}

}  // namespace signorini
