#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "diagnostics/observed_order.hpp"
#include "ida/ida.hpp"
#include "layer/layer.hpp"
#include "steady/regularised_profile.hpp"
#include "support/example_scene.hpp"

/// A uniform layer between rough walls, run from rest to its steady state: a periodic box whose columns stand at a right angle to
/// the layer, or at any other. The reference is the one-dimensional profile with the same regularisations.
namespace {

using namespace talus;

struct Steady {
  double flux;           ///< [kg/s]
  double surface_speed;  ///< [m/s], in the middle of the top layer
  double profile_error;  ///< L2 over the depth, relative
};

constexpr double zeta = 45.0 * M_PI / 180.0, thickness = 0.012;

steady::RegularisedLayer reference_layer(const layer::Parameters& par) {
  return {
      {par.grains, par.law, par.box.gap, par.wall.mu_w, par.box.gravity}, par.regularisation, par.wall.u_c, thickness};
}

const steady::RegularisedProfile& reference(const layer::Parameters& par) {
  static const auto profile = steady::RegularisedProfile::at(reference_layer(par), zeta, 8000);
  return *profile;
}

/// `tilt` [rad] between the columns and the normal of the layer.
Steady run(int layers, double tilt) {
  auto scene =
      tests::small("chute_periodic", 4, layers,
                   {"wall.u_c=1e-4", "rheology.p_0=0", "rheology.eta_max=1e6", "integrator.linear_solver=klu"});
  auto par = app::make_layer_parameters(scene);
  par.box.tilt = zeta - tilt;
  par.box.base_slope = -std::tan(tilt);
  par.initial.thickness = thickness / std::cos(tilt);
  par.grid.cluster_depth /= std::cos(tilt);
  const layer::Layer system(par);
  core::Observer nobody;
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  ida::Ida integrator(system, app::make_integrator_options(scene));
  integrator.start(0.0, y, yp);
  integrator.advance(1000.0, nobody);
  const auto now = integrator.current();
  const auto& context = system.context(now.t, now.y);
  const auto& exact = reference(par);

  Steady result{};
  double error = 0.0, size = 0.0;
  const double along = 1.0 / std::cos(tilt);
  for (int k = 0; k < layers; ++k) {
    const double bottom = context.z[context.at(1, k)], top = context.z[context.at(1, k + 1)];
    const double u = now.y[system.unknowns().u(1, k)];
    const double depth = (par.initial.thickness - 0.5 * (bottom + top)) * std::cos(tilt);
    result.flux += u * (top - bottom) * par.grains.rho() * par.box.gap;
    error += std::pow(u * along - exact.speed(-depth), 2) * (top - bottom);
    size += std::pow(exact.speed(-depth), 2) * (top - bottom);
    result.surface_speed = u * along;
  }
  result.profile_error = std::sqrt(error / size);
  return result;
}

TEST(UniformLayer, FluxAndProfileConvergeToSecondOrder) {
  const layer::Parameters par = app::make_layer_parameters(
      tests::small("chute_periodic", 4, 8, {"wall.u_c=1e-4", "rheology.p_0=0", "rheology.eta_max=1e6"}));
  const double exact = reference(par).flux();
  std::printf("layers  flux error  profile error (L2)\n");
  std::vector<double> widths, flux_errors, profile_errors;
  for (const int layers : {8, 16, 32, 64}) {
    const auto steady = run(layers, 0.0);
    std::printf("%6d  %10.3e  %10.3e\n", layers, steady.flux / exact - 1.0, steady.profile_error);
    widths.push_back(1.0 / layers);
    flux_errors.push_back(std::abs(steady.flux / exact - 1.0));
    profile_errors.push_back(steady.profile_error);
  }
  EXPECT_LT(flux_errors[2], 1e-2);
  EXPECT_LT(profile_errors.back(), 1e-3);
  const double order = diagnostics::fitted_order(widths, profile_errors);
  std::printf("order of the profile: %.2f\n", order);
  EXPECT_GT(order, 1.8);
}

TEST(UniformLayer, TiltAgainstTheGridChangesNothing) {
  const auto aligned = run(16, 0.0);
  for (const double degrees : {20.0, -50.0}) {
    const auto tilted = run(16, degrees * M_PI / 180.0);
    std::printf("tilt %5.1f degrees: flux differs by %.2e, surface speed by %.2e\n", degrees,
                tilted.flux / aligned.flux - 1.0, tilted.surface_speed / aligned.surface_speed - 1.0);
    EXPECT_NEAR(tilted.flux, aligned.flux, 1e-6 * aligned.flux);
    EXPECT_NEAR(tilted.surface_speed, aligned.surface_speed, 1e-6 * aligned.surface_speed);
    EXPECT_NEAR(tilted.profile_error, aligned.profile_error, 1e-6);
  }
}

}  // namespace
