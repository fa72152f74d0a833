#include "app/steady_layer.hpp"

#include <algorithm>
#include <cmath>

#include "app/column_model.hpp"
#include "app/layer_model.hpp"
#include "core/errors.hpp"
#include "kinsol/kinsol.hpp"

namespace talus::app {
namespace {

const Scene& checked(const Scene& scene) {
  if (scene.model != "layer" && scene.model != "column")
    throw core::ConfigError("study wellposed: expected model.name = \"layer\" or \"column\", found \"" + scene.model +
                            "\"");
  if (!scene.box.periodic || scene.box.lid || scene.inflow.rate > 0.0 ||
      scene.box.base != experiment::Contact::no_slip || scene.box.base_speed != 0.0 || scene.box.base_slope != 0.0)
    throw core::ConfigError(
        "study wellposed: waves need a uniform layer: expected box.periodic = true, a free surface, no inflow, and a "
        "base to which grains stick, "
        "at rest and along x");
  return scene;
}

/// The box as it stands at the end, for good.
Scene still(Scene scene) {
  scene.box = experiment::box_at(scene.box, scene.motion, scene.end);
  scene.motion = {};
  scene.initial.state = Initial::State::rest;
  return scene;
}

layer::Parameters ring(const Scene& scene, int n_columns) {
  auto par = make_layer_parameters(still(scene));
  const double dx =
      scene.cells.columns > 0 ? scene.box.length / scene.cells.columns : par.initial.thickness / par.grid.layers;
  par.grid.columns = n_columns;
  par.box.length = n_columns * dx;
  return par;
}

}  // namespace

SteadyLayer::SteadyLayer(const Scene& scene, int n_columns)
    : column_(make_column_parameters(still(checked(scene)))), layer_(ring(scene, n_columns)) {
  core::Observer nobody;
  kinsol::Options options;
  options.rtol = std::min(scene.integration.rtol, 1e-8);
  kinsol::Kinsol steady(column_, options);
  const auto n = static_cast<std::size_t>(column_.layout().size());
  steady.start(0.0, std::vector<double>(n, 0.0), std::vector<double>(n, 0.0));
  steady.advance(scene.end, nobody);
  const auto now = steady.current();
  u_.assign(now.y.begin(), now.y.end());
  y_.resize(layer_.layout().size());
  std::vector<double> rates(y_.size()), left(y_.size());
  layer_.initial_state(0.0, y_, rates);
  const auto& at = layer_.unknowns();
  for (int f = 0; f < n_columns; ++f)
    for (std::size_t k = 0; k < n; ++k) y_[at.u(f, static_cast<int>(k))] = u_[k];
  layer_.residual(0.0, y_, rates, left);
  const auto& par = layer_.parameters();
  const double weight = par.grains.rho() * par.box.gravity * thickness() * layer_.columns().dx();
  for (const double each : left) residual_ = std::max(residual_, std::abs(each) / weight);
}

double SteadyLayer::froude() const {
  double flow = 0.0;
  for (std::size_t k = 0; k < u_.size(); ++k) flow += u_[k] * column_.heights().thickness(static_cast<int>(k));
  const auto& box = layer_.parameters().box;
  return flow / thickness() / std::sqrt(box.gravity * thickness() * std::cos(box.tilt));
}

}  // namespace talus::app
