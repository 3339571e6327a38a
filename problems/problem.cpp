#include "problems/problem.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "problems/matrix_properties.hpp"
#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

// A coordinate combination whose inertia or stiffness is below this fraction of the matrix's largest
// entry has none: what is left is rounding of the assembly.
constexpr double kNothing = 1e-14;

// w_j^T A w_j / |w_j|^4 for every column w_j of W, zero where it is rounding only.
Eigen::VectorXd reduced(const SparseMatrix& A, const SparseMatrix& W) {
  const SparseMatrix AW = A * W;
  const double least = kNothing * largest_entry(A);
  Eigen::VectorXd forms(W.cols());
  for (int j = 0; j < W.cols(); ++j) {
    const double form = W.col(j).dot(AW.col(j));
    const double length2 = W.col(j).squaredNorm();
    forms(j) = form > least * length2 ? form / (length2 * length2) : 0.0;
  }
  return forms;
}

template <class Kind>
bool has_law(const Problem& problem) {
  return std::ranges::any_of(
      problem.contacts, [](const Contact& contact) { return std::holds_alternative<Kind>(contact.law); });
}

void require_one_law_each(std::size_t laws, std::size_t contacts) {
  if (laws != contacts)
    throw std::invalid_argument("laws = " + std::to_string(laws) +
                                " (must be one per contact: " + std::to_string(contacts) + ")");
}

struct SetLaws {
  std::vector<Contact>& contacts;
  void operator()(std::monostate) const { (*this)(Massless{}); }
  void operator()(const auto& same) const {
    for (Contact& contact : contacts) contact.law = same;
  }
  void operator()(const Penalty& springs) const {
    require_one_law_each(springs.stiffness.size(), contacts.size());
    for (std::size_t j = 0; j < contacts.size(); ++j) contacts[j].law = Spring{springs.stiffness[j]};
  }
  void operator()(const MixedLaws& mixed) const {
    require_one_law_each(mixed.laws.size(), contacts.size());
    for (std::size_t j = 0; j < contacts.size(); ++j) contacts[j].law = mixed.laws[j];
  }
};

}  // namespace

Law common_law(const std::vector<ContactLaw>& laws) {
  if (laws.empty()) return {};
  const auto all = [&laws](const auto& is) { return std::ranges::all_of(laws, is); };
  if (all([](const ContactLaw& law) { return std::holds_alternative<Spring>(law); })) {
    Penalty springs;
    for (const ContactLaw& law : laws) springs.stiffness.push_back(std::get<Spring>(law).stiffness);
    return springs;
  }
  if (!all([&laws](const ContactLaw& law) { return law == laws.front(); })) return MixedLaws{laws};
  if (const auto* restitution = std::get_if<Restitution>(&laws.front())) return *restitution;
  return Massless{};
}

Law Problem::law() const {
  std::vector<ContactLaw> laws;
  for (const Contact& contact : contacts) laws.push_back(contact.law);
  return common_law(laws);
}

void Problem::set_law(const Law& law) { std::visit(SetLaws{contacts}, law); }

Problem at_frequency(Problem problem, double frequency) {
  problem.frequency = frequency;
  if (const std::shared_ptr<const SpeedTerms> speed = problem.structure->speed) {
    problem.edit_structure([&](Structure& s) {
      s.damping = speed->damping + frequency * speed->gyroscopic;
      s.stiffness = speed->stiffness + frequency * speed->circulatory;
    });
  }
  return problem;
}

void follow_speed(Structure& structure, const SparseMatrix& gyroscopic, const SparseMatrix& circulatory) {
  structure.speed = std::make_shared<const SpeedTerms>(SpeedTerms{.damping = structure.damping,
                                                                  .stiffness = structure.stiffness,
                                                                  .gyroscopic = gyroscopic,
                                                                  .circulatory = circulatory});
}

Problem with_subharmonic(Problem problem, int order) {
  problem.subharmonic = order;
  return problem;
}

SparseMatrix contact_directions(const Problem& problem) {
  return contact_directions(problem.contacts, problem.size());
}

SparseMatrix contact_directions(const std::vector<Contact>& contacts, int size) {
  const int count = static_cast<int>(contacts.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < count; ++j) {
    for (const auto& [dof, coefficient] : contacts[static_cast<std::size_t>(j)].normal) {
      entries.emplace_back(dof, j, coefficient);
    }
  }
  SparseMatrix W(size, count);
  W.setFromTriplets(entries.begin(), entries.end());
  return W;
}

std::vector<int> contact_coordinates(const std::vector<Contact>& contacts) {
  std::set<int> coordinates;
  for (const Contact& contact : contacts) {
    for (const auto& [dof, coefficient] : contact.normal)
      if (coefficient != 0.0) coordinates.insert(dof);
  }
  return {coordinates.begin(), coordinates.end()};
}

std::vector<std::vector<int>> contact_groups(const std::vector<Contact>& contacts) {
  std::vector<int> leader(contacts.size());  // of lower or the same number, up to the first of a group
  std::iota(leader.begin(), leader.end(), 0);
  const auto first_of = [&](int j) {
    while (leader[static_cast<std::size_t>(j)] != j) {
      int& up = leader[static_cast<std::size_t>(j)];
      up = leader[static_cast<std::size_t>(up)];
      j = up;
    }
    return j;
  };
  std::map<int, int> first_at;  // of each coordinate
  for (int j = 0; j < std::ssize(contacts); ++j) {
    for (const auto& [dof, coefficient] : contacts[static_cast<std::size_t>(j)].normal) {
      if (coefficient == 0.0) continue;
      const auto [low, high] =
          std::minmax({first_of(j), first_of(first_at.try_emplace(dof, j).first->second)});
      leader[static_cast<std::size_t>(high)] = low;
    }
  }
  std::map<int, std::vector<int>> groups;
  for (int j = 0; j < std::ssize(contacts); ++j) groups[first_of(j)].push_back(j);
  std::vector<std::vector<int>> result;
  for (auto& [first, members] : groups) result.push_back(std::move(members));
  return result;
}

Eigen::VectorXd stop_compliance(const Problem& problem) {
  Eigen::VectorXd compliance = Eigen::VectorXd::Zero(problem.contact_count());
  for (std::size_t j = 0; j < problem.contacts.size(); ++j) {
    if (const auto* spring = std::get_if<Spring>(&problem.contacts[j].law))
      compliance[static_cast<Eigen::Index>(j)] = 1.0 / spring->stiffness;
  }
  return compliance;
}

bool has_impacts(const Problem& problem) { return has_law<Restitution>(problem); }

bool has_springs(const Problem& problem) { return has_law<Spring>(problem); }

Eigen::VectorXd contact_gaps(const Problem& problem) {
  Eigen::VectorXd gaps(problem.contact_count());
  std::ranges::transform(problem.contacts, gaps.begin(), &Contact::gap);
  return gaps;
}

std::complex<double> force_amplitude(const ForceTerm& term, double frequency) {
  const std::complex<double> amplitude(term.cos, term.harmonic == 0 ? 0.0 : -term.sin);
  return term.omega_power == 0 ? amplitude : std::pow(frequency, term.omega_power) * amplitude;
}

bool load_grows(const Problem& problem) {
  return std::ranges::any_of(problem.force, [](const ForceTerm& term) {
    return term.omega_power > 0 && (term.cos != 0.0 || term.sin != 0.0);
  });
}

Eigen::VectorXcd load_harmonic(const Problem& problem, int harmonic) {
  Eigen::VectorXcd load = Eigen::VectorXcd::Zero(problem.size());
  for (const ForceTerm& term : problem.force) {
    if (term.harmonic == harmonic) load(term.dof) += force_amplitude(term, problem.frequency);
  }
  return load;
}

Eigen::VectorXcd load_harmonic_rate(const Problem& problem, int harmonic) {
  Eigen::VectorXcd rate = Eigen::VectorXcd::Zero(problem.size());
  for (const ForceTerm& term : problem.force) {
    if (term.harmonic != harmonic || term.omega_power == 0) continue;
    rate(term.dof) += term.omega_power / problem.frequency * force_amplitude(term, problem.frequency);
  }
  return rate;
}

Eigen::VectorXcd frame_motion(const Problem& problem, int dof) {
  int highest = 0;
  for (const FrameTerm& term : problem.frame) highest = std::max(highest, term.harmonic);
  Eigen::VectorXcd motion = Eigen::VectorXcd::Zero(highest + 1);
  for (const FrameTerm& term : problem.frame) {
    if (term.dof == dof) motion(term.harmonic) += std::complex<double>(term.cos, -term.sin);
  }
  return motion;
}

Eigen::VectorXcd stop_motion(const Problem& problem, int contact) {
  Eigen::VectorXcd motion = frame_motion(problem, -1);  // of no coordinate: zeros
  for (const auto& [dof, coefficient] : problem.contacts[static_cast<std::size_t>(contact)].normal)
    motion += coefficient * frame_motion(problem, dof);
  return motion;
}

int highest_load_harmonic(const Problem& problem) {
  int highest = 0;
  for (const ForceTerm& term : problem.force) {
    if (term.cos != 0.0 || term.sin != 0.0) highest = std::max(highest, term.harmonic);
  }
  return highest;
}

int load_bandwidth(const Problem& problem) { return highest_load_harmonic(problem) * problem.subharmonic; }

int whole_periods(double period, double part) {
  constexpr double kSame = 1e-6;
  const double ratio = period / part;
  const double whole = std::round(ratio);
  if (!(whole >= 1.0 && whole <= 1.0 / kSame)) return 0;
  return std::abs(ratio - whole) <= kSame * ratio ? static_cast<int>(whole) : 0;
}

Eigen::VectorXd load_at(const Problem& problem, double time) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(problem.size());
  for (const ForceTerm& term : problem.force) {
    const double angle = term.harmonic * problem.frequency * time;
    const std::complex<double> amplitude = force_amplitude(term, problem.frequency);
    load(term.dof) += amplitude.real() * std::cos(angle) - amplitude.imag() * std::sin(angle);
  }
  return load;
}

Eigen::MatrixXd delassus_matrix(const Problem& problem) {
  if (!is_definite(problem.mass())) {
    throw std::invalid_argument("mass = singular (must be positive definite for the Delassus matrix)");
  }
  const SparseMatrix W = contact_directions(problem);
  SparseCholesky factors(problem.mass());
  Eigen::MatrixXd G(W.cols(), W.cols());
  // One column at a time: all of them together would be a dense Nd x Nc array.
  for (int j = 0; j < W.cols(); ++j) {
    G.col(j) = W.transpose() * factors.solve(Eigen::MatrixXd(W.col(j)));
  }
  return G;
}

Eigen::VectorXd contact_stiffness_scale(const Problem& problem) {
  const SparseMatrix W = contact_directions(problem);
  const double omega = problem.frequency;
  Eigen::VectorXd scale = reduced(problem.stiffness(), W);
  if ((scale.array() > 0.0).all()) return scale;
  const Eigen::VectorXd inertia = omega * omega * reduced(problem.mass(), W);
  const Eigen::VectorXd resistance = omega * reduced(problem.damping(), W);
  for (int j = 0; j < scale.size(); ++j) {
    // Neither spring nor mass: validate() has made sure of a damper.
    if (scale(j) == 0.0) scale(j) = inertia(j) > 0.0 ? inertia(j) : resistance(j);
  }
  return scale;
}

std::vector<bool> contacts_with_mass(const Problem& problem) {
  const SparseMatrix W = contact_directions(problem);
  const SparseMatrix momenta = problem.mass() * W;
  const double least = kNothing * largest_entry(problem.mass());
  std::vector<bool> massive;
  for (int j = 0; j < W.cols(); ++j)
    massive.push_back(largest_entry(momenta.col(j)) > least * largest_entry(W.col(j)));
  return massive;
}

}  // namespace signorini
