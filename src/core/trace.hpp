#pragma once

#include <bitset>

namespace talus::core {

/// Dependency tracer: a scalar that remembers which of N stencil inputs it was made from.
/// Running a kernel on it yields the structural pattern of that kernel's Jacobian block.
/// It carries no value; `select` below unites both branches so that no dependency is lost.
template <int N>
struct Trace {
  std::bitset<N> inputs;

  Trace() = default;
  Trace(double) {}  // NOLINT(google-explicit-constructor): a constant depends on nothing

  static Trace input(int seed) {
    Trace x;
    x.inputs.set(seed);
    return x;
  }

  Trace& operator+=(const Trace& b) {
    inputs |= b.inputs;
    return *this;
  }
  Trace& operator-=(const Trace& b) { return *this += b; }
  Trace& operator*=(double) { return *this; }

  friend Trace operator+(Trace a, const Trace& b) { return a += b; }
  friend Trace operator-(Trace a, const Trace& b) { return a += b; }
  friend Trace operator*(Trace a, const Trace& b) { return a += b; }
  friend Trace operator/(Trace a, const Trace& b) { return a += b; }
  friend Trace operator-(const Trace& a) { return a; }
};

template <int N>
Trace<N> sqrt(const Trace<N>& x) {
  return x;
}
template <int N>
Trace<N> exp(const Trace<N>& x) {
  return x;
}
template <int N>
Trace<N> log(const Trace<N>& x) {
  return x;
}
template <int N>
Trace<N> tanh(const Trace<N>& x) {
  return x;
}
template <int N>
Trace<N> erf(const Trace<N>& x) {
  return x;
}
template <int N>
Trace<N> pow(const Trace<N>& x, double) {
  return x;
}

}  // namespace talus::core
