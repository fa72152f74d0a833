#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/sparse_pattern.hpp"
#include "linear/direct_solver.hpp"

/// Matrices like those of the integrators, for the tests of the direct solvers.
namespace talus::test {

using core::Index;

struct Matrix {
  core::SparsePattern pattern;
  std::vector<double> values;
};

/// Numbers in [-1, 1), the same in every run.
class Random {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1.0;
  }

 private:
  std::uint64_t state_ = 7;
};

/// Collects entries; those at one place add up.
class MatrixBuilder {
 public:
  /// Rows are renumbered by `row_number`.
  explicit MatrixBuilder(Index n, std::function<Index(Index)> row_number = {})
      : n_(n), row_number_(std::move(row_number)) {}
  void add(Index row, Index column, double value) {
    entries_.push_back({row_number_ ? row_number_(row) : row, column, value});
  }
  [[nodiscard]] Matrix build() const {
    std::vector<std::pair<Index, Index>> places;
    for (const auto& e : entries_) places.emplace_back(e.row, e.column);
    Matrix m{core::SparsePattern(n_, std::move(places)), {}};
    m.values.assign(m.pattern.n_nonzeros(), 0.0);
    for (const auto& e : entries_) m.values[m.pattern.find(e.row, e.column)] += e.value;
    return m;
  }

 private:
  struct Entry {
    Index row, column;
    double value;
  };
  Index n_;
  std::function<Index(Index)> row_number_;
  std::vector<Entry> entries_;
};

/// About `row_entries` random entries a row of magnitudes 1e-3 to 1e3, and no dominant diagonal.
inline Matrix random_matrix(Index n, int row_entries) {
  Random random;
  MatrixBuilder m(n);
  for (Index i = 0; i < n; ++i) {
    m.add(i, (7 * i + 3) % n, 1.0 + random() * 0.5);  // keeps it structurally regular for n prime to 7
    for (int k = 1; k < row_entries; ++k) {
      m.add(i, static_cast<Index>((random() + 1.0) * 0.5 * static_cast<double>(n)),
            random() * std::pow(10.0, 3.0 * random()));
    }
  }
  return m.build();
}

/// A layer of viscous grains, `columns` x `layers`: in each column a height H, then (u, w, p) layer by layer, as in the
/// layer model. Momentum rows: rho c_j, diffusion over 3 x 3 cells with a viscosity that varies by six powers of ten,
/// grad p, weight of H; constraint rows: div u; H: fed by the fluxes of all layers of three columns. `constraint_at`:
/// the unknown whose number the constraint rows carry. p: they have no diagonal. w: they chain w up a column, and the
/// momentum rows of w, under the number of p, have grad p on the diagonal.
enum class ConstraintAt { p, w };
inline Matrix saddle_point(Index columns, Index layers, double c_j, ConstraintAt constraint_at = ConstraintAt::p) {
  constexpr double dx = 5e-3, dz = 1e-3, rho = 1500.0, g = 9.81;
  const Index width = 1 + 3 * layers;
  const auto at = [=](Index i, Index k, int what) { return i * width + 1 + 3 * k + what; };
  const auto eta = [=](Index i, Index k) {
    return std::pow(10.0, 3.0 - 5.0 * static_cast<double>(k) / static_cast<double>(layers) +
                              std::sin(0.7 * static_cast<double>(i)));
  };
  Random random;
  MatrixBuilder m(columns * width, [=](Index row) {
    const Index in_column = row % width;
    if (constraint_at == ConstraintAt::p || in_column == 0 || in_column % 3 == 1) return row;
    return in_column % 3 == 2 ? row + 1 : row - 1;
  });
  for (Index i = 0; i < columns; ++i) {
    const Index left = std::max<Index>(i - 1, 0), right = std::min(i + 1, columns - 1);
    m.add(i * width, i * width, c_j);
    for (Index j = left; j <= right; ++j) {
      for (Index k = 0; k < layers; ++k) m.add(i * width, at(j, k, 0), (j == i ? 1.0 : -0.5) * dz / dx);
    }
    for (Index k = 0; k < layers; ++k) {
      const Index u = at(i, k, 0), w = at(i, k, 1), p = at(i, k, 2);
      m.add(u, u, rho * c_j);
      m.add(w, w, rho * c_j);
      for (Index j = left; j <= right; ++j) {
        for (Index l = std::max<Index>(k - 1, 0); l <= std::min(k + 1, layers - 1); ++l) {
          if (j == i && l == k) continue;
          const double h = l == k ? dx : dz;
          const double flux = 0.5 * (eta(i, k) + eta(j, l)) / (h * h) * (j == i || l == k ? 1.0 : 0.1);
          for (const auto& [row, what] : {std::pair(u, 0), std::pair(w, 1)}) {
            m.add(row, row, flux);
            m.add(row, at(j, l, what), -flux * (1.0 + 0.1 * random()));
            m.add(row, at(j, l, 1 - what), 0.2 * flux * random());
            m.add(row, at(j, l, 2), 5.0 * random());
          }
        }
      }
      if (k == 0) m.add(w, w, 2.0 * eta(i, k) / (dz * dz));
      if (k == 0) m.add(u, u, 2.0 * eta(i, k) / (dz * dz));
      // grad p and its adjoint: u on the right face, w on the upper face of the cell.
      m.add(u, p, -1.0 / dx);
      m.add(p, u, 1.0 / dx);
      if (i + 1 < columns) m.add(u, at(i + 1, k, 2), 1.0 / dx);
      if (i > 0) m.add(p, at(i - 1, k, 0), -1.0 / dx);
      m.add(w, p, -1.0 / dz);
      m.add(p, w, 1.0 / dz);
      if (k + 1 < layers) m.add(w, at(i, k + 1, 2), 1.0 / dz);
      if (k > 0) m.add(p, at(i, k - 1, 1), -1.0 / dz);
      for (Index j = left; j <= right; ++j) {
        m.add(u, j * width, rho * g * (j == i ? 1.0 : 0.5) / dx);
        m.add(p, j * width, 0.01 * random() / dx);
      }
    }
  }
  return m.build();
}

/// max |b - A x| over max (|A| |x| + |b|), each row divided by its largest entry: computed here, not by the solver.
inline double relative_residual(const Matrix& m, const std::vector<double>& x, const std::vector<double>& b) {
  std::vector<double> r(b), size(b.size()), scale(b.size(), 0.0);
  for (std::size_t i = 0; i < b.size(); ++i) size[i] = std::abs(b[i]);
  for (Index j = 0; j < m.pattern.n(); ++j) {
    for (Index k = m.pattern.column_starts()[j]; k < m.pattern.column_starts()[j + 1]; ++k) {
      const Index i = m.pattern.rows()[k];
      r[i] -= m.values[k] * x[j];
      size[i] += std::abs(m.values[k] * x[j]);
      scale[i] = std::max(scale[i], std::abs(m.values[k]));
    }
  }
  double error = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    error = std::max(error, std::abs(r[i]) / scale[i]);
    whole = std::max(whole, size[i] / scale[i]);
  }
  return error / whole;
}

inline std::vector<double> right_side(const Matrix& m) {
  Random random;
  std::vector<double> b(m.pattern.n());
  std::generate(b.begin(), b.end(), [&] { return random(); });
  return b;
}

inline double solve_residual(linear::DirectSolver& solver, const Matrix& m) {
  solver.factor(m.values);
  const auto b = right_side(m);
  auto x = b;
  solver.solve(x);
  return relative_residual(m, x, b);
}

}  // namespace talus::test
