#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/both.hpp"
#include "fv/term.hpp"

namespace talus::fv {

/// The sum of a list of terms: residual, exact sparse Jacobian and its pattern, all from the same kernels.
///
/// Terms are summed in four parts of their places, first and third, then second and fourth: two parts that share no row can be
/// summed by two threads. The order of every sum is the same whether they are or not: same input, same bits.
template <class Context>
class Operator {
 public:
  using Terms = std::vector<std::unique_ptr<Term<Context>>>;

  static constexpr Index least_for_threads = 2000;  ///< unknowns; below, starting a thread costs more than it saves

  /// `context` may hold any admissible state; it only serves to trace the pattern of n unknowns. From `least` unknowns on,
  /// two threads share the sums.
  Operator(Index n, Terms terms, const Context& context, Index least = least_for_threads) : terms_(std::move(terms)) {
    std::vector<std::pair<Index, Index>> entries;
    for (const auto& term : terms_) term->append_pattern(context, entries);
    pattern_ = core::SparsePattern(n, std::move(entries));
    for (const auto& term : terms_) term->bind(context, pattern_);
    in_threads_ = n >= least && disjoint(0, 2) && disjoint(1, 3);
  }

  [[nodiscard]] const core::SparsePattern& pattern() const { return pattern_; }
  [[nodiscard]] bool in_threads() const { return in_threads_; }

  void residual(const Context& context, std::span<const double> y, std::span<const double> yp,
                std::span<double> r) const {
    std::fill(r.begin(), r.end(), 0.0);
    in_parts([&](Part part) {
      for (const auto& term : terms_) term->add_residual(context, part, y, yp, r);
    });
  }

  void jacobian(const Context& context, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const {
    std::fill(values.begin(), values.end(), 0.0);
    in_parts([&](Part part) {
      for (const auto& term : terms_) term->add_jacobian(context, part, y, yp, c_j, values);
    });
  }

 private:
  [[nodiscard]] bool disjoint(int first, int second) const {
    std::vector<bool> used(pattern_.n(), false);
    std::vector<Index> rows;
    for (const auto& term : terms_) term->append_rows({first}, rows);
    for (const Index row : rows) used[row] = true;
    rows.clear();
    for (const auto& term : terms_) term->append_rows({second}, rows);
    return std::none_of(rows.begin(), rows.end(), [&](Index row) { return used[row]; });
  }

  template <class Sum>
  void in_parts(const Sum& sum) const {
    for (const int first : {0, 1}) {
      core::both(
          in_threads_, [&] { sum(Part{first}); }, [&] { sum(Part{first + 2}); });
    }
  }

  Terms terms_;
  core::SparsePattern pattern_;
  bool in_threads_ = false;
};

}  // namespace talus::fv
