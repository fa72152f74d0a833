#pragma once

#include <cmath>
#include <variant>

#include "core/scalar.hpp"

namespace talus::rheology {

/// Below these a rate [1/s] and a granular sound speed sqrt(p/rho_*) [m/s] count as zero: they keep sqrt differentiable.
inline constexpr double tiny_rate = 1e-12;
inline constexpr double tiny_speed = 1e-9;

struct Grains {
  double rho_star;  ///< intrinsic density rho_* [kg/m3]
  double Phi;       ///< solids fraction within the grains [1]
  double d;         ///< diameter [m]
  [[nodiscard]] double rho() const { return Phi * rho_star; }
};

/// mu(I) = mu_s + (mu_d - mu_s)/(I_0/I + 1), (1.3).
struct Classical {
  double mu_s, mu_d, I_0;
  template <class S>
  S friction(const S& I) const { return mu_s + (mu_d - mu_s) * I / (I + I_0); }
};

/// (3.19) with A of (3.20): logarithmic creep below I_N, rational above.
struct PartiallyRegularised {
  double mu_s, mu_d, mu_inf, I_0, I_N, alpha, A;
  template <class S>
  S friction(const S& I) const {
    using std::sqrt; using std::log;
    using core::sqrt; using core::log;
    return core::select_above(
        I, I_N, [&] { return S((mu_s * I_0 + mu_d * I + mu_inf * I * I) / (I_0 + I)); },
        [&] { return S(sqrt(alpha / log(A / (I + 1e-300)))); });
  }
};

/// Drucker-Prager: mu does not depend on I.
struct Constant {
  double mu_s;
  template <class S>
  S friction(const S&) const { return S(mu_s); }
};

using Law = std::variant<Classical, PartiallyRegularised, Constant>;

template <class S>
S friction(const Law& law, const S& I) {
  return std::visit([&](const auto& l) { return l.friction(I); }, law);
}

}  // namespace talus::rheology
