#include "methods/harmonic_balance/distinct_stops.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

/// Normal and gap of a stop, whatever the order of the entries.
using StopKey = std::pair<std::vector<std::pair<int, double>>, double>;

StopKey key_of(const Contact& contact) {
  StopKey key{contact.normal, contact.gap};
  std::erase_if(key.first, [](const auto& entry) { return entry.second == 0.0; });
  std::ranges::sort(key.first);
  return key;
}

/// A motion whose contacts are those of another one, taken several times or together.
class RearrangedTrajectory final : public Trajectory {
 public:
  /// x = x_base(:, source), force = force_base * shares; `shares` has one row for each contact of the base.
  RearrangedTrajectory(std::shared_ptr<const Trajectory> base, std::vector<int> source,
                       Eigen::MatrixXd shares)
      : base_(std::move(base)), source_(std::move(source)), shares_(std::move(shares)) {}

  [[nodiscard]] int contact_count() const override { return static_cast<int>(source_.size()); }
  [[nodiscard]] double period() const override { return base_->period(); }
  [[nodiscard]] Samples sample(int count) const override {
    const Samples samples = base_->sample(count);
    return {columns_of(samples.x, source_), columns_of(samples.velocity, source_),
            product(samples.force, shares_)};
  }
  [[nodiscard]] std::vector<Impulse> impulses() const override {
    std::vector<Impulse> all;
    for (const Impulse& impulse : base_->impulses()) {
      for (int contact = 0; contact < contact_count(); ++contact) {
        const double share = shares_(impulse.contact, contact);
        if (share != 0.0) all.push_back({contact, impulse.time, impulse.value * share});
      }
    }
    return all;
  }
  [[nodiscard]] std::optional<int> nodes() const override { return base_->nodes(); }
  [[nodiscard]] std::optional<int> bandwidth() const override { return base_->bandwidth(); }
  [[nodiscard]] Eigen::MatrixXcd force_coefficients() const override {
    const Eigen::MatrixXcd coefficients = base_->force_coefficients();
    if (coefficients.size() == 0) return coefficients;
    return complex_product(coefficients, shares_.cast<std::complex<double>>());
  }

 private:
  std::shared_ptr<const Trajectory> base_;
  std::vector<int> source_;
  Eigen::MatrixXd shares_;
};

/// One row for each distinct stop, one column for each contact of the scene: 1 where they belong together.
Eigen::MatrixXd membership(const DistinctStops& stops) {
  Eigen::MatrixXd belongs =
      Eigen::MatrixXd::Zero(stops.problem.contact_count(), static_cast<Eigen::Index>(stops.places.size()));
  for (std::size_t contact = 0; contact < stops.places.size(); ++contact)
    belongs(stops.places[contact], static_cast<Eigen::Index>(contact)) = 1.0;
  return belongs;
}

}  // namespace

std::optional<DistinctStops> distinct_stops(const Problem& problem) {
  DistinctStops stops{.problem = problem};
  stops.problem.contacts.clear();
  std::map<StopKey, int> known;
  for (const Contact& contact : problem.contacts) {
    const int next = stops.problem.contact_count();
    const bool spring = std::holds_alternative<Spring>(contact.law);
    const int place = spring ? next : known.try_emplace(key_of(contact), next).first->second;
    if (place == next) stops.problem.contacts.push_back(contact);
    stops.places.push_back(place);
  }
  if (stops.problem.contact_count() == problem.contact_count()) return std::nullopt;
  return stops;
}

std::shared_ptr<const Trajectory> on_all_contacts(std::shared_ptr<const Trajectory> motion,
                                                  const DistinctStops& stops) {
  Eigen::MatrixXd shares = membership(stops);
  const Eigen::VectorXd copies = shares.rowwise().sum();
  shares.array().colwise() /= copies.array();
  return std::make_shared<RearrangedTrajectory>(std::move(motion), stops.places, std::move(shares));
}

std::shared_ptr<const Trajectory> on_distinct_stops(std::shared_ptr<const Trajectory> motion,
                                                    const DistinctStops& stops) {
  std::vector<int> first(static_cast<std::size_t>(stops.problem.contact_count()));
  for (std::size_t contact = stops.places.size(); contact-- > 0;)
    first[static_cast<std::size_t>(stops.places[contact])] = static_cast<int>(contact);
  return std::make_shared<RearrangedTrajectory>(std::move(motion), std::move(first),
                                                membership(stops).transpose());
}

}  // namespace signorini
