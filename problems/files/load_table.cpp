#include "problems/files/load_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/files/text_lines.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

// cos and sin of 2 pi k / N, k = 0..N-1: no angle of a sum over the samples is another one.
struct Circle {
  explicit Circle(std::size_t count) : cos(count), sin(count) {
    for (std::size_t k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
      cos[k] = std::cos(angle);
      sin[k] = std::sin(angle);
    }
  }
  std::vector<double> cos, sin;
};

double mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum / static_cast<double>(values.size());
}

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& name) : lines_(text, name, ",; \t\r\v\f") {}

  std::vector<double> read(double period) {
    while (lines_.next()) take_line();
    if (samples_.size() < 3)
      lines_.refuse("samples", fmt::format("{}", samples_.size()), "must be at least 3");
    if (columns_ == 2) check_instants(period);
    return std::move(samples_);
  }

 private:
  void take_line() {
    const std::vector<std::string_view>& words = lines_.words();
    if (words[0].starts_with('#')) return;
    std::vector<double> numbers;
    for (const std::string_view word : words) {
      const std::optional<double> number = number_of<double>(word);
      // A heading: the first line with content, once.
      if (!number && columns_ == 0 && !headed_ && number_mistake(word).empty()) return void(headed_ = true);
      if (!number || !std::isfinite(*number))
        lines_.refuse("value", fmt::format("\"{}\"", one_line(word)),
                      fmt::format("must be a finite number{}", number_mistake(word)));
      numbers.push_back(*number);
    }
    if (columns_ == 0) columns_ = numbers.size();
    if (numbers.size() > 2 || numbers.size() != columns_)
      lines_.refuse("columns", std::to_string(numbers.size()),
                    fmt::format("must be 1, the samples, or 2, instants [s] and samples, in every line{}",
                                lines_.line().find_first_of("; \t") == std::string_view::npos
                                    ? ""
                                    : number_mistake(lines_.line())));
    if (columns_ == 2) instants_.push_back(numbers[0]);
    samples_.push_back(numbers.back());
    if (samples_.size() > kMostLoadSamples)
      lines_.refuse("samples", "more", fmt::format("must be at most {}", kMostLoadSamples));
  }

  void check_instants(double period) const {
    constexpr double kSame = 1e-6;  // of the period
    const double step = period / static_cast<double>(samples_.size());
    for (std::size_t i = 0; i < instants_.size(); ++i) {
      if (std::abs(instants_[i] - step * static_cast<double>(i)) <= kSame * period) continue;
      lines_.refuse(
          fmt::format("instant {}", i), fmt::format("{:g} s", instants_[i]),
          fmt::format("must be {:g} s: {} samples, equidistant from 0, fill the period of the load, {:g} s",
                      step * static_cast<double>(i), samples_.size(), period));
    }
  }

  TextLines lines_;
  std::size_t columns_ = 0;  // 0: not known yet
  bool headed_ = false;
  std::vector<double> instants_, samples_;
};

}  // namespace

SampledLoad load_of_samples(const std::vector<double>& samples, std::optional<int> harmonics) {
  constexpr double kNegligible = 1e-6;  // of the root mean square
  const std::size_t count = samples.size();
  const Circle circle(count);
  const std::size_t most = harmonics ? static_cast<std::size_t>(*harmonics) : (count - 1) / 2;
  SampledLoad load{.samples = static_cast<int>(count)};
  std::vector<double> left = samples;  // what the harmonics so far leave out
  for (std::size_t h = 0; h <= most; ++h) {
    double cos = 0.0, sin = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      cos += samples[i] * circle.cos[h * i % count];
      sin += samples[i] * circle.sin[h * i % count];
    }
    const double weight = (h == 0 ? 1.0 : 2.0) / static_cast<double>(count);
    load.cos.push_back(weight * cos);
    load.sin.push_back(h == 0 ? 0.0 : weight * sin);
    for (std::size_t i = 0; i < count; ++i)
      left[i] -= load.cos[h] * circle.cos[h * i % count] + load.sin[h] * circle.sin[h * i % count];
    load.left_out_rms = std::sqrt(mean_square(left));
    if (h == 0) load.rms = load.left_out_rms;
    if (!harmonics && load.left_out_rms <= kNegligible * load.rms) break;
  }
  for (const double value : left) load.left_out_max = std::max(load.left_out_max, std::abs(value));
  return load;
}

std::vector<double> parse_load_table(std::string_view text, const std::string& name, double period) {
  return TableReader(text, name).read(period);
}

}  // namespace signorini
