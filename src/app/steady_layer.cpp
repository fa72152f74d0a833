#include "app/steady_layer.hpp"

#include <algorithm>
#include <cmath>

#include "app/column_model.hpp"
#include "app/layer_model.hpp"
#include "app/uniform_layer.hpp"

namespace talus::app {
namespace {

layer::Parameters ring(const Scene& scene, int n_columns) {
  auto par = make_layer_parameters(uniform_layer_at_rest(scene));
  const double dx =
      scene.cells.columns > 0 ? scene.box.length / scene.cells.columns : par.initial.thickness / par.grid.layers;
  par.grid.columns = n_columns;
  par.box.length = n_columns * dx;
  return par;
}

}  // namespace

SteadyLayer::SteadyLayer(const Scene& scene, int n_columns)
    : column_(make_column_parameters(uniform_layer_at_rest(scene))), layer_(ring(scene, n_columns)) {
  u_ = steady_speeds(column_, scene);
  y_.resize(layer_.layout().size());
  std::vector<double> rates(y_.size()), left(y_.size());
  layer_.initial_state(0.0, y_, rates);
  const auto& at = layer_.unknowns();
  for (int f = 0; f < n_columns; ++f)
    for (std::size_t k = 0; k < u_.size(); ++k) y_[at.u(f, static_cast<int>(k))] = u_[k];
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
