#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include "diagnostics/heap_shape.hpp"
#include "ida/ida.hpp"
#include "layer/cell_state.hpp"
#include "layer/layer.hpp"
#include "steady/regularised_profile.hpp"
#include "steady/uniform_flow.hpp"
#include "support/example_scene.hpp"

/// The grown heap, when its inflow ends, against the exact steady flow down its face: slope, speed and inertial number. The exact flow is
/// that of the flux which really passes there, with the same regularisations.
namespace {

using namespace talus;

constexpr double degrees = 180.0 / std::numbers::pi;

struct Face {
  double slope, slope_of_flow, slope_of_inflow;  ///< [degree]: found; exact for what passes and for Q, regularised
  double speed_error, inertial_error;            ///< relative L2 over the column in the middle of the face
  double roughness;  ///< largest second difference of H over the face, as a share of the top layer
};

Face grow(const std::string& example, int columns, int layers) {
  const auto scene = tests::small(example, columns, layers);
  const layer::Layer system(app::make_layer_parameters(scene));
  const auto& par = system.parameters();
  core::Observer nobody;
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  ida::Ida integrator(system, app::make_integrator_options(scene));
  integrator.start(0.0, y, yp);
  integrator.advance(par.inflow.stop, nobody);
  const auto now = integrator.current();

  std::vector<double> H;
  for (int i = 0; i < columns; ++i) H.push_back(now.y[system.unknowns().H(i)]);
  const auto face = diagnostics::right_face({system.columns().dx(), par.box.tilt, H});
  EXPECT_TRUE(face.has_value());
  const auto& context = system.context(now.t, now.y);
  const int middle = (face->first + face->last) / 2;
  const double lean = face->angle - par.box.tilt;

  double flux = 0.0;
  std::vector<double> depth, thickness, speed, inertial;
  for (int k = 0; k < layers; ++k) {
    const double bottom = context.z[context.at(middle, k)], top = context.z[context.at(middle, k + 1)];
    const auto cell = layer::cell_state(system, context, now.y, middle, k);
    flux += cell.u * (top - bottom) * par.grains.rho() * par.box.gap;
    depth.push_back((H[middle] - 0.5 * (bottom + top)) * std::cos(lean));
    thickness.push_back(top - bottom);
    speed.push_back(std::hypot(cell.u, cell.w));
    inertial.push_back(cell.I);
  }

  const steady::Channel channel{par.grains, par.law, par.box.gap, par.wall.mu_w, par.box.gravity};
  auto regularisation = par.regularisation;
  regularisation.rate_floor = std::hypot(regularisation.rate_floor, regularisation.rate_speed / H[middle]);
  regularisation.rate_speed = 0.0;
  const steady::RegularisedLayer exact_layer{channel, regularisation, par.wall.u_c, H[middle] * std::cos(lean)};
  const auto slope_of_flow = steady::slope_of_flux(exact_layer, flux);
  const auto slope_of_inflow = steady::slope_of_flux(exact_layer, par.inflow.rate);
  const auto exact = steady::RegularisedProfile::at(exact_layer, *slope_of_flow);
  const auto exact_flow = steady::UniformFlow::at(channel, *slope_of_flow);
  Face result{face->angle * degrees, *slope_of_flow * degrees, *slope_of_inflow * degrees, 0.0, 0.0, 0.0};
  double speed_size = 0.0, inertial_size = 0.0;
  for (int k = 0; k < layers; ++k) {
    const double u = exact->speed(-depth[k]), I = exact_flow->inertial_number(-depth[k]);
    result.speed_error += std::pow(speed[k] - u, 2) * thickness[k];
    speed_size += u * u * thickness[k];
    result.inertial_error += std::pow(inertial[k] - I, 2) * thickness[k];
    inertial_size += I * I * thickness[k];
  }
  result.speed_error = std::sqrt(result.speed_error / speed_size);
  result.inertial_error = std::sqrt(result.inertial_error / inertial_size);
  for (int i = face->first + 1; i < face->last; ++i) {
    const double top = context.z[context.at(i, layers)] - context.z[context.at(i, layers - 1)];
    result.roughness = std::max(result.roughness, std::abs(H[i - 1] - 2.0 * H[i] + H[i + 1]) / top);
  }
  std::printf("%-9s %3dx%-3d %8.3f %10.3f %10.3f %9.2f %9.2f %10.2f\n", example.c_str(), columns, layers, result.slope,
              result.slope_of_flow, result.slope_of_inflow, 100.0 * result.speed_error, 100.0 * result.inertial_error,
              100.0 * result.roughness);
  return result;
}

void head() {
  std::printf("scene     grid    slope    exact for  exact for   error of  error of  roughness\n");
  std::printf("                  [deg]    what flows the inflow  speed, %%  I, %%      %% of a layer\n");
}

TEST(HeapSteady, FaceHasTheExactSlopeAndProfile) {
  head();
  for (const char* example : {"heap_q20", "heap_q46", "heap_q60"}) {
    const auto face = grow(example, 150, 16);
    EXPECT_NEAR(face.slope, face.slope_of_flow, 0.15) << example;
    EXPECT_NEAR(face.slope, face.slope_of_inflow, 0.3) << example;
    EXPECT_LT(face.speed_error, 0.05) << example;
    EXPECT_LT(face.roughness, 0.03) << example;
  }
}

TEST(HeapSteady, FaceConvergesUnderRefinement) {
  head();
  const auto coarse = grow("heap_q46", 60, 16), fine = grow("heap_q46", 150, 16), deep = grow("heap_q46", 150, 32);
  EXPECT_LT(std::abs(fine.slope - fine.slope_of_flow), 0.15);
  EXPECT_LT(std::abs(deep.slope - deep.slope_of_flow), 0.15);
  EXPECT_LT(deep.speed_error, 0.02);
  EXPECT_LT(deep.speed_error, fine.speed_error);
  EXPECT_LT(std::abs(fine.slope - fine.slope_of_flow), std::abs(coarse.slope - coarse.slope_of_flow) + 0.05);
}

}  // namespace
