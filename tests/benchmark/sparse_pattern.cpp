#include <benchmark/benchmark.h>

#include <utility>
#include <vector>

#include "core/sparse_pattern.hpp"

/// Set-up cost of the frozen pattern: built once a run from all (row, column) pairs, then searched once an entry.
namespace {
using talus::core::Index;

/// 3 unknowns a cell, each coupled to all unknowns of its 9 neighbours, on a grid of n x n cells.
std::vector<std::pair<Index, Index>> nine_point(Index n) {
  std::vector<std::pair<Index, Index>> entries;
  const Index cells = n * n;
  for (Index cell = 0; cell < cells; ++cell)
    for (Index neighbour : {-n - 1, -n, -n + 1, Index{-1}, Index{0}, Index{1}, n - 1, n, n + 1})
      if (cell + neighbour >= 0 && cell + neighbour < cells)
        for (Index a = 0; a < 3; ++a)
          for (Index b = 0; b < 3; ++b) entries.emplace_back(3 * cell + a, 3 * (cell + neighbour) + b);
  return entries;
}

void build(benchmark::State& state) {
  const auto entries = nine_point(state.range(0));
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(talus::core::SparsePattern(3 * state.range(0) * state.range(0), entries));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(entries.size()));
}

void find(benchmark::State& state) {
  const auto entries = nine_point(state.range(0));
  const talus::core::SparsePattern pattern(3 * state.range(0) * state.range(0), entries);
  for ([[maybe_unused]] auto _ : state)
    for (const auto& [row, column] : entries) benchmark::DoNotOptimize(pattern.find(row, column));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(entries.size()));
}

BENCHMARK(build)->Arg(20)->Arg(70);
BENCHMARK(find)->Arg(20)->Arg(70);
}  // namespace
