#include "app/integrator.hpp"

#include "ida/ida.hpp"
#include "kinsol/kinsol.hpp"

namespace talus::app {

std::unique_ptr<core::Integrator> make_integrator(const Scene& scene, const core::DaeSystem& system) {
  if (scene.integration.method == Integration::Method::bdf)
    return std::make_unique<ida::Ida>(system, make_integrator_options(scene));
  kinsol::Options options;
  options.rtol = scene.integration.rtol;
  options.linear.choice = scene.integration.linear_solver;
  return std::make_unique<kinsol::Kinsol>(system, options);
}

}  // namespace talus::app
