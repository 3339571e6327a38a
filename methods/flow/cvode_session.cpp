#include "methods/flow/cvode_session.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <exception>
#include <string>
#include <utility>

namespace signorini {

struct CvodeSession::Handles {
  SUNContext context = nullptr;
  N_Vector y = nullptr, output = nullptr, tolerance = nullptr;
  SUNNonlinearSolver iteration = nullptr;  // of Adams
  SUNMatrix jacobian = nullptr;            // of BDF
  SUNLinearSolver linear = nullptr;
  void* memory = nullptr;

  Rhs rhs;
  long evaluations = 0;
  double stop = 0.0;
  std::string last_message;
  std::exception_ptr thrown;

  ~Handles() {
    if (memory != nullptr) CVodeFree(&memory);
    if (iteration != nullptr) SUNNonlinSolFree(iteration);
    if (linear != nullptr) SUNLinSolFree(linear);
    if (jacobian != nullptr) SUNMatDestroy(jacobian);
    for (N_Vector vector : {y, output, tolerance}) {
      if (vector != nullptr) N_VDestroy(vector);
    }
    if (context != nullptr) SUNContext_Free(&context);
  }

  void check(int flag, const char* call) {
    if (thrown) std::rethrow_exception(std::exchange(thrown, nullptr));
    if (flag < 0) {
      throw IntegrationError(std::string(call) + " failed with flag " + std::to_string(flag) +
                             (last_message.empty() ? "" : ": " + last_message));
    }
  }

  template <class T>
  T* check_made(T* pointer, const char* call) {
    if (pointer == nullptr) throw IntegrationError(std::string(call) + " returned nothing");
    return pointer;
  }
};

namespace {

Eigen::Map<Eigen::VectorXd> view(N_Vector vector) {
  return {NV_DATA_S(vector), static_cast<Eigen::Index>(NV_LENGTH_S(vector))};
}

}  // namespace

CvodeSession::CvodeSession(double relative_tolerance, const Eigen::VectorXd& absolute_tolerance, Rhs rhs,
                           Multistep multistep)
    : handles_(std::make_unique<Handles>()) {
  Handles& h = *handles_;
  h.rhs = std::move(rhs);
  h.check(SUNContext_Create(nullptr, &h.context), "SUNContext_Create");
  h.y = h.check_made(N_VNew_Serial(absolute_tolerance.size(), h.context), "N_VNew_Serial");
  h.output = h.check_made(N_VClone(h.y), "N_VClone");
  h.tolerance = h.check_made(N_VClone(h.y), "N_VClone");
  view(h.y).setZero();
  view(h.tolerance) = absolute_tolerance;

  // An exception must not unwind through C frames: it is kept and rethrown by `check`.
  const CVRhsFn call = [](realtype time, N_Vector y, N_Vector derivative, void* user) {
    auto& handles = *static_cast<Handles*>(user);
    ++handles.evaluations;
    try {
      handles.rhs(time, view(y), view(derivative));
    } catch (...) {
      handles.thrown = std::current_exception();
      return -1;
    }
    return 0;
  };
  const CVErrHandlerFn keep_message = [](int, const char*, const char*, char* message, void* user) {
    static_cast<Handles*>(user)->last_message = message;
  };
  h.memory =
      h.check_made(CVodeCreate(multistep == Multistep::adams ? CV_ADAMS : CV_BDF, h.context), "CVodeCreate");
  h.check(CVodeSetErrHandlerFn(h.memory, keep_message, &h), "CVodeSetErrHandlerFn");
  h.check(CVodeInit(h.memory, call, 0.0, h.y), "CVodeInit");
  h.check(CVodeSetUserData(h.memory, &h), "CVodeSetUserData");
  h.check(CVodeSVtolerances(h.memory, relative_tolerance, h.tolerance), "CVodeSVtolerances");
  if (multistep == Multistep::adams) {
    h.iteration = h.check_made(SUNNonlinSol_FixedPoint(h.y, 0, h.context), "SUNNonlinSol_FixedPoint");
    h.check(CVodeSetNonlinearSolver(h.memory, h.iteration), "CVodeSetNonlinearSolver");
    return;
  }
  const auto size = static_cast<sunindextype>(absolute_tolerance.size());
  h.jacobian = h.check_made(SUNDenseMatrix(size, size, h.context), "SUNDenseMatrix");
  h.linear = h.check_made(SUNLinSol_Dense(h.y, h.jacobian, h.context), "SUNLinSol_Dense");
  h.check(CVodeSetLinearSolver(h.memory, h.linear, h.jacobian), "CVodeSetLinearSolver");
}

CvodeSession::~CvodeSession() = default;

void CvodeSession::start(double time, const Eigen::VectorXd& y, double stop, double largest_step) {
  Handles& h = *handles_;
  view(h.y) = y;
  h.check(CVodeReInit(h.memory, time, h.y), "CVodeReInit");
  h.check(CVodeSetMaxStep(h.memory, largest_step), "CVodeSetMaxStep");
  h.check(CVodeSetStopTime(h.memory, stop), "CVodeSetStopTime");
  h.stop = stop;
}

double CvodeSession::step() {
  Handles& h = *handles_;
  double time = 0.0;
  h.check(CVode(h.memory, h.stop, h.output, &time, CV_ONE_STEP), "CVode");
  return time;
}

void CvodeSession::interpolate(double time, Eigen::VectorXd& y) const {
  handles_->check(CVodeGetDky(handles_->memory, time, 0, handles_->output), "CVodeGetDky");
  y = view(handles_->output);
}

long CvodeSession::rhs_evaluations() const { return handles_->evaluations; }

}  // namespace signorini
