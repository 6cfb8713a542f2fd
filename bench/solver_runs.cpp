#include "bench/solver_runs.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <ctime>
#include <memory>

#include "engine/simulate/solve/solver.hpp"

namespace stepwire::bench {

namespace {

constexpr long max_steps = 5'000'000;

/// Returns the processor time of this thread [s].
double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class EngineSystem : public solve::System {
 public:
  explicit EngineSystem(const ivp::Problem& problem)
      : numbers(solve::ControlReport::count(problem.start.size())),
        problem_(problem),
        states_(problem.start),
        derivatives_(problem.start.size()) {
    time = &time_;
    x = states_.data();
    dot = derivatives_.data();
    count = states_.size();
    report = {numbers.data()};
  }
  void evaluate() override {
    ++calls;
    problem_.derivative(time_, x, dot);
  }

  long calls = 0;
  std::vector<double> numbers;

 private:
  const ivp::Problem& problem_;
  std::vector<double> states_, derivatives_;
  double time_ = 0.0;
};

/// The problem and its number of calls, as user data of CVODE.
struct Counted {
  const ivp::Problem& problem;
  long calls = 0;
};

int derivative(sunrealtype time, N_Vector x, N_Vector result, void* user) {
  auto& counted = *static_cast<Counted*>(user);
  ++counted.calls;
  counted.problem.derivative(time, N_VGetArrayPointer(x), N_VGetArrayPointer(result));
  return 0;
}

void stay_silent(int, const char*, const char*, char*, void*) {}

/// CVODE and its matrices for a problem.
class Cvode {
 public:
  Cvode(Counted& counted, double relative, double absolute) {
    const ivp::Problem& problem = counted.problem;
    SUNContext_Create(nullptr, &context_);
    x_ = N_VNew_Serial(static_cast<sunindextype>(problem.start.size()), context_);
    std::copy(problem.start.begin(), problem.start.end(), N_VGetArrayPointer(x_));
    memory_ = CVodeCreate(problem.stiff ? CV_BDF : CV_ADAMS, context_);
    CVodeSetErrHandlerFn(memory_, stay_silent, nullptr);
    CVodeInit(memory_, derivative, 0.0, x_);
    CVodeSStolerances(memory_, relative, absolute);
    CVodeSetUserData(memory_, &counted);
    CVodeSetMaxNumSteps(memory_, max_steps);
    CVodeSetStopTime(memory_, problem.end);
    problem.stiff ? set_newton() : set_fixed_point();
  }
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;
  ~Cvode() {
    CVodeFree(&memory_);
    if (linear_) SUNLinSolFree(linear_);
    if (matrix_) SUNMatDestroy(matrix_);
    if (fixed_point_) SUNNonlinSolFree(fixed_point_);
    N_VDestroy(x_);
    SUNContext_Free(&context_);
  }

  bool run(double end) {
    sunrealtype reached = 0.0;
    return CVode(memory_, end, x_, &reached, CV_NORMAL) >= 0;
  }
  void read(SolverRun& run) const {
    run.x.assign(N_VGetArrayPointer(x_), N_VGetArrayPointer(x_) + N_VGetLength(x_));
    CVodeGetNumSteps(memory_, &run.steps);
    CVodeGetNumErrTestFails(memory_, &run.rejected);
  }

 private:
  void set_newton() {
    const sunindextype count = N_VGetLength(x_);
    matrix_ = SUNDenseMatrix(count, count, context_);
    linear_ = SUNLinSol_Dense(x_, matrix_, context_);
    CVodeSetLinearSolver(memory_, linear_, matrix_);
  }
  void set_fixed_point() {
    fixed_point_ = SUNNonlinSol_FixedPoint(x_, 0, context_);
    CVodeSetNonlinearSolver(memory_, fixed_point_);
  }

  SUNContext context_ = nullptr;
  N_Vector x_ = nullptr;
  void* memory_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  SUNNonlinearSolver fixed_point_ = nullptr;
};

}  // namespace

SolverRun run_engine(const ivp::Problem& problem, const std::string& solver, double relative,
                     double absolute) {
  using Report = solve::ControlReport;
  SolverRun result;
  EngineSystem system(problem);
  const auto method =
      solve::make_solver(solver, system.count, solve::ErrorControl{relative, absolute, max_steps});
  const double start = now();
  system.evaluate();
  method->advance(system, {0.0, problem.end, problem.end});
  result.seconds = now() - start;
  if (system.numbers[0] != solve::StepReport::fine) result.failure = "stopped";
  result.x.assign(system.x, system.x + system.count);
  result.digits = ivp::digits(problem, system.x);
  result.steps = static_cast<long>(system.numbers[Report::steps]);
  result.rejected = static_cast<long>(system.numbers[Report::rejected]);
  result.calls = system.calls;
  return result;
}

SolverRun run_cvode(const ivp::Problem& problem, double relative, double absolute) {
  SolverRun result;
  Counted counted{problem};
  Cvode cvode(counted, relative, absolute);
  const double start = now();
  if (!cvode.run(problem.end)) result.failure = "stopped";
  result.seconds = now() - start;
  cvode.read(result);
  result.digits = ivp::digits(problem, result.x.data());
  result.calls = counted.calls;
  return result;
}

}  // namespace stepwire::bench
