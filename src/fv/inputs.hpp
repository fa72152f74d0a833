#pragma once

#include <array>
#include <span>

#include "core/sparse_pattern.hpp"

namespace talus::fv {

using core::Index;

/// What a kernel reads at one place: unknowns and their time derivatives, in the order that its `connect` gave.
/// An absent input (index -1) reads as zero.
template <class S, int N>
struct Inputs {
  std::array<S, N> y;
  std::array<S, N> rate;
};

/// Stands for minus the unknown `index` as an input: its mirror image beyond a wall on which it vanishes. minus(minus(i)) is i.
constexpr Index minus(Index index) { return -2 - index; }

/// The number of an unknown behind an index that may be one of `minus`.
constexpr Index unknown_of(Index index) { return index < -1 ? minus(index) : index; }

/// What an index stands for among y: an unknown, minus one, or zero.
inline double read(std::span<const double> y, Index index) {
  if (index >= 0) return y[index];
  return index < -1 ? -y[minus(index)] : 0.0;
}

}  // namespace talus::fv
