#include "ida/secants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sums.hpp"

namespace talus::ida {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void Secants::add(double lambda, std::span<const double> step, std::span<const double> before,
                  std::span<const double> after) {
  if (depth_ == 0) return;
  if (pairs_.size() < depth_) pairs_.emplace_back();
  std::rotate(pairs_.begin(), pairs_.end() - 1, pairs_.end());
  auto& pair = pairs_.front();
  pair.step.resize(step.size());
  pair.change.resize(step.size());
  core::in_halves(step.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      pair.step[i] = lambda * step[i];
      pair.change[i] = (after[i] - before[i]) / scale_;
    }
  });
  pair.products.assign(depth_, unknown);
}

void Secants::reweigh() {
  for (auto& pair : pairs_) pair.products.assign(depth_, unknown);
}

double Secants::product_of(const Product& product, std::size_t newer, std::size_t older) {
  double& value = pairs_[newer].products[older - newer];
  if (std::isnan(value)) value = product(pairs_[newer].change, pairs_[older].change);
  return value;
}

/// Cholesky's factorisation L L^T of the Gram matrix of the changes, row by row, dependent and small rows left out.
std::vector<double> Secants::nearest(const Product& product, std::span<const double> dx) {
  const std::size_t m = pairs_.size();
  const double enough = m > 0 ? least_size * product(dx, dx) / (scale_ * scale_) : 0.0;
  std::vector<double> L(m * m, 0.0), gamma(m, 0.0);
  std::vector<std::size_t> used;
  const auto less_newer = [&](double v, std::size_t i, std::size_t j) {
    for (const std::size_t k : used)
      if (k < j) v -= L[i * m + k] * L[j * m + k];
    return v;
  };
  for (std::size_t i = 0; i < m; ++i) {
    const double whole = product_of(product, i, i);
    if (whole < enough) continue;
    for (const std::size_t j : used) L[i * m + j] = less_newer(product_of(product, j, i), i, j) / L[j * m + j];
    const double rest = less_newer(whole, i, i);
    if (!(rest > least_new * whole)) continue;
    L[i * m + i] = std::sqrt(rest);
    double v = product(pairs_[i].change, dx) / scale_;
    for (const std::size_t k : used) v -= L[i * m + k] * gamma[k];
    gamma[i] = v / L[i * m + i];
    used.push_back(i);
  }
  for (auto i = used.rbegin(); i != used.rend(); ++i) {
    for (auto k = used.rbegin(); k != i; ++k) gamma[*i] -= L[*k * m + *i] * gamma[*k];
    gamma[*i] /= L[*i * m + *i];
  }
  return gamma;
}

void Secants::accelerate(const Product& product, std::span<const double> dx, std::span<double> step) {
  const auto gamma = nearest(product, dx);
  constexpr std::size_t block = 1024;  // stays in the nearest cache while one secant after the other is taken from it
  core::in_halves(dx.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t from = begin; from < end; from += block) {
      const std::size_t to = std::min(from + block, end);
      std::copy(dx.begin() + from, dx.begin() + to, step.begin() + from);
      for (std::size_t k = 0; k < pairs_.size(); ++k) {
        if (gamma[k] == 0.0) continue;
        const double *taken = pairs_[k].step.data(), *change = pairs_[k].change.data();
        for (std::size_t i = from; i < to; ++i) step[i] -= gamma[k] * (taken[i] + change[i]);
      }
    }
  });
}

}  // namespace talus::ida
