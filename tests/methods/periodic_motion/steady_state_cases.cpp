#include "tests/methods/periodic_motion/steady_state_cases.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "tests/support/data_folder.hpp"

namespace signorini::test {

namespace {

using Json = nlohmann::json;

// Clamped-free bar, rho = E = A = L = 1, linear elements, consistent mass, C = 0.1 M + 0.002 K.
void assemble_bar(Problem& problem, int elements) {
  const double h = 1.0 / elements;
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(elements + 1, elements + 1), K = M;
  for (int i = 0; i < elements; ++i) {
    M.block<2, 2>(i, i) += h / 6.0 * (Eigen::Matrix2d() << 2.0, 1.0, 1.0, 2.0).finished();
    K.block<2, 2>(i, i) += 1.0 / h * (Eigen::Matrix2d() << 1.0, -1.0, -1.0, 1.0).finished();
  }
  const Eigen::MatrixXd inner_mass = M.bottomRightCorner(elements, elements);
  const Eigen::MatrixXd inner_stiffness = K.bottomRightCorner(elements, elements);
  problem.edit_structure([&](Structure& s) {
    s.mass = inner_mass.sparseView();
    s.stiffness = inner_stiffness.sparseView();
    s.damping = (0.1 * inner_mass + 0.002 * inner_stiffness).sparseView();
  });
}

SteadyStateCase parse(const Json& json) {
  SteadyStateCase result;
  result.name = json.at("name");
  result.order = json.at("order");
  Problem& problem = result.problem;
  problem.name = result.name;
  problem.frequency = json.at("frequency");
  const double load_size = json.at("load_size");
  if (json.contains("mass")) {
    problem.edit_structure([&](Structure& s) {
      s.mass = sparse(json.at("mass").get<Rows>());
      s.damping = sparse(json.at("damping").get<Rows>());
      s.stiffness = sparse(json.at("stiffness").get<Rows>());
    });
    const auto load = json.at("load").get<std::vector<double>>();
    for (std::size_t i = 0; i < load.size(); ++i) {
      if (load[i] == 0.0) continue;
      problem.force.push_back(
          {.dof = static_cast<int>(i), .harmonic = 1, .cos = load_size * load[i], .sin = 0.0});
    }
  } else {
    constexpr int kElements = 10;
    assemble_bar(problem, kElements);
    problem.force.push_back({.dof = kElements - 1, .harmonic = 1, .cos = load_size, .sin = 0.0});
  }
  for (const Json& contact : json.at("contacts")) {
    problem.contacts.push_back({.normal = {{contact.at("dof").get<int>(), contact.at("sign").get<double>()}},
                                .gap = contact.at("gap").get<double>()});
  }
  problem.set_law(Restitution{json.at("restitution").get<double>()});
  for (const Json& event : json.at("events")) {
    result.events.push_back({.phase = event[0],
                             .contact = event[1],
                             .type = event[2],
                             .approach = event[3],
                             .rebound = event[4],
                             .impulse = event[5]});
  }
  const auto columns = json.at("columns").get<std::vector<std::string>>();
  for (std::size_t i = 0; i < columns.size(); i += 2) result.dofs.push_back(std::stoi(columns[i].substr(1)));
  result.samples = json.at("samples").get<Rows>();
  return result;
}

// Impacts of one block of forcing periods that starts `shift` of them into the motion.
std::vector<Impulse> shifted_impacts(const Trajectory& found, double forcing_period, int shift, int order,
                                     double smallest) {
  std::vector<Impulse> impacts;
  for (Impulse impulse : found.impulses()) {
    if (-impulse.value <= smallest) continue;
    double phase = std::fmod(impulse.time / forcing_period - shift + order, order);
    if (phase > order - 1e-9) phase -= order;
    impulse.time = phase;
    impacts.push_back(impulse);
  }
  std::sort(impacts.begin(), impacts.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return impacts;
}

}  // namespace

SparseMatrix sparse(const Rows& rows) {
  const auto size = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd dense(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j)
      dense(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return dense.sparseView();
}

std::vector<SteadyStateCase> steady_state_cases(const std::string& family) {
  std::ifstream file(test::data_folder() / "siconos" / (family + ".json"));
  if (!file) throw std::runtime_error("tests/data/siconos/" + family + ".json is missing");
  std::vector<SteadyStateCase> cases;
  const Json json = Json::parse(file);
  for (const Json& entry : json.at("cases")) cases.push_back(parse(entry));
  return cases;
}

SteadyStateCase steady_state_case(const std::string& family, const std::string& name) {
  for (SteadyStateCase& entry : steady_state_cases(family)) {
    if (entry.name == name) return entry;
  }
  throw std::runtime_error("no case " + name + " in " + family);
}

SteadyStateDifference difference(const SteadyStateCase& expected, const Trajectory& found, double counted) {
  const double forcing_period = 2.0 * std::numbers::pi / expected.problem.frequency;
  const int order = expected.order;
  constexpr int kPerPeriod = 20;  // rows of the data per forcing period
  const Samples samples = found.sample(kPerPeriod * order);
  const double smallest = counted * (1.0 + std::get<Restitution>(expected.problem.law()).e);
  SteadyStateDifference best{.x = 1e300};
  for (int shift = 0; shift < order; ++shift) {
    SteadyStateDifference now;
    double largest = 0.0;
    for (const auto& row : expected.samples) {
      const int index =
          (static_cast<int>(std::lround(row[0] * kPerPeriod)) + shift * kPerPeriod) % (kPerPeriod * order);
      for (int j = 0; j < expected.problem.contact_count(); ++j) {
        const auto& [dof, sign] = expected.problem.contacts[static_cast<std::size_t>(j)].normal.front();
        const auto column =
            std::find(expected.dofs.begin(), expected.dofs.end(), dof) - expected.dofs.begin();
        const double x = sign * row[static_cast<std::size_t>(1 + 2 * column)];
        largest = std::max(largest, std::abs(x));
        now.x = std::max(now.x, std::abs(x - samples.x(index, j)));
      }
    }
    now.x /= largest;
    const auto impacts = shifted_impacts(found, forcing_period, shift, order, smallest);
    std::vector<ExpectedEvent> wanted;
    double largest_impulse = 0.0;
    for (const ExpectedEvent& event : expected.events) {
      if (event.type != 0 || event.impulse <= smallest) continue;
      wanted.push_back(event);
      largest_impulse = std::max(largest_impulse, event.impulse);
    }
    now.expected_impacts = static_cast<int>(wanted.size());
    now.found_impacts = static_cast<int>(impacts.size());
    for (std::size_t i = 0; i < std::min(wanted.size(), impacts.size()); ++i) {
      now.impact_time = std::max(now.impact_time, std::abs(wanted[i].phase - impacts[i].time));
      now.impulse = std::max(now.impulse, std::abs(wanted[i].impulse + impacts[i].value) / largest_impulse);
      if (wanted[i].contact != impacts[i].contact) now.impulse = 1.0;
    }
    if (now.x < best.x) best = now;
  }
  return best;
}

}  // namespace signorini::test
