#pragma once

#include <array>
#include <cmath>

namespace talus::core {

/// Four numbers side by side, one for each of four places that run the same code: a scalar of kernels that gives each lane the very
/// bits that `double` would. It is passed in memory, whatever registers a part of the program is compiled for.
struct alignas(32) Pack {
  static constexpr int lanes = 4;
  using Vector [[gnu::vector_size(32), gnu::may_alias]] = double;
  std::array<double, lanes> lane;

  Pack() = default;
  Pack(double x) : lane{x, x, x, x} {}  // NOLINT(google-explicit-constructor): constants mix freely with packs
  Pack(double a, double b, double c, double d) : lane{a, b, c, d} {}
  [[gnu::always_inline]] explicit Pack(const Vector& v) { vector() = v; }
  /// Four numbers in a row.
  static Pack at(const double* x) { return {x[0], x[1], x[2], x[3]}; }

  [[gnu::always_inline]] Vector& vector() { return *reinterpret_cast<Vector*>(lane.data()); }
  [[gnu::always_inline]] const Vector& vector() const { return *reinterpret_cast<const Vector*>(lane.data()); }

  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator*=(const Pack& b) { return *this = *this * b; }
  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.vector() + b.vector()); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.vector() - b.vector()); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.vector() * b.vector()); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.vector() / b.vector()); }
  friend Pack operator-(const Pack& a) { return Pack(-a.vector()); }
};

namespace detail {

template <class F>
[[gnu::always_inline]] inline Pack of_each(const Pack& x, F&& f) {
  return {f(x.lane[0]), f(x.lane[1]), f(x.lane[2]), f(x.lane[3])};
}

}  // namespace detail

[[gnu::always_inline]] inline Pack sqrt(const Pack& x) {
  return detail::of_each(x, [](double a) { return std::sqrt(a); });
}
inline Pack exp(const Pack& x) {
  return detail::of_each(x, [](double a) { return std::exp(a); });
}
inline Pack log(const Pack& x) {
  return detail::of_each(x, [](double a) { return std::log(a); });
}
inline Pack tanh(const Pack& x) {
  return detail::of_each(x, [](double a) { return std::tanh(a); });
}
inline Pack erf(const Pack& x) {
  return detail::of_each(x, [](double a) { return std::erf(a); });
}
inline Pack pow(const Pack& x, double exponent) {
  return detail::of_each(x, [=](double a) { return std::pow(a, exponent); });
}

}  // namespace talus::core
