#pragma once

#include <memory>
#include <span>
#include <vector>

#include "linear/direct_solver.hpp"

namespace talus::linear {

/// An LU factorisation by MUMPS in double or in single precision (Real), of a matrix whose rows and columns are scaled beforehand.
/// Ordering (nested_dissection) and pattern of the factors are found once, from the pattern alone.
template <class Real>
class MumpsFactors {
 public:
  /// `spare` [%] is the workspace beyond what is foreseen, for pivots that have to wait; it grows where it is too small.
  /// Throws SingularMatrix where no numbering has a diagonal without structural zeros, std::bad_alloc.
  explicit MumpsFactors(const SparsePattern& pattern, int spare = 50);
  MumpsFactors(const MumpsFactors&) = delete;
  MumpsFactors& operator=(const MumpsFactors&) = delete;
  ~MumpsFactors();

  /// The values of the matrix in the order of the pattern, to be written before factor().
  [[nodiscard]] std::span<Real> values() { return values_; }
  /// Throws SingularMatrix, std::bad_alloc.
  void factor();
  /// b <- (L U)^-1 b, shape n.
  void substitute(std::span<Real> b);
  /// Entries of the factors, and operations, of the last factorisation.
  [[nodiscard]] Index fill() const;
  [[nodiscard]] double flops() const;

 private:
  struct Library;  ///< MUMPS' structure

  void call(int job);
  void reserve(int spare);

  std::vector<int> rows_, columns_;  ///< of the entries, from one on, as MUMPS wants them
  std::vector<int> places_;          ///< of the unknowns in the ordering, from one on
  std::vector<Real> values_;
  std::unique_ptr<Library> library_;
  std::unique_ptr<Real[]> workspace_;  ///< kept: new pages of memory cost a quarter of a factorisation
};

}  // namespace talus::linear
