#include "harness/motion/stop_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "methods/discretisation/two_point_integral.hpp"

namespace signorini {

namespace {

/// Derivatives 0..4 from the one number `first` of a row on.
Derivatives derivatives_of(const Eigen::MatrixXd& row_values, int contact, Eigen::Index first = 0) {
  Derivatives values{};
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = row_values(contact, first + static_cast<Eigen::Index>(k));
  return values;
}

/// Of the product of two functions, by Leibniz' rule.
Derivatives product_of(const Derivatives& f, const Derivatives& g) {
  constexpr std::array<Derivatives, 5> kBinomial{{{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}}};
  Derivatives product{};
  for (std::size_t k = 0; k < product.size(); ++k)
    for (std::size_t i = 0; i <= k; ++i) product[k] += kBinomial[k][i] * f[i] * g[k - i];
  return product;
}

/// Taylor's sum of derivatives 0, 1, ... at a distance t.
double taylor(std::span<const double> derivatives, double t) {
  double sum = 0.0;
  for (std::size_t k = derivatives.size(); k-- > 0;)
    sum = derivatives[k] + sum * t / static_cast<double>(k + 1);
  return sum;
}

/// The value where the slope vanishes within `reach` of an instant with these derivatives, if it does.
std::optional<double> turning_value(const Derivatives& at, double reach) {
  const std::span all(at);
  double t = 0.0;
  for (int step = 0; step < 6; ++step) {  // of Newton's method
    t -= taylor(all.subspan(1), t) / taylor(all.subspan(2), t);
    if (!(std::abs(t) <= reach)) return std::nullopt;
  }
  return taylor(all, t);
}

/// Least and largest value that a function takes between two instants, added to what is known.
struct Range {
  double least = 0.0, largest = 0.0;

  void take(double value) {
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  void take(const Derivatives& left, const Derivatives& right, double h) {
    take(left[0]);
    take(right[0]);
    if (left[1] * right[1] >= 0.0) return;
    const bool from_left = std::abs(left[1]) <= std::abs(right[1]);
    if (const auto value = turning_value(from_left ? left : right, h)) take(*value);
  }
};

Estimate root_mean_square(const std::vector<double>& squares) {
  const Estimate square = batch_mean(squares);
  const double root = std::sqrt(std::max(0.0, square.value));
  return {.value = root, .error = root > 0.0 ? 0.5 * square.error / root : 0.0};
}

/// About the mean of a value whose means and mean squares are given.
Estimate deviation(const std::vector<double>& values, std::vector<double> squares, double mean) {
  for (std::size_t i = 0; i < squares.size(); ++i) squares[i] += mean * (mean - 2.0 * values[i]);
  return root_mean_square(squares);
}

/// The largest value; its error is what the other half of the periods has less.
Estimate largest_of(const std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() + 1) / 2);
  const double first = *std::max_element(values.begin(), middle);
  const double second = middle == values.end() ? first : *std::max_element(middle, values.end());
  return {.value = std::max(first, second), .error = std::abs(first - second)};
}

}  // namespace

void StopSums::take_intervals(const FlowRecord& record, int contact, double duration, Stop& stop) {
  double x = 0.0, x_square = 0.0, force_square = 0.0, push = 0.0, work = 0.0;
  const double first = record.nodes.front().x(contact, 0);
  Range range{.least = first, .largest = first}, forces;
  for (std::size_t i = 1; i < record.nodes.size(); ++i) {
    const FlowNode &left = record.nodes[i - 1], &right = record.nodes[i];
    const double h = right.time - left.time;
    if (h <= 0.0) continue;
    const Derivatives x0 = derivatives_of(left.x, contact), x1 = derivatives_of(right.x, contact);
    const Derivatives f0 = derivatives_of(left.lambda, contact), f1 = derivatives_of(right.lambda, contact);
    x += two_point_integral(h, x0, x1);
    x_square += two_point_integral(h, product_of(x0, x0), product_of(x1, x1));
    range.take(x0, x1, h);
    const double here = two_point_integral(h, f0, f1);
    if (here < 0.0) {
      force_square += two_point_integral(h, product_of(f0, f0), product_of(f1, f1));
      work += two_point_integral(h, product_of(f0, derivatives_of(left.x, contact, 1)),
                                 product_of(f1, derivatives_of(right.x, contact, 1)));
      forces.take(f0, f1, h);
      push += here;
      stop.in_contact = stop.in_contact.value_or(0.0) + here;
    } else if (stop.in_contact) {
      stop.contacts.push_back(-*stop.in_contact);
      stop.in_contact.reset();
    }
  }
  stop.x.push_back(x / duration);
  stop.x_square.push_back(x_square / duration);
  stop.force_square.push_back(force_square / duration);
  stop.impulse.push_back(-push / duration);
  stop.power.push_back(-work / duration);
  stop.x_min.push_back(range.least);
  stop.x_max.push_back(range.largest);
  stop.force_peak.push_back(-forces.least);
}

void StopSums::take_impulses(const FlowRecord& record, int contact, double duration, Stop& stop) {
  for (const ContactEvent& event : record.events) {
    if (event.contact != contact || !(event.impulse < 0.0)) continue;
    stop.impulses.push_back(-event.impulse);
    stop.impulse.back() -= event.impulse / duration;
    // An impulse J works J (v_before + v_after) / 2.
    const auto before = std::ranges::lower_bound(record.nodes, event.time, {}, &FlowNode::time);
    auto after = before;
    while (after + 1 < record.nodes.end() && (after + 1)->time == before->time) ++after;
    if (before == record.nodes.end()) continue;
    const double speeds = before->x(contact, 1) + after->x(contact, 1);
    stop.power.back() -= 0.5 * event.impulse * speeds / duration;
  }
}

void StopSums::take(const FlowRecord& record, double duration) {
  for (std::size_t j = 0; j < stops_.size(); ++j) {
    Stop& stop = stops_[j];
    const std::size_t before = stop.impulses.size(), contacts = stop.contacts.size();
    take_intervals(record, static_cast<int>(j), duration, stop);
    take_impulses(record, static_cast<int>(j), duration, stop);
    // Where impacts have no width, phases of force are rest, not impacts.
    const std::size_t impacts =
        stop.impulses.empty() ? stop.contacts.size() - contacts : stop.impulses.size() - before;
    stop.impacts.push_back(static_cast<double>(impacts) / duration);
  }
}

std::vector<StopStatistics> StopSums::statistics() const {
  std::vector<StopStatistics> all;
  for (const Stop& stop : stops_) {
    StopStatistics one{.x_mean = batch_mean(stop.x),
                       .x_min = *std::ranges::min_element(stop.x_min),
                       .x_max = *std::ranges::max_element(stop.x_max),
                       .impulse_per_second = batch_mean(stop.impulse),
                       .impacts_per_second = batch_mean(stop.impacts),
                       .power = batch_mean(stop.power)};
    one.x_rms = deviation(stop.x, stop.x_square, one.x_mean.value);
    if (stop.impulses.empty()) {
      one.force_rms = root_mean_square(stop.force_square);
      one.force_peak = largest_of(stop.force_peak);
    }
    const std::vector<double>& impacts = stop.impulses.empty() ? stop.contacts : stop.impulses;
    if (!impacts.empty()) {
      const auto count = static_cast<double>(impacts.size());
      const double mean = std::accumulate(impacts.begin(), impacts.end(), 0.0) / count;
      double square = 0.0;
      for (const double impulse : impacts) square += (impulse - mean) * (impulse - mean);
      one.impulse_mean = mean;
      one.impulse_deviation = std::sqrt(square / count);
    }
    all.push_back(one);
  }
  return all;
}

}  // namespace signorini
