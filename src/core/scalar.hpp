#pragma once

#include <array>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/dual.hpp"
#include "core/pack.hpp"
#include "core/trace.hpp"

/// What a scalar-generic kernel may use beside arithmetic and sqrt, exp, log, tanh, pow. Kernels must not branch on values
/// with `if`, or the traced pattern could miss an entry: they call `select`.
namespace talus::core {

/// Whether a scalar carries numbers and nothing besides.
template <class S>
inline constexpr bool is_plain = std::is_same_v<S, double> || std::is_same_v<S, Pack>;

inline double value_of(double x) { return x; }
template <int N>
double value_of(const Dual<N>& x) {
  return x.value;
}
/// Of each lane.
inline Pack value_of(const Pack& x) { return x; }
/// A tracer has no value: any finite number does.
template <int N>
double value_of(const Trace<N>&) {
  return 1.0;
}

/// `yes()` where x > threshold, else `no()`. Only the branch taken is evaluated; a Trace evaluates and unites both, a Pack whose
/// lanes differ takes each lane's from both: the other branch may then raise floating-point flags, in lanes that nobody reads.
template <class Yes, class No>
double select_above(double x, double threshold, Yes&& yes, No&& no) {
  return x > threshold ? yes() : no();
}
template <int N, class Yes, class No>
Dual<N> select_above(const Dual<N>& x, double threshold, Yes&& yes, No&& no) {
  return x.value > threshold ? Dual<N>(yes()) : Dual<N>(no());
}
template <class Yes, class No>
[[gnu::always_inline]] inline Pack select_above(const Pack& x, double threshold, Yes&& yes, No&& no) {
  const auto above = x.vector() > Pack(threshold).vector();  // -1 or 0 a lane
  const auto n_above = -(above[0] + above[1] + above[2] + above[3]);
  if (n_above == Pack::lanes) return Pack(yes());
  if (n_above == 0) return Pack(no());
  return Pack(Pack::Vector(above ? Pack(yes()).vector() : Pack(no()).vector()));
}
template <int N, class Yes, class No>
Trace<N> select_above(const Trace<N>& x, double, Yes&& yes, No&& no) {
  return x + Trace<N>(yes()) + Trace<N>(no());
}

/// A smooth function of one scalar whose value and derivative were tabulated beforehand: f(x) = value, f'(x) = derivative.
inline double lift(double value, double /*derivative*/, double /*x*/) { return value; }
inline Pack lift(double value, double /*derivative*/, const Pack& /*x*/) { return value; }
template <int N>
Dual<N> lift(double value, double derivative, const Dual<N>& x) {
  return x.chain(value, derivative);
}
template <int N>
Trace<N> lift(double, double, const Trace<N>& x) {
  return x;
}

/// f(arguments...) for a function of few arguments that each depend on many inputs. With duals, f is evaluated with derivatives
/// by its arguments, and the chain rule is applied once: the same result up to rounding, for less work.
template <class F, class S, class... Rest>
S through(F&& f, const S& first, const Rest&... rest) {
  return f(first, rest...);
}
template <class F, int N, class... Rest>
Dual<N> through(F&& f, const Dual<N>& first, const Rest&... rest) {
  constexpr int m = 1 + static_cast<int>(sizeof...(rest));
  int seed = 0;
  const std::array<const Dual<N>*, m> arguments{&first, &rest...};
  std::array<Dual<m>, m> inner;
  for (const auto* x : arguments) inner[seed] = Dual<m>::input(x->value, seed), ++seed;
  const Dual<m> value = std::apply(std::forward<F>(f), inner);
  Dual<N> r = first.chain(value.value, value.slope[0]);
  for (int a = 1; a < m; ++a)
    for (int i = 0; i < N; ++i) r.slope[i] += value.slope[a] * arguments[a]->slope[i];
  return r;
}

}  // namespace talus::core
