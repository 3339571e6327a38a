#pragma once
// The symbols of mechanics: walls, masses, springs, dampers, stops, loads, gaps.

#include <string>

#include "harness/schematic/drawing.hpp"

namespace signorini {

/// Widths of lines: of meshes and of what explains, of walls, plates and rods [cm].
inline constexpr double kThin = 0.018, kThick = 0.055;

/// A line in a part of the drawing, `width` broad [cm]. Those below are made of it.
void draw_line(Part& part, std::vector<Place> places, Ink ink = Ink::structure,
               double width = Stroke().width);
/// A circle, filled or not.
void draw_circle(Part& part, const Place& centre, double radius, Fill fill, Ink ink = Ink::structure);
/// A rectangle between two opposite corners.
void draw_box(Part& part, const Place& low, const Place& high, Fill fill);
/// A body of so many elements along x, as a part of this kind, and its mesh as another: of fine ones some
/// lines.
void draw_meshed_box(Drawing& drawing, const std::string& kind, const Place& low, const Place& high,
                     int elements);
/// Words on a base line.
void draw_text(Part& part, const Place& place, std::string words, Ink ink = Ink::structure,
               Anchor anchor = Anchor::middle);

/// A line with hatches on its left as one walks from `from` to `to`: what does not move.
void hatch_line(Part& part, const Place& from, const Place& to, Ink ink = Ink::structure);
/// A wall, as a part of its own.
void draw_wall(Drawing& drawing, const Place& from, const Place& to);

/// What is written beside an element.
struct ElementText {
  std::string spring = {}, damper = {};
};
/// Spring and damper side by side, whichever of them is there, each a part of its own, the spring on the left
/// as one walks from `from` to `to`, with their texts outside.
void draw_element(Drawing& drawing, const Place& from, const Place& to, bool spring, bool damper,
                  const ElementText& text = {});

/// What stands against a contact.
struct StopLook {
  bool compliant = false;  ///< a spring before the wall
  double half = 0.45;      ///< half of its breadth [cm]
};
/// Depth of a compliant stop, from its face to its wall [cm].
inline constexpr double kStopDepth = 0.75;
/// A stop with its face at `face`, which limits motion along the unit vector `direction`; a compliant one
/// with a damper beside its spring where the drawing says so.
void draw_stop(Drawing& drawing, const Place& face, const Place& direction, const StopLook& look);

/// The spring of a stop alone.
void draw_stop_spring(Part& part, const Place& from, const Place& to);

/// A distance between two places, with arrows from outside if it is short, and its text at a place.
void draw_gap(Drawing& drawing, const Place& from, const Place& to, const Place& at, const std::string& words,
              Anchor anchor = Anchor::middle);

/// A force with its text at a place, if there is any.
void draw_load(Drawing& drawing, const Place& from, const Place& to, const Place& at,
               const std::string& words, Anchor anchor = Anchor::middle);
/// An arrow alone.
void draw_arrow(Part& part, const Place& from, const Place& to, Ink ink);
/// A load that turns, as an arrow along an arc of so many pieces: from the angle `begin` on by `turn`, both
/// in half turns.
void draw_turning_arrow(Part& part, const Place& centre, double radius, double begin, double turn,
                        int pieces);

}  // namespace signorini
