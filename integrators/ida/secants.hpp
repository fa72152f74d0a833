#pragma once

#include <functional>
#include <span>
#include <vector>

namespace talus::ida {

/// What the last moves of a Newton iteration with kept factors showed: each step taken, and how -J^-1 G(x) changed along it.
/// From them Anderson's acceleration: the combination of changes that leaves the least of a correction, in the weighted norm.
/// A correction is dx = -scale J^-1 G(x). Rows of G that are linear keep what J does for them: step + change is in their kernel.
/// (H. F. Walker and P. Ni, SIAM J. Numer. Anal. 49, 2011.)
class Secants {
 public:
  using Product = std::function<double(std::span<const double>, std::span<const double>)>;

  /// At most `depth` of them, the newest.
  explicit Secants(int depth) : depth_(static_cast<std::size_t>(depth)) {}

  [[nodiscard]] bool empty() const { return pairs_.empty(); }
  void clear() { pairs_.clear(); }
  /// The weights of the product have changed since the last accelerate().
  void reweigh();
  /// Of the corrections that follow.
  void set_scale(double scale) { scale_ = scale; }
  /// Of the move x += lambda step, along which the correction went from `before` to `after`; all of shape n.
  void add(double lambda, std::span<const double> step, std::span<const double> before, std::span<const double> after);
  /// step = dx - sum_i gamma_i (step_i + change_i), where sum_i gamma_i change_i is nearest to dx/scale. Nothing is taken of changes
  /// that are nearly dependent on newer ones, or so small beside dx that their rounding would be blown up.
  void accelerate(const Product& product, std::span<const double> dx, std::span<double> step);

 private:
  /// Squared part of a change, outside the span of newer ones, below which it counts as dependent.
  static constexpr double least_new = 1e-2;
  /// Squared size of a change, as a share of that of dx, below which it is too small.
  static constexpr double least_size = 1e-2;

  struct Pair {
    std::vector<double> step, change;
    std::vector<double> products;  // of this change and that of the pair so many places older; NaN where not yet known
  };
  /// gamma, zero for dependent and for small changes.
  [[nodiscard]] std::vector<double> nearest(const Product& product, std::span<const double> dx);
  double product_of(const Product& product, std::size_t newer, std::size_t older);

  std::size_t depth_;
  double scale_ = 1.0;
  std::vector<Pair> pairs_;  // newest first
};

}  // namespace talus::ida
