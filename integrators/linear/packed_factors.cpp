#include "linear/packed_factors.hpp"

#include <algorithm>
#include <utility>

#include "linear/dense_kernels.hpp"

namespace talus::linear {
namespace {

template <class Real>
[[gnu::always_inline]] inline void subtract(Index n, const Real* __restrict column, Real value, Real* __restrict b) {
  for (Index i = 0; i < n; ++i) b[i] -= column[i] * value;
}

template <class Real>
[[gnu::always_inline]] inline void subtract_four(Index n, const Real* __restrict columns, const Real* value,
                                                 Real* __restrict b) {
  const Real v0 = value[0], v1 = value[1], v2 = value[2], v3 = value[3];
  const Real *c0 = columns, *c1 = c0 + n, *c2 = c1 + n, *c3 = c2 + n;
  for (Index i = 0; i < n; ++i) b[i] = (((b[i] - c0[i] * v0) - c1[i] * v1) - c2[i] * v2) - c3[i] * v3;
}

}  // namespace

template <class Real>
struct PackedFactors<Real>::Kernels {
  [[gnu::always_inline]] static inline void forward(const PackedFactors& factors, Index first, Real* b);
  [[gnu::always_inline]] static inline void backward(const PackedFactors& factors, Index first, Real* b);
#ifdef TALUS_FMA
  TALUS_FMA static void forward_fma(const PackedFactors& factors, Index first, Real* b) { forward(factors, first, b); }
  TALUS_FMA static void backward_fma(const PackedFactors& factors, Index first, Real* b) {
    backward(factors, first, b);
  }
#endif
};

template <class Real>
void PackedFactors<Real>::forward(Index first, Real* b) const {
#ifdef TALUS_FMA
  if (dense::has_fma()) {
    Kernels::forward_fma(*this, first, b);
    return;
  }
#endif
  Kernels::forward(*this, first, b);
}

template <class Real>
void PackedFactors<Real>::backward(Index first, Real* b) const {
#ifdef TALUS_FMA
  if (dense::has_fma()) {
    Kernels::backward_fma(*this, first, b);
    return;
  }
#endif
  Kernels::backward(*this, first, b);
}

template <class Real>
void PackedFactors<Real>::pack(const BandLu<Real>& lu, const Real* store, Index tail) {
  groups_.clear();
  exchanges_.clear();
  std::int64_t size = 0;
  for (std::size_t panel = 0; panel + 1 < lu.panels().size(); ++panel) {
    const Index begin = lu.panels()[panel], end = lu.panels()[panel + 1];
    const auto exchanges = lu.exchanges(panel);
    exchanges_.insert(exchanges_.end(), exchanges.begin(), exchanges.end());
    if (begin == lu.n() - tail) tail_group_ = groups_.size();
    for (Index first = begin; first < end; first += width) {
      const Index count = std::min(width, end - first);
      const auto below = static_cast<int>(lu.last_row_of_L(first + count - 1) - (first + count - 1));
      const auto above = static_cast<int>(first - lu.first_row_of_U(first));
      groups_.push_back({first, static_cast<int>(count), below, above, size, 0, exchanges_.size()});
      size += count * (count + below);
    }
  }
  for (Group& group : groups_) group.upper = std::exchange(size, size + group.count * (group.count + group.above));
  values_.resize(static_cast<std::size_t>(size));
  for (const Group& group : groups_) {
    Real* l = &values_[group.lower];
    Real* u = &values_[group.upper];
    const auto square = [&](Index j) { return store + lu.slot(group.first, group.first + j); };
    for (int j = 0; j < group.count; ++j) {
      l = std::copy_n(square(j), group.count, l);
      u = std::copy_n(square(j), group.count, u);
    }
    for (int j = 0; j < group.count; ++j) {
      l = std::copy_n(square(j) + group.count, group.below, l);
      u = std::copy_n(square(j) - group.above, group.above, u);
    }
  }
}

template <class Real>
void PackedFactors<Real>::Kernels::forward(const PackedFactors& factors, Index first, Real* b) {
  const auto& groups = factors.groups_;
  const auto& values = factors.values_;
  const std::size_t start = factors.group_from(first);
  const auto& exchanges = factors.exchanges_;
  std::size_t next = start == 0 ? 0 : groups[start - 1].exchanges;
  for (std::size_t number = start; number < groups.size(); ++number) {
    const Group& group = groups[number];
    for (; next < group.exchanges; ++next) std::swap(b[exchanges[next].row - first], b[exchanges[next].with - first]);
    const Real* square = &values[group.lower];
    const Real* columns = square + group.count * group.count;
    Real* at = b + (group.first - first);
    for (int j = 0; j < group.count; ++j)
      for (int i = j + 1; i < group.count; ++i) at[i] -= square[j * group.count + i] * at[j];
    if (group.count == width) {
      subtract_four<Real>(group.below, columns, at, at + width);
    } else {
      for (int j = 0; j < group.count; ++j)
        subtract<Real>(group.below, columns + Index{j} * group.below, at[j], at + group.count);
    }
  }
}

template <class Real>
void PackedFactors<Real>::Kernels::backward(const PackedFactors& factors, Index first, Real* b) {
  const auto& groups = factors.groups_;
  const auto& values = factors.values_;
  const std::size_t start = factors.group_from(first);
  for (std::size_t number = groups.size(); number-- > start;) {
    const Group& group = groups[number];
    const Real* square = &values[group.upper];
    Real* at = b + (group.first - first);
    for (int j = group.count; j-- > 0;) {
      at[j] /= square[j * group.count + j];
      for (int i = 0; i < j; ++i) at[i] -= square[j * group.count + i] * at[j];
    }
    const Index hidden = std::max<Index>(0, group.above - (group.first - first));  // rows before `first`
    const Index rows = group.above - hidden;
    const Real* columns = square + group.count * group.count + hidden;
    if (group.count == width && hidden == 0) {
      subtract_four<Real>(rows, columns, at, at - rows);
    } else {
      for (int j = 0; j < group.count; ++j) subtract<Real>(rows, columns + Index{j} * group.above, at[j], at - rows);
    }
  }
}

template class PackedFactors<float>;
template class PackedFactors<double>;

}  // namespace talus::linear
