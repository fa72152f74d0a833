#include "linear/packed_factors.hpp"

#include <algorithm>
#include <utility>

namespace talus::linear {
namespace {

template <class Real>
void subtract(Index n, const Real* __restrict column, Real value, Real* __restrict b) {
  for (Index i = 0; i < n; ++i) b[i] -= column[i] * value;
}

template <class Real>
void subtract_four(Index n, const Real* __restrict columns, const Real* value, Real* __restrict b) {
  const Real v0 = value[0], v1 = value[1], v2 = value[2], v3 = value[3];
  const Real *c0 = columns, *c1 = c0 + n, *c2 = c1 + n, *c3 = c2 + n;
  for (Index i = 0; i < n; ++i) b[i] = (((b[i] - c0[i] * v0) - c1[i] * v1) - c2[i] * v2) - c3[i] * v3;
}

}  // namespace

template <class Real>
void PackedFactors<Real>::pack(const Band& band, Index window) {
  groups_.clear();
  pivots_.assign(band.pivots, band.pivots + band.n);
  const Index window_first = band.n - window;
  std::int64_t lower = 0;
  for (Index first = 0; first < band.n;) {
    if (first == window_first) window_group_ = groups_.size();
    const Index end = std::min(first + width, first < window_first ? window_first : band.n);
    Group group{first, static_cast<int>(end - first), false, 0, 0, lower, 0};
    for (Index j = first; j < end; ++j) group.exchanges = group.exchanges || pivots_[j] != j + 1;
    group.below = static_cast<int>(std::max<Index>(0, end - 1 + band.L_reach[end - 1] - (end - 1)));
    group.above = static_cast<int>(band.U_reach[first]);
    lower += group.count * (group.count + group.below);
    groups_.push_back(group);
    first = end;
  }
  std::int64_t upper = lower;
  for (Group& group : groups_) {
    group.upper = upper;
    upper += group.count * (group.count + group.above);
  }
  values_.resize(static_cast<std::size_t>(upper));
  for (const Group& group : groups_) {
    Real* l = &values_[group.lower];
    Real* u = &values_[group.upper];
    const Index end = group.first + group.count;
    const auto entry = [&](Index i, Index j) {
      const bool kept = i >= j ? i - j <= band.below : j - i <= band.above;
      return kept ? band.diagonal[j * band.leading + i - j] : Real(0);
    };
    for (Index j = group.first; j < end; ++j)
      for (Index i = group.first; i < end; ++i) {
        *l++ = i > j ? entry(i, j) : Real(0);
        *u++ = i <= j ? entry(i, j) : Real(0);
      }
    for (Index j = group.first; j < end; ++j) {
      for (Index i = end; i < end + group.below; ++i) *l++ = entry(i, j);
      for (Index i = group.first - group.above; i < group.first; ++i) *u++ = entry(i, j);
    }
  }
}

template <class Real>
void PackedFactors<Real>::forward(Index first, Real* b) const {
  for (auto group = groups_.begin() + static_cast<std::ptrdiff_t>(group_from(first)); group != groups_.end(); ++group) {
    const Real* triangle = &values_[group->lower];
    const Real* columns = triangle + group->count * group->count;
    Real* at = b + (group->first - first);
    Real* rest = at + group->count;
    for (int j = 0; j < group->count; ++j) {
      if (const Index pivot = pivots_[group->first + j] - 1 - first; group->exchanges) std::swap(at[j], b[pivot]);
      for (int i = j + 1; i < group->count; ++i) at[i] -= triangle[j * group->count + i] * at[j];
      if (group->exchanges || group->count < width)
        subtract<Real>(group->below, columns + Index{j} * group->below, at[j], rest);
    }
    if (!group->exchanges && group->count == width) subtract_four<Real>(group->below, columns, at, rest);
  }
}

template <class Real>
void PackedFactors<Real>::backward(Index first, Real* b) const {
  const auto last = groups_.begin() + static_cast<std::ptrdiff_t>(group_from(first));
  for (auto group = groups_.end(); group != last;) {
    --group;
    const Real* triangle = &values_[group->upper];
    Real* at = b + (group->first - first);
    for (int j = group->count; j-- > 0;) {
      at[j] /= triangle[j * group->count + j];
      for (int i = 0; i < j; ++i) at[i] -= triangle[j * group->count + i] * at[j];
    }
    const Index hidden = std::max<Index>(0, group->above - (group->first - first));  // rows before `first`
    const Index rows = group->above - hidden;
    const Real* columns = triangle + group->count * group->count + hidden;
    if (group->count == width && hidden == 0) {
      subtract_four<Real>(rows, columns, at, at - rows);
    } else {
      for (int j = 0; j < group->count; ++j)
        subtract<Real>(rows, columns + Index{j} * group->above, at[j], at - rows);
    }
  }
}

template class PackedFactors<float>;
template class PackedFactors<double>;

}  // namespace talus::linear
