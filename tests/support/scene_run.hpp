#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/integrator.hpp"
#include "app/models.hpp"
#include "app/scene.hpp"

namespace talus::tests {

/// A scene as its model and its integrator run it, begun at t = 0, without files.
class SceneRun {
 public:
  explicit SceneRun(const app::Scene& scene)
      : simulation_(app::model(scene.model).build(scene)),
        integrator_(app::make_integrator(scene, *simulation_.system)) {
    std::vector<double> y(simulation_.system->layout().size()), yp(y);
    simulation_.system->initial_state(0.0, y, yp);
    integrator_->start(0.0, y, yp);
  }

  /// Goes on to time t [s].
  void advance(double t) { integrator_->advance(t, nobody_); }
  [[nodiscard]] core::Snapshot current() const { return integrator_->current(); }
  /// The values of one of the model's fields, by its name.
  [[nodiscard]] std::vector<double> field(const std::string& name) const {
    const auto variables = simulation_.fields->variables();
    const auto found = std::ranges::find(variables, name, &core::Variable::name);
    if (found == variables.end()) throw std::out_of_range("no field named " + name);
    std::vector<std::vector<double>> values;
    simulation_.fields->evaluate(integrator_->current(), values);
    return values.at(found - variables.begin());
  }
  [[nodiscard]] double number(const std::string& name) const { return field(name).at(0); }
  [[nodiscard]] double largest(const std::string& name) const { return std::ranges::max(field(name)); }

 private:
  app::Simulation simulation_;
  std::unique_ptr<core::Integrator> integrator_;
  core::Observer nobody_;
};

}  // namespace talus::tests
