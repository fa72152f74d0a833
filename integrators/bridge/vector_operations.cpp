#include "bridge/vector_operations.hpp"

#include <nvector/nvector_serial.h>

#include <array>
#include <cmath>

#include "core/scalar.hpp"
#include "core/sums.hpp"

namespace talus::bridge {
namespace {

/// In one pass: predictions of order 5 have no more.
constexpr int most_terms = 6;
using Sources = std::array<const double*, most_terms>;

std::size_t length(N_Vector v) { return static_cast<std::size_t>(NV_LENGTH_S(v)); }

/// z = sum of c[t] x[t], summed from the first term on; z may be one of x.
template <int n_terms>
void combine(const realtype* c, const Sources& x, double* z, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    double sum = c[0] * x[0][i];
    for (int t = 1; t < n_terms; ++t) sum += c[t] * x[t][i];
    z[i] = sum;
  }
}

void combine_few(int n_terms, const realtype* c, const Sources& x, N_Vector z) {
  constexpr std::array kernels{combine<1>, combine<2>, combine<3>, combine<4>, combine<5>, combine<6>};
  core::in_halves(length(z),
                  [&](std::size_t begin, std::size_t end) { kernels[n_terms - 1](c, x, NV_DATA_S(z), begin, end); });
}

int linear_combination(int n_terms, realtype* c, N_Vector* X, N_Vector z) {
  if (n_terms < 1) return -1;
  Sources x{};
  std::array<realtype, most_terms> share{};
  int filled = 0;
  for (int t = 0; t < n_terms; ++t) {
    x[filled] = NV_DATA_S(X[t]);
    share[filled++] = c[t];
    if (filled < most_terms && t + 1 < n_terms) continue;
    combine_few(filled, share.data(), x, z);
    x[0] = NV_DATA_S(z);  // the rest is added to what is there
    share[0] = 1.0;
    filled = 1;
  }
  return 0;
}

void linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z) {
  std::array c{a, b};
  std::array X{x, y};
  linear_combination(2, c.data(), X.data(), z);
}

void scale(realtype c, N_Vector x, N_Vector z) { linear_combination(1, &c, &x, z); }

int scale_array(int n, realtype* c, N_Vector* X, N_Vector* Z) {
  for (int j = 0; j < n; ++j) scale(c[j], X[j], Z[j]);
  return 0;
}

int linear_sum_array(int n, realtype a, N_Vector* X, realtype b, N_Vector* Y, N_Vector* Z) {
  for (int j = 0; j < n; ++j) linear_sum(a, X[j], b, Y[j], Z[j]);
  return 0;
}

realtype weighted_norm(N_Vector v, N_Vector w) {
  const double *x = NV_DATA_S(v), *weight = NV_DATA_S(w);
  const double sum = core::sum_in_halves(length(v), [=](auto read, std::size_t i) {
    const auto share = read(x + i) * read(weight + i);
    return share * share;
  });
  return std::sqrt(sum / static_cast<double>(length(v)));
}

realtype weighted_norm_where(N_Vector v, N_Vector w, N_Vector where) {
  const double *x = NV_DATA_S(v), *weight = NV_DATA_S(w), *counts = NV_DATA_S(where);
  const double sum = core::sum_in_halves(length(v), [=](auto read, std::size_t i) {
    const auto share = read(x + i) * read(weight + i);
    return core::select_above(
        read(counts + i), 0.0, [&] { return share * share; }, [&] { return 0.0 * share; });
  });
  return std::sqrt(sum / static_cast<double>(length(v)));
}

}  // namespace

void use_own_operations(N_Vector v) {
  auto& ops = *v->ops;
  ops.nvlinearsum = linear_sum;
  ops.nvscale = scale;
  ops.nvwrmsnorm = weighted_norm;
  ops.nvwrmsnormmask = weighted_norm_where;
  ops.nvlinearcombination = linear_combination;
  ops.nvscalevectorarray = scale_array;
  ops.nvlinearsumvectorarray = linear_sum_array;
}

}  // namespace talus::bridge
