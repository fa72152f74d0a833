#include "layer/disturbance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "layer/layer.hpp"
#include "support/layer_cases.hpp"

namespace {

using namespace talus;
using layer::Disturbance;

/// Faces of n columns over the length, and middles of n layers over the thickness.
std::vector<double> places(int n, double shift) {
  std::vector<double> out;
  for (int i = 0; i < n; ++i) out.push_back((i + shift) / n);
  return out;
}

double rms(const std::vector<double>& u) {
  double squares = 0.0;
  for (const double each : u) squares += each * each;
  return std::sqrt(squares / static_cast<double>(u.size()));
}

TEST(Disturbance, IsOneFunctionOnEveryGrid) {
  const Disturbance noise{1e-3, 1, 3, 4, 7};
  const auto z = places(6, 0.5);
  const auto coarse = layer::sampled(noise, places(8, 0.0), z), fine = layer::sampled(noise, places(16, 0.0), z);
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(coarse[k * 8 + i], fine[k * 16 + 2 * i], 1e-15);
  EXPECT_GT(rms(coarse), 1e-3);
  EXPECT_NEAR(layer::sampled(noise, places(8, 0.0), std::vector{0.0})[3], 0.0, 1e-15) << "zero on the base";
}

TEST(Disturbance, MoreWavesAndProfilesAddToThoseThatWereThere) {
  const auto x = places(32, 0.0), z = places(16, 0.5);
  const auto few = layer::sampled({1e-3, 1, 2, 3, 7}, x, z), more = layer::sampled({1e-3, 1, 5, 8, 7}, x, z);
  // Against each wave and profile that both have: their projections are equal.
  for (int m = 1; m <= 2; ++m) {
    for (int n = 1; n <= 3; ++n) {
      double in_few = 0.0, in_more = 0.0;
      for (std::size_t k = 0; k < z.size(); ++k)
        for (std::size_t i = 0; i < x.size(); ++i) {
          const double shape =
              std::cos(2.0 * std::numbers::pi * m * x[i]) * std::sin((n - 0.5) * std::numbers::pi * z[k]);
          in_few += shape * few[k * x.size() + i];
          in_more += shape * more[k * x.size() + i];
        }
      EXPECT_NEAR(in_few, in_more, 1e-12) << m << ", " << n;
      EXPECT_GT(std::abs(in_few), 1e-6);
    }
  }
  EXPECT_NE(layer::sampled({1e-3, 1, 2, 3, 8}, x, z), few) << "another seed";
}

/// At the middle of the layer, where each wave has the one profile: its cosine and sine parts give the phase.
TEST(Disturbance, PhasesDiffer) {
  constexpr int columns = 32, waves = 8;
  const auto x = places(columns, 0.0);
  const auto u = layer::sampled({1.0, 1, waves, 1, 7}, x, std::vector{1.0});
  std::vector<double> phases;
  for (int m = 1; m <= waves; ++m) {
    double cosine = 0.0, sine = 0.0;
    for (int i = 0; i < columns; ++i) {
      cosine += u[i] * std::cos(2.0 * std::numbers::pi * m * x[i]);
      sine += u[i] * std::sin(2.0 * std::numbers::pi * m * x[i]);
    }
    EXPECT_NEAR(std::hypot(cosine, sine), 0.5 * columns, 1e-10) << "all of one amplitude";
    for (const double other : phases) EXPECT_GT(std::abs(std::atan2(sine, cosine) - other), 1e-3);
    phases.push_back(std::atan2(sine, cosine));
  }
}

TEST(Disturbance, PartsOfASpeedAreItsWaves) {
  constexpr int columns = 12, layers = 8;
  const auto x = places(columns, 0.0), z = places(layers, 0.5);
  const auto wave = layer::sampled({2e-3, 2, 2, 1, 1}, x, z), other = layer::sampled({1e-4, 4, 4, 1, 1}, x, z);
  EXPECT_NEAR(rms(wave), 1e-3, 1e-15) << "half the amplitude";
  std::vector<double> u;
  for (std::size_t i = 0; i < wave.size(); ++i) u.push_back(wave[i] + other[i] + 0.3 + 0.1 * double(i / columns));
  const auto parts = layer::wave_parts({1.0, 2, 2, 1, 1}, u, columns);
  EXPECT_NEAR(parts.disturbed, 1e-3, 1e-14);
  EXPECT_NEAR(parts.others, 0.5e-4, 1e-13);
  std::vector<double> zigzag(std::size_t(columns) * layers);
  for (std::size_t i = 0; i < zigzag.size(); ++i) zigzag[i] = i % 2 == 0 ? 1.0 : -1.0;
  EXPECT_NEAR(layer::wave_parts({1.0, 6, 6, 1, 1}, zigzag, columns).disturbed, 1.0, 1e-14) << "two columns a wave";
}

TEST(Disturbance, StandsInTheLayersFirstState) {
  auto par = tests::periodic_layer(0.1, 0.01, 0.4, 8, 5);
  par.initial.speeds = {0.1, 0.2, 0.3, 0.4, 0.5};
  const layer::Layer still(par);
  par.initial.disturbance = Disturbance{1e-3, 1, 3, 5, 1};
  const layer::Layer disturbed(par);
  std::vector<double> y(still.layout().size()), yp(y), z(y);
  still.initial_state(0.0, y, yp);
  disturbed.initial_state(0.0, z, yp);
  double sum = 0.0, largest = 0.0;
  for (int k = 0; k < 5; ++k) {
    for (int f = 0; f < 8; ++f) {
      EXPECT_EQ(y[still.unknowns().u(f, k)], par.initial.speeds[k]);
      const double added = z[disturbed.unknowns().u(f, k)] - y[still.unknowns().u(f, k)];
      sum += added;
      largest = std::max(largest, std::abs(added));
    }
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_NEAR(sum, 0.0, 1e-14) << "whole waves";
  par.initial.speeds.pop_back();
  EXPECT_THROW(layer::Layer{par}, std::invalid_argument);
}

}  // namespace
