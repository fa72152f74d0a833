#include "linear/band_lu.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linear/dense_kernels.hpp"

namespace talus::linear {
namespace {

/// The rows of a band beyond its last entry are kept as zeros as far as this takes them.
template <class Real>
Index whole_lanes(Index m) {
  return (m + dense::lanes<Real> - 1) / dense::lanes<Real> * dense::lanes<Real>;
}

void no_smaller(int& most, Index value) { most = std::max(most, static_cast<int>(value)); }

}  // namespace

/// Each once for any processor and once for those with AVX2 and FMA.
template <class Real>
struct BandLu<Real>::Kernels {
  struct Factoring;
  [[gnu::always_inline]] static inline void factor(BandLu& lu, Real* store);
  [[gnu::always_inline]] static inline void solve_tail(const BandLu& lu, const Real* store, Index m, Real* X);
  [[gnu::always_inline]] static inline void product(Index m, Index n, Index k, const Real* A, const Real* B, Real* C) {
    dense::subtract_product(m, n, k, A, m, B, k, C, m);
  }
  static void factor_anywhere(BandLu& lu, Real* store) { factor(lu, store); }
  static void solve_anywhere(const BandLu& lu, const Real* store, Index m, Real* X) { solve_tail(lu, store, m, X); }
  static void product_anywhere(Index m, Index n, Index k, const Real* A, const Real* B, Real* C) {
    product(m, n, k, A, B, C);
  }
#ifdef TALUS_FMA
  TALUS_FMA static void factor_fma(BandLu& lu, Real* store) { factor(lu, store); }
  TALUS_FMA static void solve_fma(const BandLu& lu, const Real* store, Index m, Real* X) {
    solve_tail(lu, store, m, X);
  }
  TALUS_FMA static void product_fma(Index m, Index n, Index k, const Real* A, const Real* B, Real* C) {
    product(m, n, k, A, B, C);
  }
#endif
};

template <class Real>
BandLu<Real>::BandLu(Index n, Index width, Index window, Index tail)
    : n_(n),
      width_(width),
      window_(std::min(window, width)),
      tail_(tail),
      above_(width + window_ + panel),
      leading_(above_ + width + panel + dense::lanes<Real> + 1),
      last_row_(n),
      last_column_(n),
      L_end_(n),
      U_start_(n) {
  for (Index i = 0; i < n; ++i) last_row_[i] = last_column_[i] = static_cast<int>(i);
  for (Index first = 0; first < n;) {
    panels_.push_back(first);
    first = std::min(first + panel, first < n - tail ? n - tail : n);
  }
  panels_.push_back(n);
}

template <class Real>
void BandLu<Real>::expect(Index i, Index j) {
  no_smaller(last_row_[j], i);
  no_smaller(last_column_[i], j);
}

template <class Real>
void BandLu<Real>::factor(Real* store) {
  first_exchange_.assign(1, 0);
  exchanges_.clear();
#ifdef TALUS_FMA
  if (dense::has_fma()) Kernels::factor_fma(*this, store);
  else
#endif
    Kernels::factor_anywhere(*this, store);
  // Where columns of U begin, from where its rows, kept in U_start_ until now, end.
  const std::vector<int> U_end(U_start_);
  Index row = 0;
  for (Index j = 0; j < n_; ++j) {
    while (U_end[row] < j) ++row;
    U_start_[j] = static_cast<int>(std::min(row, j));
  }
}

/// The columns of L in the last panel end where an exchange put an entry below their end, and none ends before an earlier one.
template <class Real>
void BandLu<Real>::lengthen(Index a, Index b) {
  const std::size_t first = first_exchange_[first_exchange_.size() - 2];
  int lower = 0;
  for (std::size_t x = exchanges_.size(); x-- > first;) {
    no_smaller(lower, exchanges_[x].with);
    for (Index j = x > first ? exchanges_[x - 1].row : a; j < exchanges_[x].row; ++j) no_smaller(L_end_[j], lower);
  }
  for (Index j = std::max<Index>(a, 1); j < b; ++j) no_smaller(L_end_[j], L_end_[j - 1]);
}

template <class Real>
void BandLu<Real>::solve_tail(const Real* store, Index m, Real* X) const {
#ifdef TALUS_FMA
  if (dense::has_fma()) {
    Kernels::solve_fma(*this, store, m, X);
    return;
  }
#endif
  Kernels::solve_anywhere(*this, store, m, X);
}

template <class Real>
void BandLu<Real>::subtract_product(Index m, Index n, Index k, const Real* A, const Real* B, Real* C) {
#ifdef TALUS_FMA
  if (dense::has_fma()) {
    Kernels::product_fma(m, n, k, A, B, C);
    return;
  }
#endif
  Kernels::product_anywhere(m, n, k, A, B, C);
}

/// An elimination under way.
template <class Real>
struct BandLu<Real>::Kernels::Factoring {
  BandLu& lu;
  Real* origin;  ///< of A(0, 0); A(i, j) is i + j ld further
  Index ld;
  int lowest = 0;             ///< row that an entry was announced for in the columns so far
  int known = -1, reach = 0;  ///< rows up to `known` reach to column `reach`
  int farthest = 0;           ///< column of U so far

  [[gnu::always_inline]] Real* at(Index i, Index j) const { return origin + i + j * ld; }

  /// Column j of the panel [a, b): its pivot, its part of L, and what it takes from the columns up to e.
  [[gnu::always_inline]] void eliminate(Index j, Index a, Index e, Index b) {
    no_smaller(lowest, lu.last_row_[j]);
    Real* const column = at(0, j);
    const Index pivot = choose(j, column);
    if (pivot != j) {
      lu.exchanges_.push_back({static_cast<int>(j), static_cast<int>(pivot)});
      for (Index c = a; c < b; ++c) std::swap(*at(j, c), *at(pivot, c));
    }
    while (known < pivot) no_smaller(reach, lu.last_column_[++known]);
    no_smaller(farthest, reach);
    lu.L_end_[j] = lowest;
    lu.U_start_[j] = farthest;
    const Real inverse = Real(1) / column[j];
    for (Index i = j + 1; i <= lowest; ++i) column[i] *= inverse;
    for (Index c = j + 1; c < e; ++c) {
      const Real u = *at(j, c);
      Real* const other = at(0, c);
      for (Index i = j + 1; i <= lowest; ++i) other[i] -= column[i] * u;
    }
  }

  [[gnu::always_inline]] Index choose(Index j, const Real* column) const {
    const Index near = std::min<Index>(lowest, j + lu.window_);
    Real most_near = 0, most_far = 0;
    for (Index i = j + 1; i <= near; ++i) most_near = std::max(most_near, std::abs(column[i]));
    for (Index i = near + 1; i <= lowest; ++i) most_far = std::max(most_far, std::abs(column[i]));
    Index pivot = j;
    if (std::abs(column[j]) < Real(0.5) * most_near)
      while (std::abs(column[pivot]) < most_near) ++pivot;
    const Real value = std::abs(column[pivot]);
    if (!(value > Real(0)) || static_cast<Real>(most_growth) * value < most_far)
      throw SingularMatrix("no pivot of the band is within reach", -1);
    return pivot;
  }

  /// What the eliminated columns [s, e) take from the columns [first, last): rows of U, then what lies below.
  [[gnu::always_inline]] void update(Index s, Index e, Index first, Index last) const {
    if (last <= first) return;
    dense::solve_lower(e - s, last - first, at(s, s), ld, at(s, first), ld);
    dense::subtract_product(whole_lanes<Real>(lowest + 1 - e), last - first, e - s, at(e, s), ld, at(s, first), ld,
                            at(e, first), ld);
  }

  /// The exchanges from `start` on, in the columns from b on that they reach.
  [[gnu::always_inline]] void exchange(std::size_t start, Index b) const {
    for (Index c = b; c <= std::min<Index>(farthest, lu.n_ - 1); ++c)
      for (std::size_t x = start; x < lu.exchanges_.size(); ++x)
        std::swap(*at(lu.exchanges_[x].row, c), *at(lu.exchanges_[x].with, c));
  }
};

template <class Real>
void BandLu<Real>::Kernels::factor(BandLu& lu, Real* store) {
  Factoring f{lu, store + lu.above_, lu.stride()};
  for (std::size_t number = 0; number + 1 < lu.panels_.size(); ++number) {
    const Index a = lu.panels_[number], b = lu.panels_[number + 1];
    for (Index s = a; s < b; s += dense::lanes<Real>) {
      const Index e = std::min<Index>(s + dense::lanes<Real>, b);
      for (Index j = s; j < e; ++j) f.eliminate(j, a, e, b);
      f.update(s, e, e, b);
    }
    f.exchange(lu.first_exchange_.back(), b);
    lu.first_exchange_.push_back(lu.exchanges_.size());
    f.update(a, b, b, std::min<Index>(f.farthest, lu.n_ - 1) + 1);
    lu.lengthen(a, b);
  }
}

template <class Real>
void BandLu<Real>::Kernels::solve_tail(const BandLu& lu, const Real* store, Index m, Real* X) {
  const Index tail = lu.tail_, first = lu.n_ - tail, ld = lu.stride();
  const auto at = [&](Index i, Index j) { return store + lu.above_ + i + j * ld; };
  const auto& panels = lu.panels_;
  const auto start = static_cast<std::size_t>(std::lower_bound(panels.begin(), panels.end(), first) - panels.begin());
  for (std::size_t number = start; number + 1 < panels.size(); ++number) {
    const Index a = panels[number], b = panels[number + 1];
    Real* const x = X + (a - first);
    for (Index c = 0; c < m; ++c)
      for (const auto& exchange : lu.exchanges(number))
        std::swap(x[exchange.row - a + c * tail], x[exchange.with - a + c * tail]);
    dense::solve_lower(b - a, m, at(a, a), ld, x, tail);
    dense::subtract_product(lu.L_end_[b - 1] + 1 - b, m, b - a, at(b, a), ld, x, tail, x + (b - a), tail);
  }
  for (std::size_t number = panels.size() - 1; number-- > start;) {
    const Index a = panels[number], b = panels[number + 1];
    Real* const x = X + (a - first);
    dense::solve_upper(b - a, m, at(a, a), ld, x, tail);
    const Index top = std::max<Index>(lu.U_start_[a], first);
    dense::subtract_product(a - top, m, b - a, at(top, a), ld, x, tail, X + (top - first), tail);
  }
}

template class BandLu<float>;
template class BandLu<double>;

}  // namespace talus::linear
