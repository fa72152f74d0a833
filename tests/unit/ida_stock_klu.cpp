#include <gtest/gtest.h>

#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "ida/ida.hpp"
#include "unit/ida_problems.hpp"

namespace talus::test {
namespace {

/// Start-up of viscous flow between two walls under a given discharge q(t) = 1 - exp(-t): velocities u_i at rest at the
/// start, and the pressure gradient p that keeps sum(u_i) h = q (index 2).
struct Channel {
  static constexpr int n_cells = 20, n = n_cells + 1;
  static constexpr double h = 1.0 / n_cells, nu = 0.3;
  std::array<core::Kind, n> kinds;
  std::array<double, n> tolerances, y_0{}, yp_0{};

  Channel() {
    kinds.fill(differential);
    kinds[n_cells] = algebraic;
    tolerances.fill(1e-9);
    tolerances[n_cells] = 1e-6;
    yp_0.fill(1.0);  // u' = p = q' = 1
    yp_0[n_cells] = 0.0;
    y_0[n_cells] = 1.0;
  }
  template <class S>
  std::array<S, n> residual(double t, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    std::array<S, n> r;
    S discharge = 0.0;
    for (int i = 0; i < n_cells; ++i) {
      const S below = i > 0 ? y[i - 1] : -1.0 * y[0];
      const S above = i + 1 < n_cells ? y[i + 1] : -1.0 * y[i];
      r[i] = yp[i] - (nu / (h * h)) * (below - 2.0 * y[i] + above) - y[n_cells];
      discharge += h * y[i];
    }
    r[n_cells] = discharge - (1.0 - std::exp(-t));
    return r;
  }
};

using System = SmallDae<Channel>;

std::span<double> view(N_Vector v) { return {NV_DATA_S(v), static_cast<std::size_t>(NV_LENGTH_S(v))}; }

/// The same system by SUNDIALS alone: stock Newton and stock KLU.
std::vector<double> by_stock_klu(const System& system, double rtol, double t_end) {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  void* ida = IDACreate(context);
  N_Vector y = N_VNew_Serial(Channel::n, context), yp = N_VClone(y), tolerances = N_VClone(y), kinds = N_VClone(y);
  system.initial_state(0.0, view(y), view(yp));
  std::copy(system.model.tolerances.begin(), system.model.tolerances.end(), view(tolerances).begin());
  for (int i = 0; i < Channel::n; ++i) view(kinds)[i] = system.model.kinds[i] == differential ? 1.0 : 0.0;
  SUNMatrix matrix = SUNSparseMatrix(Channel::n, Channel::n, system.pattern().n_nonzeros(), CSC_MAT, context);
  SUNLinearSolver solver = SUNLinSol_KLU(y, matrix, context);

  const IDAResFn residual = [](realtype t, N_Vector a, N_Vector b, N_Vector r, void* user) {
    static_cast<const System*>(user)->residual(t, view(a), view(b), view(r));
    return 0;
  };
  const IDALsJacFn jacobian = [](realtype t, realtype c_j, N_Vector a, N_Vector b, N_Vector, SUNMatrix J, void* user,
                                 N_Vector, N_Vector, N_Vector) {
    const auto& s = *static_cast<const System*>(user);
    const auto& pattern = s.pattern();  // SUNMatZero has wiped the indices
    std::copy(pattern.column_starts().begin(), pattern.column_starts().end(), SUNSparseMatrix_IndexPointers(J));
    std::copy(pattern.rows().begin(), pattern.rows().end(), SUNSparseMatrix_IndexValues(J));
    s.jacobian(t, view(a), view(b), c_j, {SUNSparseMatrix_Data(J), static_cast<std::size_t>(pattern.n_nonzeros())});
    return 0;
  };
  EXPECT_EQ(IDAInit(ida, residual, 0.0, y, yp), IDA_SUCCESS);
  EXPECT_EQ(IDASVtolerances(ida, rtol, tolerances), IDA_SUCCESS);
  EXPECT_EQ(IDASetUserData(ida, const_cast<System*>(&system)), IDA_SUCCESS);
  EXPECT_EQ(IDASetId(ida, kinds), IDA_SUCCESS);
  EXPECT_EQ(IDASetSuppressAlg(ida, SUNTRUE), IDA_SUCCESS);
  EXPECT_EQ(IDASetLinearSolver(ida, solver, matrix), IDA_SUCCESS);
  EXPECT_EQ(IDASetJacFn(ida, jacobian), IDA_SUCCESS);
  double t = 0.0;
  EXPECT_EQ(IDASolve(ida, t_end, &t, y, yp, IDA_NORMAL), IDA_SUCCESS);
  const std::vector<double> result(view(y).begin(), view(y).end());
  IDAFree(&ida);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  for (N_Vector v : {y, yp, tolerances, kinds}) N_VDestroy(v);
  SUNContext_Free(&context);
  return result;
}

struct Silent final : core::Observer {};

TEST(IdaAgainstStockKlu, AgreesWithEachNewtonAndEachDirectSolver) {
  const System system;
  constexpr double rtol = 1e-6, t_end = 0.5;
  const auto reference = by_stock_klu(system, rtol, t_end);
  for (const auto kind : {ida::Newton::damped, ida::Newton::stock}) {
    for (const auto choice :
         {linear::Choice::klu, linear::Choice::umfpack, linear::Choice::banded, linear::Choice::automatic}) {
      ida::Options options;
      options.rtol = rtol;
      options.newton.kind = kind;
      options.linear.choice = choice;
      ida::Ida integrator(system, options);
      Silent observer;
      integrator.start(0.0, system.model.y_0, system.model.yp_0);
      ASSERT_TRUE(integrator.advance(t_end, observer));
      const auto y = integrator.current().y;
      for (int i = 0; i < Channel::n_cells; ++i) EXPECT_NEAR(y[i], reference[i], 1e-5) << integrator.describe();
      EXPECT_NEAR(y[Channel::n_cells], reference[Channel::n_cells], 1e-4) << integrator.describe();
    }
  }
}

}  // namespace
}  // namespace talus::test
