#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "support/layer_cases.hpp"
#include "support/layer_flow.hpp"
#include "support/reference.hpp"
#include "support/table.hpp"

/// The layer model with a fluid of constant viscosity against exact solutions: Stokes' first problem, the start of a film,
/// and the decay of Taylor-Green vortices.
namespace {

using namespace talus;
constexpr double pi = std::numbers::pi;

const nlohmann::json& flows() {
  static const nlohmann::json all = support::reference("viscous_flows.json");
  return all;
}

/// Errors of u(z), as shares of `speed` [m/s], at the times of a reference, for growing numbers of layers, against a profile u(z, t) that is first checked
/// against the reference's samples.
void expect_profiles(const char* name, const nlohmann::json& samples, const std::vector<double>& times, double speed,
                     const std::function<layer::Parameters(int)>& parameters,
                     const std::function<double(double, double)>& profile) {
  for (const auto& s : samples)
    EXPECT_NEAR(profile(s.at("z"), s.at("t")), s.at("u").get<double>(), 1e-9 * speed) << name;
  tests::Table table(name, {"t [s]", "layers", "L1 of u [1]", "L2 of u [1]", "Linf of u [1]", "order L2"});
  std::vector<std::vector<double>> all(times.size());
  std::vector<double> h;
  for (const int n : {16, 32, 64}) {
    const layer::Layer system(parameters(n));
    auto y = tests::state_at_rest(system);
    h.push_back(1.0 / n);
    double last = 0.0;
    for (std::size_t j = 0; j < times.size(); ++j) {
      // What Newton's method leaves is an error of w, where the flow has none.
      tests::integrate(system, last, times[j], y, 1e-7, {.tolerance = 1e-3});
      last = times[j];
      const auto e = tests::errors(
          system,
          [&](double, double z, double t) {
            return tests::PointFlow{profile(z, t), 0.0, 0.0};
          },
          last, y);
      all[j].push_back(e.u.l2 / speed);
      table.row({last, double(n), e.u.l1 / speed, e.u.l2 / speed, e.u.linf / speed,
                 n == 16 ? tests::Table::Cell("") : diagnostics::observed_orders(h, all[j]).back()});
      EXPECT_LT(e.w.linf, 1e-10 * speed) << name;
    }
  }
  for (const auto& e : all) {
    EXPECT_NEAR(diagnostics::observed_orders(h, e).back(), 2.0, 0.15) << name;
    EXPECT_LT(e.back(), 1e-3) << name;
  }
}

TEST(LayerViscous, StokesFirstProblem) {
  const auto& problem = flows().at("stokes");
  const double nu = problem.at("nu"), U = problem.at("U");
  expect_profiles(
      "layer_stokes", problem.at("samples"), {0.5, 1.0, 2.0}, U,
      [&](int n) {
        auto par = tests::fluid_box(nu, 2, n);
        par.box.base_speed = U;
        par.box.lid->contact = experiment::Contact::free_slip;
        par.initial.thickness = 1.5;
        return par;
      },
      [&](double z, double t) { return U * std::erfc(z / (2.0 * std::sqrt(nu * t))); });
}

/// Wave number [1/m] of the n-th mode cos(b d) of a film, d the depth: b l tan(b h) = 1.
double wave_number(int n, double h, double l) {
  double low = n * pi / h, high = (n + 0.5) * pi / h;
  if (l == 0.0) return high;
  for (int i = 0; i < 200; ++i) {
    const double b = 0.5 * (low + high);
    (b * l * std::tan(b * h) < 1.0 ? low : high) = b;
  }
  return 0.5 * (low + high);
}

/// A film on a base on which it slips by Navier's length `l` [m], from rest to its parabola.
void expect_film_starts(const char* name, double l) {
  const auto problem = support::reference("newtonian_film.json");
  const double nu = problem.at("nu"), pull = problem.at("g_sin_zeta"), h = problem.at("thickness");
  nlohmann::json samples = problem.at("samples");  // their z is 0 at the surface
  for (auto& s : samples) s["z"] = s.at("z").get<double>() + h;
  if (l > 0.0) samples.clear();
  std::vector<double> waves;
  for (int n = 0; n < 400; ++n) waves.push_back(wave_number(n, h, l));
  const double tilt = pi / 6.0;
  expect_profiles(
      name, samples, {1.0, 5.0, 20.0, 100.0}, 50.0,
      [&](int n) {
        auto par = tests::fluid_box(nu, 2, n);
        par.box.lid.reset();
        par.box.tilt = tilt;
        par.box.gravity = pull / std::sin(tilt);
        par.box.base_slip_length = l;
        return par;
      },
      [&](double z, double t) {
        const double d = h - z;
        double u = pull / nu * (0.5 * (h * h - d * d) + l * h);
        for (const double b : waves) {
          const double norm = 0.5 * h + std::sin(2.0 * b * h) / (4.0 * b);
          u -= pull * std::sin(b * h) / (nu * b * b * b * norm) * std::cos(b * d) * std::exp(-nu * b * b * t);
        }
        return u;
      });
}

TEST(LayerViscous, FilmStartsDownASlope) { expect_film_starts("layer_film", 0.0); }

TEST(LayerViscous, FilmStartsOnABaseOnWhichItSlips) { expect_film_starts("layer_film_slip", 0.3); }

struct Vortices {
  std::string name;
  bool walls;
  grid::Spacing spacing;
  layer::Advection advection;
  double order, order_p;
};
void PrintTo(const Vortices& v, std::ostream* out) { *out << v.name; }

class TaylorGreen : public testing::TestWithParam<Vortices> {};

TEST_P(TaylorGreen, VorticesDecayAtOrderTwo) {
  const auto& c = GetParam();
  const auto& problem = flows().at("taylor_green");
  const double nu = problem.at("nu"), k = 2.0 * pi, end = 0.5;
  const auto exact = [&](double x, double z, double t) {
    const double a = std::exp(-2.0 * nu * k * k * t);
    return tests::PointFlow{a * std::sin(k * x) * std::cos(k * z), -a * std::cos(k * x) * std::sin(k * z),
                            0.25 * a * a * (std::cos(2.0 * k * x) + std::cos(2.0 * k * z))};
  };
  tests::Table table("layer_taylor_green_" + c.name,
                     {"cells", "L2 of u [m/s]", "L2 of w [m/s]", "L2 of p [Pa]", "Linf of u [m/s]", "Linf of p [Pa]",
                      "kinetic energy [m2/s2]", "order u", "order w", "order p"});
  std::vector<double> h, u, w, p;
  for (const int n : {8, 16, 32}) {
    auto par = tests::fluid_box(nu, n, n);
    par.box.periodic = !c.walls;
    par.box.left_open = par.box.right_open = false;
    par.box.base = par.box.lid->contact = experiment::Contact::free_slip;
    par.numerics.advection = c.advection;
    par.grid.spacing = c.spacing;
    par.grid.cluster_depth = 1.0;
    const layer::Layer system(par);
    auto y = tests::state_at_rest(system);
    tests::set_flow(system, exact, 0.0, y);
    tests::integrate(system, 0.0, end, y, 1e-7);
    const auto e = tests::errors(system, exact, end, y, true);
    double energy = 0.0;
    for (int f = 0; f < n; ++f) {
      for (int j = 0; j < n; ++j) {
        const auto i = system.unknowns().u(f, j);
        const auto& context = system.context(end, y);
        if (i >= 0) energy += y[i] * y[i] * (context.z[context.at(0, j + 1)] - context.z[context.at(0, j)]) / n;
      }
    }
    h.push_back(1.0 / n), u.push_back(e.u.l2), w.push_back(e.w.l2), p.push_back(e.p.l2);
    const auto order = [&](const std::vector<double>& v) {
      return v.size() == 1 ? tests::Table::Cell("") : diagnostics::observed_orders(h, v).back();
    };
    table.row({double(n), e.u.l2, e.w.l2, e.p.l2, e.u.linf, e.p.linf, energy, order(u), order(w), order(p)});
    if (n == 32 && c.advection == layer::Advection::central) {
      for (const auto& s : problem.at("samples")) {
        if (s.at("t") == end) { EXPECT_NEAR(energy, s.at("KE_mean").get<double>(), 5e-3 * energy); }
      }
    }
  }
  EXPECT_GT(diagnostics::observed_orders(h, u).back(), c.order);
  EXPECT_GT(diagnostics::observed_orders(h, w).back(), c.order);
  EXPECT_GT(diagnostics::observed_orders(h, p).back(), c.order_p);
}

INSTANTIATE_TEST_SUITE_P(
    LayerViscous, TaylorGreen,
    testing::Values(Vortices{"periodic", false, grid::Spacing::uniform, layer::Advection::central, 1.8, 1.8},
                    Vortices{"walls", true, grid::Spacing::uniform, layer::Advection::central, 1.8, 1.8},
                    Vortices{"stretched", true, grid::Spacing::clustered, layer::Advection::central, 1.8, 1.8},
                    Vortices{"upwind", false, grid::Spacing::uniform, layer::Advection::upwind, 0.8, 0.8}),
    [](const auto& each) { return each.param.name; });

}  // namespace
