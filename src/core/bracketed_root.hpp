#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace talus::core {

/// Root of a continuous scalar function f between a and b, where it changes sign: inverse quadratic interpolation
/// guarded by bisection (Chandrupatla 1997, Adv. Eng. Softw. 28, 145). Exact to a few rounding errors of x, or to
/// `tolerance` [unit of x]. Throws std::domain_error where f(a) and f(b) have one sign or are not numbers.
template <class F, class T>
T bracketed_root(F&& f, T a, T b, T tolerance = 0.0) {
  T fa = f(a), fb = f(b);
  if (fa == 0.0) return a;
  if (fb == 0.0) return b;
  if (!(std::signbit(fa) != std::signbit(fb)) || std::isnan(fa) || std::isnan(fb))
    throw std::domain_error("bracketed_root: no change of sign between the two ends");
  T t = 0.5;
  for (int i = 0; i < 200; ++i) {
    const T x = a + t * (b - a);
    const T fx = f(x);
    T c = a, fc = fa;
    if (std::signbit(fx) != std::signbit(fa)) {
      c = b, fc = fb;
      b = a, fb = fa;
    }
    a = x, fa = fx;
    const T best = std::abs(fa) < std::abs(fb) ? a : b;
    const T limit = (2 * std::numeric_limits<T>::epsilon() * std::abs(best) + tolerance / 2) / std::abs(b - a);
    if (fa == 0.0 || !(limit < 0.5)) return best;
    const T xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
    const bool smooth = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
    t = smooth ? fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb) : T(0.5);
    t = std::clamp(t, limit, 1 - limit);
  }
  return std::abs(fa) < std::abs(fb) ? a : b;
}

}  // namespace talus::core
