#pragma once

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "rheology/law.hpp"

/// Friction laws and inertial numbers at the ends of what is admitted.
namespace talus::support {

struct NamedLaw {
  std::string name;
  rheology::Law law;
};

/// Numbers between `low` and `high`, evenly in their logarithm, the same on every machine.
class LogUniform {
 public:
  explicit LogUniform(unsigned seed) : bits_(seed) {}
  double operator()(double low, double high) {
    const double share = static_cast<double>(bits_() >> 11) * 0x1p-53;
    return low * std::exp(share * (std::log(high) - std::log(low)));
  }

 private:
  std::mt19937_64 bits_;
};

/// Any partially regularised law that is admitted, with scales up to 10^(+-decades).
inline rheology::PartiallyRegularised random_partial(LogUniform& random, double decades) {
  const double wide = std::pow(10.0, decades);
  const double mu_s = random(std::max(1e-100, 1.0 / wide), 10.0);
  const double mu_d = std::min(1e6, mu_s * random(1.0, 10.0));
  const rheology::Classical base = rheology::classical(mu_s, mu_d, random(1.0 / wide, wide));
  const double mu_inf = random(0.0 < decades ? 1.0 / wide : 1.0, 10.0);
  const double I_N = random(std::max(1e-150, 1e-3 / wide), std::min(1e90, wide));
  // With alpha = 1 only the friction at I_N is asked for.
  const double mu_N =
      rheology::PartiallyRegularised{mu_s, mu_d, mu_inf, base.I_0, I_N, 1.0, 0.0, 0.0, 0.0}.rational(I_N);
  const double folds = random(1e-40, 0.99 * std::log(1e100 / I_N));
  return rheology::partially_regularised(base, mu_inf, folds * mu_N * mu_N, I_N);
}

inline std::vector<NamedLaw> extreme_laws() {
  using rheology::classical;
  using rheology::partially_regularised;
  const auto table_1 = classical(0.342, 0.557, 0.069), table_2 = classical(0.4, 0.9, 1.3);
  return {{"table 1", table_1},
          {"table 2", table_2},
          {"table 1, printed I_N", partially_regularised(table_1, 0.05, 1.9, 0.004)},
          {"table 1, computed I_N", partially_regularised(table_1, 0.05, 1.9)},
          {"table 2, printed I_N", partially_regularised(table_2, 1.3, 1.9, 0.05178)},
          {"table 2, computed I_N", partially_regularised(table_2, 1.3, 1.9)},
          {"mu_inf = 0", partially_regularised(table_2, 0.0, 1.9, 0.05)},
          {"mu_d = mu_s", partially_regularised(classical(0.4, 0.4, 1.3), 1.3, 1.9, 0.05)},
          {"classical with mu_d = mu_s", classical(0.4, 0.4, 1.3)},
          {"smallest I_N", partially_regularised(table_2, 1.3, 1.9, 1e-150)},
          {"largest I_N", partially_regularised(table_2, 1e-100, 1.9, 1e90)},
          {"smallest alpha", partially_regularised(table_2, 1.3, 2e-51, 0.05)},
          {"largest alpha", partially_regularised(table_2, 1.3, 40.0, 0.05)},
          {"alpha above 2", partially_regularised(table_2, 1.3, 2.5, 0.05)},
          {"smallest I_0", classical(0.4, 0.9, 1e-100)},
          {"largest I_0", partially_regularised(classical(0.4, 0.9, 1e100), 1e6, 1.9, 0.05)},
          {"smallest friction", classical(1e-100, 1.0, 1.0)},
          {"largest friction", classical(0.4, 1e6, 1.0)},
          {"constant", rheology::constant(0.4)}};
}

/// 0, the smallest doubles, and 1e-300 to 1e300 in steps of the cube root of ten.
inline std::vector<double> extreme_I() {
  std::vector<double> list{0.0, 5e-324, 2.3e-308};
  for (int i = -900; i <= 900; ++i) list.push_back(std::pow(10.0, i / 3.0));
  return list;
}

}  // namespace talus::support
