#pragma once
// The mechanical system of a scene as a figure: masses, springs, dampers, meshes, stops with their gaps,
// loads.

#include <string>
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

// The parts of it, one function for each kind of system. Each returns what its picture does not show, in
// words.

std::string draw_chain(Drawing& drawing, const Problem& problem, const Chain& chain);
std::string draw_bar(Drawing& drawing, const Problem& problem, const Bar& bar);
std::string draw_beams(Drawing& drawing, const Problem& problem, const Beam& beam);
std::string draw_block(Drawing& drawing, const Problem& problem, const BlockMesh& mesh);
std::string draw_solid(Drawing& drawing, const Problem& problem, const SolidMesh& mesh);
std::string draw_rotor(Drawing& drawing, const Problem& problem, const Rotor& rotor);
std::string draw_shaft(Drawing& drawing, const Problem& problem, const Shaft& shaft);
/// A body of unknown shape, with its contacts and loads.
std::string draw_body(Drawing& drawing, const Problem& problem);

}  // namespace signorini
