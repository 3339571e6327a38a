#include "simulation.hpp"

#include <SiconosKernel.hpp>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace siconos_rivals {

namespace {

// Gaps that an event may have, rounded to either side [m]; Siconos' own 2.2e-12 makes it stop at roots.
constexpr double kGapTolerance = 1e-8;
constexpr int kMostSteps = 100000;  // of LSODAR between two events

SP::SiconosVector vector_of(const Eigen::VectorXd& values) {
  auto vector = std::make_shared<SiconosVector>(static_cast<unsigned>(values.size()));
  std::copy(values.data(), values.data() + values.size(), vector->getArray());
  return vector;
}

SP::SimpleMatrix matrix_of(const Eigen::MatrixXd& values) {
  auto matrix = std::make_shared<SimpleMatrix>(static_cast<unsigned>(values.rows()),
                                               static_cast<unsigned>(values.cols()));
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (Eigen::Index j = 0; j < values.cols(); ++j)
      (*matrix)(static_cast<unsigned>(i), static_cast<unsigned>(j)) = values(i, j);
  }
  return matrix;
}

Eigen::VectorXd values_of(const SiconosVector& vector) {
  return Eigen::Map<const Eigen::VectorXd>(vector.getArray(), static_cast<Eigen::Index>(vector.size()));
}

State at_rest(const System& system) {
  return {Eigen::VectorXd::Zero(system.mass.rows()), Eigen::VectorXd::Zero(system.mass.rows())};
}

// f(), with what Siconos has to say where it throws.
template <class Function>
auto with_reasons(const Function& f) {
  try {
    return f();
  } catch (const Siconos::exception& error) {
    const std::string* message = boost::get_error_info<Siconos::exception::extra_message>(error);
    throw std::runtime_error("Siconos: " + (message != nullptr ? *message : std::string(error.what())));
  }
}

// The structure under its load.
class ForcedStructure final : public LagrangianLinearTIDS {
 public:
  ForcedStructure(const System& system, const State& start)
      : LagrangianLinearTIDS(vector_of(start.u), vector_of(start.v), matrix_of(system.mass),
                             matrix_of(system.stiffness), matrix_of(system.damping)),
        load_(system.load) {
    _fExt = std::make_shared<SiconosVector>(static_cast<unsigned>(system.mass.rows()));
  }

  void computeFExt(double time) override {
    const Eigen::VectorXd load = load_(time);
    std::copy(load.data(), load.data() + load.size(), _fExt->getArray());
  }

 private:
  std::function<Eigen::VectorXd(double)> load_;
};

// The structure and its stops y_j = g_j - w_j^T u >= 0, each a relation with a law of impact.
struct Model {
  Model(const System& given, const State& start, double end)
      : structure(std::make_shared<ForcedStructure>(given, start)),
        system(std::make_shared<NonSmoothDynamicalSystem>(0.0, end)) {
    system->insertDynamicalSystem(structure);
    for (Eigen::Index j = 0; j < given.gap.size(); ++j) {
      auto relation = std::make_shared<LagrangianLinearTIR>(matrix_of(-given.directions.col(j).transpose()),
                                                            vector_of(given.gap.segment(j, 1)));
      stops.push_back(
          std::make_shared<Interaction>(std::make_shared<NewtonImpactNSL>(given.restitution), relation));
      system->link(stops.back(), structure);
    }
  }

  [[nodiscard]] State state() const {
    return {values_of(*structure->q()), values_of(*structure->velocity())};
  }

  // The multipliers of a level, 1: impulses, 2: forces; Nc.
  [[nodiscard]] Eigen::VectorXd multipliers(unsigned level) const {
    Eigen::VectorXd all(static_cast<Eigen::Index>(stops.size()));
    for (std::size_t j = 0; j < stops.size(); ++j)
      all[static_cast<Eigen::Index>(j)] = (*stops[j]->lambda(level))(0);
    return all;
  }

  std::shared_ptr<ForcedStructure> structure;
  std::vector<SP::Interaction> stops;
  SP::NonSmoothDynamicalSystem system;
};

// At an event Siconos 4.4 takes the acceleration that LSODAR evaluated last, beyond the event and before the
// impact. Here it is that of the event, without which no contact can stay closed under a changing load.
class Integrator final : public LsodarOSI {
 public:
  explicit Integrator(std::shared_ptr<ForcedStructure> structure) : structure_(std::move(structure)) {}

  void computeFreeOutput(InteractionsGraph::VDescriptor& vertex, OneStepNSProblem* problem) override {
    structure_->computeRhs(_simulation->nextTime());
    LsodarOSI::computeFreeOutput(vertex, problem);
  }

 private:
  std::shared_ptr<ForcedStructure> structure_;
};

}  // namespace

struct Stepping::Parts {
  Parts(const System& system, const State& start, double h, double end, double theta)
      : model(system, start, end),
        simulation(std::make_shared<TimeStepping>(model.system, std::make_shared<TimeDiscretisation>(0.0, h),
                                                  std::make_shared<MoreauJeanOSI>(theta),
                                                  std::make_shared<LCP>(SICONOS_LCP_LEMKE))) {}

  Model model;
  std::shared_ptr<TimeStepping> simulation;
};

Stepping::Stepping(const System& system, const State& start, double h, double end, double theta)
    : parts_(std::make_unique<Parts>(system, start, h, end, theta)) {}

Stepping::~Stepping() = default;

State Stepping::state() const { return parts_->model.state(); }

Eigen::VectorXd Stepping::step() {
  return with_reasons([this] {
    parts_->simulation->computeOneStep();
    Eigen::VectorXd impulses = parts_->model.multipliers(1);
    parts_->simulation->nextStep();
    return impulses;
  });
}

struct Events::Parts {
  Parts(const System& system, double h, double end)
      : model(system, at_rest(system), end),
        simulation(
            std::make_shared<EventDriven>(model.system, std::make_shared<TimeDiscretisation>(0.0, h))) {
    const auto integrator = std::make_shared<Integrator>(model.structure);
    simulation->insertIntegrator(integrator);
    simulation->insertNonSmoothProblem(std::make_shared<LCP>(SICONOS_LCP_LEMKE), SICONOS_OSNSP_ED_IMPACT);
    simulation->insertNonSmoothProblem(std::make_shared<LCP>(SICONOS_LCP_LEMKE), SICONOS_OSNSP_ED_SMOOTH_ACC);
    simulation->setToleranceED(kGapTolerance);
    simulation->initialize();
    integrator->setMaxNstep(kMostSteps);  // only now it has a place for it
  }

  Model model;
  std::shared_ptr<EventDriven> simulation;
  bool at_stop = false;
};

Events::Events(const System& system, double h, double end)
    : parts_(std::make_unique<Parts>(system, h, end)) {}

Events::~Events() = default;

State Events::state() const { return parts_->model.state(); }

Eigen::VectorXd Events::pressure() const { return parts_->model.multipliers(2); }

Events::Arrival Events::advance() {
  EventDriven& simulation = *parts_->simulation;
  with_reasons([&] { simulation.advanceToEvent(); });
  parts_->at_stop = simulation.eventsManager()->nextEvent()->getType() == NS_EVENT;
  return {simulation.nextTime(), parts_->at_stop};
}

Eigen::VectorXd Events::process() {
  with_reasons([this] { parts_->simulation->processEvents(); });
  Eigen::VectorXd impulses = parts_->model.multipliers(1);
  if (!parts_->at_stop) impulses.setZero();  // those of an earlier event
  return impulses;
}

}  // namespace siconos_rivals
