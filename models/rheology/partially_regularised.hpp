#pragma once

#include <cmath>
#include <optional>

#include "core/scalar.hpp"
#include "rheology/classical.hpp"

namespace talus::rheology {

/// mu(I) of Barker & Gray (2017), (3.19): logarithmic creep up to I_N, rational above and linear at large I, so that
/// every mu >= 0 has its I. Continuous (A of (3.20)); its slope jumps at I_N. Below `tiny_I` the logarithm is continued
/// by the parabola through zero that joins it with its slope: mu(0) = 0 and dmu/dI stays finite there.
/// (ln(A/I) is written -log(I/A): the derivative of A/I overflows.)
struct PartiallyRegularised {
  static constexpr const char* name = "partially regularised";
  static constexpr double tiny_I = 1e-200;
  double mu_s, mu_d, mu_inf, I_0, I_N, alpha, A;

  template <class S>
  S friction(const S& I) const {
    using std::sqrt;
    using std::log;
    using core::sqrt;
    using core::log;
    return core::select_above(
        I, I_N,
        [&] {
          const S rest = I_0 / (I + I_0);
          return S(mu_s * rest + (mu_d + mu_inf * I) * (1.0 - rest));
        },
        [&] {
          return core::select_above(
              I, tiny_I, [&] { return S(sqrt(alpha / -log(I / A))); },
              [&] {
                const S x = I / tiny_I;
                return S(creep_limit() * x * (2.0 - creep_power() - (1.0 - creep_power()) * x));
              });
        });
  }

  /// dmu/dI; at I_N that of the creep side.
  template <class S>
  S slope(const S& I) const {
    using std::sqrt;
    using std::log;
    using core::sqrt;
    using core::log;
    return core::select_above(
        I, I_N,
        [&] {
          const S rest = I_0 / (I + I_0);
          return S(mu_inf * (1.0 - rest) * (1.0 + rest) + ((mu_d - mu_s) / I_0) * rest * rest);
        },
        [&] {
          return core::select_above(
              I, tiny_I,
              [&] {
                const S folds = -log(I / A);
                return S(0.5 * sqrt(alpha / folds) / (I * folds));
              },
              [&] {
                const S x = I / tiny_I;
                return S((creep_limit() / tiny_I) * (2.0 - creep_power() - 2.0 * (1.0 - creep_power()) * x));
              });
        });
  }

  [[nodiscard]] double friction_at_rest() const { return 0.0; }
  /// mu(I_N), where the branches meet.
  [[nodiscard]] double friction_at_I_N() const { return friction(I_N); }
  /// I with mu(I) = mu. Throws std::domain_error where mu < 0, and where mu_inf = 0 and mu >= mu_d.
  [[nodiscard]] double inverse(double mu) const;

 private:
  [[nodiscard]] double creep_limit() const { return std::sqrt(alpha / std::log(A / tiny_I)); }  ///< mu(tiny_I)
  [[nodiscard]] double creep_power() const { return 0.5 / std::log(A / tiny_I); }               ///< I mu'/mu there
};

/// A of (3.20), which makes (3.19) continuous at I_N.
[[nodiscard]] double creep_amplitude(const Classical& base, double mu_inf, double alpha, double I_N);

/// Checked: `base` as `classical` demands, mu_inf >= 0, alpha > 0, I_N > 0 and A finite. Without I_N it is the lower
/// neutral point of `base` (3.18). Throws std::invalid_argument naming the parameter, also where `base` has no neutral
/// point to take.
[[nodiscard]] PartiallyRegularised partially_regularised(const Classical& base, double mu_inf, double alpha,
                                                         std::optional<double> I_N = {});

}  // namespace talus::rheology
