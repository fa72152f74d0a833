#pragma once

#include "rheology/saturation.hpp"

namespace talus::rheology {

/// mu(I) = mu_s + (mu_d - mu_s)/(I_0/I + 1), (1.3): rises from mu_s at rest and saturates at mu_d.
struct Classical {
  static constexpr const char* name = "classical";
  double mu_s, mu_d, I_0;

  template <class S>
  S friction(const S& I) const {
    return mu_s + (mu_d - mu_s) * saturation(I, I_0);
  }

  /// I dmu/dI.
  template <class S>
  S log_slope(const S& I) const {
    return (mu_d - mu_s) * saturation(I, I_0) * (I_0 / (I + I_0));
  }

  [[nodiscard]] double friction_at_rest() const { return mu_s; }
  /// mu is below it at every I.
  [[nodiscard]] double friction_bound() const { return mu_d; }
  /// I with mu(I) = mu - less, for mu_s <= mu - less < mu_d; else throws std::domain_error.
  [[nodiscard]] double inverse(double mu, double less = 0.0) const;
};

/// Checked: 0 < mu_s <= mu_d, I_0 > 0, within the ranges that `checks` states. Throws std::invalid_argument naming the
/// parameter and its range.
[[nodiscard]] Classical classical(double mu_s, double mu_d, double I_0);

}  // namespace talus::rheology
