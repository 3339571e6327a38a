#pragma once
// Stops and loads of what moves along x: masses of a chain, nodes of a bar.

#include <functional>
#include <optional>
#include <vector>

#include "harness/schematic/boundary.hpp"
#include "harness/schematic/drawing.hpp"

namespace signorini {

/// Where a coordinate is drawn.
struct AxialPoint {
  double x = 0.0, top = 0.0, bottom = 0.0;  ///< a load acts above, stops against a pin below [cm]
  std::optional<double> face = {};          ///< right end of what is free there [cm]
  double room = 0.0;                        ///< to the next one that is drawn [cm]
};
/// Empty for coordinates that are left out.
using AxialPlaces = std::function<std::optional<AxialPoint>(int)>;

/// Whether a stop is drawn against the free end; all others are drawn against pins.
bool stands_at_end(const SingleStop& stop, const std::vector<SingleStop>& all, const AxialPlaces& places);

/// All stops on single coordinates that have a place. Texts that equal the one before are left out.
void draw_axial_stops(Drawing& drawing, const Problem& problem, const AxialPlaces& places);
/// All loads on coordinates that have a place, with texts if there are up to two, "f(t)" where those would
/// overlap.
void draw_axial_loads(Drawing& drawing, const Problem& problem, const AxialPlaces& places);

}  // namespace signorini
