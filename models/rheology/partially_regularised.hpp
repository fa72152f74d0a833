#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "core/scalar.hpp"
#include "rheology/classical.hpp"

namespace talus::rheology {

/// mu(I) of Barker & Gray (2017), (3.19): logarithmic creep up to I_N, rational above and linear at large I, so that
/// every mu >= 0 has its I. Continuous to the last bit; its slope jumps at I_N. Below `tiny_I` the logarithm is
/// continued by the parabola through zero that joins it with its slope: mu(0) = 0 and dmu/dI stays finite there.
/// The creep sqrt(alpha/ln(A/I)) is written with ln(A/I) = ln(A/I_N) + ln(I_N/I) and A of (3.20): nothing cancels
/// where A is close to I_N, and nothing overflows where it is large.
struct PartiallyRegularised {
  static constexpr const char* name = "partially regularised";
  static constexpr double tiny_I = 1e-200;
  double mu_s, mu_d, mu_inf, I_0, I_N, alpha;
  double mu_N;     ///< mu(I_N)
  double folds_N;  ///< ln(A/I_N) = alpha/mu_N^2
  double A;        ///< (3.20)

  template <class S>
  S friction(const S& I) const {
    using std::sqrt;
    using core::sqrt;
    return core::select_above(
        I, I_N, [&] { return rational(I); },
        [&] {
          return core::select_above(
              I, tiny_I, [&] { return S(mu_N / sqrt(folds(I) / folds_N)); },
              [&] {
                const S x = I / tiny_I;
                return S(creep_limit() * x * (2.0 - creep_power() - (1.0 - creep_power()) * x));
              });
        });
  }

  /// I dmu/dI; at I_N that of the creep side.
  template <class S>
  S log_slope(const S& I) const {
    return core::select_above(
        I, I_N,
        [&] {
          const S share = saturation(I, I_0), rest = I_0 / (I + I_0);
          return S(share * ((mu_d - mu_s) * rest + mu_inf * I * (1.0 + rest)));
        },
        [&] {
          return core::select_above(
              I, tiny_I, [&] { return S(0.5 * friction(I) / folds(I)); },
              [&] {
                const S x = I / tiny_I;
                return S(creep_limit() * x * (2.0 - creep_power() - 2.0 * (1.0 - creep_power()) * x));
              });
        });
  }

  [[nodiscard]] double friction_at_rest() const { return 0.0; }
  [[nodiscard]] double friction_bound() const { return mu_inf > 0.0 ? std::numeric_limits<double>::infinity() : mu_d; }
  /// mu(I_N), where the branches meet.
  [[nodiscard]] double friction_at_I_N() const { return mu_N; }
  /// I with mu(I) = mu - less. Throws std::domain_error where that is below 0, where mu_inf = 0 and it is not below mu_d,
  /// and where I is beyond doubles.
  [[nodiscard]] double inverse(double mu, double less = 0.0) const;

  /// The branch above I_N.
  template <class S>
  S rational(const S& I) const {
    return mu_s + (mu_d - mu_s + mu_inf * I) * saturation(I, I_0);
  }

 private:
  /// ln(A/I).
  template <class S>
  S folds(const S& I) const {
    using std::log;
    using core::log;
    return folds_N - log(I / I_N);
  }
  [[nodiscard]] double creep_limit() const { return mu_N / std::sqrt(folds(tiny_I) / folds_N); }  ///< mu(tiny_I)
  [[nodiscard]] double creep_power() const { return 0.5 / folds(tiny_I); }                        ///< I mu'/mu there
};

/// Checked: `base` as `classical` demands; mu_inf 0 or from 1e-100 to 1e6; I_N from 1e-150 to 1e90; alpha such that A
/// (3.20) is above I_N and at most 1e100. mu then grows with I everywhere. Without I_N it is the lower neutral point
/// of `base` (3.18). Throws std::invalid_argument naming the parameter and its range, also where `base` has no neutral
/// point to take.
[[nodiscard]] PartiallyRegularised partially_regularised(const Classical& base, double mu_inf, double alpha,
                                                         std::optional<double> I_N = {});

}  // namespace talus::rheology
