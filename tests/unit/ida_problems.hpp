#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/dae_system.hpp"
#include "core/dual.hpp"

/// Small systems with known answers, for the tests of the integrators.
namespace talus::test {

/// A DaeSystem of N unknowns from a scalar-generic `Model`:
///   static constexpr int n; std::array<core::Kind, n> kinds; std::array<double, n> tolerances, y_0, yp_0;
///   template <class S> std::array<S, n> residual(double t, const std::array<S, n>& y, const std::array<S, n>& yp)
///   const; Each unknown is a field of its own, with the newton_bound that a std::array<double, n> bounds of the model says.
///   The Jacobian is exact; its pattern is full, or what a static bool couples(int row, int column) of the model says.
template <class Model>
class SmallDae final : public core::DaeSystem {
 public:
  static constexpr int n = Model::n;

  explicit SmallDae(Model m = {}, std::vector<double> breaks = {})
      : model(std::move(m)), breakpoints_(std::move(breaks)) {
    std::vector<std::pair<core::Index, core::Index>> entries;
    for (int i = 0; i < n; ++i) {
      layout_.fields.push_back({"y" + std::to_string(i), "1", model.kinds[i], model.tolerances[i]});
      if constexpr (requires { model.bounds; }) layout_.fields.back().newton_bound = model.bounds[i];
      layout_.field_of.push_back(static_cast<std::uint8_t>(i));
      for (int j = 0; j < n; ++j) {
        if (couples(i, j)) entries.emplace_back(i, j);
      }
    }
    pattern_ = core::SparsePattern(n, entries);
  }

  [[nodiscard]] const core::Layout& layout() const override { return layout_; }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return pattern_; }
  void initial_state(double, std::span<double> y, std::span<double> yp) const override {
    std::copy(model.y_0.begin(), model.y_0.end(), y.begin());
    std::copy(model.yp_0.begin(), model.yp_0.end(), yp.begin());
  }
  void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override {
    std::array<double, n> a{}, b{};
    std::copy(y.begin(), y.end(), a.begin());
    std::copy(yp.begin(), yp.end(), b.begin());
    const auto f = model.residual(t, a, b);
    std::copy(f.begin(), f.end(), r.begin());
  }
  void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override {
    using S = core::Dual<n>;
    std::array<S, n> a, b;
    for (int j = 0; j < n; ++j) {
      a[j] = S::input(y[j], j);
      b[j] = S::input(yp[j], j, c_j);
    }
    const auto f = model.residual(t, a, b);
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        if (couples(i, j)) values[pattern_.find(i, j)] = f[i].slope[j];
      }
    }
  }
  [[nodiscard]] std::string describe(core::Index row) const override {
    return "row " + std::to_string(row) + " of the test";
  }
  [[nodiscard]] std::vector<double> breakpoints() const override { return breakpoints_; }

  Model model;

 private:
  static bool couples(int row, int column) {
    if constexpr (requires { Model::couples(row, column); }) return Model::couples(row, column);
    else return true;
  }

  core::Layout layout_;
  core::SparsePattern pattern_;
  std::vector<double> breakpoints_;
};

inline constexpr auto differential = core::Kind::differential;
inline constexpr auto algebraic = core::Kind::algebraic;

/// Pendulum of unit length and mass in Cartesian coordinates (x, y, u, v, lambda), constrained in velocity (index 2).
/// At rest at 90 degrees unless said otherwise; the exact multiplier is u^2 + v^2 - g y.
struct Pendulum {
  static constexpr int n = 5;
  static constexpr double g = 9.81;
  std::array<core::Kind, n> kinds = {differential, differential, differential, differential, algebraic};
  std::array<double, n> tolerances = {1e-8, 1e-8, 1e-8, 1e-8, 1e-6};
  std::array<double, n> y_0 = {1.0, 0.0, 0.0, 0.0, 0.0}, yp_0 = {};

  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    return {yp[0] - y[2], yp[1] - y[3], yp[2] + y[4] * y[0], yp[3] + y[4] * y[1] + g, y[0] * y[2] + y[1] * y[3]};
  }
};

/// Angle and angular velocity of the pendulum from rest at 90 degrees, by the classical Runge-Kutta method with 1e-4 s
/// steps (error below 1e-12 over some seconds).
inline std::pair<double, double> pendulum_angle(double t) {
  const int steps = static_cast<int>(std::ceil(t / 1e-4));
  const double h = t / steps;
  double theta = 0.5 * M_PI, omega = 0.0;
  const auto force = [](double angle) { return -Pendulum::g * std::sin(angle); };
  for (int i = 0; i < steps; ++i) {
    const double k1 = omega, l1 = force(theta);
    const double k2 = omega + 0.5 * h * l1, l2 = force(theta + 0.5 * h * k1);
    const double k3 = omega + 0.5 * h * l2, l3 = force(theta + 0.5 * h * k2);
    const double k4 = omega + h * l3, l4 = force(theta + h * k3);
    theta += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    omega += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
  }
  return {theta, omega};
}

/// Robertson's three stiff chemical reactions as a DAE of index 1 (H. H. Robertson, 1966).
struct Robertson {
  static constexpr int n = 3;
  std::array<core::Kind, n> kinds = {differential, differential, algebraic};
  std::array<double, n> tolerances = {1e-8, 1e-14, 1e-6};
  std::array<double, n> y_0 = {1.0, 0.0, 0.0}, yp_0 = {-0.04, 0.04, 0.0};

  template <class S>
  std::array<S, n> residual(double, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    const S r_1 = 0.04 * y[0], r_2 = 1e4 * y[1] * y[2], r_3 = 3e7 * y[1] * y[1];
    return {yp[0] + r_1 - r_2, yp[1] - r_1 + r_2 + r_3, y[0] + y[1] + y[2] - 1.0};
  }
};

/// Two masses with velocities u1, u2, friction k u, tied by u1 + u2 = q(t) with force p on both (a Stokes problem in
/// the small): u' = -k u + p, so u1 - u2 decays freely, u1 + u2 = q, and p = (q' + k q)/2.
struct Tied {
  static constexpr int n = 3;
  double k = 2.0;
  std::function<double(double)> q = [](double t) { return std::sin(t); };
  std::array<core::Kind, n> kinds = {differential, differential, algebraic};
  std::array<double, n> tolerances = {1e-9, 1e-9, 1e-7};
  std::array<double, n> y_0 = {0.7, 0.3, 0.0}, yp_0 = {};

  template <class S>
  std::array<S, n> residual(double t, const std::array<S, n>& y, const std::array<S, n>& yp) const {
    return {yp[0] + k * y[0] - y[2], yp[1] + k * y[1] - y[2], y[0] + y[1] - q(t)};
  }
};

}  // namespace talus::test
