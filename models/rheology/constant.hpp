#pragma once

namespace talus::rheology {

/// Drucker-Prager plasticity: mu does not depend on I. Ill-posed everywhere (section 3.3); a bound and a contrast, not
/// a model.
struct Constant {
  static constexpr const char* name = "constant";
  double mu_s;

  template <class S>
  S friction(const S&) const {
    return S(mu_s);
  }
  template <class S>
  S log_slope(const S&) const {
    return S(0.0);
  }

  [[nodiscard]] double friction_at_rest() const { return mu_s; }
  [[nodiscard]] double friction_bound() const { return mu_s; }
  /// Throws std::domain_error always: a constant has no inverse.
  [[noreturn]] double inverse(double mu, double less = 0.0) const;
};

/// Checked: mu_s > 0. Throws std::invalid_argument.
[[nodiscard]] Constant constant(double mu_s);

}  // namespace talus::rheology
