#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "app/integrator.hpp"
#include "app/models.hpp"
#include "kinsol/kinsol.hpp"
#include "support/column_run.hpp"

/// The column's steady state found directly and through time: the same residual and Jacobian, so the same state. From rest
/// it is the exact profile, however stiff rest is.
namespace {
using namespace talus;

struct Outcome {
  std::vector<double> u;
  core::Statistics statistics;
};

Outcome at_the_end(const std::string& method, const std::string& u_c, const std::string& layers) {
  const auto scene = app::read_scene(
      std::string(TALUS_SOURCE_DIR) + "/runs/examples/chute_periodic.toml",
      {"model.name=column", "integrator.method=" + method, "integrator.rtol=1e-8", "integrator.atol_velocity=1e-10",
       "rheology.eta_max=1e6", "wall.u_c=" + u_c, "grid.layers=" + layers});
  const auto simulation = app::model(scene.model).build(scene);
  const auto integrator = app::make_integrator(scene, *simulation.system);
  std::vector<double> y(simulation.system->layout().size()), yp(y);
  simulation.system->initial_state(0.0, y, yp);
  integrator->start(0.0, y, yp);
  core::Observer nobody;
  integrator->advance(20.0, nobody);  // ten times the time to become steady
  const auto now = integrator->current();
  return {{now.y.begin(), now.y.end()}, now.statistics};
}

TEST(ColumnDirectly, NewtonFromRestGivesWhatTimeSteppingLeadsTo) {
  std::printf(
      "u_c [m/s], layers: largest difference over the fastest speed; factorisations and residuals, Newton and IDA\n");
  for (const char* u_c : {"1e-2", "1e-3", "1e-5"})
    for (const char* layers : {"32", "200"}) {
      const auto direct = at_the_end("steady", u_c, layers), stepped = at_the_end("bdf", u_c, layers);
      double difference = 0.0, fastest = 0.0;
      for (std::size_t i = 0; i < direct.u.size(); ++i) {
        difference = std::max(difference, std::abs(direct.u[i] - stepped.u[i]));
        fastest = std::max(fastest, std::abs(stepped.u[i]));
      }
      const auto &newton = direct.statistics, &ida = stepped.statistics;
      std::printf("%5s %4s  %.1e  %3lld %4lld  %3lld %5lld\n", u_c, layers, difference / fastest,
                  static_cast<long long>(newton.factorisations), static_cast<long long>(newton.residuals),
                  static_cast<long long>(ida.factorisations), static_cast<long long>(ida.residuals));
      EXPECT_GT(fastest, 0.2);
      EXPECT_LT(difference, 1e-6 * fastest) << u_c << " " << layers;
      EXPECT_LT(newton.residuals, ida.residuals / 4);
    }
}

TEST(ColumnDirectly, NewtonFromRestGivesTheExactProfileWhateverTheCap) {
  std::printf("eta_max [Pa s], u_c [m/s], layers: L1 error; iterations, residuals, continuation steps\n");
  for (const double eta_max : {1e4, 1e6, 1e8, 1e10}) {
    for (const double u_c : {1e-3, 1e-5, 1e-7}) {
      auto par = tests::table_2(48.8126, 0.012, 0);
      par.regularisation.p_0 = 0.01;
      par.regularisation.cap = rheology::Cap::smooth;
      par.regularisation.eta_max = eta_max;
      par.wall.u_c = u_c;
      par.atol_velocity = 1e-5;  // as scenes have it
      par.grid.spacing = grid::Spacing::clustered;
      par.grid.cluster_depth = 0.003;
      const auto exact = steady::RegularisedProfile::at(tests::steady_layer(par), 48.8126 * tests::degree, 8000);
      for (const int layers : {32, 100, 400}) {
        par.grid.layers = layers;
        const column::Column system(par);
        kinsol::Kinsol direct(system);
        core::Observer nobody;
        const std::vector<double> rest(system.layout().size(), 0.0);
        direct.start(0.0, rest, rest);
        direct.advance(0.0, nobody);
        const auto now = direct.current();
        double error = 0.0;
        for (int k = 0; k < layers; ++k) {
          const double z = system.heights().centre[k] - system.heights().surface();
          error += std::abs(now.y[k] - exact->speed(z)) * system.heights().thickness(k);
        }
        error /= exact->surface_speed() * system.heights().surface();
        std::printf("%.0e %.0e %4d  %.2e  %3lld %4lld %3lld\n", eta_max, u_c, layers, error,
                    static_cast<long long>(now.statistics.newton_iterations),
                    static_cast<long long>(now.statistics.residuals), static_cast<long long>(now.statistics.restarts));
        EXPECT_LT(error, 0.5 / (layers * layers)) << eta_max << ' ' << u_c << ' ' << layers;  // second order
      }
    }
  }
}
}  // namespace
