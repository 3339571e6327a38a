#include "problems/scene_matrices.hpp"

#include "problems/scene_family.hpp"
#include "problems/scene_field.hpp"
#include "problems/toml_tree.hpp"

namespace signorini {

std::vector<std::filesystem::path> matrix_files(std::string_view text, const std::string& name,
                                                std::string_view level) {
  TomlNode document = parse_toml(text);
  choose_level(document, name, level);
  const SceneField system = SceneField(document, name)["system"];
  std::vector<std::filesystem::path> files;
  if (system["kind"].text("must be a kind of system") != "matrices") return files;
  const std::filesystem::path folder = std::filesystem::path(name).parent_path();
  for (const char* matrix : {"mass", "damping", "stiffness"}) {
    if (system[matrix].given()) files.push_back(folder / system[matrix].text("must be the name of a file"));
  }
  return files;
}

}  // namespace signorini
