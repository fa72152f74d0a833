#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "linear/banded_solver.hpp"
#include "linear/condensed_solver.hpp"
#include "linear/direct_solver.hpp"
#include "linear/klu_solver.hpp"
#include "linear/mumps_solver.hpp"
#include "linear/ordering.hpp"
#include "linear/umfpack_solver.hpp"
#include "unit/linear_matrices.hpp"

namespace talus::test {
namespace {

using linear::Choice;

/// Those that take any matrix. `condensed` is for column models with a good diagonal: it cuts the band in two blindly.
constexpr Choice general[] = {Choice::automatic, Choice::klu, Choice::umfpack, Choice::mumps, Choice::banded};
constexpr Choice every_choice[] = {Choice::automatic, Choice::klu,    Choice::umfpack,  Choice::dissected,
                                   Choice::mumps,     Choice::banded, Choice::condensed};

TEST(LinearSolvers, SolveRandomMatrices) {
  const Matrix m = random_matrix(401, 6);
  for (const Choice choice : every_choice) {
    const auto solver = linear::make_solver(m.pattern, {choice});
    EXPECT_LT(solve_residual(*solver, m), 1e-10) << solver->describe();
  }
}

TEST(LinearSolvers, SolveSaddlePointsOfManyScales) {
  for (const double c_j : {1e-2, 1e2, 1e8}) {
    const Matrix m = saddle_point(25, 8, c_j);
    for (const Choice choice : general) {
      const auto solver = linear::make_solver(m.pattern, {choice});
      EXPECT_LT(solve_residual(*solver, m), 1e-10) << solver->describe() << " at c_j = " << c_j;
    }
  }
}

TEST(LinearSolvers, SolveColumnModelsOfManyScales) {
  for (const double c_j : {1e-2, 1e2, 1e8}) {
    for (const Index columns : {10, 80}) {
      const Matrix m = saddle_point(columns, 6, c_j, ConstraintAt::w);
      for (const Choice choice : every_choice) {
        const auto solver = linear::make_solver(m.pattern, {choice});
        EXPECT_LT(solve_residual(*solver, m), 1e-10) << solver->describe() << " at c_j = " << c_j;
      }
    }
  }
}

TEST(LinearSolvers, FollowAMatrixWhoseValuesChange) {
  const Matrix first = saddle_point(25, 8, 1e8, ConstraintAt::w), second = saddle_point(25, 8, 1e-2, ConstraintAt::w);
  for (const Choice choice : every_choice) {
    const auto solver = linear::make_solver(first.pattern, {choice});
    EXPECT_LT(solve_residual(*solver, first), 1e-10);
    EXPECT_LT(solve_residual(*solver, second), 1e-10) << solver->describe();
    EXPECT_EQ(solver->statistics().factorisations, 2);
    EXPECT_EQ(solver->statistics().solves, 2);
  }
}

TEST(LinearSolvers, TakeWhatAnEarlierOneChoseAndForgetItsMatrices) {
  const Matrix first = saddle_point(25, 8, 1e8, ConstraintAt::w), second = saddle_point(25, 8, 1e-2, ConstraintAt::w);
  for (const Choice choice : every_choice) {
    const auto earlier = linear::make_solver(first.pattern, {choice});
    EXPECT_LT(solve_residual(*earlier, first), 1e-10);
    ASSERT_NE(earlier->chosen(), "") << earlier->describe();
    std::vector<double> x[2];
    for (auto& each : x) {
      const auto solver =
          linear::make_solver(first.pattern, {.choice = Choice::automatic, .chosen = earlier->chosen()});
      solver->factor(second.values);
      solver->solve(each = right_side(second));
      EXPECT_EQ(solver->chosen(), earlier->chosen());
      EXPECT_EQ(solver->describe().find("predicted"), std::string::npos) << "tried again: " << solver->describe();
    }
    EXPECT_EQ(x[0], x[1]);
  }
}

TEST(LinearSolvers, RecoverTheKnownSolutionOfASmallSystem) {
  MatrixBuilder builder(3);
  for (const auto& [i, j, v] : {std::tuple(0, 1, 2.0), {1, 0, 1.0}, {1, 2, 1.0}, {2, 1, 1.0}, {2, 2, 4.0}})
    builder.add(i, j, v);
  const Matrix m = builder.build();  // zero diagonal in rows 0 and 1
  for (const Choice choice : general) {
    const auto solver = linear::make_solver(m.pattern, {choice});
    solver->factor(m.values);
    std::vector<double> b = {4.0, 5.0, 14.0};
    solver->solve(b);
    EXPECT_NEAR(b[0], 2.0, 1e-14);
    EXPECT_NEAR(b[1], 2.0, 1e-14);
    EXPECT_NEAR(b[2], 3.0, 1e-14);
  }
}

TEST(LinearSolvers, ReportASingularMatrix) {
  Matrix m = saddle_point(6, 4, 1.0);
  const auto column = m.pattern.column_starts();
  for (Index k = column[9]; k < column[10]; ++k) m.values[k] = 0.0;
  for (const Choice choice : general) {
    EXPECT_THROW(linear::make_solver(m.pattern, {choice})->factor(m.values), linear::SingularMatrix)
        << static_cast<int>(choice);
  }
  linear::BandedSolver banded(m.pattern);
  try {
    banded.factor(m.values);
    FAIL() << "a column of zeros was factored";
  } catch (const linear::SingularMatrix& error) { EXPECT_EQ(error.place(), 9); }
}

TEST(LinearSolvers, RefuseZeroRowsAndEntriesThatAreNotFinite) {
  for (const Choice choice : every_choice) {
    Matrix m = saddle_point(6, 4, 1.0);
    m.values[17] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(linear::make_solver(m.pattern, {choice})->factor(m.values), linear::SingularMatrix);
    m = saddle_point(6, 4, 1.0);
    for (std::size_t k = 0; k < m.values.size(); ++k)
      if (m.pattern.rows()[k] == 5) m.values[k] = 0.0;
    try {
      linear::make_solver(m.pattern, {choice})->factor(m.values);
      FAIL() << "a row of zeros was factored";
    } catch (const linear::SingularMatrix& error) { EXPECT_EQ(error.place(), 5); }
  }
}

TEST(LinearSolvers, RecoverAfterASingularMatrix) {
  const Matrix good = saddle_point(6, 4, 1.0);
  Matrix bad = good;
  for (Index k = bad.pattern.column_starts()[9]; k < bad.pattern.column_starts()[10]; ++k) bad.values[k] = 0.0;
  for (const Choice choice : general) {
    const auto solver = linear::make_solver(good.pattern, {choice});
    solver->factor(good.values);
    EXPECT_THROW(solver->factor(bad.values), linear::SingularMatrix);
    EXPECT_LT(solve_residual(*solver, good), 1e-10);
  }
}

TEST(Klu, ReusesPivotsWhileTheyServeAndSearchesAnewWhenTheyDoNot) {
  // 1 1/3 in the first column asks for the pivot in row 1; the next matrix makes that pivot 1e-14 of the other.
  MatrixBuilder builder(2);
  for (const auto& [i, j, v] : {std::tuple(0, 0, 0.01), {0, 1, 1.0}, {1, 0, 4.0}, {1, 1, 3.0}}) builder.add(i, j, v);
  Matrix m = builder.build();
  linear::KluSolver solver(m.pattern);
  EXPECT_LT(solve_residual(solver, m), 1e-15);
  m.values[m.pattern.find(1, 0)] = 5.0;
  EXPECT_LT(solve_residual(solver, m), 1e-15);
  EXPECT_EQ(solver.statistics().refactorisations, 1);
  EXPECT_EQ(solver.statistics().rejected, 0);
  m.values[m.pattern.find(0, 0)] = 1.0;
  m.values[m.pattern.find(1, 0)] = 1e-17;
  EXPECT_LT(solve_residual(solver, m), 1e-15);
  EXPECT_EQ(solver.statistics().rejected, 1);
}

TEST(Klu, StopsACandidateThatFillsInTooMuch) {
  const Matrix m = saddle_point(60, 16, 1e3);  // AMD, made for good diagonals, is hopeless here
  linear::KluSolver solver(m.pattern);
  EXPECT_LT(solve_residual(solver, m), 1e-10);
  EXPECT_NE(solver.describe().find("ordering COLAMD"), std::string::npos) << solver.describe();
  EXPECT_NE(solver.describe().find("AMD given up"), std::string::npos) << solver.describe();
  linear::KluSolver bounded(m.pattern, {0.1, {}, solver.statistics().fill / 4});
  EXPECT_THROW(bounded.factor(m.values), linear::SingularMatrix);
}

TEST(Umfpack, BothStrategiesAreSetAndNotGuessed) {
  const Matrix m = saddle_point(20, 6, 10.0);
  linear::UmfpackSolver symmetric(m.pattern, linear::UmfpackSolver::Strategy::symmetric);
  linear::UmfpackSolver unsymmetric(m.pattern, linear::UmfpackSolver::Strategy::unsymmetric);
  EXPECT_LT(solve_residual(symmetric, m), 1e-10);
  EXPECT_LT(solve_residual(unsymmetric, m), 1e-10);
  EXPECT_LT(unsymmetric.statistics().fill, symmetric.statistics().fill);
}

/// `m` with the unknown of number `column` held by the row of another number: a single entry, off the diagonal.
Matrix with_held_unknown(const Matrix& m, core::Index row, core::Index column) {
  MatrixBuilder held(m.pattern.n());
  for (core::Index j = 0; j < m.pattern.n(); ++j)
    for (auto k = m.pattern.column_starts()[j]; k < m.pattern.column_starts()[j + 1]; ++k)
      if (m.pattern.rows()[k] != row) held.add(m.pattern.rows()[k], j, m.values[k]);
  held.add(row, column, 1.0);
  return held.build();
}

TEST(Umfpack, AHeldUnknownDoesNotCostTheSymmetricStrategy) {
  using enum linear::UmfpackSolver::Strategy;
  const Matrix m = saddle_point(40, 40, 1e3, ConstraintAt::w);
  const core::Index p = m.pattern.n() - 1;  // of the last cell, whose w is the number before
  const Matrix held = with_held_unknown(m, p, p - 1);
  const auto fill = [](const Matrix& matrix, linear::UmfpackSolver::Strategy strategy) {
    linear::UmfpackSolver solver(matrix.pattern, strategy);
    EXPECT_LT(solve_residual(solver, matrix), 1e-10);
    return solver.statistics().fill;
  };
  for (const auto strategy : {symmetric, dissected}) {
    EXPECT_NEAR(double(fill(held, strategy)), double(fill(m, strategy)), 0.02 * double(fill(m, strategy)));
    EXPECT_LT(fill(m, strategy), 0.9 * double(fill(m, unsymmetric)));
  }
  EXPECT_LT(fill(m, dissected), fill(m, symmetric));
}

TEST(Condensed, SolvesForTheChainsAndGivesTheSameBitsAgain) {
  const Matrix m = saddle_point(80, 6, 1e2, ConstraintAt::w);
  for (const double accuracy : {linear::full_accuracy, 1e-6}) {
    linear::CondensedSolver solver(m.pattern, 0);
    solver.demand(accuracy);
    EXPECT_EQ(solver.n_kept(), m.pattern.n() - 80 * 6);
    auto first = right_side(m), again = first;
    solver.factor(m.values);
    solver.solve(first);
    solver.factor(m.values);
    solver.solve(again);
    EXPECT_EQ(first, again);
  }
}

TEST(Condensed, FactorsInSinglePrecisionWhatIsLargeWhereThatIsAllThatIsAsked) {
  const Matrix m = saddle_point(80, 6, 1e2, ConstraintAt::w);
  linear::CondensedSolver single(m.pattern, 0), small(m.pattern);
  for (auto* solver : {&single, &small}) solver->demand(1e-6);
  const double residual = solve_residual(single, m);
  EXPECT_LT(residual, 1e-6);
  EXPECT_GT(residual, 1e-12);
  EXPECT_EQ(single.statistics().rejected, 0);
  EXPECT_NE(single.describe().find("in single precision"), std::string::npos) << single.describe();
  EXPECT_LT(solve_residual(small, m), 1e-12) << small.describe();
}

/// Pairs of unknowns whose second pivot is `gap`, in rows too long for chains.
Matrix nearly_singular_pairs(double gap) {
  constexpr Index n = 40;
  MatrixBuilder builder(n);
  for (Index i = 0; i < n; i += 2) {
    builder.add(i, i, 1.0 + gap);
    builder.add(i, i + 1, 1.0);
    builder.add(i + 1, i, 1.0);
    builder.add(i + 1, i + 1, 1.0);
    for (Index j = 0; j < n; j += 4)
      for (const Index row : {i, i + 1}) builder.add(row, j, 0.0);
  }
  return builder.build();
}

TEST(LinearSolvers, GoBackToDoubleWhereSinglePrecisionFails) {
  // 1 + 1e-9 is 1 in single precision, and the matrix singular; of 1 + 1.05e-7 one digit is left, though the residual is small.
  for (const double gap : {1e-9, 1.05e-7}) {
    const Matrix m = nearly_singular_pairs(gap);
    linear::CondensedSolver condensed(m.pattern, 0);
    linear::MumpsSolver mumps(m.pattern);
    for (linear::CheckedSolver* solver : std::initializer_list<linear::CheckedSolver*>{&condensed, &mumps}) {
      solver->demand(linear::single_precision);
      EXPECT_LT(solve_residual(*solver, m), 1e-6) << solver->describe();
      EXPECT_NE(solver->describe().find("in double precision"), std::string::npos) << gap << solver->describe();
    }
  }
}

TEST(Automatic, TakesTheSameSolverEachTimeAndSaysWhy) {
  const Matrix m = saddle_point(60, 8, 1e3);
  const auto one = linear::make_solver(m.pattern), other = linear::make_solver(m.pattern);
  EXPECT_NE(one->describe().find("not chosen yet"), std::string::npos);
  EXPECT_LT(solve_residual(*one, m), 1e-10);
  EXPECT_LT(solve_residual(*other, m), 1e-10);
  EXPECT_EQ(one->describe(), other->describe());
  for (const char* name : {"UMFPACK", "predicted on the first matrix"}) {
    EXPECT_NE(one->describe().find(name), std::string::npos) << one->describe();
  }
}

TEST(Ordering, ReverseCuthillMcKeeFindsTheBandOfAShuffledOne) {
  constexpr Index n = 200;
  MatrixBuilder builder(n);
  for (Index i = 0; i < n; ++i)  // a ring of n, scattered by a multiplication: 2 diagonals on either side are least
    for (const Index j : {i, (i + 1) % n}) builder.add(77 * i % n, 77 * j % n, 1.0);
  const Matrix m = builder.build();
  const auto width = linear::bandwidth(m.pattern, linear::reverse_cuthill_mckee(m.pattern));
  EXPECT_LE(width.lower, 2);
  EXPECT_LE(width.upper, 2);
  EXPECT_GT(linear::bandwidth(m.pattern, linear::natural_ordering(n)).lower, 70);
}

TEST(Ordering, MustNameEachUnknownOnce) {
  const Matrix m = saddle_point(4, 3, 1.0);
  auto ordering = linear::natural_ordering(m.pattern.n());
  std::reverse(ordering.begin(), ordering.end());
  for (const Choice choice : {Choice::automatic, Choice::klu, Choice::banded}) {
    const auto solver = linear::make_solver(m.pattern, {choice, 0.1, ordering});
    EXPECT_LT(solve_residual(*solver, m), 1e-10);
  }
  ordering[3] = ordering[4];
  EXPECT_THROW((void)linear::make_solver(m.pattern, {Choice::klu, 0.1, ordering}), std::invalid_argument);
  EXPECT_THROW((void)linear::make_solver(m.pattern, {Choice::klu, 0.1, {0, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace talus::test
