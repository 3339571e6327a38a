#include "methods/complementarity/contact_nodes.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "methods/discretisation/gauss_rule.hpp"

namespace signorini {

namespace {

template <class NodesOf>
ContactNodes joined(const std::vector<ContactInterval>& intervals, NodesOf nodes_of) {
  ContactNodes all;
  for (const ContactInterval& interval : intervals) {
    const ContactNodes part = nodes_of(interval);
    for (const auto& [whole, added] : {std::pair{&all.time, &part.time}, {&all.weight, &part.weight}}) {
      whole->conservativeResize(whole->size() + added->size());
      whole->tail(added->size()) = *added;
    }
  }
  return all;
}

}  // namespace

int node_count(double length, int harmonics) {
  return gauss_nodes_for(std::numbers::pi * harmonics * length);
}

ContactNodes nodes_on(double begin, double end, int harmonics) {
  const double half = 0.5 * (end - begin);
  const GaussRule& rule = gauss_rule(node_count(end - begin, harmonics));
  return {.time = (0.5 * (begin + end) + half * rule.nodes.array()).matrix(), .weight = half * rule.weights};
}

ContactNodes nodes_on(const std::vector<ContactInterval>& intervals, int harmonics) {
  return joined(intervals, [harmonics](const ContactInterval& interval) {
    return nodes_on(interval.begin, interval.end, harmonics);
  });
}

ContactNodes samples_on(const std::vector<ContactInterval>& intervals, int samples) {
  return joined(intervals, [samples](const ContactInterval& interval) -> ContactNodes {
    const Eigen::Index count = std::lround((interval.end - interval.begin) * samples);
    const double step = 1.0 / samples;
    const bool throughout = count == samples;
    return {.time = (throughout ? 0.0 : interval.begin + 0.5 * step) +
                    step * Eigen::ArrayXd::LinSpaced(count, 0.0, static_cast<double>(count - 1)),
            .weight = Eigen::VectorXd::Constant(count, step)};
  });
}

Eigen::MatrixXcd phases_at(const Eigen::VectorXd& time, int harmonics) {
  Eigen::MatrixXcd phases(time.size(), harmonics + 1);
  Eigen::VectorXcd unit(time.size());
  for (Eigen::Index i = 0; i < time.size(); ++i) unit[i] = std::polar(1.0, 2.0 * std::numbers::pi * time[i]);
  phases.col(0).setOnes();
  for (int n = 1; n <= harmonics; ++n) phases.col(n) = phases.col(n - 1).cwiseProduct(unit);
  return phases;
}

}  // namespace signorini
