#include "harness/extend/plugins/curve_exchange.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/records/json_fields.hpp"
#include "harness/text/json.hpp"
#include "methods/discretisation/fourier_series.hpp"

namespace signorini {

/// A point of a command's or a file's branch.
void visit_fields(Either<ExchangedPoint> auto& point, auto&& field) {
  field(required("omega", "rad/s"), point.omega);
  field(Field{"order"}, point.order);
  field(Field{"x", "m"}, point.x);
  field(Field{"coefficients", "m"}, point.coefficients);
  field(Field{"stable"}, point.stable);
  field(Field{"impacts"}, point.impacts);
}

/// A special point: the keys of a point, and its own.
void visit_fields(Either<ExchangedSpecial> auto& special, auto&& field) {
  field(required("kind"), special.kind);
  visit_fields(special.point, field);
  field(Field{"text"}, special.text);
  field(Field{"after"}, special.after);
}

/// A branch.
void visit_fields(Either<ExchangedBranch> auto& branch, auto&& field) {
  field(Field{"scene"}, branch.scene);
  field(Field{"sequence"}, branch.sequence);
  field(Field{"began"}, branch.began);
  field(Field{"ended"}, branch.ended);
  field(Field{"by_steps"}, branch.by_steps);
  field(required("points"), branch.points);
  field(Field{"special"}, branch.special);
}

/// A whole answer.
void visit_fields(Either<ExchangedCurve> auto& curve, auto&& field) {
  field(required("branches"), curve.branches);
  field(Field{"unfinished"}, curve.unfinished);
  field(Field{"notes"}, curve.notes);
  field(Field{"seconds", "s"}, curve.seconds);
}

namespace {

/// x_j at N equidistant instants of the period, N x Nc [m].
using Samples = Eigen::MatrixXd;

constexpr std::size_t kMostInstants = 1'000'000;

void require_known_keys_of_branch(const nlohmann::ordered_json& json) {
  require_known_keys<ExchangedBranch>(json);
  for (const auto& point : json.at("points")) require_known_keys<ExchangedPoint>(point);
  if (!json.contains("special")) return;
  for (const auto& special : json["special"]) require_known_keys<ExchangedSpecial>(special);
}

/// The rows of a key, one per contact and all of one length, as columns. \throws BadRecord
Eigen::MatrixXd columns_of(const std::vector<std::vector<double>>& rows, const char* key, int contacts,
                           std::size_t least) {
  if (std::cmp_not_equal(rows.size(), contacts))
    throw BadRecord("{} = {} lists (must be one for each of {} contacts)", key, rows.size(), contacts);
  const std::size_t length = rows.empty() ? least : rows.front().size();
  if (length < least || length > kMostInstants)
    throw BadRecord("{} = {} numbers (must be {}..{})", key, length, least, kMostInstants);
  Eigen::MatrixXd columns(length, contacts);
  for (int j = 0; j < contacts; ++j) {
    const std::vector<double>& row = rows[static_cast<std::size_t>(j)];
    if (row.size() != length)
      throw BadRecord("{} = {} and {} numbers (must be as many for each contact)", key, length, row.size());
    columns.col(j) = Eigen::Map<const Eigen::VectorXd>(row.data(), std::ssize(row));
  }
  if (!columns.allFinite()) throw BadRecord("{} (must be finite numbers)", key);
  return columns;
}

/// a_0, a_1, b_1, .. as the coefficients n = 0..H of fourier_series.hpp, x = c_0 + 2 Re sum of c_n e^(i n w
/// t).
Eigen::MatrixXcd series_of(const Eigen::MatrixXd& coefficients) {
  Eigen::MatrixXcd series(coefficients.rows() / 2 + 1, coefficients.cols());
  series.row(0) = coefficients.row(0).cast<std::complex<double>>();
  for (Eigen::Index n = 1; n < series.rows(); ++n) {
    series.row(n).real() = 0.5 * coefficients.row(2 * n - 1);
    series.row(n).imag() = -0.5 * coefficients.row(2 * n);
  }
  return series;
}

/// Between the instants by straight lines, at `count` others.
Eigen::MatrixXd at_phases(const Samples& x, Eigen::Index count) {
  Eigen::MatrixXd motion(count, x.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index left = i * x.rows() / count;
    const double share = static_cast<double>(i * x.rows() % count) / static_cast<double>(count);
    motion.row(i) = (1.0 - share) * x.row(left) + share * x.row((left + 1) % x.rows());
  }
  return motion;
}

OrbitStability stability_of(const std::optional<bool>& stable) {
  if (!stable) return OrbitStability::unknown;
  return *stable ? OrbitStability::stable : OrbitStability::unstable;
}

SolutionPoint solution_of(const ExchangedPoint& given, int contacts, int phases) {
  constexpr int kLargestOrder = 1000;
  if (!(given.omega > 0.0) || !std::isfinite(given.omega))
    throw BadRecord("omega = {} (must be a positive number)", given.omega);
  if (given.order < 1 || given.order > kLargestOrder)
    throw BadRecord("order = {} (must be in 1..{})", given.order, kLargestOrder);
  if (given.impacts < 0) throw BadRecord("impacts = {} (must be 0 or more)", given.impacts);
  if (given.x.empty() == given.coefficients.empty() && contacts > 0)
    throw BadRecord("point at {} rad/s (must have either x or coefficients)", given.omega);
  const Eigen::Index asked = Eigen::Index{phases} * given.order;
  Samples x;
  Eigen::MatrixXd motion;
  if (given.coefficients.empty()) {
    x = columns_of(given.x, "x", contacts, 2);
    if (phases > 0) motion = at_phases(x, asked);
  } else {
    constexpr Eigen::Index kPerHarmonic = 32, kFewest = 64;
    const Eigen::MatrixXd pairs = columns_of(given.coefficients, "coefficients", contacts, 1);
    if (pairs.rows() % 2 == 0)
      throw BadRecord("coefficients = {} numbers (must be a_0 and pairs a_h, b_h)", pairs.rows());
    const Eigen::MatrixXcd series = series_of(pairs);
    x = sample_series(series, static_cast<int>(std::max(kFewest, kPerHarmonic * (series.rows() - 1))));
    if (phases > 0) motion = sample_series(series, static_cast<int>(asked));
  }
  if (!x.allFinite() || !motion.allFinite())
    throw BadRecord("point at {} rad/s (must have a motion of finite numbers)", given.omega);
  SolutionPoint point{.parameter = given.omega,
                      .frequency = given.omega,
                      .order = given.order,
                      .motion = std::move(motion),
                      .impacts = given.impacts,
                      .stability = stability_of(given.stable)};
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    point.x_max.push_back(x.col(j).maxCoeff());
    point.amplitude.push_back(0.5 * x.col(j).maxCoeff() - 0.5 * x.col(j).minCoeff());
  }
  return point;
}

/// The longest period asked for [forcing periods].
int longest_order(const ParametrisedScene& scene, const CurveLimits& limits) {
  return std::max(limits.max_order, scene.at(scene.from).subharmonic);
}

/// Cuts one branch into the parts that lie in the interval and have no longer period than `longest`.
class Clipping {
 public:
  Clipping(const ParametrisedScene& scene, int contacts, const CurveLimits& limits, int longest)
      : scene_(scene), contacts_(contacts), limits_(limits), longest_(longest) {}

  /// Adds the parts of a branch to the diagram.
  void add(const ExchangedBranch& given, BranchDiagram& diagram) {
    Branch part = beginning_of(given, given.began);
    auto special = given.special.begin();
    for (std::size_t i = 0; i <= given.points.size(); ++i) {
      for (; special != given.special.end() &&
             (std::cmp_less_equal(special->after, i) || i == given.points.size());
           ++special)
        add_special(*special, part);
      if (i == given.points.size()) break;
      SolutionPoint point = solution_of(given.points[i], contacts_, limits_.phases);
      if (const std::string why = why_outside(point); !why.empty()) {
        close(std::move(part), why, diagram);
        part = beginning_of(given, why);
      } else if (std::cmp_less(part.points.size(), limits_.max_points)) {
        part.points.push_back(std::move(point));
      } else {
        full_ = true;
      }
    }
    close(std::move(part), full_ ? "limit of points" : given.ended, diagram);
  }

 private:
  static Branch beginning_of(const ExchangedBranch& given, const std::string& began) {
    Branch branch;
    branch.sequence = given.sequence;
    branch.began = began;
    branch.by_steps = given.by_steps;
    return branch;
  }
  /// Why a point is cut off; empty where it is not. Ends of the interval are in it to rounding of the text of
  /// a file.
  [[nodiscard]] std::string why_outside(const SolutionPoint& point) const {
    constexpr double kRounding = 1e-9;
    if (point.frequency < (1.0 - kRounding) * scene_.low() ||
        point.frequency > (1.0 + kRounding) * scene_.high())
      return "end of the interval";
    if (point.order <= longest_) return {};
    return fmt::format("a period of {} forcing periods, of {} at most", point.order, longest_);
  }
  void add_special(const ExchangedSpecial& given, Branch& part) const {
    SolutionPoint point = solution_of(given.point, contacts_, limits_.phases);
    if (why_outside(point).empty())
      part.special.push_back(
          {.kind = given.kind, .point = std::move(point), .text = given.text, .after = part.points.size()});
  }
  void close(Branch part, const std::string& ended, BranchDiagram& diagram) const {
    if (part.points.empty()) return;
    if (part.points.size() == 1) {
      diagram.notes.push_back(fmt::format("a point alone at {:.6g} rad/s", part.points.front().frequency));
      return;
    }
    if (std::cmp_greater_equal(diagram.branches.size(), limits_.max_branches)) {
      diagram.unfinished = fmt::format("more than {} branches", limits_.max_branches);
      return;
    }
    part.ended = ended;
    if (limits_.take) limits_.take(part);
    diagram.branches.push_back(std::move(part));
  }

  const ParametrisedScene& scene_;
  int contacts_;
  const CurveLimits& limits_;
  int longest_;
  bool full_ = false;
};

}  // namespace

nlohmann::ordered_json follow_request(const ParametrisedScene& scene, const CurveLimits& limits) {
  return {{"parameter", scene.parameter},
          {"from", scene.from},
          {"to", scene.to},
          {"max_order", longest_order(scene, limits)},
          {"max_branches", limits.max_branches},
          {"max_points", limits.max_points},
          {"phases", limits.phases},
          {"at", limits.at}};
}

ExchangedCurve curve_from_json(const nlohmann::ordered_json& json) {
  require_known_keys<ExchangedCurve>(json);
  for (const auto& branch : json.at("branches")) require_known_keys_of_branch(branch);
  ExchangedCurve curve;
  read_fields(json, curve);
  if (curve.seconds && !(*curve.seconds >= 0.0))
    throw BadRecord("seconds = {} (must be 0 or more)", *curve.seconds);
  return curve;
}

ExchangedBranch branch_from_line(const std::string& line) {
  const nlohmann::ordered_json json = parse_json(line);
  require_known_keys_of_branch(json);
  ExchangedBranch branch;
  read_fields(json, branch);
  if (branch.scene.empty()) throw BadRecord("scene = missing (must be the name of the scene)");
  return branch;
}

BranchDiagram diagram_of(const ExchangedCurve& curve, const ParametrisedScene& scene, int contacts,
                         const CurveLimits& limits) {
  BranchDiagram diagram{.branches = {}, .unfinished = curve.unfinished, .notes = curve.notes};
  const int longest = longest_order(scene, limits);
  for (const ExchangedBranch& branch : curve.branches)
    Clipping(scene, contacts, limits, longest).add(branch, diagram);
  if (diagram.branches.empty() && diagram.unfinished.empty())
    diagram.unfinished =
        fmt::format("no branch of two points or more from {:.6g} to {:.6g} rad/s", scene.low(), scene.high());
  return diagram;
}

}  // namespace signorini
