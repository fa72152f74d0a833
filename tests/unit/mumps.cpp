#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "linear/mumps_factors.hpp"
#include "linear/mumps_solver.hpp"
#include "linear/ordering.hpp"
#include "unit/linear_matrices.hpp"

/// What of MUMPS other solvers do not have: precisions, a given ordering, a workspace that grows.
namespace talus::test {
namespace {

TEST(Mumps, FactorsInSinglePrecisionWhereThatIsAllThatIsAskedWhateverTheUnits) {
  Matrix m = saddle_point(25, 8, 1e2, ConstraintAt::w);
  linear::MumpsSolver whole(m.pattern);
  EXPECT_LT(solve_residual(whole, m), 1e-12) << whole.describe();
  // Of equations, beyond what single precision holds, and of unknowns.
  const auto unit = [](Index i, double least, double step) {
    return std::pow(10.0, least + step * static_cast<double>(i % 7));
  };
  for (const bool scaled : {false, true}) {
    for (Index j = 0; scaled && j < m.pattern.n(); ++j)
      for (Index k = m.pattern.column_starts()[j]; k < m.pattern.column_starts()[j + 1]; ++k)
        m.values[k] *= unit(m.pattern.rows()[k], -45.0, 15.0) * unit(j + 3, -3.0, 1.0);
    linear::MumpsSolver solver(m.pattern);
    solver.demand(linear::single_precision);
    const double residual = solve_residual(solver, m);
    EXPECT_LT(residual, 1e-5) << solver.describe();
    EXPECT_GT(residual, 1e-12) << solver.describe();
    EXPECT_EQ(solver.statistics().rejected, 0);
    EXPECT_NE(solver.describe().find("in single precision"), std::string::npos) << solver.describe();
  }
}

TEST(Mumps, TakesSinglePrecisionByItsErrorNotByItsResidual) {
  const Matrix m = saddle_point(25, 8, 1.0, ConstraintAt::w);
  linear::MumpsSolver solver(m.pattern);
  solver.demand(linear::single_precision);
  solve_residual(solver, m);
  EXPECT_GT(solver.statistics().first_residual, linear::single_precision) << "no case for this test";
  EXPECT_EQ(solver.statistics().rejected, 0) << solver.describe();
}

TEST(Mumps, IsOrderedTheSameEachTimeAndFillsLessThanABand) {
  constexpr Index n = 40;
  MatrixBuilder builder(n * n);  // five-point stencil on a square
  for (Index i = 0; i < n * n; ++i) {
    builder.add(i, i, 4.1);
    for (const Index j : {i % n + 1 < n ? i + 1 : i, i + n < n * n ? i + n : i}) {
      if (j == i) continue;
      builder.add(i, j, -1.0);
      builder.add(j, i, -1.0);
    }
  }
  const Matrix m = builder.build();
  EXPECT_EQ(linear::nested_dissection(m.pattern), linear::nested_dissection(m.pattern));
  linear::MumpsSolver solver(m.pattern);
  EXPECT_LT(solve_residual(solver, m), 1e-12);
  EXPECT_LT(static_cast<double>(solver.statistics().fill), 0.6 * 2.0 * n * n * n);
}

TEST(Mumps, TakesMoreMemoryWherePivotsHaveToWait) {
  const Matrix m = saddle_point(60, 16, 1e3);  // no diagonal entries for the pressures
  linear::MumpsSolver solver(m.pattern);
  EXPECT_LT(solve_residual(solver, m), 1e-10) << solver.describe();
}

TEST(Mumps, TakesMoreMemoryWhereItForesawTooLittle) {
  const Matrix m = saddle_point(60, 16, 1e3);
  const auto solution = [&](int spare) {
    linear::MumpsFactors<double> factors(m.pattern, spare);
    std::ranges::copy(m.values, factors.values().begin());
    factors.factor();
    std::vector<double> b(m.pattern.n(), 1.0);
    factors.substitute(b);
    return b;
  };
  EXPECT_EQ(solution(-90), solution(50));
}

}  // namespace
}  // namespace talus::test
