#include "problems/files/gmsh_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "problems/files/text_lines.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

using Tag = std::int64_t;
using Entity = std::pair<int, Tag>;  // dimension and tag, of an entity or of a physical group

constexpr std::string_view kFormat =
    "must be 4.1 0 8: a text file of that version, as gmsh -format msh41 writes it";

struct GivenNode {
  Tag tag = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

// What a file holds; elements name nodes by their place in `nodes`.
struct GivenMesh {
  std::vector<GivenNode> nodes;  // by rising tag
  std::vector<ElementList> solids;
  std::map<std::string, MeshGroup, std::less<>> groups;
};

// The mesh without nodes that no solid has. \throws SceneError for groups that have some
SolidMesh without_loose_nodes(const TextLines& lines, GivenMesh given) {
  if (given.solids.empty())
    lines.refuse("elements", "no solid",
                 "must be tetrahedra or hexahedra: in Gmsh, Mesh 3 and a named physical volume");
  std::vector<int> number(given.nodes.size(), -1);  // among those of solids
  for (const ElementList& elements : given.solids) {
    for (const int node : elements.nodes) number[static_cast<std::size_t>(node)] = 0;
  }
  SolidMesh mesh{.nodes = {}, .solids = std::move(given.solids), .groups = std::move(given.groups)};
  for (std::size_t node = 0; node < number.size(); ++node) {
    if (number[node] < 0) continue;
    number[node] = static_cast<int>(mesh.nodes.size());
    mesh.nodes.push_back(given.nodes[node].place);
  }
  const auto renumber = [&](ElementList& elements, std::string_view of) {
    for (int& node : elements.nodes) {
      const auto place = static_cast<std::size_t>(node);
      node = number[place];
      if (node < 0)
        lines.refuse("group", of,
                     fmt::format("node {} must be one of a solid element", given.nodes[place].tag));
    }
  };
  for (ElementList& elements : mesh.solids) renumber(elements, "solids");
  for (auto& [name, group] : mesh.groups) {
    for (ElementList& elements : group) renumber(elements, one_line(name));
  }
  return mesh;
}

// What stands between the first and the last " of a line; nothing where there are not two.
std::string_view between_quotes(std::string_view text) {
  const std::size_t first = text.find('"'), last = text.rfind('"');
  return first == last ? std::string_view() : text.substr(first + 1, last - first - 1);
}

// What a type of elements that is not read is, and how Gmsh makes others: to end a message with.
std::string unread_shape(std::int64_t type) {
  constexpr std::string_view kPrisms =
      "without Recombine and layers of prisms, Gmsh makes tetrahedra of the volume";
  constexpr std::string_view kIncomplete = "Mesh.SecondOrderIncomplete = 0 makes complete ones";
  struct Unread {
    std::int64_t type;
    std::string_view name, cure;
  };
  constexpr std::array<Unread, 8> kUnread{{{6, "prisms of 6 nodes", kPrisms},
                                           {13, "prisms of 18 nodes", kPrisms},
                                           {18, "prisms of 15 nodes", kPrisms},
                                           {7, "pyramids of 5 nodes", kPrisms},
                                           {14, "pyramids of 14 nodes", kPrisms},
                                           {19, "pyramids of 13 nodes", kPrisms},
                                           {16, "quadrangles of 8 nodes", kIncomplete},
                                           {17, "hexahedra of 20 nodes", kIncomplete}}};
  const auto* const found = std::ranges::find(kUnread, type, &Unread::type);
  if (found != kUnread.end()) return fmt::format("; {} are {}: {}", type, found->name, found->cure);
  return shape_of_gmsh_type(static_cast<int>(type)) != nullptr ? ""
                                                               : "; gmsh -order 2 makes the second degree";
}

[[noreturn]] void refuse_shape(const TextLines& lines, int dimension, std::int64_t type) {
  std::string known;
  for (const ElementShape& shape : element_shapes()) {
    if (shape.dimension == dimension)
      known += fmt::format("{}{} ({})", known.empty() ? "" : ", ", shape.gmsh, shape.name);
  }
  lines.refuse("block of elements",
               fmt::format("word 3, the type of elements, must be one of {}{}", known, unread_shape(type)));
}

void append(const ElementList& elements, MeshGroup& group) {
  const auto same = std::ranges::find(group, elements.shape, &ElementList::shape);
  if (same == group.end())
    group.push_back(elements);
  else
    same->nodes.insert(same->nodes.end(), elements.nodes.begin(), elements.nodes.end());
}

constexpr Tag kLargestTag = std::int64_t{1} << 31U;
constexpr Tag kMostBlocks = 1'000'000;

// A line of $Entities or $PartitionedEntities.
struct EntityLine {
  Tag tag = 0;
  Entity parent{-1, 0};  // what a part of a partition is a part of
  std::vector<Tag> groups = {};
};

// Its tag, a place (of a point) or a box, a number of groups, their tags, and more that is passed over. Of a
// part of a partition the parent, a number of partitions and these stand behind the tag.
EntityLine read_entity(TextLines& lines, int dimension, bool partitioned) {
  lines.expect("entity", 1);
  EntityLine entity{.tag = lines.whole(0, "entity", -kLargestTag, kLargestTag)};
  std::size_t place = dimension == 0 ? 4 : 7;
  if (partitioned) {
    place += 3 + static_cast<std::size_t>(lines.whole(3, "entity", 0, kMostBlocks));
    entity.parent = {static_cast<int>(lines.whole(1, "entity", -1, 3)),
                     lines.whole(2, "entity", -kLargestTag, kLargestTag)};
  }
  const Tag groups = lines.whole(place, "entity", 0, kMostBlocks);
  for (Tag g = 0; g < groups; ++g)
    entity.groups.push_back(
        std::abs(lines.whole(place + 1 + static_cast<std::size_t>(g), "entity", -kLargestTag, kLargestTag)));
  return entity;
}

// The head of $PartitionedEntities.
void pass_over_ghosts(TextLines& lines) {
  lines.expect("count of partitions", 1);
  lines.expect("count of ghosts", 1);
  for (Tag left = lines.whole(0, "count of ghosts", 0, kMostBlocks); left > 0; --left)
    lines.expect("ghost", 2);
}

class GmshReader {
 public:
  GmshReader(std::string_view text, const std::string& name) : lines_(text, name) {}

  SolidMesh read() {
    if (!lines_.next()) lines_.refuse("file", "empty", "must begin with $MeshFormat");
    if (lines_.words()[0] != "$MeshFormat") lines_.refuse("file", "must begin with $MeshFormat");
    read_format();
    while (lines_.next()) {
      const std::string section(lines_.words()[0]);
      if (section.front() != '$') lines_.refuse("line", "must begin a section, as $Nodes does");
      if (!seen_.insert(section).second) lines_.refuse("section", "must be there once");
      if (section == "$PhysicalNames")
        read_names();
      else if (section == "$Entities")
        read_entities(false);
      else if (section == "$PartitionedEntities")
        read_entities(true);
      else if (section == "$Nodes")
        read_nodes();
      else if (section == "$Elements")
        read_elements();
      else
        pass_over(section);
    }
    return without_loose_nodes(lines_, std::move(given_));
  }

 private:
  static constexpr Tag kMostElements = 20'000'000;
  static constexpr std::size_t kMostKept = 200'000'000;  // nodes of elements: 0.8 GB

  void end(std::string_view section) {
    const bool ends = lines_.next() && lines_.words()[0] == section;
    if (!ends) lines_.refuse("line", fmt::format("must be {}", section));
  }

  void read_format() {
    const auto& words = lines_.expect("format", 3);
    if (words[0] != "4.1" || words[1] != "0") lines_.refuse("format", kFormat);
    end("$EndMeshFormat");
  }

  void pass_over(const std::string& section) {
    const std::string last = "$End" + section.substr(1);
    while (lines_.next()) {
      if (lines_.words()[0] == last) return;
    }
    lines_.refuse("section", one_line(section), fmt::format("must end with {}", one_line(last)));
  }

  void read_names() {
    lines_.expect("count of names", 1);
    const Tag count = lines_.whole(0, "count of names", 0, kMostBlocks);
    for (Tag i = 0; i < count; ++i) {
      lines_.expect("name", 3);
      const int dimension = static_cast<int>(lines_.whole(0, "name", 0, 3));
      const Tag tag = lines_.whole(1, "name", 1, kLargestTag);
      constexpr std::size_t kLongest = 127;
      const std::string_view name = between_quotes(lines_.line());
      if (name.empty() || name.size() > kLongest || has_control_characters(name))
        lines_.refuse(
            "name",
            fmt::format("must stand in \"\", of at most {} bytes, without control characters", kLongest));
      names_[{dimension, tag}] = name;
    }
    end("$EndPhysicalNames");
  }

  // Of a partition, a part is in the groups of what it is a part of too.
  void read_entities(bool partitioned) {
    if (partitioned) pass_over_ghosts(lines_);
    std::array<Tag, 4> counts{};
    lines_.expect("counts of entities", 4);
    for (std::size_t d = 0; d < 4; ++d) counts[d] = lines_.whole(d, "counts of entities", 0, kMostBlocks);
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (Tag i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
        const EntityLine entity = read_entity(lines_, dimension, partitioned);
        std::set<std::string_view>& named = groups_of_[{dimension, entity.tag}];
        const auto parent = groups_of_.find(entity.parent);
        if (entity.parent.first == dimension && parent != groups_of_.end())
          named.insert(parent->second.begin(), parent->second.end());
        for (const Tag group : entity.groups) named.insert(name_of_group(dimension, group));
      }
    }
    end(partitioned ? "$EndPartitionedEntities" : "$EndEntities");
  }

  // A group without a name is called by its number.
  std::string_view name_of_group(int dimension, Tag group) {
    return names_.try_emplace({dimension, group}, std::to_string(group)).first->second;
  }

  void read_nodes();

  void read_elements() {
    if (!seen_.contains("$Nodes")) lines_.refuse("section", "must come after $Nodes");
    lines_.expect("counts of elements", 4);
    const Tag blocks = lines_.whole(0, "counts of elements", 0, kMostBlocks);
    Tag left = lines_.whole(1, "counts of elements", 0, kMostElements);
    for (Tag block = 0; block < blocks; ++block) {
      lines_.expect("block of elements", 4);
      const Entity entity{static_cast<int>(lines_.whole(0, "block of elements", 0, 3)),
                          lines_.whole(1, "block of elements", -kLargestTag, kLargestTag)};
      const Tag inside = lines_.whole(3, "block of elements", 0, left);
      left -= inside;
      read_block(entity, inside);
    }
    if (left > 0)
      lines_.refuse("elements", fmt::format("{} too few", left), "must be as many as their count says");
    end("$EndElements");
  }

  void read_block(const Entity& entity, Tag inside) {
    const Tag type = lines_.whole(2, "block of elements", 1, std::numeric_limits<int>::max());
    const ElementShape* shape = shape_of_gmsh_type(static_cast<int>(type));
    const auto named = groups_of_.find(entity);
    const bool solid = entity.first == 3;
    const bool kept = solid || (named != groups_of_.end() && !named->second.empty());
    if (kept && (shape == nullptr || shape->dimension != entity.first))
      refuse_shape(lines_, entity.first, type);
    ElementList elements{.shape = shape};
    for (Tag i = 0; i < inside; ++i) {
      lines_.expect("element", 2);
      if (!kept) continue;
      const auto nodes = static_cast<std::size_t>(shape->nodes);
      if (lines_.words().size() != 1 + nodes)
        lines_.refuse("element", fmt::format("must be its tag and {} nodes", nodes));
      for (std::size_t n = 1; n <= nodes; ++n) elements.nodes.push_back(node_at(n));
    }
    if (!kept || elements.nodes.empty()) return;
    if (solid)
      keep(elements, given_.solids);
    else
      for (const std::string_view group : named->second) keep(elements, given_.groups[std::string(group)]);
  }

  // An entity may be in many groups, each of which gets its elements.
  void keep(const ElementList& elements, MeshGroup& group) {
    kept_ += elements.nodes.size();
    if (kept_ > kMostKept)
      lines_.refuse("elements", fmt::format("{} nodes so far, in all groups", kept_),
                    fmt::format("must have at most {}", kMostKept));
    append(elements, group);
  }

  // Place among given_.nodes of the node whose tag is a word of the line.
  [[nodiscard]] int node_at(std::size_t word) const {
    const Tag tag = lines_.whole(word, "element", 1, kLargestTag);
    const auto found = std::ranges::lower_bound(given_.nodes, tag, {}, &GivenNode::tag);
    if (found == given_.nodes.end() || found->tag != tag)
      lines_.refuse("element", fmt::format("word {} must be the tag of a node", word + 1));
    return static_cast<int>(found - given_.nodes.begin());
  }

  TextLines lines_;
  std::set<std::string> seen_;  // sections
  std::map<Entity, std::string> names_;
  std::map<Entity, std::set<std::string_view>> groups_of_;  // of each entity, names in names_
  std::size_t kept_ = 0;                                    // nodes of elements, in all groups
  GivenMesh given_;
};

void GmshReader::read_nodes() {
  lines_.expect("counts of nodes", 4);
  const Tag blocks = lines_.whole(0, "counts of nodes", 0, kMostBlocks);
  const Tag count = lines_.whole(1, "counts of nodes", 0, kMostMeshNodes);
  for (Tag block = 0; block < blocks; ++block) {
    lines_.expect("block of nodes", 4);
    const Tag inside = lines_.whole(3, "block of nodes", 0, count - std::ssize(given_.nodes));
    const std::size_t first = given_.nodes.size();
    for (Tag i = 0; i < inside; ++i) {
      lines_.expect("node", 1);
      given_.nodes.push_back(GivenNode{.tag = lines_.whole(0, "node", 1, kLargestTag)});
    }
    for (Tag i = 0; i < inside; ++i) {
      lines_.expect("place of a node", 3);
      for (std::size_t a = 0; a < 3; ++a)
        given_.nodes[first + static_cast<std::size_t>(i)].place[static_cast<Eigen::Index>(a)] =
            lines_.finite(a, "place of a node");
    }
  }
  if (std::ssize(given_.nodes) != count)
    lines_.refuse("nodes", fmt::format("{}", given_.nodes.size()), fmt::format("must be {}", count));
  std::ranges::sort(given_.nodes, {}, &GivenNode::tag);
  const auto twin = std::ranges::adjacent_find(given_.nodes, {}, &GivenNode::tag);
  if (twin != given_.nodes.end()) lines_.refuse("node", fmt::format("{}", twin->tag), "must be given once");
  end("$EndNodes");
}

}  // namespace

SolidMesh read_gmsh_mesh(std::string_view text, const std::string& name) {
  return GmshReader(text, name).read();
}

}  // namespace signorini
