#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <Eigen/SparseLU>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "ida/ida.hpp"
#include "support/layer_cases.hpp"
#include "support/table.hpp"

/// Small waves on a viscous layer over a no-slip base: the layer model with a fluid of constant viscosity against the exact
/// linear theory, by the eigenvalues of its Jacobian and by a run.
namespace {

using namespace talus;
using Complex = std::complex<double>;

constexpr double depth = 0.1, gravity = 9.81;  // [m], [m/s2]

/// exp(sigma t + i k x) with w = A (cosh kz - cosh mz) + B (sinh kz - (k/m) sinh mz), m^2 = k^2 + sigma/nu, which neither moves nor
/// slips on the base; the surface is free of shear and, with its weight, of normal stress. Returns the determinant of these
/// two conditions.
Complex surface_determinant(Complex sigma, double k, double nu) {
  const Complex m = std::sqrt(k * k + sigma / nu);
  const auto conditions = [&](const std::array<Complex, 4>& w) {  // w and its derivatives at the surface
    const Complex shear = w[2] + k * k * w[0];
    const Complex normal =
        nu * (w[3] - k * k * w[1]) - sigma * w[1] - 2.0 * nu * k * k * w[1] - gravity * k * k / sigma * w[0];
    return std::pair{shear, normal};
  };
  const double K = k * depth;
  const Complex M = m * depth, km = k / m;
  const Complex ck = std::cosh(K), sk = std::sinh(K), cm = std::cosh(M), sm = std::sinh(M);
  const double k2 = k * k, k3 = k2 * k;
  const auto [a_1, a_2] = conditions({ck - cm, k * sk - m * sm, k2 * ck - m * m * cm, k3 * sk - m * m * m * sm});
  const auto [b_1, b_2] = conditions({sk - km * sm, k * (ck - cm), k2 * sk - k * m * sm, k3 * ck - k * m * m * cm});
  return (a_1 * b_2 - a_2 * b_1) / (cm * ck);
}

/// The slowest-decaying wave of wave number k [1/m]: sigma = -damping + i frequency [1/s], by the secant method from the inviscid
/// one.
Complex exact_wave(double k, double nu) {
  const double inviscid = std::sqrt(gravity * k * std::tanh(k * depth));
  Complex a(-2.0 * nu * k * k, inviscid), b = a * 1.001, f_a = surface_determinant(a, k, nu);
  for (int i = 0; i < 60; ++i) {
    const Complex f_b = surface_determinant(b, k, nu);
    if (f_b == f_a) break;
    const Complex c = b - f_b * (b - a) / (f_b - f_a);
    a = b, f_a = f_b, b = c;
    if (std::abs(b - a) < 1e-14 * std::abs(b)) break;
  }
  return b;
}

layer::Parameters viscous_layer(double wavelength, double nu, int columns, int layers) {
  auto par = tests::periodic_layer(wavelength, depth, 0.0, columns, layers);
  par.fluid = rheology::Newtonian{nu * par.grains.rho()};
  par.atol_velocity = 1e-9;
  par.atol_height = 1e-10;
  par.atol_pressure = 1e-6;
  return par;
}

struct Mode {
  Complex sigma;
  Eigen::VectorXcd shape;  ///< of all unknowns, the largest change of H being 1 m
};

/// The eigenmode of the linearised layer at rest whose sigma is nearest to a guess, by inverse iteration.
Mode nearest_mode(const layer::Layer& system, Complex guess) {
  const auto& pattern = system.pattern();
  const Eigen::Index n = pattern.n();
  std::vector<double> y(n), yp(n), stiffness(pattern.n_nonzeros()), both(stiffness);
  system.initial_state(0.0, y, yp);
  system.jacobian(0.0, y, yp, 0.0, stiffness);
  system.jacobian(0.0, y, yp, 1.0, both);
  std::vector<Eigen::Triplet<Complex>> shifted, mass;
  for (Eigen::Index j = 0; j < n; ++j) {
    for (auto e = pattern.column_starts()[j]; e < pattern.column_starts()[j + 1]; ++e) {
      const double m = both[e] - stiffness[e];
      shifted.emplace_back(pattern.rows()[e], j, stiffness[e] + guess * m);
      mass.emplace_back(pattern.rows()[e], j, m);
    }
  }
  Eigen::SparseMatrix<Complex> A(n, n), M(n, n);
  A.setFromTriplets(shifted.begin(), shifted.end());
  M.setFromTriplets(mass.begin(), mass.end());
  Eigen::SparseLU<Eigen::SparseMatrix<Complex>> solver(A);
  EXPECT_EQ(solver.info(), Eigen::Success);
  const auto& c = system.columns();
  Eigen::VectorXcd v = Eigen::VectorXcd::Zero(n);
  for (int i = 0; i < c.n_columns; ++i)
    v[system.unknowns().H(i)] = std::cos(2.0 * std::numbers::pi * c.x_centre(i) / c.length);
  Complex sigma = guess;
  for (int i = 0; i < 40; ++i) {
    const Eigen::VectorXcd w = solver.solve(M * v);
    const Complex theta = v.dot(w) / v.squaredNorm();
    const Complex last = sigma;
    sigma = guess - 1.0 / theta;
    v = w / w.norm();
    if (i > 2 && std::abs(sigma - last) < 1e-12 * std::abs(sigma)) break;
  }
  Complex largest = 0.0;
  for (int i = 0; i < c.n_columns; ++i) {
    if (const Complex H = v[system.unknowns().H(i)]; std::abs(H) > std::abs(largest)) largest = H;
  }
  return {sigma, v / largest};
}

TEST(LayerSloshing, FrequencyAndDampingConvergeToTheLinearTheory) {
  tests::Table table("layer_sloshing", {"k H", "nu [m2/s]", "columns", "layers", "frequency [1/s]", "damping [1/s]",
                                        "error of frequency", "error of damping", "order of sigma"});
  struct Case {
    double wavelength, nu, order, error;  // [m], [m2/s]; at least, at most
  };
  for (const auto& [wavelength, nu, order, error] : {Case{2.0, 1e-3, 1.9, 2e-3}, Case{0.6, 2e-3, 1.8, 1e-3},
                                                     Case{0.15, 2e-3, 1.8, 1e-2}, Case{0.6, 2e-2, 1.8, 1e-2}}) {
    const double k = 2.0 * std::numbers::pi / wavelength;
    const Complex exact = exact_wave(k, nu);
    table.row({k * depth, nu, "exact", "", exact.imag(), -exact.real(), "", "", ""});
    std::vector<double> h, e;
    for (const int n : {8, 16, 32}) {
      const layer::Layer system(viscous_layer(wavelength, nu, n, n));
      const auto mode = nearest_mode(system, exact);
      h.push_back(1.0 / n);
      e.push_back(std::abs(mode.sigma - exact) / std::abs(exact));
      table.row({k * depth, nu, double(n), double(n), mode.sigma.imag(), -mode.sigma.real(),
                 mode.sigma.imag() / exact.imag() - 1.0, mode.sigma.real() / exact.real() - 1.0,
                 e.size() == 1 ? tests::Table::Cell("") : diagnostics::observed_orders(h, e).back()});
    }
    EXPECT_GT(diagnostics::observed_orders(h, e).back(), order) << wavelength << " " << nu;
    EXPECT_LT(e.back(), error) << wavelength << " " << nu;
  }
}

TEST(LayerSloshing, ARunFollowsTheModeOverAPeriod) {
  const double wavelength = 0.6, nu = 2e-3, height = 1e-5;  // [m], [m2/s], [m]
  const int n = 16;
  const layer::Layer system(viscous_layer(wavelength, nu, n, n));
  const auto mode = nearest_mode(system, exact_wave(2.0 * std::numbers::pi / wavelength, nu));
  std::vector<double> rest(system.layout().size()), y(rest), yp(rest);
  system.initial_state(0.0, rest, yp);
  for (std::size_t i = 0; i < y.size(); ++i) {
    y[i] = rest[i] + height * mode.shape[i].real();
    yp[i] = height * (mode.sigma * mode.shape[i]).real();
  }
  ida::Options options;
  options.rtol = 1e-9;
  ida::Ida integrator(system, options);
  integrator.start(0.0, y, yp);
  core::Observer nobody;
  const double period = 2.0 * std::numbers::pi / mode.sigma.imag();
  double largest = 0.0;
  for (int quarter = 1; quarter <= 4; ++quarter) {
    const double t = 0.25 * quarter * period;
    integrator.advance(t, nobody);
    const auto now = integrator.current();
    for (int i = 0; i < n; ++i) {
      const auto H = system.unknowns().H(i);
      const double expected = height * (mode.shape[H] * std::exp(mode.sigma * t)).real();
      largest = std::max(largest, std::abs(now.y[H] - rest[H] - expected) / height);
    }
  }
  std::printf("largest departure from the mode: %.2e of its height\n", largest);
  EXPECT_LT(largest, 5e-4);
}

}  // namespace
