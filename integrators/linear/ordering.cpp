#include "linear/ordering.hpp"

#include <cholmod.h>

#include <algorithm>
#include <new>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace talus::linear {
namespace {

using core::Index;

/// Neighbours of each unknown in the graph of A + A^T, without itself, by ascending degree.
class Graph {
 public:
  explicit Graph(const core::SparsePattern& pattern) : neighbours_(pattern.n()) {
    const auto starts = pattern.column_starts();
    const auto rows = pattern.rows();
    for (Index j = 0; j < pattern.n(); ++j) {
      for (Index k = starts[j]; k < starts[j + 1]; ++k) {
        if (rows[k] == j) continue;
        neighbours_[j].push_back(rows[k]);
        neighbours_[rows[k]].push_back(j);
      }
    }
    for (auto& list : neighbours_) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    const auto by_degree = [this](Index a, Index b) { return degree(a) < degree(b); };
    for (auto& list : neighbours_) std::stable_sort(list.begin(), list.end(), by_degree);
  }

  [[nodiscard]] const std::vector<Index>& neighbours(Index node) const { return neighbours_[node]; }
  [[nodiscard]] std::size_t degree(Index node) const { return neighbours_[node].size(); }

  /// Nodes reached from `root` level by level, and the number of levels.
  [[nodiscard]] std::pair<Ordering, int> levels(Index root) const {
    Ordering reached = {root};
    std::vector<bool> seen(neighbours_.size(), false);
    seen[root] = true;
    int depth = 0;
    for (std::size_t begin = 0; begin < reached.size(); ++depth) {
      for (const std::size_t end = reached.size(); begin < end; ++begin) {
        for (const Index next : neighbours_[reached[begin]]) {
          if (!seen[next]) reached.push_back(next);
          seen[next] = true;
        }
      }
    }
    return {std::move(reached), depth};
  }

  /// Levels from a node that is as far away as any from some other node.
  [[nodiscard]] Ordering longest_levels(Index root) const {
    auto [order, depth] = levels(root);
    while (true) {
      auto [next_order, next_depth] = levels(order.back());
      if (next_depth <= depth) return order;
      std::tie(order, depth) = std::pair(std::move(next_order), next_depth);
    }
  }

 private:
  std::vector<Ordering> neighbours_;
};

}  // namespace

Ordering natural_ordering(Index n) {
  Ordering order(n);
  std::iota(order.begin(), order.end(), Index{0});
  return order;
}

Ordering inverse(std::span<const Index> ordering) {
  const Index n = static_cast<Index>(ordering.size());
  Ordering place(n, -1);
  for (Index k = 0; k < n; ++k) {
    if (ordering[k] < 0 || ordering[k] >= n || place[ordering[k]] >= 0) {
      throw std::invalid_argument("inverse: an ordering must name each unknown once");
    }
    place[ordering[k]] = k;
  }
  return place;
}

Ordering reverse_cuthill_mckee(const core::SparsePattern& pattern) {
  const Graph graph(pattern);
  Ordering order;
  std::vector<bool> placed(pattern.n(), false);
  for (Index root = 0; root < pattern.n(); ++root) {
    if (placed[root]) continue;
    for (const Index node : graph.longest_levels(root)) {
      order.push_back(node);
      placed[node] = true;
    }
  }
  std::reverse(order.begin(), order.end());
  return order;
}

Bandwidth bandwidth(const core::SparsePattern& pattern, std::span<const Index> ordering) {
  const Ordering place = inverse(ordering);
  if (static_cast<Index>(place.size()) != pattern.n())
    throw std::invalid_argument("bandwidth: ordering of another size");
  const auto starts = pattern.column_starts();
  const auto rows = pattern.rows();
  Bandwidth width{0, 0};
  for (Index j = 0; j < pattern.n(); ++j) {
    for (Index k = starts[j]; k < starts[j + 1]; ++k) {
      const Index below = place[rows[k]] - place[j];
      width.lower = std::max(width.lower, below);
      width.upper = std::max(width.upper, -below);
    }
  }
  return width;
}

Ordering nested_dissection(const core::SparsePattern& pattern) {
  const Graph graph(pattern);
  std::vector<Index> starts{0}, rows;
  for (Index j = 0; j < pattern.n(); ++j) {
    for (const Index i : graph.neighbours(j))
      if (i > j) rows.push_back(i);
    starts.push_back(static_cast<Index>(rows.size()));
  }
  Ordering order(pattern.n());
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = order.size();
  matrix.nzmax = rows.size();
  matrix.p = starts.data();
  matrix.i = rows.data();
  matrix.stype = -1;
  matrix.itype = CHOLMOD_LONG;
  matrix.xtype = CHOLMOD_PATTERN;
  matrix.packed = 1;
  cholmod_common common;
  cholmod_l_start(&common);
  common.print = 0;
  const bool done = cholmod_l_metis(&matrix, nullptr, 0, 1, order.data(), &common) != 0;
  cholmod_l_finish(&common);
  if (!done) throw std::bad_alloc();
  return order;
}

}  // namespace talus::linear
