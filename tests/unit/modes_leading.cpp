#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "modes/leading_modes.hpp"
#include "modes/plane_waves.hpp"

/// Systems whose modes are known: diffusion and drift round a ring, with a constraint in each cell.
namespace {

using namespace talus;
using modes::Complex;

/// u_i' = growth u_i + spread (u_(i+1) - 2 u_i + u_(i-1)) - drift (u_(i+1) - u_(i-1))/2 + p_i, v_i' = p_i, u_i + v_i = 0: eliminating p_i,
/// half of that acts on u. Unknowns (u, v, p) cell by cell; index 2.
class Ring final : public core::DaeSystem {
 public:
  Ring(core::Index n, double growth, double spread, double drift)
      : n_(n), growth_(growth), spread_(spread), drift_(drift) {
    layout_.fields = {{"u", "m s-1", core::Kind::differential, 1e-6},
                      {"v", "m s-1", core::Kind::differential, 1e-6},
                      {"p", "Pa", core::Kind::algebraic, 1e-6}};
    std::vector<std::pair<core::Index, core::Index>> entries;
    for (core::Index i = 0; i < n; ++i) {
      for (const std::uint8_t field : {0, 1, 2}) layout_.field_of.push_back(field);
      for (core::Index j = i - 1; j <= i + 1; ++j) entries.emplace_back(3 * i, 3 * ((j + n) % n));
      entries.insert(entries.end(), {{3 * i, 3 * i + 2},
                                     {3 * i + 1, 3 * i + 1},
                                     {3 * i + 1, 3 * i + 2},
                                     {3 * i + 2, 3 * i},
                                     {3 * i + 2, 3 * i + 1}});
    }
    pattern_ = core::SparsePattern(3 * n, entries);
  }
  [[nodiscard]] const core::Layout& layout() const override { return layout_; }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return pattern_; }
  void initial_state(double, std::span<double>, std::span<double>) const override {}
  void residual(double, std::span<const double>, std::span<const double>, std::span<double>) const override {}
  void jacobian(double, std::span<const double>, std::span<const double>, double c_j,
                std::span<double> values) const override {
    std::ranges::fill(values, 0.0);
    const auto put = [&](core::Index r, core::Index c, double value) { values[pattern_.find(r, c)] += value; };
    for (core::Index i = 0; i < n_; ++i) {
      put(3 * i, 3 * i, c_j - growth_ + 2.0 * spread_);
      put(3 * i, 3 * ((i + 1) % n_), -spread_ + 0.5 * drift_);
      put(3 * i, 3 * ((i + n_ - 1) % n_), -spread_ - 0.5 * drift_);
      put(3 * i, 3 * i + 2, -1.0);
      put(3 * i + 1, 3 * i + 1, c_j);
      put(3 * i + 1, 3 * i + 2, -1.0);
      put(3 * i + 2, 3 * i, 1.0);
      put(3 * i + 2, 3 * i + 1, 1.0);
    }
  }
  [[nodiscard]] std::string describe(core::Index) const override { return "row"; }
  [[nodiscard]] Complex rate(double phase) const {
    return 0.5 * Complex(growth_ - 2.0 * spread_ * (1.0 - std::cos(phase)), -drift_ * std::sin(phase));
  }

 private:
  core::Index n_;
  double growth_, spread_, drift_;
  core::Layout layout_;
  core::SparsePattern pattern_;
};

TEST(PlaneWaves, FindTheOneModeOfEachWave) {
  const Ring ring(7, 0.3, 2.0, 5.0);
  const std::vector<double> y(21, 0.0);
  const modes::PlaneWaves waves(ring, 0.0, y, 7);
  EXPECT_EQ(waves.block_size(), 3);
  for (const double phase : {0.0, 0.01, 0.7, 2.0, std::numbers::pi}) {
    const auto found = waves.modes(phase);
    ASSERT_EQ(found.size(), 1U) << "the constraint leaves one of three";
    EXPECT_LT(std::abs(found[0].rate - ring.rate(phase)), 1e-12);
    EXPECT_LT(std::abs(found[0].shape[0] + found[0].shape[1]), 1e-12);
    EXPECT_LT(found[0].residual, 1e-12);
  }
}

TEST(PlaneWaves, RefuseWhatDoesNotRepeatAndRingsThatAreTooShort) {
  const std::vector<double> y(21, 0.0), short_y(9, 0.0);
  EXPECT_THROW(modes::PlaneWaves(Ring(7, 0.3, 2.0, 5.0), 0.0, y, 5), std::invalid_argument);
  EXPECT_THROW(modes::PlaneWaves(Ring(3, 0.3, 2.0, 5.0), 0.0, short_y, 3), std::invalid_argument);
}

TEST(LeadingModes, FindTheFastestOfAllWavesAndSayHowFarTheyLooked) {
  constexpr int n = 40;
  const Ring ring(n, 0.3, 2.0, 0.5);
  const std::vector<double> y(3 * n, 0.0);
  const auto found =
      modes::leading_modes(ring, 0.0, y, {.shifts = {0.5, 2.0}, .n_modes = 9, .n_vectors = 30, .linear = {}});
  ASSERT_GE(found.modes.size(), 9U);
  EXPECT_LT(std::abs(found.modes[0].rate - ring.rate(0.0)), 1e-8);
  for (int pair = 1; pair <= 3; ++pair) {
    const Complex exact = ring.rate(2.0 * std::numbers::pi * pair / n);
    for (const int i : {2 * pair - 1, 2 * pair}) {
      EXPECT_LT(std::abs(found.modes[i].rate.real() - exact.real()), 1e-8) << i;
      EXPECT_NEAR(std::abs(found.modes[i].rate.imag()), std::abs(exact.imag()), 1e-8) << i;
      EXPECT_LT(found.modes[i].residual, 1e-7);
    }
  }
  ASSERT_EQ(found.searched.size(), 2U);
  for (const auto& searched : found.searched) {
    int within = 0;
    for (int m = 0; m < n; ++m)
      within += std::abs(ring.rate(2.0 * std::numbers::pi * m / n) - searched.shift) <= searched.radius * (1.0 + 1e-9);
    EXPECT_EQ(within, searched.n_found) << "nothing within the radius was missed";
  }
}

TEST(LeadingModes, RefuseOptionsWithoutSense) {
  const Ring ring(7, 0.3, 2.0, 5.0);
  const std::vector<double> y(21, 0.0);
  EXPECT_THROW((void)modes::leading_modes(ring, 0.0, y, {}), std::invalid_argument);
  EXPECT_THROW(
      (void)modes::leading_modes(ring, 0.0, y, {.shifts = {1.0}, .n_modes = 10, .n_vectors = 11, .linear = {}}),
      std::invalid_argument);
}

}  // namespace
