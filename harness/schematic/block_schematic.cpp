// Blocks and meshes of solids, in oblique projection: x to the right, y into the paper, z upwards.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <complex>
#include <functional>
#include <map>

#include "harness/schematic/boundary.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/schematic/sharp_edges.hpp"
#include "harness/schematic/symbols.hpp"

namespace signorini {

namespace {

/// A box on paper; places within it are shares of its edges.
struct ObliqueBox {
  std::array<Place, 3> edges;  ///< along x, y and z [cm]

  explicit ObliqueBox(const Eigen::Vector3d& lengths) {
    const double scale = 9.0 / lengths.maxCoeff();
    const auto length = [&](int axis) { return std::max(1.3, scale * lengths[axis]); };
    edges = {Place(length(0), 0.0), length(1) * Place(0.5, 0.4), Place(0.0, length(2))};
  }
  [[nodiscard]] Place at(const Eigen::Vector3d& shares) const {
    return shares.x() * edges[0] + shares.y() * edges[1] + shares.z() * edges[2];
  }
  /// From the solid to the reader, of a box of these lengths: a direction that is a point on paper.
  [[nodiscard]] Eigen::Vector3d towards_reader(const Eigen::Vector3d& lengths) const {
    const Eigen::Vector3d shares(edges[1].x() / edges[0].x(), -1.0, edges[1].y() / edges[2].y());
    return shares.cwiseProduct(lengths);
  }
};

/// Nodes of a block where one coordinate direction is in contact or loaded.
struct NodeGroup {
  std::vector<Eigen::Vector3d> nodes = {};  ///< as shares of the edges
  SingleStop stops = {};
  std::map<int, std::complex<double>> load = {};  ///< by harmonic, summed [N]
};

/// The corners of the least box around some places.
std::pair<Eigen::Vector3d, Eigen::Vector3d> corners_of(const std::vector<Eigen::Vector3d>& places) {
  Eigen::Vector3d low = places.front(), high = low;
  for (const Eigen::Vector3d& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  return {low, high};
}

/// Where a coordinate is, as shares of the edges, and its axis.
struct SharedPlace {
  Eigen::Vector3d shares = Eigen::Vector3d::Zero();
  int axis = 0;
};
using SharesOf = std::function<SharedPlace(int dof)>;

/// By axis, and whether it is the positive side.
std::map<std::pair<int, bool>, NodeGroup> contact_groups(const Problem& problem, const SharesOf& shares_of) {
  std::map<std::pair<int, bool>, NodeGroup> groups;
  for (const SingleStop& stop : single_stops(problem)) {
    const SharedPlace at = shares_of(stop.dof);
    NodeGroup& group = groups[{at.axis, stop.forward}];
    group.nodes.push_back(at.shares);
    group.stops.add({.contacts = 1, .least_gap = stop.least_gap, .largest_gap = stop.largest_gap});
  }
  return groups;
}

std::map<int, NodeGroup> load_groups(const Problem& problem, const SharesOf& shares_of) {
  std::map<int, NodeGroup> groups;
  for (const ForceTerm& term : problem.force) {
    const SharedPlace at = shares_of(term.dof);
    NodeGroup& group = groups[at.axis];
    group.nodes.push_back(at.shares);
    group.load[term.harmonic] += std::conj(force_amplitude(term, problem.frequency));
  }
  return groups;
}

/// The mesh on the face spanned by two edges.
void draw_face(Drawing& drawing, const ObliqueBox& box, const BlockMesh& mesh, const Eigen::Vector3d& corner,
               std::array<int, 2> axes) {
  const auto unit = [](int axis) { return Eigen::Vector3d(Eigen::Vector3d::Unit(axis)); };
  const Eigen::Vector3d a = unit(axes[0]), b = unit(axes[1]);
  drawing.add("face").strokes.push_back(
      {.places = {box.at(corner), box.at(corner + a), box.at(corner + a + b), box.at(corner + b)},
       .fill = Fill::body,
       .closed = true,
       .width = 0.045});
  Part& lines = drawing.add("mesh");
  const auto draw = [&](const Eigen::Vector3d& along, const Eigen::Vector3d& across, int elements) {
    for (const double share : mesh_lines(elements))
      draw_line(lines, {box.at(corner + share * along), box.at(corner + share * along + across)}, Ink::note,
                kThin);
  };
  draw(a, b, mesh.elements[static_cast<std::size_t>(axes[0])]);
  draw(b, a, mesh.elements[static_cast<std::size_t>(axes[1])]);
}

/// The nodes on their face, and a plate opposite to them.
void draw_contact_group(Drawing& drawing, const ObliqueBox& box, int axis, bool upper, const NodeGroup& group,
                        bool compliant) {
  constexpr std::size_t kMostDots = 150;
  const Place way = (upper ? 1.0 : -1.0) * box.edges[static_cast<std::size_t>(axis)].normalized();
  Part& dots = drawing.add("contact-nodes");
  if (group.nodes.size() <= kMostDots)
    for (const auto& node : group.nodes) draw_circle(dots, box.at(node), 0.055, Fill::ink, Ink::contact);
  const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  auto [low, high] = corners_of(group.nodes);
  const Place foot = box.at(low);
  for (const int side : {first, second}) {
    const double margin = 0.25 / box.edges[static_cast<std::size_t>(side)].norm();
    low(side) -= margin;
    high(side) += margin;
  }
  std::array<Eigen::Vector3d, 4> corners{low, low, high, high};
  corners[1](first) = high(first);
  corners[3](first) = low(first);
  const Place out = 0.55 * way;
  std::vector<Place> plate;
  for (const auto& corner : corners) plate.push_back(box.at(corner) + out);
  Part& stop = drawing.add("stop");
  stop.strokes.push_back(
      {.places = plate, .ink = Ink::contact, .fill = Fill::paper, .closed = true, .width = kThick});
  for (const double share : mesh_lines(6)) {  // hatches
    const Place near = plate[0] + share * (plate[1] - plate[0]),
                far = plate[3] + share * (plate[2] - plate[3]);
    draw_line(stop, {near, far}, Ink::contact, 0.022);
  }
  if (compliant)
    draw_stop_spring(stop, foot, foot + out);
  else
    stop.strokes.push_back({.places = {foot, foot + out}, .ink = Ink::contact, .dashed = true});
  const Place middle = 0.25 * (plate[0] + plate[1] + plate[2] + plate[3]);
  draw_text(drawing.add("gap"), middle + 0.45 * way + Place(0.0, way.y() < 0.0 ? -kTextSize : 0.1),
            gap_text(group.stops, "nodes"), Ink::contact);
}

/// The whole force along an axis, where its nodes are on the average.
void draw_load_group(Drawing& drawing, const ObliqueBox& box, int axis, const NodeGroup& group) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& node : group.nodes) middle += node / static_cast<double>(group.nodes.size());
  Problem whole;  // one coordinate that the whole force acts on
  for (const auto& [harmonic, size] : group.load)
    whole.force.push_back({.dof = 0, .harmonic = harmonic, .cos = size.real(), .sin = size.imag()});
  const Place from = box.at(middle), to = from + 1.1 * box.edges[static_cast<std::size_t>(axis)].normalized();
  // Beyond the block, at the height of the arrow, where no stop is in the way.
  const Place beside(std::max(box.edges[0].x() + box.edges[1].x(), to.x()) + 0.25, 0.5 * (from.y() + to.y()));
  draw_load(drawing, from, to, beside, load_text(whole, 0), Anchor::start);
  draw_circle(drawing.parts.back(), from, 0.06, Fill::ink, Ink::load);
}

/// What acts on a solid, and in words what is not drawn of it.
std::string draw_surroundings(Drawing& drawing, const ObliqueBox& box, const Problem& problem,
                              const SharesOf& shares_of) {
  for (const auto& [side, group] : contact_groups(problem, shares_of))
    draw_contact_group(drawing, box, side.first, side.second, group, has_springs(problem));
  for (const auto& [axis, group] : load_groups(problem, shares_of))
    draw_load_group(drawing, box, axis, group);
  return hidden_text(std::ssize(pair_stops(problem)) + other_stops(problem), "contact",
                     " between coordinates not drawn");
}

/// "0.5 × 0.1 × 0.2 m"
std::string size_text(const Eigen::Vector3d& lengths) {
  return fmt::format("{} × {} × {} m", number_text(lengths.x()), number_text(lengths.y()),
                     number_text(lengths.z()));
}

}  // namespace

std::string draw_model(Drawing& drawing, const Problem& problem, const BlockMesh& mesh) {
  const Eigen::Vector3d lengths(mesh.lengths[0], mesh.lengths[1], mesh.lengths[2]);
  const ObliqueBox box(lengths);
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  const Place overlap = 0.25 * Place(0.0, 1.0);
  draw_wall(drawing, box.at(origin) - overlap, box.at(Eigen::Vector3d::UnitZ()));
  draw_wall(drawing, box.at(Eigen::Vector3d::UnitZ()),
            box.at({0.0, 1.0, 1.0}) + 0.25 * box.edges[1].normalized());
  draw_face(drawing, box, mesh, origin, {0, 2});
  draw_face(drawing, box, mesh, Eigen::Vector3d::UnitZ(), {0, 1});
  draw_face(drawing, box, mesh, Eigen::Vector3d::UnitX(), {1, 2});
  const std::string hidden = draw_surroundings(drawing, box, problem, [&](int dof) {
    const auto [node, axis] = mesh.place(dof);
    Eigen::Vector3d shares;
    for (std::size_t a = 0; a < 3; ++a)
      shares[static_cast<Eigen::Index>(a)] = static_cast<double>(node[a]) / mesh.elements[a];
    return SharedPlace{.shares = shares, .axis = axis};
  });
  return fmt::format("elastic block of {} × {} × {} bricks, {}{}", mesh.elements[0], mesh.elements[1],
                     mesh.elements[2], size_text(lengths), hidden);
}

std::string draw_model(Drawing& drawing, const Problem& problem,
                       const std::shared_ptr<const SolidMesh>& solid) {
  const SolidMesh& mesh = *solid;
  const auto [low, high] = corners_of(mesh.nodes);
  const Eigen::Vector3d lengths = high - low;
  const ObliqueBox box(lengths);
  const auto shares = [&, from = low](int node) -> Eigen::Vector3d {
    return (mesh.nodes[static_cast<std::size_t>(node)] - from).cwiseQuotient(lengths);
  };
  Part& edges = drawing.add("edges");
  for (const auto& [from, to] : sharp_edges(mesh, box.towards_reader(lengths)))
    draw_line(edges, {box.at(shares(from)), box.at(shares(to))}, Ink::structure, 0.03);
  Part& held = drawing.add("support");
  for (int node = 0; node < mesh.held; ++node)
    draw_circle(held, box.at(shares(node)), 0.035, Fill::ink, Ink::structure);
  const std::string hidden = draw_surroundings(drawing, box, problem, [&](int dof) {
    const auto [node, axis] = mesh.place(dof);
    return SharedPlace{.shares = shares(node), .axis = axis};
  });
  int elements = 0;
  for (const ElementList& list : mesh.solids) elements += list.count();
  return fmt::format("elastic solid of {} elements, {}, {} nodes held{}", elements, size_text(lengths),
                     mesh.held, hidden);
}

}  // namespace signorini
