#include "tests/reference/reference_data.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "methods/discretisation/real_fft.hpp"
#include "tests/support/data_folder.hpp"

namespace signorini::test {

namespace {

using Json = nlohmann::json;

Json read(const std::string& file) {
  std::ifstream stream(test::data_folder() / "reference" / file);
  if (!stream) throw std::runtime_error("missing test data: " + file);
  return Json::parse(stream);
}

// [a0, a1, b1, ...] of a0 + sum a_h cos + b_h sin, as x_0 = a0, x_h = (a_h - i b_h) / 2.
Eigen::VectorXcd complex_series(const Json& real) {
  const auto harmonics = static_cast<Eigen::Index>(real.size() / 2);
  Eigen::VectorXcd x(harmonics + 1);
  x[0] = real[0].get<double>();
  for (Eigen::Index n = 1; n <= harmonics; ++n) {
    const auto i = static_cast<std::size_t>(n);
    x[n] = 0.5 * std::complex<double>(real[2 * i - 1].get<double>(), -real[2 * i].get<double>());
  }
  return x;
}

ReferenceMotion motion_of(const Json& row) {
  ReferenceMotion motion{.omega = row.at("omega"),
                         .stiffness = row.value("stiffness", 0.0),
                         .restitution = row.value("restitution", 1.0),
                         .samples = row.value("samples", 0),
                         .close = row.value("close", row.value("impact_time", 0.0)),
                         .open = row.value("open", 0.0),
                         .impulse = row.value("impulse", 0.0)};
  const Json& series = row.at("coefficients");
  if (!series[0].is_array()) {
    motion.x = complex_series(series);
    return motion;
  }
  motion.x.resize(static_cast<Eigen::Index>(series[0].size() / 2 + 1),
                  static_cast<Eigen::Index>(series.size()));
  for (std::size_t c = 0; c < series.size(); ++c)
    motion.x.col(static_cast<Eigen::Index>(c)) = complex_series(series[c]);
  return motion;
}

std::vector<ReferenceMotion> motions_of(const Json& rows) {
  std::vector<ReferenceMotion> motions;
  for (const Json& row : rows) motions.push_back(motion_of(row));
  return motions;
}

SparseMatrix matrix_of(const Json& rows) {
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows[0].size()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      matrix(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get<double>();
    }
  }
  return matrix.sparseView();
}

}  // namespace

std::vector<ReferenceMotion> load_oscillator_motions(const std::string& file) {
  return motions_of(read(file).at("rows"));
}

ReferenceStructure load_structure(const std::string& name) {
  const Json data = read(name + ".json");
  ReferenceStructure structure{
      .problem = {}, .nlvib = motions_of(data.at("nlvib")), .exact = motions_of(data.at("exact"))};
  Problem& problem = structure.problem;
  problem.name = name;
  problem.kind = "matrices";
  problem.edit_structure([&](Structure& s) {
    s.mass = matrix_of(data.at("mass"));
    s.damping = matrix_of(data.at("damping"));
    s.stiffness = matrix_of(data.at("stiffness"));
  });
  const auto load = data.at("load_cos").get<std::vector<double>>();
  for (std::size_t i = 0; i < load.size(); ++i) {
    if (load[i] != 0.0)
      problem.force.push_back({.dof = static_cast<int>(i), .harmonic = 1, .cos = load[i], .sin = 0.0});
  }
  const SparseMatrix directions = matrix_of(data.at("directions"));
  const auto gap = data.at("gap").get<std::vector<double>>();
  for (int c = 0; c < directions.cols(); ++c) {
    Contact contact{.normal = {}, .gap = gap[static_cast<std::size_t>(c)]};
    for (SparseMatrix::InnerIterator it(directions, c); it; ++it) {
      contact.normal.emplace_back(static_cast<int>(it.row()), it.value());
    }
    problem.contacts.push_back(contact);
  }
  problem.set_law(Penalty{data.at("penalty").get<std::vector<double>>()});
  return structure;
}

Problem reference_oscillator(double omega, Law law) {
  Problem problem;
  problem.name = "reference-oscillator";
  problem.kind = "sdof";
  const auto scalar = [](double value) {
    SparseMatrix matrix(1, 1);
    matrix.insert(0, 0) = value;
    return matrix;
  };
  problem.edit_structure([&](Structure& s) {
    s.mass = scalar(1.0);
    s.damping = scalar(0.1);
    s.stiffness = scalar(1.0);
  });
  problem.frequency = omega;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 1.0}};
  problem.set_law(std::move(law));
  return problem;
}

std::shared_ptr<const Trajectory> start_from(const ReferenceMotion& motion, const Problem& problem) {
  FourierTrajectory::Data data;
  data.period = problem.period();
  data.x = motion.x;
  data.lambda = Eigen::MatrixXcd::Zero(motion.x.rows(), motion.x.cols());
  data.gap = contact_gaps(problem);
  const std::vector<double> stop = std::get<Penalty>(problem.law()).stiffness;
  data.stiffness = Eigen::Map<const Eigen::VectorXd>(stop.data(), data.gap.size());
  data.multiplier_weight = Eigen::VectorXd::Zero(data.gap.size());
  // Known of the motion is x alone; the spring's force follows from it.
  constexpr int kSamples = 4096;
  const Samples samples = FourierTrajectory(data).sample(kSamples);
  RealFft fft(kSamples);
  Eigen::VectorXcd spectrum(fft.coefficients());
  for (Eigen::Index c = 0; c < data.lambda.cols(); ++c) {
    fft.forward(samples.force.col(c), spectrum);
    data.lambda.col(c) = spectrum.head(data.lambda.rows());
  }
  return std::make_shared<FourierTrajectory>(std::move(data));
}

Eigen::MatrixXcd coefficients_of(const Solution& solution) {
  return dynamic_cast<const FourierTrajectory&>(*solution.trajectory).data().x;
}

double relative_l2(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& reference, int harmonics) {
  double error = 0.0;
  double size = 0.0;
  for (Eigen::Index n = 0; n <= harmonics; ++n) {
    // Harmonics n and -n both count.
    const double weight = n == 0 ? 1.0 : 2.0;
    Eigen::RowVectorXcd difference = Eigen::RowVectorXcd::Zero(reference.cols());
    if (n < x.rows()) difference += x.row(n);
    if (n < reference.rows()) {
      difference -= reference.row(n);
      size += weight * reference.row(n).squaredNorm();
    }
    error += weight * difference.squaredNorm();
  }
  return std::sqrt(error / size);
}

}  // namespace signorini::test
