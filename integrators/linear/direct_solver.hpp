#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/sparse_pattern.hpp"

/// Sparse direct solvers for the square, unsymmetric, often indefinite matrices of the integrators. SuiteSparse and
/// LAPACK are seen in this room only.
namespace talus::linear {

using core::Index;
using core::SparsePattern;

/// No usable factors: structurally or numerically singular, or not finite.
class SingularMatrix : public std::runtime_error {
 public:
  SingularMatrix(const std::string& message, Index place) : std::runtime_error(message), place_(place) {}
  /// The row or column where it showed, or -1 where the library does not say.
  [[nodiscard]] Index place() const { return place_; }

 private:
  Index place_;
};

/// What a solver did since it was made.
struct Statistics {
  std::int64_t factorisations = 0;    ///< of all kinds
  std::int64_t refactorisations = 0;  ///< of these, with the pivots of an earlier one
  std::int64_t rejected = 0;          ///< factorisations that failed their first solve and were done anew
  std::int64_t solves = 0;            ///< asked for; refinements do not count
  std::int64_t refinements = 0;
  Index fill = 0;               ///< entries of L + U of the last factorisation
  double flops = 0.0;           ///< of the last full factorisation, as the library counts or bounds them
  double first_residual = 0.0;  ///< relative residual of the first solve of the last factorisation, before refinement
  double worst_residual = 0.0;  ///< largest relative residual of all solves, after refinement
};

/// Factors A, of a frozen pattern, and solves A x = b.
class DirectSolver {
 public:
  DirectSolver() = default;
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;
  virtual ~DirectSolver() = default;

  /// Factors the matrix `values` (shape n_nonzeros, in the order of the pattern; copied). Throws SingularMatrix.
  virtual void factor(std::span<const double> values) = 0;
  /// b <- A^-1 b, shape n. Precondition: the last factor() returned. Throws SingularMatrix where the solution is not
  /// finite.
  virtual void solve(std::span<double> b) = 0;
  [[nodiscard]] virtual const Statistics& statistics() const = 0;
  /// What was taken on the first matrix, for Settings::chosen; "" before it.
  [[nodiscard]] virtual std::string chosen() const = 0;
  /// One line: library with version, ordering, fill, residual.
  [[nodiscard]] virtual std::string describe() const = 0;
};

/// The relative residual of a solve that is as accurate as double precision allows.
inline constexpr double full_accuracy = 1e-12;
/// The relative residual that factors in single precision reach.
inline constexpr double single_precision = 1e-6;

/// `automatic` tries all but `dissected` and `mumps`: UMFPACK with nested dissection, and MUMPS, for fields in the plane on large grids.
enum class Choice : std::uint8_t { automatic, klu, umfpack, dissected, mumps, banded, condensed };

struct Settings {
  Choice choice = Choice::automatic;
  double pivot_tolerance = 0.1;      ///< KLU: take a diagonal pivot this large relative to the largest of its column
  std::vector<Index> ordering = {};  ///< optional: the unknowns in an order that keeps fill or band small, shape n
  /// Relative residual that is enough, for Newton's corrections, which contract: a solver may make coarse factors. From
  /// `single_precision` on, MUMPS and a large condensed band work in single precision.
  double accuracy = full_accuracy;
  std::string chosen = {};  ///< DirectSolver::chosen() of an earlier solver: taken without trials; "" or unknown: tried
};

/// A solver for matrices of `pattern`, which must outlive it. `automatic` tries all on the first matrix and keeps the
/// one with the least predicted time. Two new solvers with the same settings give the same bits on the same matrices:
/// what else a solver remembers (pivots) it learns from them. Throws std::invalid_argument where the ordering is no permutation of the
/// unknowns.
[[nodiscard]] std::unique_ptr<DirectSolver> make_solver(const SparsePattern& pattern, const Settings& settings = {});

}  // namespace talus::linear
