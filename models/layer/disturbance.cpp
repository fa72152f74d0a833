#include "layer/disturbance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::layer {
namespace {

constexpr double pi = std::numbers::pi;

/// The finaliser of splitmix64: neighbouring numbers in, unrelated bits out.
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31U);
}

/// Of wave m and profile n, [0, 2 pi).
double phase(std::uint64_t seed, int m, int n) {
  constexpr std::uint64_t step = 0x9e3779b97f4a7c15U;
  const std::uint64_t of_wave = mixed(mixed(seed + step) + step * static_cast<std::uint64_t>(m));
  return 2.0 * pi * static_cast<double>(mixed(of_wave + step * static_cast<std::uint64_t>(n)) >> 11U) * 0x1p-53;
}

}  // namespace

std::vector<double> sampled(const Disturbance& disturbance, std::span<const double> x, std::span<const double> z) {
  std::vector<double> u(x.size() * z.size(), 0.0), along(z.size()), across(z.size());
  for (int m = disturbance.first_wave; m <= disturbance.last_wave; ++m) {
    std::ranges::fill(along, 0.0);
    std::ranges::fill(across, 0.0);
    for (int n = 1; n <= disturbance.profiles; ++n) {
      const double shift = phase(disturbance.seed, m, n);
      for (std::size_t k = 0; k < z.size(); ++k) {
        const double profile = disturbance.speed * std::sin((n - 0.5) * pi * z[k]);
        along[k] += profile * std::cos(shift);
        across[k] -= profile * std::sin(shift);
      }
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double cosine = std::cos(2.0 * pi * m * x[i]), sine = std::sin(2.0 * pi * m * x[i]);
      for (std::size_t k = 0; k < z.size(); ++k) u[k * x.size() + i] += along[k] * cosine + across[k] * sine;
    }
  }
  return u;
}

WaveParts wave_parts(const Disturbance& disturbance, std::span<const double> u, int n_columns) {
  const std::size_t n = n_columns, layers = u.size() / n;
  std::vector<double> cosine(n), sine(n);
  double all = 0.0, disturbed = 0.0;
  for (std::size_t k = 0; k < layers; ++k) {
    const auto row = u.subspan(k * n, n);
    double mean = 0.0;
    for (const double each : row) mean += each / n_columns;
    for (const double each : row) all += (each - mean) * (each - mean);
  }
  for (int m = disturbance.first_wave; m <= std::min(disturbance.last_wave, n_columns / 2); ++m) {
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2.0 * pi * m * static_cast<double>(i) / n_columns;
      cosine[i] = std::cos(angle);
      sine[i] = std::sin(angle);
    }
    const double weight = (2 * m == n_columns ? 1.0 : 2.0) / n_columns;
    for (std::size_t k = 0; k < layers; ++k) {
      double c = 0.0, s = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        c += u[k * n + i] * cosine[i];
        s += u[k * n + i] * sine[i];
      }
      disturbed += weight * (c * c + s * s);
    }
  }
  const auto size = static_cast<double>(u.size());
  return {std::sqrt(disturbed / size), std::sqrt(std::max(all - disturbed, 0.0) / size)};
}

}  // namespace talus::layer
