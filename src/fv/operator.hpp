#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "fv/term.hpp"

namespace talus::fv {

/// The sum of a list of terms: residual, exact sparse Jacobian and its pattern, all from the same kernels.
template <class Context>
class Operator {
 public:
  using Terms = std::vector<std::unique_ptr<Term<Context>>>;

  /// `context` may hold any admissible state; it only serves to trace the pattern of n unknowns.
  Operator(Index n, Terms terms, const Context& context) : terms_(std::move(terms)) {
    std::vector<std::pair<Index, Index>> entries;
    for (const auto& term : terms_) term->append_pattern(context, entries);
    pattern_ = core::SparsePattern(n, std::move(entries));
    for (const auto& term : terms_) term->bind(context, pattern_);
  }

  [[nodiscard]] const core::SparsePattern& pattern() const { return pattern_; }

  void residual(const Context& context, std::span<const double> y, std::span<const double> yp, std::span<double> r) const {
    std::fill(r.begin(), r.end(), 0.0);
    for (const auto& term : terms_) term->add_residual(context, y, yp, r);
  }

  void jacobian(const Context& context, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const {
    std::fill(values.begin(), values.end(), 0.0);
    for (const auto& term : terms_) term->add_jacobian(context, y, yp, c_j, values);
  }

 private:
  Terms terms_;
  core::SparsePattern pattern_;
};

}  // namespace talus::fv
