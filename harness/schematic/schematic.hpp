#pragma once
// The mechanical system of a scene as a figure: masses, springs, dampers, meshes, stops with their gaps,
// loads.

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "harness/schematic/drawing.hpp"
#include "problems/damped_stops.hpp"
#include "problems/problem.hpp"
#include "problems/scene/system_layout.hpp"

namespace signorini {

/// The schematic of a scene. Not to scale: gaps are drawn large. Long chains leave out masses where nothing
/// happens, fine meshes elements, many stops side by side become a rail; texts say what is left out.
/// \param layout  of the same scene
/// \param damped  its stops, if they are springs with dampers
Drawing schematic(const Problem& scene, const SystemLayout& layout,
                  const std::vector<DampedStop>& damped = {});

/// The model on paper, as its kind is drawn; what the picture does not show, in words.
std::string draw_model(Drawing& drawing, const Problem& problem, const Chain& chain);
std::string draw_model(Drawing& drawing, const Problem& problem, const Bar& bar);
std::string draw_model(Drawing& drawing, const Problem& problem, const Beam& beam);
std::string draw_model(Drawing& drawing, const Problem& problem, const BlockMesh& mesh);
std::string draw_model(Drawing& drawing, const Problem& problem,
                       const std::shared_ptr<const SolidMesh>& mesh);
std::string draw_model(Drawing& drawing, const Problem& problem, const Rotor& rotor);
std::string draw_model(Drawing& drawing, const Problem& problem, const Shaft& shaft);
/// A body of unknown shape, with its contacts and loads.
std::string draw_model(Drawing& drawing, const Problem& problem, const std::monostate& matrices);

}  // namespace signorini
