#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/dae_system.hpp"
#include "core/dual.hpp"

/// A yielding layer between rough walls: the column model in the small, for the tests of steady solves.
namespace talus::test {

/// u' = d tau/dz + drive - friction(z) tanh(u/u_c) on n cells of a layer of depth 1; z = 0 at the free surface, where
/// tau = 0, u = 0 on the base, z = 1 downwards. The stress is plastic and viscous,
///   tau = -(yield z s/sqrt(s^2 + s_0^2) + viscosity s) with s = -du/dz,
/// and friction grows with depth, friction = wall z: above z = drive/wall the layer flows, below it creeps.
class ShearLayer final : public core::DaeSystem {
 public:
  struct Parameters {
    double drive = 1.0, wall = 2.0, yield = 0.5, viscosity = 0.02, s_0 = 1e-3, u_c = 1e-3;
  };

  ShearLayer(int n, Parameters parameters) : n_(n), p_(parameters) {
    layout_.fields.push_back({"u", "1", core::Kind::differential, 1e-3 * p_.u_c});
    layout_.field_of.assign(n, 0);
    std::vector<std::pair<core::Index, core::Index>> entries;
    for (int i = 0; i < n; ++i) {
      for (int j = std::max(0, i - 1); j <= std::min(n - 1, i + 1); ++j) entries.emplace_back(i, j);
    }
    pattern_ = core::SparsePattern(n, entries);
  }

  [[nodiscard]] const core::Layout& layout() const override { return layout_; }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return pattern_; }
  void initial_state(double, std::span<double> y, std::span<double> yp) const override {
    std::fill(y.begin(), y.end(), 0.0);
    std::fill(yp.begin(), yp.end(), 0.0);
  }
  void residual(double, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override {
    for (int i = 0; i < n_; ++i) r[i] = row(i, {above(y, i), y[i], below(y, i)}, yp[i]);
  }
  void jacobian(double, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override {
    using S = core::Dual<3>;
    for (int i = 0; i < n_; ++i) {
      const std::array<S, 3> u = {S::input(above(y, i), 0), S::input(y[i], 1), S::input(below(y, i), 2)};
      const S r = row(i, u, S(yp[i]));
      for (int k = 0; k < 3; ++k) {
        const int j = i + k - 1;
        if (j >= 0 && j < n_) values[pattern_.find(i, j)] = r.slope[k] + (k == 1 ? c_j : 0.0);
      }
    }
  }
  [[nodiscard]] std::string describe(core::Index row) const override { return "u in cell " + std::to_string(row); }

  /// The stress that the slope s of a profile makes at depth z.
  template <class S>
  [[nodiscard]] S stress(double z, const S& s) const {
    using std::sqrt;
    return p_.yield * z * s / sqrt(s * s + p_.s_0 * p_.s_0) + p_.viscosity * s;
  }
  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] double dz() const { return 1.0 / n_; }

 private:
  /// At the surface the mirrored cell makes the slope zero, at the base the reflected one makes u zero.
  [[nodiscard]] double above(std::span<const double> u, int i) const { return i == 0 ? u[0] : u[i - 1]; }
  [[nodiscard]] double below(std::span<const double> u, int i) const { return i + 1 == n_ ? 0.0 : u[i + 1]; }

  template <class S>
  [[nodiscard]] S row(int i, const std::array<S, 3>& u, const S& rate) const {
    using std::tanh;
    const double z = (i + 0.5) * dz(), face = i * dz();
    const S upper = i == 0 ? S(0.0) : stress(face, (u[0] - u[1]) * (1.0 / dz()));
    const S lower = stress(face + dz(), (u[1] - (i + 1 == n_ ? S(-1.0) * u[1] : u[2])) * (1.0 / dz()));
    return rate - (upper - lower) * (1.0 / dz()) - p_.drive + p_.wall * z * tanh(u[1] * (1.0 / p_.u_c));
  }

  int n_;
  Parameters p_;
  core::Layout layout_;
  core::SparsePattern pattern_;
};

}  // namespace talus::test
