#pragma once

#include <array>
#include <cmath>

namespace talus::core {

/// Forward-mode dual number: a value and its partial derivatives with respect to N inputs of a stencil kernel.
/// Arithmetic is exact to rounding. sqrt and log at zero have no finite derivative: kernels regularise before they call them.
template <int N>
struct Dual {
  double value = 0.0;
  std::array<double, N> slope{};

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT(google-explicit-constructor): constants mix freely with duals

  /// The input number `seed`, with d/d(input) = `weight`.
  static Dual input(double v, int seed, double weight = 1.0) {
    Dual x(v);
    x.slope[seed] = weight;
    return x;
  }

  /// f(value) with f'(value) = derivative.
  [[nodiscard]] Dual chain(double f, double derivative) const {
    Dual r(f);
    for (int i = 0; i < N; ++i) r.slope[i] = derivative * slope[i];
    return r;
  }

  Dual& operator+=(const Dual& b) {
    value += b.value;
    for (int i = 0; i < N; ++i) slope[i] += b.slope[i];
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    value -= b.value;
    for (int i = 0; i < N; ++i) slope[i] -= b.slope[i];
    return *this;
  }
  Dual& operator+=(double b) {
    value += b;
    return *this;
  }
  Dual& operator-=(double b) {
    value -= b;
    return *this;
  }
  Dual& operator*=(double b) {
    value *= b;
    for (int i = 0; i < N; ++i) slope[i] *= b;
    return *this;
  }

  friend Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend Dual operator+(Dual a, double b) { return a += b; }
  friend Dual operator+(double a, Dual b) { return b += a; }
  friend Dual operator-(Dual a, double b) { return a -= b; }
  friend Dual operator-(double a, const Dual& b) { return b.chain(a - b.value, -1.0); }
  friend Dual operator-(const Dual& a) { return a.chain(-a.value, -1.0); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual r(a.value * b.value);
    for (int i = 0; i < N; ++i) r.slope[i] = a.value * b.slope[i] + b.value * a.slope[i];
    return r;
  }
  friend Dual operator*(Dual a, double b) { return a *= b; }
  friend Dual operator*(double a, Dual b) { return b *= a; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double inverse = 1.0 / b.value;
    Dual r(a.value * inverse);
    for (int i = 0; i < N; ++i) r.slope[i] = (a.slope[i] - r.value * b.slope[i]) * inverse;
    return r;
  }
  friend Dual operator/(Dual a, double b) { return a *= 1.0 / b; }
  friend Dual operator/(double a, const Dual& b) {
    const double r = a / b.value;
    return b.chain(r, -r / b.value);
  }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
};

template <int N>
Dual<N> sqrt(const Dual<N>& x) {
  const double r = std::sqrt(x.value);
  return x.chain(r, 0.5 / r);
}
template <int N>
Dual<N> exp(const Dual<N>& x) {
  const double r = std::exp(x.value);
  return x.chain(r, r);
}
template <int N>
Dual<N> log(const Dual<N>& x) {
  return x.chain(std::log(x.value), 1.0 / x.value);
}
template <int N>
Dual<N> tanh(const Dual<N>& x) {
  const double r = std::tanh(x.value);
  return x.chain(r, 1.0 - r * r);
}
template <int N>
Dual<N> erf(const Dual<N>& x) {
  constexpr double two_over_sqrt_pi = 1.12837916709551257390;
  return x.chain(std::erf(x.value), two_over_sqrt_pi * std::exp(-x.value * x.value));
}
template <int N>
Dual<N> pow(const Dual<N>& x, double exponent) {
  const double r = std::pow(x.value, exponent);
  return x.chain(r, exponent * r / x.value);
}

}  // namespace talus::core
