#include "harness/schematic/symbols.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/schematic/boundary.hpp"

namespace signorini {

namespace {

/// A frame along a line: places by distance along it and to its left.
struct Along {
  Place from, unit, left;
  double length;

  Along(const Place& start, const Place& end)
      : from(start),
        unit((end - start).normalized()),
        left(-unit.y(), unit.x()),
        length((end - start).norm()) {}
  [[nodiscard]] Place at(double ahead, double aside = 0.0) const {
    return from + ahead * unit + aside * left;
  }
};

/// The zigzag between two places, with straight ends.
void zigzag(Part& part, const Place& from, const Place& to, double amplitude, Ink ink) {
  constexpr int kTeeth = 6;
  const Along line(from, to);
  const double end = 0.16 * line.length, tooth = (line.length - 2.0 * end) / kTeeth;
  Stroke stroke{.places = {from, line.at(end)}, .ink = ink};
  for (int i = 0; i < kTeeth; ++i)
    stroke.places.push_back(line.at(end + (i + 0.5) * tooth, i % 2 == 0 ? amplitude : -amplitude));
  stroke.places.push_back(line.at(line.length - end));
  stroke.places.push_back(to);
  part.strokes.push_back(std::move(stroke));
}

/// A piston in its cylinder between two places, of this half breadth.
void dashpot(Part& part, const Place& from, const Place& to, double half, Ink ink) {
  const Along line(from, to);
  const double middle = 0.5 * line.length, depth = std::min(0.22, 0.2 * line.length);
  draw_line(part, {from, line.at(middle - depth)}, ink);
  draw_line(part,
            {line.at(middle + depth, half), line.at(middle - depth, half), line.at(middle - depth, -half),
             line.at(middle + depth, -half)},
            ink);
  draw_line(part, {line.at(middle + 0.3 * depth, 0.75 * half), line.at(middle + 0.3 * depth, -0.75 * half)},
            ink, kThick);
  draw_line(part, {line.at(middle + 0.3 * depth), to}, ink);
}

}  // namespace

void draw_line(Part& part, std::vector<Place> places, Ink ink, double width) {
  part.strokes.push_back({.places = std::move(places), .ink = ink, .width = width});
}

void draw_circle(Part& part, const Place& centre, double radius, Fill fill, Ink ink) {
  const int corners = std::clamp(static_cast<int>(80.0 * radius), 16, 96);
  Stroke stroke{.ink = ink, .fill = fill, .closed = true};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    stroke.places.push_back(centre + radius * Place(std::cos(angle), std::sin(angle)));
  }
  part.strokes.push_back(std::move(stroke));
}

void draw_box(Part& part, const Place& low, const Place& high, Fill fill) {
  part.strokes.push_back({.places = {low, {high.x(), low.y()}, high, {low.x(), high.y()}},
                          .fill = fill,
                          .closed = true,
                          .width = 0.045});
}

void draw_meshed_box(Drawing& drawing, const std::string& kind, const Place& low, const Place& high,
                     int elements) {
  draw_box(drawing.add(kind), low, high, Fill::body);
  Part& mesh = drawing.add("mesh");
  for (const double share : mesh_lines(elements)) {
    const double x = low.x() + share * (high.x() - low.x());
    draw_line(mesh, {{x, low.y()}, {x, high.y()}}, Ink::note, kThin);
  }
}

void draw_text(Part& part, const Place& place, std::string words, Ink ink, Anchor anchor) {
  part.labels.push_back({.place = place, .words = std::move(words), .anchor = anchor, .ink = ink});
}

void hatch_line(Part& part, const Place& from, const Place& to, Ink ink) {
  constexpr double kPitch = 0.17;  // from one to the next, and how deep they are
  const Along line(from, to);
  const int hatches = std::max(2, static_cast<int>(line.length / kPitch));
  for (int i = 0; i < hatches; ++i) {
    const double ahead = (i + 0.75) * line.length / hatches;
    draw_line(part, {line.at(ahead), line.at(ahead - kPitch, kPitch)}, ink, 0.022);
  }
  draw_line(part, {from, to}, ink, kThick);
}

void draw_wall(Drawing& drawing, const Place& from, const Place& to) {
  hatch_line(drawing.add("wall"), from, to);
}

void draw_element(Drawing& drawing, const Place& from, const Place& to, bool spring, bool damper,
                  const ElementText& text) {
  const Along line(from, to);
  const double aside = spring && damper ? 0.33 : 0.0;
  const auto note = [&](const std::string& words, double distance) {
    if (words.empty()) return;
    const Place middle = line.at(0.5 * line.length, distance);
    draw_text(drawing.parts.back(), middle + Place(0.0, distance > 0.0 ? 0.02 : -0.75 * kTextSize), words);
  };
  if (spring) {
    zigzag(drawing.add("spring"), line.at(0.0, aside), line.at(line.length, aside), 0.16, Ink::structure);
    note(text.spring, aside + 0.22);
  }
  if (damper) {
    dashpot(drawing.add("damper"), line.at(0.0, -aside), line.at(line.length, -aside), 0.15, Ink::structure);
    note(text.damper, -aside - 0.22);
  }
}

void draw_stop(Drawing& drawing, const Place& face, const Place& direction, const StopLook& look) {
  const Place across(-direction.y(), direction.x());
  Part& part = drawing.add("stop");
  // The hatches are behind the wall, on its left as one walks down from its left end.
  const auto wall = [&](const Place& middle) {
    hatch_line(part, middle + look.half * across, middle - look.half * across, Ink::contact);
  };
  if (!look.compliant) return wall(face);
  const bool damped = drawing.damped_stops;
  const double half = (damped ? 0.9 : 0.6) * look.half;
  draw_line(part, {face - half * across, face + half * across}, Ink::contact, kThick);
  wall(face + kStopDepth * direction);
  const Place beside = damped ? Place(0.5 * half * across) : Place(0.0, 0.0);
  zigzag(part, face + beside, face + beside + kStopDepth * direction,
         std::min(0.12, damped ? 0.4 * half : half), Ink::contact);
  if (damped)
    dashpot(part, face - beside, face - beside + kStopDepth * direction, std::min(0.13, 0.4 * half),
            Ink::contact);
}

void draw_stop_spring(Part& part, const Place& from, const Place& to) {
  zigzag(part, from, to, 0.12, Ink::contact);
}

void draw_arrow(Part& part, const Place& from, const Place& to, Ink ink) {
  const Along line(from, to);
  const double head = std::min(0.22, 0.6 * line.length);
  draw_line(part, {from, line.at(line.length - 0.5 * head)}, ink);
  part.strokes.push_back(
      {.places = {to, line.at(line.length - head, 0.35 * head), line.at(line.length - head, -0.35 * head)},
       .ink = ink,
       .fill = Fill::ink,
       .closed = true,
       .width = 0.01});
}

void draw_turning_arrow(Part& part, const Place& centre, double radius, double begin, double turn,
                        int pieces) {
  std::vector<Place> arc;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = std::numbers::pi * (begin + turn * i / pieces);
    arc.push_back(centre + radius * Place(std::cos(angle), std::sin(angle)));
  }
  const Place tip = arc.back(), before = arc[arc.size() - 4];
  draw_line(part, std::move(arc), Ink::load, 0.05);
  draw_arrow(part, before, tip + 0.4 * (tip - before), Ink::load);
}

void draw_gap(Drawing& drawing, const Place& from, const Place& to, const Place& at, const std::string& words,
              Anchor anchor) {
  constexpr double kTail = 0.38;
  Part& part = drawing.add("gap");
  if ((to - from).norm() > 0.0) {
    const Place unit = (to - from).normalized();
    draw_arrow(part, from - kTail * unit, from, Ink::contact);
    draw_arrow(part, to + kTail * unit, to, Ink::contact);
  }
  draw_text(part, at, words, Ink::contact, anchor);
}

void draw_load(Drawing& drawing, const Place& from, const Place& to, const Place& at,
               const std::string& words, Anchor anchor) {
  Part& part = drawing.add("load");
  draw_arrow(part, from, to, Ink::load);
  part.strokes.front().width = kThick;
  if (!words.empty()) draw_text(part, at, words, Ink::load, anchor);
}

}  // namespace signorini
