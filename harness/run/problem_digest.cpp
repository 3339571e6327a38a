#include "harness/run/problem_digest.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "harness/files.hpp"
#include "harness/records/record_json.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

/// Entries in (1, 2) without a pattern that the structure of a matrix could share: the fractions of i times
/// the golden ratio.
Eigen::VectorXd probe(Eigen::Index size) {
  Eigen::VectorXd entries(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double turn = static_cast<double>(i + 1) * std::numbers::phi;
    entries[i] = 1.0 + turn - std::floor(turn);
  }
  return entries;
}

}  // namespace

std::string problem_digest(const Problem& problem, const RepresentedLaw& law) {
  std::string bytes = fmt::format("{} {:a} {} {}\n", problem.size(), problem.frequency, problem.subharmonic,
                                  json_text(JsonForm<RepresentedLaw>::write(law)));
  const Eigen::VectorXd vector = probe(problem.size());
  std::vector<const SparseMatrix*> matrices{&problem.mass(), &problem.damping(), &problem.stiffness()};
  if (const SpeedTerms* speed = problem.structure->speed.get())
    matrices.insert(matrices.end(), {&speed->gyroscopic, &speed->circulatory});
  for (const SparseMatrix* matrix : matrices) {
    const Eigen::VectorXd product = *matrix * vector;
    bytes.append(reinterpret_cast<const char*>(product.data()),
                 static_cast<std::size_t>(product.size()) * sizeof(double));
  }
  // At this frequency; what moves with the stops enters by its loads.
  for (const ForceTerm& term : problem.force) {
    const double factor = std::pow(problem.frequency, term.omega_power);
    bytes +=
        fmt::format("f {} {} {:a} {:a}\n", term.dof, term.harmonic, factor * term.cos, factor * term.sin);
  }
  for (const Contact& contact : problem.contacts) {
    bytes += fmt::format("g {:a}", contact.gap);
    for (const auto& [dof, coefficient] : contact.normal) bytes += fmt::format(" {} {:a}", dof, coefficient);
    bytes += "\n";
  }
  return short_digest(bytes);
}

}  // namespace signorini
