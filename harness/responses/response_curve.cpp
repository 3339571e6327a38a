#include "harness/responses/response_curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "harness/text/words.hpp"
#include "problems/problem.hpp"

namespace signorini {

namespace {

std::optional<bool> stable(OrbitStability stability) {
  if (stability == OrbitStability::stable) return true;
  if (stability == OrbitStability::unstable) return false;
  return std::nullopt;
}

std::optional<double> amplitude_at(const SolutionPoint& point) {
  return point.amplitude.empty() ? std::nullopt : std::optional(std::ranges::max(point.amplitude));
}

/// The motion at kComparedPhases instants of each forcing period, interpolated.
Eigen::MatrixXd at_phases(const std::vector<std::vector<double>>& x, int order) {
  const Eigen::Index count = Eigen::Index{kComparedPhases} * order;
  Eigen::MatrixXd motion(count, static_cast<Eigen::Index>(x.size()));
  for (std::size_t j = 0; j < x.size(); ++j) {
    const std::vector<double>& values = x[j];
    for (Eigen::Index i = 0; i < count; ++i) {
      const double place =
          static_cast<double>(i) * static_cast<double>(values.size()) / static_cast<double>(count);
      const auto before = static_cast<std::size_t>(place);
      const double share = place - static_cast<double>(before);
      motion(i, static_cast<Eigen::Index>(j)) =
          (1.0 - share) * values[before] + share * values[(before + 1) % values.size()];
    }
  }
  return motion;
}

/// Forcing periods per period of an answer; 0 where it is no whole number of them.
int order_of(const SweepPoint& step) {
  return step.motion ? whole_periods(step.motion->period, 2.0 * std::numbers::pi / step.frequency) : 0;
}

/// Phases x contacts; empty unless all contacts have as many phases.
Eigen::MatrixXd kept_motion(const KeptMotion& x) {
  const std::size_t phases = x.empty() ? 0 : x.front().size();
  Eigen::MatrixXd motion(static_cast<Eigen::Index>(phases), static_cast<Eigen::Index>(x.size()));
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j].size() != phases) return {};
    motion.col(static_cast<Eigen::Index>(j)) =
        Eigen::Map<const Eigen::VectorXd>(x[j].data(), static_cast<Eigen::Index>(phases));
  }
  return motion;
}

/// The point at a share of the straight line between two of one order.
ResponsePoint on_chord(const ResponsePoint& a, const ResponsePoint& b, double share) {
  ResponsePoint point = share < 0.5 ? a : b;
  point.frequency = (1.0 - share) * a.frequency + share * b.frequency;
  point.motion = (1.0 - share) * a.motion + share * b.motion;
  return point;
}

/// Whether all between two points are as stable as these, and lie on their chord. \param along  length up to
/// each point
bool is_straight(const std::vector<ResponsePoint>& points, const std::vector<double>& along, std::size_t from,
                 std::size_t to, const ResponseMetric& metric) {
  constexpr double kOnChord = 1e-3;
  const ResponsePoint &a = points[from], &b = points[to];
  if (a.stable != b.stable || !std::isfinite(along[to])) return false;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double share = (along[i] - along[from]) / (along[to] - along[from]);
    if (points[i].stable != a.stable || !(metric(points[i], on_chord(a, b, share)) <= kOnChord)) return false;
  }
  return true;
}

/// The points that straight lines between them need.
std::vector<ResponsePoint> thinned(const std::vector<ResponsePoint>& points, const ResponseMetric& metric) {
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < points.size(); ++i)
    along.push_back(along.back() + metric(points[i - 1], points[i]));
  std::vector<ResponsePoint> kept;
  std::size_t from = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && i + 1 < points.size() && is_straight(points, along, from, i + 1, metric)) continue;
    kept.push_back(points[i]);
    from = i;
  }
  return kept;
}

/// Adds the elements between two points. \return false where nothing may be drawn between them
bool add_chord(const ResponsePoint& from, const ResponsePoint& to, bool by_arc_length,
               const ResponseMetric& metric, std::vector<CurveElement>& elements) {
  const auto [a, b] = metric.aligned(from, to);
  const double length = metric(a, b);
  if (!by_arc_length && length > kLongestChord) return false;
  const int pieces = std::max(1, static_cast<int>(std::ceil(length / kElementLength)));
  for (int k = 0; k < pieces; ++k)
    elements.push_back({metric.primitive(on_chord(a, b, (k + 0.5) / pieces)), length / pieces});
  return true;
}

// Digits that tell a motion to 5e-4 of its size, wherever the origin is: far below kCloseTolerance, and a
// third of the text of all digits.
int digits_of(const Eigen::MatrixXd& motion) {
  constexpr int kOfItsSize = 4, kAll = 17;
  const double size = half_range(motion), largest = motion.size() > 0 ? motion.cwiseAbs().maxCoeff() : 0.0;
  if (!(size > 0.0)) return kAll;
  return std::clamp(kOfItsSize + static_cast<int>(std::ceil(std::log10(largest / size))), kOfItsSize, kAll);
}

}  // namespace

ResponseCurve curve_of(const BranchDiagram& diagram) {
  ResponseCurve curve;
  for (const Branch& branch : diagram.branches) {
    ResponseBranch points{.by_arc_length = !branch.by_steps};
    for (const SolutionPoint& point : branch.points)
      points.points.push_back({.frequency = point.frequency,
                               .order = point.order,
                               .motion = point.motion,
                               .stable = stable(point.stability),
                               .amplitude = amplitude_at(point)});
    curve.branches.push_back(std::move(points));
    for (const SpecialPoint& special : branch.special) {
      if (special.kind == SpecialKind::phase_resonance) continue;  // nothing changes there
      curve.located.push_back({.kind = special.kind,
                               .frequency = special.point.frequency,
                               .order = special.point.order,
                               .amplitude = amplitude_at(special.point)});
    }
  }
  if (!diagram.unfinished.empty()) curve.open_ends.push_back(diagram.unfinished);
  curve.open_ends.insert(curve.open_ends.end(), diagram.notes.begin(), diagram.notes.end());
  return curve;
}

ResponseCurve curve_of(const std::vector<SweepPoint>& steps) {
  ResponseCurve curve;
  bool open = false;  // a branch is being added to
  for (const SweepPoint& step : steps) {
    const int order = order_of(step);
    const bool found = step.status == Status::converged && order > 0;
    if (found && !open) curve.branches.push_back({.by_arc_length = false});
    if (found)
      curve.branches.back().points.push_back({.frequency = step.frequency,
                                              .order = order,
                                              .motion = at_phases(step.motion->x, order),
                                              .stable = step.stable});
    open = found;
  }
  return curve;
}

ResponseCurve curve_of(const RecordedResponse& response) {
  ResponseCurve curve{.located = response.located, .open_ends = response.open_ends};
  for (const DrawnBranch& branch : response.branches) {
    ResponseBranch& points = curve.branches.emplace_back();
    points.by_arc_length = !branch.by_steps.value_or(false);
    const std::size_t count = std::min({branch.frequency.size(), branch.stable.size(), branch.motion.size()});
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::MatrixXd motion = kept_motion(branch.motion[i]);
      const int stable = branch.stable[i];
      points.points.push_back({.frequency = branch.frequency[i],
                               .order = std::max(1, static_cast<int>(motion.rows()) / kComparedPhases),
                               .motion = motion,
                               .stable = stable < 0 ? std::nullopt : std::optional(stable == 1)});
    }
  }
  return curve;
}

std::vector<DrawnBranch> drawn(const ResponseCurve& curve) {
  std::vector<DrawnBranch> branches;
  for (const ResponseBranch& branch : curve.branches) {
    DrawnBranch& lines = branches.emplace_back();
    for (const ResponsePoint& point : branch.points) {
      lines.frequency.push_back(point.frequency);
      lines.amplitude.push_back(point.amplitude.value_or(half_range(point.motion)));
      lines.stable.push_back(!point.stable ? -1 : *point.stable ? 1 : 0);
    }
  }
  return branches;
}

std::vector<DrawnBranch> drawn_with_motions(const ResponseCurve& curve) {
  std::vector<DrawnBranch> branches = drawn(curve);
  for (std::size_t i = 0; i < branches.size(); ++i) {
    if (!curve.branches[i].by_arc_length) branches[i].by_steps = true;
    for (const ResponsePoint& point : curve.branches[i].points) {
      KeptMotion& motion = branches[i].motion.emplace_back();
      const int digits = digits_of(point.motion);
      for (const auto& x : point.motion.colwise()) {
        std::vector<double>& kept = motion.emplace_back();
        std::ranges::transform(x, std::back_inserter(kept), [&](double at) { return rounded(at, digits); });
      }
    }
  }
  return branches;
}

ResponseCurve thinned(ResponseCurve curve, const ResponseMetric& metric) {
  for (ResponseBranch& branch : curve.branches)
    if (branch.by_arc_length && !branch.points.empty()) branch.points = thinned(branch.points, metric);
  return curve;
}

double half_range(const Eigen::MatrixXd& motion) {
  if (motion.size() == 0) return 0.0;
  return 0.5 * (motion.colwise().maxCoeff() - motion.colwise().minCoeff()).maxCoeff();
}

double amplitude_of(const ResponseCurve& curve) {
  double largest = 0.0;
  for (const ResponseBranch& branch : curve.branches)
    for (const ResponsePoint& point : branch.points) largest = std::max(largest, half_range(point.motion));
  return largest;
}

std::vector<CurveElement> elements_of(const ResponseCurve& curve, const ResponseMetric& metric) {
  std::vector<CurveElement> elements;
  for (const ResponseBranch& branch : curve.branches) {
    const std::vector<ResponsePoint>& points = branch.points;
    bool joined = false;  // the point before, to the one before it
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool goes_on = i + 1 < points.size() &&
                           add_chord(points[i], points[i + 1], branch.by_arc_length, metric, elements);
      if (!joined && !goes_on) elements.push_back({metric.primitive(points[i]), kElementLength});
      joined = goes_on;
    }
  }
  return elements;
}

}  // namespace signorini
