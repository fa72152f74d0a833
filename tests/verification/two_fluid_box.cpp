#include <gtest/gtest.h>

#include <cmath>

#include "app/theory.hpp"
#include "app/two_fluid_model.hpp"
#include "ida/ida.hpp"
#include "steady/uniform_flow.hpp"
#include "support/example_scene.hpp"
#include "support/table.hpp"
#include "two_fluid/two_fluid.hpp"

/// The periodic box of the paper's appendix B, figures 20 and 21, against the exact steady flow.
namespace {

using namespace talus;

struct Box {
  two_fluid::TwoFluid system;
  std::vector<double> y, yp;
  app::Scene scene;

  Box(double slope, double gap, int layers, std::vector<std::string> settings = {})
      : Box(read(slope, gap, layers, std::move(settings))) {}
  explicit Box(app::Scene read_scene)
      : system(app::make_two_fluid_parameters(read_scene)),
        y(system.layout().size()),
        yp(y),
        scene(std::move(read_scene)) {
    core::Observer nobody;
    system.initial_state(0.0, y, yp);
    ida::Ida integrator(system, app::make_integrator_options(scene));
    integrator.start(0.0, y, yp);
    integrator.advance(scene.end, nobody);
    const auto now = integrator.current();
    y.assign(now.y.begin(), now.y.end());
    steps = static_cast<int>(now.statistics.steps);
    factorisations = static_cast<int>(now.statistics.factorisations);
  }
  static app::Scene read(double slope, double gap, int layers, std::vector<std::string> settings) {
    settings.push_back("box.tilt=" + std::to_string(slope));
    settings.push_back("box.gap=" + std::to_string(gap));
    return tests::small("two_fluid_box", 1, layers, std::move(settings));
  }

  int steps = 0, factorisations = 0;
  [[nodiscard]] double u(int k) const { return y[system.unknowns().u(0, k)]; }
  [[nodiscard]] double phi(int k) const { return y[system.unknowns().phi(0, k)]; }
};

/// Relative errors of the flow of grains a unit width, and of their speed in L2, against the exact flow.
struct Errors {
  double flux, L2;
};
Errors errors(const Box& box) {
  const double depth = box.scene.initial.thickness;
  const auto exact = steady::UniformFlow::at(app::channel_of(box.scene), box.scene.box.tilt, depth);
  const auto& g = box.system.mesh().grid();
  double flow = 0.0, off = 0.0, size = 0.0;
  for (int k = 0; k < g.n_layers(); ++k) {
    const double grains = box.phi(k) * g.dz(k), z = std::fmin(g.z_centre(k) - depth, 0.0);
    const double u = exact->speed(z);
    flow += grains * box.u(k);
    off += grains * (box.u(k) - u) * (box.u(k) - u);
    size += grains * u * u;
  }
  return {flow / exact->volume_flux_above(depth) - 1.0, std::sqrt(off / size)};
}

struct Case {
  double slope, gap;
};
const std::vector<Case> figure_20{{41, 0.04}, {47, 0.04}, {51, 0.04}, {54, 0.04}, {57, 0.04}, {59, 0.04}};
const std::vector<Case> figure_21{{28, 0.18}, {28, 0.45}, {28, 1.0}, {28, 3.0}, {28, 500.0}};

TEST(TwoFluidBox, FlowsAsTheExactSolutionInFigures20And21) {
  tests::Table table("two_fluid_box", {"slope [deg]", "gap [m]", "flux error [%]", "L2 of u [%]", "phi below 0 [1]",
                                       "phi above 1 [1]", "steps", "factorisations"});
  for (const auto& cases : {figure_20, figure_21})
    for (const auto& [slope, gap] : cases) {
      const Box box(slope, gap, 105);
      const auto e = errors(box);
      double least = 0.0, most = 1.0;
      for (int k = 0; k < 105; ++k) least = std::min(least, box.phi(k)), most = std::max(most, box.phi(k));
      table.row({slope, gap, 100.0 * e.flux, 100.0 * e.L2, -least, most - 1.0, double(box.steps),
                 double(box.factorisations)});
      EXPECT_LT(std::abs(e.flux), 0.005) << slope << " degrees, " << gap << " m";
      EXPECT_LT(e.L2, 0.01) << slope << " degrees, " << gap << " m";
      EXPECT_GE(least, -1e-6);
      EXPECT_LE(most, 1.0 + 1e-6);
      EXPECT_LT(box.factorisations, box.steps / 5)
          << "w is nothing here: its rows must not keep Newton's method in doubt";
    }
}

/// What each regularisation costs, 41 degrees: the flux error falls with the cap as 1/eta_max down to what the others leave; neither the
/// speed of segregation, where the phases are parted already, nor the viscosity of air that is carried along matters.
TEST(TwoFluidBox, ErrorsFollowTheRegularisations) {
  tests::Table table("two_fluid_box_regularisations", {"eta_max [Pa s]", "f_ga [m/s]", "air viscosity [Pa s]",
                                                       "flux error [%]", "L2 of u [%]", "steps", "factorisations"});
  const auto error = [&](double eta_max, double f_ga, double air) {
    const Box box(41, 0.04, 105,
                  {"rheology.eta_max=" + std::to_string(eta_max), "two_fluid.segregation_speed=" + std::to_string(f_ga),
                   "two_fluid.air_viscosity=" + std::to_string(air)});
    const auto e = errors(box);
    table.row({eta_max, f_ga, air, 100.0 * e.flux, 100.0 * e.L2, double(box.steps), double(box.factorisations)});
    return e.flux;
  };
  const double reference = error(1e6, 0.1, 1e-4), capped = error(1e3, 0.1, 1e-4) - reference;
  EXPECT_GT(std::abs(capped), 1e-3);
  EXPECT_LT(std::abs(error(1e4, 0.1, 1e-4) - reference), 0.2 * std::abs(capped));
  error(1e2, 0.1, 1e-4);
  error(1e8, 0.1, 1e-4);
  for (const double f_ga : {0.01, 0.3, 1.0}) EXPECT_NEAR(error(1e6, f_ga, 1e-4), reference, 1e-5) << f_ga;
  for (const double air : {1e-3, 1e-2, 1e-1}) EXPECT_NEAR(error(1e6, 0.1, air), reference, 1e-4) << air;
}

/// The surface between two cells (100 in 105), and within one (100 in all).
TEST(TwoFluidBox, ConvergesWithTheCellsInDepth) {
  tests::Table table("two_fluid_box_order", {"layers", "flux error [%]", "L2 of u [%]"});
  std::vector<double> L2;
  for (const int layers : {26, 53, 100, 105, 210}) {
    const auto e = errors(Box(41, 0.04, layers));
    table.row({double(layers), 100.0 * e.flux, 100.0 * e.L2});
    L2.push_back(e.L2);
  }
  EXPECT_LT(L2[0], 0.04);
  EXPECT_GT(std::log2(L2[0] / L2[1]), 1.7);
  EXPECT_GT(std::log2(L2[1] / L2[2]), 1.7);
}

}  // namespace
