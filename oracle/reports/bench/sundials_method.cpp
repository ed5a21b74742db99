#include "oracle/reports/bench/sundials_method.hpp"

#include <cvode/cvode.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace lubjoint::reports {

namespace {

using Clock = std::chrono::steady_clock;

template <class Handle, void (*Free)(Handle)>
struct Freed {
  Handle handle = nullptr;
  explicit Freed(Handle h) : handle(h) {
    if (!handle) throw std::bad_alloc();
  }
  ~Freed() { Free(handle); }
  Freed(const Freed&) = delete;
  Freed& operator=(const Freed&) = delete;
  operator Handle() const { return handle; }  // NOLINT(google-explicit-constructor): SUNDIALS' functions take it
};

void free_solver(SUNLinearSolver solver) { SUNLinSolFree(solver); }
void free_fixed_point(SUNNonlinearSolver solver) { SUNNonlinSolFree(solver); }

using Vector = Freed<N_Vector, N_VDestroy>;
using Matrix = Freed<SUNMatrix, SUNMatDestroy>;
using Linear = Freed<SUNLinearSolver, free_solver>;
using FixedPoint = Freed<SUNNonlinearSolver, free_fixed_point>;

struct Context {
  SUNContext handle = nullptr;
  Context() {
    if (SUNContext_Create(nullptr, &handle) != 0) throw std::bad_alloc();
  }
  ~Context() { SUNContext_Free(&handle); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

void require(int status, const char* what) {
  if (status < 0) throw std::runtime_error(std::string(what) + " returned " + std::to_string(status));
}

/// What the callbacks reach.
struct Call {
  const SundialsProblem& problem;
  const BenchLimits& limits;
  std::vector<double> dydt;
  Clock::time_point begin = Clock::now();
  std::size_t calls = 0;
  bool out_of_time = false;

  /// 0, 1 (a shorter step may do), −1 (give up)
  int rate(double t, N_Vector y, double* out) {
    if (++calls % 1024 == 0 && std::chrono::duration<double>(Clock::now() - begin).count() > limits.seconds) {
      out_of_time = true;
      return -1;
    }
    try {
      problem.rate(t, N_VGetArrayPointer(y), out);
      return 0;
    } catch (const std::domain_error&) {
      return 1;
    }
  }
};

int cvode_rate(double t, N_Vector y, N_Vector dydt, void* data) {
  return static_cast<Call*>(data)->rate(t, y, N_VGetArrayPointer(dydt));
}

int ida_residual(double t, N_Vector y, N_Vector dydt, N_Vector residual, void* data) {
  auto& call = *static_cast<Call*>(data);
  double* r = N_VGetArrayPointer(residual);
  const int status = call.rate(t, y, r);
  for (std::size_t i = 0; i < call.problem.start.size(); ++i) r[i] = N_VGetArrayPointer(dydt)[i] - r[i];
  return status;
}

void quiet(int, const char*, const char*, char*, void*) {}

void fill(N_Vector vector, const std::vector<double>& values) {
  std::copy(values.begin(), values.end(), N_VGetArrayPointer(vector));
}

/// Goes from observed time to observed time, or to the end at once. Step(t_goal, &t) returns SUNDIALS' status.
template <class Step>
void go(const SundialsProblem& problem, Call& call, N_Vector y, MethodRun& result, const Step& step) {
  std::vector<double> goals = problem.times;
  if (goals.empty()) goals = {problem.duration};
  double t = 0;
  for (const double goal : goals) {
    const int status = step(goal, &t);
    if (status < 0) {
      result.message = call.out_of_time ? "given up after its share of time"
                                        : "SUNDIALS stopped with status " + std::to_string(status);
      return;
    }
    if (problem.observe) problem.observe(goal, N_VGetArrayPointer(y));
  }
  result.finished = true;
}

MethodRun run_cvode(int family, const SundialsProblem& problem, const BenchLimits& limits) {
  MethodRun result;
  const auto n = static_cast<sunindextype>(problem.start.size());
  const Context context;
  const Vector y(N_VNew_Serial(n, context.handle));
  const Vector tolerance(N_VNew_Serial(n, context.handle));
  fill(y, problem.start);
  fill(tolerance, problem.absolute_tolerance);
  Call call{problem, limits, std::vector<double>(problem.start.size())};
  void* memory = CVodeCreate(family, context.handle);
  const std::unique_ptr<void, void (*)(void*)> freed(memory, [](void* m) { CVodeFree(&m); });
  require(CVodeInit(memory, cvode_rate, 0, y), "CVodeInit");
  CVodeSetErrHandlerFn(memory, quiet, nullptr);
  require(CVodeSVtolerances(memory, problem.relative_tolerance, tolerance), "CVodeSVtolerances");
  CVodeSetUserData(memory, &call);
  CVodeSetMaxNumSteps(memory, -1);
  CVodeSetStopTime(memory, problem.duration);
  const Matrix matrix(SUNDenseMatrix(n, n, context.handle));
  const Linear linear(SUNLinSol_Dense(y, matrix, context.handle));
  const FixedPoint fixed_point(SUNNonlinSol_FixedPoint(y, 0, context.handle));
  if (family == CV_ADAMS) {
    require(CVodeSetNonlinearSolver(memory, fixed_point), "CVodeSetNonlinearSolver");
  } else {
    require(CVodeSetLinearSolver(memory, linear, matrix), "CVodeSetLinearSolver");
  }
  go(problem, call, y, result, [&](double goal, double* t) { return CVode(memory, goal, y, t, CV_NORMAL); });
  result.seconds = std::chrono::duration<double>(Clock::now() - call.begin).count();
  long steps = 0;
  long rejected = 0;
  long jacobians = 0;
  long setups = 0;
  CVodeGetNumSteps(memory, &steps);
  CVodeGetNumErrTestFails(memory, &rejected);
  CVodeGetNumLinSolvSetups(memory, &setups);
  if (family == CV_BDF) CVodeGetNumJacEvals(memory, &jacobians);
  result.steps = static_cast<std::size_t>(steps);
  result.rejected = static_cast<std::size_t>(rejected);
  result.jacobian_evaluations = static_cast<std::size_t>(jacobians);
  result.factorisations = static_cast<std::size_t>(setups);
  return result;
}

MethodRun run_ida(const SundialsProblem& problem, const BenchLimits& limits) {
  MethodRun result;
  const auto n = static_cast<sunindextype>(problem.start.size());
  const Context context;
  const Vector y(N_VNew_Serial(n, context.handle));
  const Vector dydt(N_VNew_Serial(n, context.handle));
  const Vector tolerance(N_VNew_Serial(n, context.handle));
  fill(y, problem.start);
  fill(tolerance, problem.absolute_tolerance);
  Call call{problem, limits, std::vector<double>(problem.start.size())};
  if (call.rate(0, y, N_VGetArrayPointer(dydt)) != 0) throw std::runtime_error("no rate at the start");
  void* memory = IDACreate(context.handle);
  const std::unique_ptr<void, void (*)(void*)> freed(memory, [](void* m) { IDAFree(&m); });
  require(IDAInit(memory, ida_residual, 0, y, dydt), "IDAInit");
  IDASetErrHandlerFn(memory, quiet, nullptr);
  require(IDASVtolerances(memory, problem.relative_tolerance, tolerance), "IDASVtolerances");
  IDASetUserData(memory, &call);
  IDASetMaxNumSteps(memory, -1);
  IDASetStopTime(memory, problem.duration);
  const Matrix matrix(SUNDenseMatrix(n, n, context.handle));
  const Linear linear(SUNLinSol_Dense(y, matrix, context.handle));
  require(IDASetLinearSolver(memory, linear, matrix), "IDASetLinearSolver");
  go(problem, call, y, result, [&](double goal, double* t) { return IDASolve(memory, goal, t, y, dydt, IDA_NORMAL); });
  result.seconds = std::chrono::duration<double>(Clock::now() - call.begin).count();
  long steps = 0;
  long rejected = 0;
  long jacobians = 0;
  long setups = 0;
  IDAGetNumSteps(memory, &steps);
  IDAGetNumErrTestFails(memory, &rejected);
  IDAGetNumLinSolvSetups(memory, &setups);
  IDAGetNumJacEvals(memory, &jacobians);
  result.steps = static_cast<std::size_t>(steps);
  result.rejected = static_cast<std::size_t>(rejected);
  result.jacobian_evaluations = static_cast<std::size_t>(jacobians);
  result.factorisations = static_cast<std::size_t>(setups);
  return result;
}

}  // namespace

std::vector<std::string_view> sundials_methods() { return {"cvode_bdf", "cvode_adams", "ida"}; }

MethodRun solve_with_sundials(std::string_view method, const SundialsProblem& problem, const BenchLimits& limits) {
  if (method == "cvode_bdf") return run_cvode(CV_BDF, problem, limits);
  if (method == "cvode_adams") return run_cvode(CV_ADAMS, problem, limits);
  if (method == "ida") return run_ida(problem, limits);
  throw std::invalid_argument("there is no SUNDIALS method \"" + std::string(method) + "\"");
}

}  // namespace lubjoint::reports
