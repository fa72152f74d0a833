#include "linear/two_ended_band.hpp"

#include <algorithm>

#include "core/both.hpp"
#include "linear/lapack.hpp"

namespace talus::linear {

using core::both;

namespace {

/// Below this many unknowns for each diagonal the separator costs more than the second thread saves.
constexpr Index least_rows_per_diagonal = 12;

}  // namespace

template <class Real>
TwoEndedBand<Real>::TwoEndedBand(Index n, Index width, Index window) : n_(n), width_(width) {
  const bool split = n >= least_rows_per_diagonal * width && width > 0;
  separator_ = split ? width : 0;
  left_ = split ? (n - separator_) / 2 : n;
  part_[0].n = left_;
  part_[1].n = n - left_ - separator_;
  const auto reserve = [&](Index entries) { return std::exchange(size_, size_ + entries); };
  for (auto& part : part_) {
    part.tail = std::min(part.n, width + std::min(window, width) + BandLu<Real>::panel);
    part.lu = BandLu<Real>(part.n, width, window, part.tail);
    part.band = reserve(part.lu.storage());
    part.to = reserve(part.tail * separator_);
    part.from = reserve(part.tail * separator_);
  }
  middle_ = reserve(separator_ * separator_);
  joined_.resize(separator_ * separator_);
  joined_pivots_.resize(separator_);
}

template <class Real>
void TwoEndedBand<Real>::clear() {
  store_.resize(size_);
  const auto half = store_.begin() + size_ / 2;
  both(
      separator_ > 0, [&] { std::fill(store_.begin(), half, Real(0)); },
      [&] { std::fill(half, store_.end(), Real(0)); });
}

template <class Real>
void TwoEndedBand<Real>::expect(Index i, Index j) {
  const auto row = place(i), column = place(j);
  if (row.part == 2 || row.part != column.part) return;
  part_[row.part].lu.expect(row.number, column.number);
}

template <class Real>
Index TwoEndedBand<Real>::slot(Index i, Index j) const {
  const auto row = place(i), column = place(j);
  if (row.part == 2 && column.part == 2) return middle_ + column.number * separator_ + row.number;
  const Part& part = part_[row.part == 2 ? column.part : row.part];
  const Index first = part.n - part.tail;
  if (row.part == 2) return part.from + (column.number - first) * separator_ + row.number;
  if (column.part == 2) return part.to + column.number * part.tail + row.number - first;
  return part.band + part.lu.slot(row.number, column.number);
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
  part.lu.factor(&store_[part.band]);
  part.factors.pack(part.lu, &store_[part.band], part.tail);
  if (separator_ == 0) return;
  // The last columns of the factors are the factors of the trailing Schur complement, all that F and G touch.
  std::vector<Real> x(store_.begin() + part.to, store_.begin() + part.to + part.tail * separator_);
  part.lu.solve_tail(&store_[part.band], separator_, x.data());
  schur.assign(separator_ * separator_, Real(0));
  BandLu<Real>::subtract_product(separator_, separator_, part.tail, &store_[part.from], x.data(), schur.data());
}

template <class Real>
void TwoEndedBand<Real>::factor() {
  std::vector<Real> schur[2];
  if (separator_ == 0) {
    factor_part(part_[0], schur[0]);
    return;
  }
  both(
      true, [&] { factor_part(part_[0], schur[0]); }, [&] { factor_part(part_[1], schur[1]); });
  for (std::size_t i = 0; i < joined_.size(); ++i) joined_[i] = store_[middle_ + i] + schur[0][i] + schur[1][i];
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
    const Index w = part.tail, first = part.n - w;
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
    const Index w = part.tail, first = part.n - w;
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
