#pragma once

#include <string_view>
#include <variant>

#include "core/scalar.hpp"
#include "rheology/classical.hpp"
#include "rheology/constant.hpp"
#include "rheology/grains.hpp"
#include "rheology/partially_regularised.hpp"

namespace talus::rheology {

/// Every friction law of the room. A law is an aggregate with name, friction, log_slope, friction_at_rest,
/// friction_bound and inverse; I >= 0 throughout.
using Law = std::variant<Classical, PartiallyRegularised, Constant>;

/// mu(I).
template <class S>
S friction(const Law& law, const S& I) {
  return std::visit([&](const auto& l) { return l.friction(I); }, law);
}

/// I dmu/dI, which keeps its digits where dmu/dI is too small or too large for a double.
template <class S>
S friction_log_slope(const Law& law, const S& I) {
  return std::visit([&](const auto& l) { return l.log_slope(I); }, law);
}

/// dmu/dI, by a dual number; at I_N that of the creep side.
[[nodiscard]] inline double friction_slope(const Law& law, double I) {
  return friction(law, core::Dual<1>::input(I, 0)).slope[0];
}

/// I with mu(I) = mu - less: the two apart, so that a friction however close to mu_s or mu_d, where I hangs on the
/// difference, can be stated without loss. Throws std::domain_error naming law, mu and the bound where there is none.
[[nodiscard]] inline double inverse(const Law& law, double mu, double less = 0.0) {
  return std::visit([&](const auto& l) -> double { return l.inverse(mu, less); }, law);
}

/// mu(0).
[[nodiscard]] inline double friction_at_rest(const Law& law) {
  return std::visit([](const auto& l) { return l.friction_at_rest(); }, law);
}

/// The smallest number that mu(I) never exceeds; infinite where there is none.
[[nodiscard]] inline double friction_bound(const Law& law) {
  return std::visit([](const auto& l) { return l.friction_bound(); }, law);
}

[[nodiscard]] inline std::string_view name(const Law& law) {
  return std::visit([](const auto& l) { return std::string_view(l.name); }, law);
}

}  // namespace talus::rheology
