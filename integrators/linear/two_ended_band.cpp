#include "linear/two_ended_band.hpp"

#include <algorithm>

#include "core/both.hpp"
#include "linear/blas.hpp"

extern "C" {
void dgbtrf_(const int* m, const int* n, const int* kl, const int* ku, double* ab, const int* ldab, int* ipiv,
             int* info);
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* ipiv, int* info);
void dgetrs_(const char* trans, const int* n, const int* nrhs, const double* a, const int* lda, const int* ipiv,
             double* b, const int* ldb, int* info, std::size_t trans_length);
void dgbtrs_(const char* trans, const int* n, const int* kl, const int* ku, const int* nrhs, const double* ab,
             const int* ldab, const int* ipiv, double* b, const int* ldb, int* info, std::size_t trans_length);
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k, const double* alpha,
            const double* a, const int* lda, const double* b, const int* ldb, const double* beta, double* c,
            const int* ldc, std::size_t transa_length, std::size_t transb_length);
}

namespace talus::linear {

using core::both;

namespace {

/// Below this many unknowns for each diagonal the separator costs more than the second thread saves.
constexpr Index least_rows_per_diagonal = 12;

}  // namespace

TwoEndedBand::TwoEndedBand(Index n, Index width) : n_(n), width_(width) {
  const bool split = n >= least_rows_per_diagonal * width && width > 0;
  separator_ = split ? width : 0;
  left_ = split ? (n - separator_) / 2 : n;
  part_[0].n = left_;
  part_[1].n = n - left_ - separator_;
  for (auto& part : part_) {
    part.band.resize(leading() * part.n);
    part.pivots.resize(part.n);
    part.above.resize(part.n);
    part.below.resize(part.n);
    part.to.resize(window(part) * separator_);
    part.from.resize(window(part) * separator_);
  }
  middle_.resize(separator_ * separator_);
  joined_.resize(middle_.size());
  joined_pivots_.resize(separator_);
}

void TwoEndedBand::clear() {
  for (auto& part : part_)
    for (auto* v : {&part.band, &part.to, &part.from}) std::fill(v->begin(), v->end(), 0.0);
  std::fill(middle_.begin(), middle_.end(), 0.0);
}

void TwoEndedBand::add(Index i, Index j, double value) {
  const auto row = place(i), column = place(j);
  if (row.part == 2 && column.part == 2) {
    middle_[column.number * separator_ + row.number] += value;
  } else if (row.part == 2) {
    Part& part = part_[column.part];
    part.from[(column.number - (part.n - window(part))) * separator_ + row.number] += value;
  } else if (column.part == 2) {
    Part& part = part_[row.part];
    part.to[column.number * window(part) + row.number - (part.n - window(part))] += value;
  } else {
    part_[row.part].band[column.number * leading() + 2 * width_ + row.number - column.number] += value;
  }
}

void TwoEndedBand::add_column(Index j, Index first, double scale, std::span<const double> v) {
  const auto column = place(j);
  const Index last = first + static_cast<Index>(v.size());
  if (column.part == 0 && last <= left_) {
    double* target = part_[0].band.data() + column.number * leading() + 2 * width_ + first - column.number;
    for (std::size_t i = 0; i < v.size(); ++i) target[i] += scale * v[i];
  } else if (column.part == 1 && first >= left_ + separator_) {
    double* target = part_[1].band.data() + column.number * leading() + 2 * width_ + (n_ - 1 - first) - column.number;
    for (std::size_t i = 0; i < v.size(); ++i) target[-static_cast<Index>(i)] += scale * v[i];
  } else {
    for (std::size_t i = 0; i < v.size(); ++i)
      if (v[i] != 0.0) add(first + static_cast<Index>(i), j, scale * v[i]);
  }
}

void TwoEndedBand::factor_part(Part& part, std::vector<double>& schur) const {
  if (part.n == 0) return;
  const int n = static_cast<int>(part.n), k = static_cast<int>(width_), lead = static_cast<int>(leading());
  int info = 0;
  dgbtrf_(&n, &n, &k, &k, part.band.data(), &lead, part.pivots.data(), &info);
  if (info != 0) throw SingularMatrix("LAPACK dgbtrf: the matrix is singular", -1);
  measure(part);
  if (separator_ == 0) return;
  // The last `window` columns of the factors are the factors of the trailing Schur complement, all that F and G touch.
  const Index w = window(part), first = part.n - w;
  std::vector<double> x = part.to;
  const int window_n = static_cast<int>(w), m = static_cast<int>(separator_);
  std::vector<int> pivots(part.pivots.begin() + first, part.pivots.end());
  for (int& p : pivots) p -= static_cast<int>(first);
  dgbtrs_("N", &window_n, &k, &k, &m, part.band.data() + first * leading(), &lead, pivots.data(), x.data(), &window_n,
          &info, 1);
  schur.assign(separator_ * separator_, 0.0);
  const double one = 1.0, zero = 0.0;
  dgemm_("N", "N", &m, &m, &window_n, &one, part.from.data(), &m, x.data(), &window_n, &zero, schur.data(), &m, 1, 1);
}

void TwoEndedBand::measure(Part& part) const {
  for (Index j = 0; j < part.n; ++j) {
    const double* column = part.band.data() + j * leading() + 2 * width_;
    Index above = std::min(2 * width_, j), below = std::min(width_, part.n - 1 - j);
    while (above > 0 && column[-above] == 0.0) --above;
    while (below > 0 && column[below] == 0.0) --below;
    part.above[j] = static_cast<int>(above);
    part.below[j] = static_cast<int>(below);
  }
}

void TwoEndedBand::factor() {
  if (separator_ == 0) {
    std::vector<double> none;
    factor_part(part_[0], none);
    return;
  }
  std::vector<double> schur[2];
  both(
      blas_allows_threads(), [&] { factor_part(part_[0], schur[0]); }, [&] { factor_part(part_[1], schur[1]); });
  for (std::size_t i = 0; i < joined_.size(); ++i) joined_[i] = middle_[i] - schur[0][i] - schur[1][i];
  const int m = static_cast<int>(separator_);
  int info = 0;
  dgetrf_(&m, &m, joined_.data(), &m, joined_pivots_.data(), &info);
  if (info != 0) throw SingularMatrix("LAPACK dgetrf: the separator's matrix is singular", -1);
}

/// L^-1 P on rows from `first` on; b points at row `first`.
void TwoEndedBand::forward(const Part& part, Index first, double* b) const {
  for (Index j = first; j < part.n; ++j) {
    const Index pivot = part.pivots[j] - 1;
    double* at = b + (j - first);
    if (pivot != j) std::swap(*at, b[pivot - first]);
    const double value = *at;
    const double* column = part.band.data() + j * leading() + 2 * width_;
    const Index reach = part.below[j];
    for (Index i = 1; i <= reach; ++i) at[i] -= column[i] * value;
  }
}

/// U^-1 on rows from `first` on, whose solution does not depend on the rows before.
void TwoEndedBand::backward(const Part& part, Index first, double* b) const {
  for (Index j = part.n - 1; j >= first; --j) {
    const double* column = part.band.data() + j * leading() + 2 * width_;
    double* at = b + (j - first);
    const double value = *at /= *column;
    const Index reach = std::min<Index>(part.above[j], j - first);
    for (Index i = 1; i <= reach; ++i) at[-i] -= column[-i] * value;
  }
}

void TwoEndedBand::solve(std::span<double> b) const {
  if (separator_ == 0) {
    forward(part_[0], 0, b.data());
    backward(part_[0], 0, b.data());
    return;
  }
  std::vector<double> right(b.rbegin(), b.rbegin() + part_[1].n);
  double* side[2] = {b.data(), right.data()};
  double* middle = b.data() + left_;
  std::vector<double> seen[2];
  const auto descend = [&](int s) {
    const Part& part = part_[s];
    forward(part, 0, side[s]);
    const Index w = window(part), first = part.n - w;
    std::vector<double> y(side[s] + first, side[s] + part.n);
    backward(part, first, y.data());
    seen[s].assign(separator_, 0.0);
    for (Index j = 0; j < w; ++j)
      for (Index i = 0; i < separator_; ++i) seen[s][i] += part.from[j * separator_ + i] * y[j];
  };
  both(
      true, [&] { descend(0); }, [&] { descend(1); });
  for (Index i = 0; i < separator_; ++i) middle[i] -= seen[0][i] + seen[1][i];
  const int m = static_cast<int>(separator_), one = 1;
  int info = 0;
  dgetrs_("N", &m, &one, joined_.data(), &m, joined_pivots_.data(), middle, &m, &info, 1);
  const auto ascend = [&](int s) {
    const Part& part = part_[s];
    const Index w = window(part), first = part.n - w;
    std::vector<double> pulled(w, 0.0);
    for (Index j = 0; j < separator_; ++j)
      for (Index i = 0; i < w; ++i) pulled[i] += part.to[j * w + i] * middle[j];
    forward(part, first, pulled.data());
    for (Index i = 0; i < w; ++i) side[s][first + i] -= pulled[i];
    backward(part, 0, side[s]);
  };
  both(
      true, [&] { ascend(0); }, [&] { ascend(1); });
  std::copy(right.begin(), right.end(), b.rbegin());
}

std::size_t TwoEndedBand::memory() const {
  std::size_t entries = middle_.size() + joined_.size();
  for (const auto& part : part_) entries += part.band.size() + part.to.size() + part.from.size();
  return entries * sizeof(double);
}

}  // namespace talus::linear
