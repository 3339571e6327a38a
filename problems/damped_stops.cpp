#include "problems/damped_stops.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "problems/validation.hpp"

namespace signorini {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

void require_positive(double value, const char* key, int contact, const std::string& unit) {
  if (std::isfinite(value) && value > 0.0) return;
  throw InvalidProblem(fmt::format("contact[{}].{}", contact, key), fmt::format("{}", value),
                       fmt::format("must be a positive number [{}]", unit));
}

// `A`, larger by the faces, and what is added to it.
SparseMatrix extended(const SparseMatrix& A, int size, Triplets added) {
  for_each_entry(A, [&](int row, int column, double value) { added.emplace_back(row, column, value); });
  SparseMatrix result(size, size);
  result.setFromTriplets(added.begin(), added.end());
  return result;
}

// factor n n^T of n = (w, -1), the face being coordinate `face`.
void add_element(Triplets& entries, const DampedStop& stop, int face, double factor) {
  std::vector<std::pair<int, double>> n = stop.normal;
  n.emplace_back(face, -1.0);
  for (const auto& [row, of_row] : n) {
    for (const auto& [column, of_column] : n) {
      if (of_row != 0.0 && of_column != 0.0) entries.emplace_back(row, column, factor * of_row * of_column);
    }
  }
}

}  // namespace

void damp_stops(Problem& problem, const std::vector<DampedStop>& stops) {
  const int first = problem.size();
  Triplets springs, dampers;
  for (std::size_t j = 0; j < stops.size(); ++j) {
    const DampedStop& stop = stops[j];
    // What validate() will not see once the contact acts on the face.
    validate_normal(stop.normal, first, fmt::format("contact[{}].normal", stop.contact));
    require_positive(stop.stiffness, "penalty", stop.contact, "N/m");
    require_positive(stop.damping, "damper", stop.contact, "N s/m");
    const int face = first + static_cast<int>(j);
    add_element(springs, stop, face, stop.stiffness);
    add_element(dampers, stop, face, stop.damping);
    Contact& contact = problem.contacts[static_cast<std::size_t>(stop.contact)];
    contact.normal = {{face, 1.0}};
    contact.law = Massless{};
  }
  const int size = first + static_cast<int>(stops.size());
  problem.edit_structure([&](Structure& s) {
    s.mass = extended(s.mass, size, {});
    s.damping = extended(s.damping, size, dampers);
    s.stiffness = extended(s.stiffness, size, springs);
    if (s.speed)
      s.speed = std::make_shared<const SpeedTerms>(
          SpeedTerms{.damping = extended(s.speed->damping, size, std::move(dampers)),
                     .stiffness = extended(s.speed->stiffness, size, std::move(springs)),
                     .gyroscopic = extended(s.speed->gyroscopic, size, {}),
                     .circulatory = extended(s.speed->circulatory, size, {})});
  });
}

std::vector<Contact> contacts_of_structure(std::vector<Contact> contacts,
                                           const std::vector<DampedStop>& stops) {
  for (const DampedStop& stop : stops) contacts[static_cast<std::size_t>(stop.contact)].normal = stop.normal;
  return contacts;
}

}  // namespace signorini
