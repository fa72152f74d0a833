#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "core/both.hpp"
#include "core/pack.hpp"

/// Loops over long vectors: on both threads where that pays, with the same bits as on one.
namespace talus::core {

/// Numbers from which on a second thread is worth its while for a loop bound by memory.
inline constexpr std::size_t long_vector = 1 << 14;

/// part(begin, end) for the two halves of [0, n), at once where n is long.
template <class Part>
void in_halves(std::size_t n, const Part& part) {
  constexpr std::size_t line = 8;  // of numbers in a line of the cache
  const std::size_t half = n / (2 * line) * line;
  both(
      n >= long_vector, [&] { part(std::size_t{0}, half); }, [&] { part(half, n); });
}

/// Whether all of v is finite.
inline bool all_finite(std::span<const double> v) {
  bool first = true, second = true;
  in_halves(v.size(), [&](std::size_t begin, std::size_t end) {
    bool finite = true;
    for (std::size_t i = begin; i < end; ++i) finite &= std::abs(v[i]) <= std::numeric_limits<double>::max();
    (begin == 0 ? first : second) = finite;
  });
  return first && second;
}

/// The sum of term(read, i) for i in [begin, end), in eight sums side by side: one alone waits for each addition. A term reads the
/// numbers at a place as read(pointer), one or a Pack of them, and computes with either.
template <class Term>
double sum_of(std::size_t begin, std::size_t end, const Term& term) {
  constexpr std::size_t lanes = Pack::lanes;
  Pack even(0.0), odd(0.0);
  std::size_t i = begin;
  for (; i + 2 * lanes <= end; i += 2 * lanes) {
    even += term(Pack::at, i);
    odd += term(Pack::at, i + lanes);
  }
  even += odd;
  double sum = (even.lane[0] + even.lane[1]) + (even.lane[2] + even.lane[3]);
  for (; i < end; ++i) sum += term([](const double* x) { return *x; }, i);
  return sum;
}

/// The sum over all i < n: of the halves, whichever threads sum them.
template <class Term>
double sum_in_halves(std::size_t n, const Term& term) {
  double first = 0.0, second = 0.0;
  in_halves(n, [&](std::size_t begin, std::size_t end) { (begin == 0 ? first : second) = sum_of(begin, end, term); });
  return first + second;
}

}  // namespace talus::core
