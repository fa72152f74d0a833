#include "linear/two_ended_band.hpp"

#include <algorithm>

#include "core/both.hpp"
#include "linear/blas.hpp"
#include "linear/lapack.hpp"

namespace talus::linear {

using core::both;

namespace {

/// Below this many unknowns for each diagonal the separator costs more than the second thread saves.
constexpr Index least_rows_per_diagonal = 12;

void no_smaller(int& most, Index value) { most = std::max(most, static_cast<int>(value)); }

}  // namespace

template <class Real>
TwoEndedBand<Real>::TwoEndedBand(Index n, Index width) : n_(n), width_(width) {
  const bool split = n >= least_rows_per_diagonal * width && width > 0;
  separator_ = split ? width : 0;
  left_ = split ? (n - separator_) / 2 : n;
  part_[0].n = left_;
  part_[1].n = n - left_ - separator_;
  const auto reserve = [&](Index entries) { return std::exchange(size_, size_ + entries); };
  for (auto& part : part_) {
    part.band = reserve(leading() * part.n);
    part.to = reserve(window(part) * separator_);
    part.from = reserve(window(part) * separator_);
    for (auto* v : {&part.pivots, &part.last_row, &part.last_column, &part.below, &part.above}) v->resize(part.n);
    for (Index i = 0; i < part.n; ++i) part.last_row[i] = part.last_column[i] = static_cast<int>(i);
  }
  middle_ = reserve(separator_ * separator_);
  joined_.resize(separator_ * separator_);
  joined_pivots_.resize(separator_);
}

template <class Real>
void TwoEndedBand<Real>::clear() {
  store_.resize(size_);
  std::fill(store_.begin(), store_.end(), Real(0));
}

template <class Real>
void TwoEndedBand<Real>::expect(Index i, Index j) {
  const auto row = place(i), column = place(j);
  if (row.part == 2 || row.part != column.part) return;
  no_smaller(part_[row.part].last_row[column.number], row.number);
  no_smaller(part_[row.part].last_column[row.number], column.number);
}

template <class Real>
Index TwoEndedBand<Real>::slot(Index i, Index j) const {
  const auto row = place(i), column = place(j);
  if (row.part == 2 && column.part == 2) return middle_ + column.number * separator_ + row.number;
  const Part& part = part_[row.part == 2 ? column.part : row.part];
  const Index first = part.n - window(part);
  if (row.part == 2) return part.from + (column.number - first) * separator_ + row.number;
  if (column.part == 2) return part.to + column.number * window(part) + row.number - first;
  return part.band + column.number * leading() + 2 * width_ + row.number - column.number;
}

template <class Real>
void TwoEndedBand<Real>::add_column(Index j, Index first, Real scale, std::span<const Real> v) {
  const auto column = place(j);
  const Index last = first + static_cast<Index>(v.size());
  if (column.part == 0 && last <= left_) {
    Real* target = store_.data() + slot(first, j);
    for (std::size_t i = 0; i < v.size(); ++i) target[i] += scale * v[i];
  } else if (column.part == 1 && first >= left_ + separator_) {
    Real* target = store_.data() + slot(last - 1, j);
    for (std::size_t i = 0; i < v.size(); ++i) target[i] += scale * v[v.size() - 1 - i];
  } else {
    for (std::size_t i = 0; i < v.size(); ++i)
      if (v[i] != Real(0)) add(slot(first + static_cast<Index>(i), j), scale * v[i]);
  }
}

template <class Real>
void TwoEndedBand<Real>::factor_part(Part& part, std::vector<Real>& schur) {
  if (part.n == 0) return;
  const int k = static_cast<int>(width_), lead = static_cast<int>(leading());
  if (lapack::factor_band(static_cast<int>(part.n), k, k, &store_[part.band], lead, part.pivots.data()) != 0)
    throw SingularMatrix("LAPACK gbtrf: the matrix is singular", -1);
  measure(part);
  if (separator_ == 0) return;
  // The last `window` columns of the factors are the factors of the trailing Schur complement, all that F and G touch.
  const Index w = window(part), first = part.n - w;
  const int window_n = static_cast<int>(w), m = static_cast<int>(separator_);
  std::vector<Real> x(store_.begin() + part.to, store_.begin() + part.to + w * separator_);
  std::vector<int> pivots(part.pivots.begin() + first, part.pivots.end());
  for (int& p : pivots) p -= static_cast<int>(first);
  lapack::solve_band(window_n, k, k, m, &store_[part.band + first * leading()], lead, pivots.data(), x.data());
  schur.resize(separator_ * separator_);
  lapack::multiply(m, m, window_n, &store_[part.from], x.data(), schur.data());
}

/// Row exchanges stay above the lowest entry announced so far; a row of U reaches as far as any row that was or could have
/// been put in its place.
template <class Real>
void TwoEndedBand<Real>::measure(Part& part) const {
  int lowest = 0, known = -1, reach = 0, farthest = 0;
  Index row_of_U = 0;
  std::vector<int> U_reaches(part.n);
  for (Index j = 0; j < part.n; ++j) {
    no_smaller(lowest, part.last_row[j]);
    part.below[j] = lowest - static_cast<int>(j);
    for (const int pivot = part.pivots[j] - 1; known < pivot;) no_smaller(reach, part.last_column[++known]);
    no_smaller(farthest, reach);
    U_reaches[j] = farthest;
  }
  for (Index j = 0; j < part.n; ++j) {
    while (U_reaches[row_of_U] < j) ++row_of_U;
    part.above[j] = static_cast<int>(j - std::min(row_of_U, j));
  }
}

template <class Real>
void TwoEndedBand<Real>::pack(Part& part) const {
  part.factors.pack({part.n, store_.data() + part.band + 2 * width_, leading(), width_, 2 * width_, part.pivots.data(),
                     part.below.data(), part.above.data()},
                    window(part));
}

template <class Real>
void TwoEndedBand<Real>::factor() {
  std::vector<Real> schur[2];
  if (separator_ == 0) {
    factor_part(part_[0], schur[0]);
    pack(part_[0]);
    return;
  }
  both(
      blas_allows_threads(), [&] { factor_part(part_[0], schur[0]); }, [&] { factor_part(part_[1], schur[1]); });
  both(
      true, [&] { pack(part_[0]); }, [&] { pack(part_[1]); });
  for (std::size_t i = 0; i < joined_.size(); ++i) joined_[i] = store_[middle_ + i] - schur[0][i] - schur[1][i];
  if (lapack::factor_dense(static_cast<int>(separator_), joined_.data(), joined_pivots_.data()) != 0)
    throw SingularMatrix("LAPACK getrf: the separator's matrix is singular", -1);
}

template <class Real>
void TwoEndedBand<Real>::solve(std::span<Real> b) const {
  if (separator_ == 0) {
    part_[0].factors.forward(0, b.data());
    part_[0].factors.backward(0, b.data());
    return;
  }
  std::vector<Real> right(b.rbegin(), b.rbegin() + part_[1].n);
  Real* side[2] = {b.data(), right.data()};
  Real* middle = b.data() + left_;
  std::vector<Real> seen[2];
  const auto descend = [&](int s) {
    const Part& part = part_[s];
    part.factors.forward(0, side[s]);
    const Index w = window(part), first = part.n - w;
    std::vector<Real> y(side[s] + first, side[s] + part.n);
    part.factors.backward(first, y.data());
    seen[s].assign(separator_, Real(0));
    for (Index j = 0; j < w; ++j) {
      const Real* from = store_.data() + part.from + j * separator_;
      for (Index i = 0; i < separator_; ++i) seen[s][i] += from[i] * y[j];
    }
  };
  both(
      true, [&] { descend(0); }, [&] { descend(1); });
  for (Index i = 0; i < separator_; ++i) middle[i] -= seen[0][i] + seen[1][i];
  lapack::solve_dense(static_cast<int>(separator_), joined_.data(), joined_pivots_.data(), middle);
  const auto ascend = [&](int s) {
    const Part& part = part_[s];
    const Index w = window(part), first = part.n - w;
    std::vector<Real> pulled(w, Real(0));
    for (Index j = 0; j < separator_; ++j) {
      const Real* to = store_.data() + part.to + j * w;
      for (Index i = 0; i < w; ++i) pulled[i] += to[i] * middle[j];
    }
    part.factors.forward(first, pulled.data());
    for (Index i = 0; i < w; ++i) side[s][first + i] -= pulled[i];
    part.factors.backward(0, side[s]);
  };
  both(
      true, [&] { ascend(0); }, [&] { ascend(1); });
  std::copy(right.begin(), right.end(), b.rbegin());
}

template <class Real>
std::size_t TwoEndedBand<Real>::memory() const {
  return (static_cast<std::size_t>(size_) + joined_.size()) * sizeof(Real);
}

template class TwoEndedBand<float>;
template class TwoEndedBand<double>;

}  // namespace talus::linear
