#include "oracle/measure/bench/half_size_solver.hpp"

#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <Eigen/LU>
#include <new>

namespace lubjoint::reports {

namespace {

struct Factors {
  Eigen::Index m;
  double alpha = 1;
  double beta = 0;
  Eigen::MatrixXd lower;  ///< C
  Eigen::MatrixXd reduced;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
  Eigen::VectorXd right;

  explicit Factors(Eigen::Index size) : m(size), lower(m, m), reduced(m, m), lu(m), right(m) {}
};

Factors& factors_of(SUNLinearSolver solver) { return *static_cast<Factors*>(solver->content); }

SUNLinearSolver_Type type(SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; }

/// 0, or 1: singular, a shorter step may do
int set_up(SUNLinearSolver solver, SUNMatrix matrix) {
  Factors& f = factors_of(solver);
  const Eigen::Map<const Eigen::MatrixXd> whole(SM_DATA_D(matrix), 2 * f.m, 2 * f.m);
  f.alpha = whole(0, 0);
  f.beta = whole(0, f.m);
  f.lower = whole.bottomLeftCorner(f.m, f.m);
  if (f.alpha == 0) return 1;
  f.reduced = whole.bottomRightCorner(f.m, f.m) - (f.beta / f.alpha) * f.lower;
  f.lu.compute(f.reduced);
  return f.lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 0 ? 0 : 1;
}

int solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector r, double) {
  Factors& f = factors_of(solver);
  const Eigen::Map<const Eigen::VectorXd> right(N_VGetArrayPointer(r), 2 * f.m);
  Eigen::Map<Eigen::VectorXd> solution(N_VGetArrayPointer(x), 2 * f.m);
  f.right.noalias() = right.tail(f.m) - f.lower * (right.head(f.m) / f.alpha);
  const auto upper = right.head(f.m).eval();  // x and r may be the same
  solution.tail(f.m) = f.lu.solve(f.right);
  solution.head(f.m) = (upper - f.beta * solution.tail(f.m)) / f.alpha;
  return 0;
}

int release(SUNLinearSolver solver) {
  delete static_cast<Factors*>(solver->content);
  solver->content = nullptr;
  SUNLinSolFreeEmpty(solver);
  return 0;
}

}  // namespace

SUNLinearSolver half_size_solver(sunindextype size, SUNContext context) {
  SUNLinearSolver solver = SUNLinSolNewEmpty(context);
  if (!solver) throw std::bad_alloc();
  solver->ops->gettype = type;
  solver->ops->setup = set_up;
  solver->ops->solve = solve;
  solver->ops->free = release;
  solver->content = new Factors(size / 2);
  return solver;
}

}  // namespace lubjoint::reports
