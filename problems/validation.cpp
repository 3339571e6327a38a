#include "problems/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "problems/admissible_set.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/skew_parts.hpp"
#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

void require(bool ok, const std::string& field, const std::string& found, const std::string& requirement) {
  if (!ok) throw InvalidProblem(field, found, requirement);
}

void require_finite(double value, const std::string& field) {
  require(std::isfinite(value), field, fmt::format("{}", value), "must be a finite number");
}

// Norms and energies are sums of squares and products: between these bounds none of them leaves the range of
// doubles, however lengths, masses and times are combined.
constexpr double kSmallest = 1e-60;
constexpr double kLargest = 1e60;

void require_magnitude(double size, const std::string& field) {
  require(size == 0.0 || (size >= kSmallest && size <= kLargest), field, fmt::format("{:g}", size),
          fmt::format("must be 0 or between {:g} and {:g}: choose other units", kSmallest, kLargest));
}

// A finite number of that magnitude.
void require_number(double value, const std::string& field) {
  require_finite(value, field);
  require_magnitude(std::abs(value), field);
}

void require_harmonic(int harmonic, int least, const std::string& field) {
  require(harmonic >= least && harmonic <= kMostLoadHarmonic, field + ".harmonic", std::to_string(harmonic),
          fmt::format("must be a whole number, {}..{}", least, kMostLoadHarmonic));
}

void require_dof(int dof, int size, const std::string& field) {
  require(dof >= 0 && dof < size, field, std::to_string(dof),
          fmt::format("must be a coordinate of the system, 0..{}", size - 1));
}

void check_matrix(const SparseMatrix& A, int size, const std::string& field) {
  require(A.rows() == size && A.cols() == size, field, fmt::format("{} x {} matrix", A.rows(), A.cols()),
          fmt::format("must be {} x {}", size, size));
  require_number(largest_entry(A), field);
}

void check_semidefinite(const SparseMatrix& A, const std::string& field, Definiteness definiteness,
                        const std::string& requirement) {
  require(definiteness != Definiteness::to_be_checked || is_semidefinite(A), field, "indefinite matrix",
          requirement);
}

// A itself where it is symmetric, else its symmetric part, which `made` then holds.
const SparseMatrix& without_skew(const SparseMatrix& A, SparseMatrix& made) {
  if (is_symmetric(A)) return A;
  symmetric_part(A).swap(made);
  return made;
}

SparseMatrix sum_of(const std::array<const SparseMatrix*, 3>& matrices) {
  SparseMatrix sum(matrices.front()->rows(), matrices.front()->cols());
  for (const SparseMatrix* A : matrices) {
    const double scale = largest_entry(*A);
    if (scale > 0.0) sum = combination({.alpha = 1.0, .beta = 1.0 / scale}, sum, *A);
  }
  return sum;
}

// A factorisation of the largest pattern among M, D and K takes so many operations at most if definiteness is
// to be judged. A core does some 2e10 in a second; up to four are needed.
constexpr double kMostOperations = 5e10;
constexpr int kSparse = 2000;  // coordinates: below, a full matrix takes 3e9

bool is_judged_in_seconds(const Problem& problem) {
  if (problem.size() < kSparse) return true;
  const SparseMatrix all = sum_of({&problem.mass(), &problem.damping(), &problem.stiffness()});
  try {
    return SparseCholesky::cost_of(all).operations <= kMostOperations;
  } catch (const std::bad_alloc&) {  // more entries than can be counted
    return false;
  }
}

// Coordinates alone are looked at where combinations of them need not be: numbers too small to be told from 0
// leave nothing of an element.
bool every_motion_is_resisted(const std::array<const SparseMatrix*, 3>& matrices, Definiteness definiteness) {
  const Eigen::Index size = matrices.front()->rows();
  if (definiteness != Definiteness::to_be_checked) {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(size);
    for (const SparseMatrix* A : matrices) diagonal += A->diagonal();
    return (diagonal.array() > 0.0).all();
  }
  return is_definite(sum_of(matrices));
}

// By construction D is alpha M + beta K with alpha, beta >= 0, a sum over modes, or these and dampers.
bool dissipates(const Problem& problem, const SparseMatrix& dissipative, Definiteness definiteness) {
  if (definiteness != Definiteness::to_be_checked) return (dissipative.diagonal().array() >= 0.0).all();
  const auto parts = proportional_damping(problem.mass(), problem.stiffness(), dissipative);
  return (parts && parts->alpha >= 0.0 && parts->beta >= 0.0) || is_semidefinite(dissipative);
}

void check_matrices(const Problem& problem, Definiteness known) {
  const int size = problem.size();
  require(size > 0, "system.mass", fmt::format("{} x {} matrix", size, problem.mass().cols()),
          "must have at least one coordinate");
  check_matrix(problem.mass(), size, "system.mass");
  check_matrix(problem.damping(), size, "system.damping");
  check_matrix(problem.stiffness(), size, "system.stiffness");
  require(largest_entry(problem.mass()) > 0.0, "system.mass", "0", "some coordinate must carry mass");
  const Definiteness definiteness = known == Definiteness::to_be_checked && !is_judged_in_seconds(problem)
                                        ? Definiteness::not_judged
                                        : known;
  require(is_symmetric(problem.mass()), "system.mass", "unsymmetric matrix",
          "must be symmetric to 1e-12 of its largest entry");
  check_semidefinite(problem.mass(), "system.mass", definiteness, "must be positive semi-definite");
  SparseMatrix of_springs, of_dampers;
  const SparseMatrix& elastic = without_skew(problem.stiffness(), of_springs);
  check_semidefinite(elastic, "system.stiffness", definiteness,
                     of_springs.size() == 0 ? "must be positive semi-definite"
                                            : "its symmetric part must be positive semi-definite");
  const SparseMatrix& dissipative = without_skew(problem.damping(), of_dampers);
  require(dissipates(problem, dissipative, definiteness), "system.damping", "matrix that feeds energy",
          "its symmetric part must be positive semi-definite");
  require(every_motion_is_resisted({&problem.mass(), &dissipative, &elastic}, definiteness), "system",
          "structure with a loose coordinate", "every motion must meet a mass, a damper or a spring");
}

void check_forcing(const Problem& problem) {
  constexpr int kMaxSubharmonic = 64;
  constexpr double kFastest = 1e20;  // [rad/s]
  require(std::isfinite(problem.frequency) && problem.frequency > 0.0, "forcing.frequency",
          fmt::format("{}", problem.frequency), "must be a positive number [rad/s]");
  require(problem.frequency >= 1.0 / kFastest && problem.frequency <= kFastest, "forcing.frequency",
          fmt::format("{:g}", problem.frequency),
          fmt::format("must be between {:g} and {:g} [rad/s]: choose other units", 1.0 / kFastest, kFastest));
  require(problem.subharmonic >= 1 && problem.subharmonic <= kMaxSubharmonic, "forcing.subharmonic",
          std::to_string(problem.subharmonic), fmt::format("must be a whole number, 1..{}", kMaxSubharmonic));
  for (std::size_t i = 0; i < problem.force.size(); ++i) {
    const ForceTerm& term = problem.force[i];
    const std::string field = fmt::format("forcing.term[{}]", i);
    require_dof(term.dof, problem.size(), field + ".dof");
    require_harmonic(term.harmonic, 0, field);
    require_number(term.cos, field + ".cos");
    require_number(term.sin, field + ".sin");
    require(term.omega_power >= 0 && term.omega_power <= 2, field + ".omega_power",
            std::to_string(term.omega_power), "must be 0, 1 or 2");
    require(term.harmonic > 0 || term.sin == 0.0, field + ".sin", fmt::format("{}", term.sin),
            "must be 0 or absent: at harmonic 0 a sine is nothing");
  }
}

void check_frame(const Problem& problem) {
  for (std::size_t i = 0; i < problem.frame.size(); ++i) {
    const FrameTerm& term = problem.frame[i];
    const std::string field = fmt::format("frame[{}]", i);
    require_dof(term.dof, problem.size(), field + ".dof");
    require_harmonic(term.harmonic, 1, field);
    require_finite(term.cos, field + ".cos");
    require_finite(term.sin, field + ".sin");
    require_magnitude(std::hypot(term.cos, term.sin), field);
  }
}

void check_contacts(const Problem& problem) {
  for (std::size_t j = 0; j < problem.contacts.size(); ++j) {
    const std::string field = fmt::format("contact[{}]", j);
    validate_normal(problem.contacts[j].normal, problem.size(), field + ".normal");
    require_finite(problem.contacts[j].gap, field + ".gap");
    require(std::abs(problem.contacts[j].gap) <= kLargest, field + ".gap",
            fmt::format("{:g}", problem.contacts[j].gap), fmt::format("must be at most {:g}", kLargest));
  }
}

// An impact on a normal with massless coordinates would have nothing to push: its inverse mass is infinite.
void check_impact_mass(const Problem& problem, std::size_t contact) {
  const Eigen::VectorXd inertia = problem.mass().diagonal();
  for (const auto& [dof, coefficient] : problem.contacts[contact].normal) {
    require(coefficient == 0.0 || inertia(dof) > 0.0, fmt::format("contact[{}].normal", contact),
            "partly massless", "under a restitution law every coordinate of a normal must carry mass");
  }
}

// Whether a contact has the law that it needs: a rigid stop an impact law exactly where it meets mass.
struct ContactLawCheck {
  const Problem& problem;
  const std::vector<bool>& massive;
  std::size_t contact;

  [[nodiscard]] std::string field(const char* key) const {
    return fmt::format("contact[{}].{}", contact, key);
  }
  void operator()(Massless) const {
    require(!massive[contact], field("restitution"), "missing",
            "required, in 0..1, unless a penalty is given: the contact coordinates carry mass");
  }
  void operator()(const Restitution& law) const {
    if (!massive[contact]) {
      require(std::ranges::find(massive, true) == massive.end(), fmt::format("contact[{}]", contact),
              "massless", "needs massless = true beside contacts that carry mass: no restitution is for it");
      throw InvalidProblem(field("restitution"), fmt::format("{}", law.e),
                           "must be absent: no contact coordinate carries mass");
    }
    require(law.e >= 0.0 && law.e <= 1.0, field("restitution"), fmt::format("{}", law.e), "must be in 0..1");
    check_impact_mass(problem, contact);
  }
  void operator()(const Spring& spring) const {
    require(std::isfinite(spring.stiffness) && spring.stiffness > 0.0, field("penalty"),
            fmt::format("{}", spring.stiffness), "must be a positive number [N/m]");
    require_magnitude(spring.stiffness, field("penalty"));
  }
};

void refuse_conflict(const std::optional<StopConflict>& conflict) {
  if (!conflict) return;
  throw InvalidProblem(fmt::format("contact[{}].{}", conflict->contact, conflict->key),
                       fmt::format("{:g}", conflict->found), conflict->requirement);
}

void check_laws(const Problem& problem) {
  if (problem.contacts.empty()) return;
  const std::vector<bool> massive = contacts_with_mass(problem);
  for (std::size_t j = 0; j < problem.contacts.size(); ++j)
    std::visit(ContactLawCheck{problem, massive, j}, problem.contacts[j].law);
  refuse_conflict(restitution_conflict(problem.contacts));
  refuse_conflict(stop_conflict(problem.contacts));
}

}  // namespace

void validate_normal(const std::vector<std::pair<int, double>>& normal, int size, const std::string& field) {
  std::set<int> seen;
  bool nonzero = false;
  for (std::size_t i = 0; i < normal.size(); ++i) {
    const auto& [dof, coefficient] = normal[i];
    const std::string entry = fmt::format("{}[{}]", field, i);
    require_dof(dof, size, entry + "[0]");
    require(seen.insert(dof).second, entry + "[0]", std::to_string(dof), "must name each coordinate once");
    require_number(coefficient, entry + "[1]");
    nonzero = nonzero || coefficient != 0.0;
  }
  require(nonzero, field, normal.empty() ? "[]" : "zero vector", "needs a nonzero coefficient");
}

void validate(const Problem& problem, Definiteness definiteness) {
  check_matrices(problem, definiteness);
  check_forcing(problem);
  check_frame(problem);
  check_contacts(problem);
  check_laws(problem);
}

}  // namespace signorini
