#pragma once

#include <array>
#include <cmath>

namespace talus::tests {

/// A value with its first and second derivatives by x, z and t: what a manufactured solution is differentiated with, exactly.
struct Taylor2 {
  enum By { x, z, t };
  double value = 0.0;
  std::array<double, 3> first{};
  std::array<std::array<double, 3>, 3> second{};

  Taylor2() = default;
  Taylor2(double v) : value(v) {}  // NOLINT(google-explicit-constructor): constants mix freely
  static Taylor2 variable(double v, By by) {
    Taylor2 r(v);
    r.first[by] = 1.0;
    return r;
  }

  /// f(value), given f' and f'' there.
  [[nodiscard]] Taylor2 chain(double f, double df, double d2f) const {
    Taylor2 r(f);
    for (int i = 0; i < 3; ++i) {
      r.first[i] = df * first[i];
      for (int j = 0; j < 3; ++j) r.second[i][j] = df * second[i][j] + d2f * first[i] * first[j];
    }
    return r;
  }

  friend Taylor2 operator+(Taylor2 a, const Taylor2& b) {
    a.value += b.value;
    for (int i = 0; i < 3; ++i) {
      a.first[i] += b.first[i];
      for (int j = 0; j < 3; ++j) a.second[i][j] += b.second[i][j];
    }
    return a;
  }
  friend Taylor2 operator-(const Taylor2& a) { return a.chain(-a.value, -1.0, 0.0); }
  friend Taylor2 operator-(const Taylor2& a, const Taylor2& b) { return a + (-b); }
  friend Taylor2 operator*(const Taylor2& a, const Taylor2& b) {
    Taylor2 r(a.value * b.value);
    for (int i = 0; i < 3; ++i) {
      r.first[i] = a.first[i] * b.value + a.value * b.first[i];
      for (int j = 0; j < 3; ++j) {
        r.second[i][j] =
            a.second[i][j] * b.value + a.first[i] * b.first[j] + a.first[j] * b.first[i] + a.value * b.second[i][j];
      }
    }
    return r;
  }
  friend Taylor2 operator/(const Taylor2& a, const Taylor2& b) {
    const double v = 1.0 / b.value;
    return a * b.chain(v, -v * v, 2.0 * v * v * v);
  }
};

inline Taylor2 sin(const Taylor2& a) {
  const double s = std::sin(a.value);
  return a.chain(s, std::cos(a.value), -s);
}
inline Taylor2 cos(const Taylor2& a) {
  const double c = std::cos(a.value);
  return a.chain(c, -std::sin(a.value), -c);
}

/// a^e for a > 0, or a = 0 where e > 1: below e = 2 its second derivatives are then no numbers.
inline Taylor2 pow(const Taylor2& a, double e) {
  return a.chain(std::pow(a.value, e), e * std::pow(a.value, e - 1.0), e * (e - 1.0) * std::pow(a.value, e - 2.0));
}
inline Taylor2 sqrt(const Taylor2& a) {
  const double r = std::sqrt(a.value);
  return a.chain(r, 0.5 / r, -0.25 / (r * a.value));
}

/// The derivative of a Taylor2, as far as it is known: its value and first derivatives.
inline Taylor2 derivative(const Taylor2& a, Taylor2::By by) {
  Taylor2 r(a.first[by]);
  r.first = a.second[by];
  return r;
}

}  // namespace talus::tests
