#include "layer/flow_shares.hpp"

#include <cmath>

namespace talus::layer {

diagnostics::FlowShares flow_shares(const Layer& layer, const Context& context, std::span<const double> H,
                                    std::span<const CellState> cells) {
  constexpr double slowest = 0.01;
  const auto& par = layer.parameters();
  const int nx = layer.columns().n_columns, nz = layer.columns().n_layers;
  const double thinnest = par.numerics.film * (1.0 + par.numerics.film_blend);
  const auto at = [&](int i, int k) -> const CellState& { return cells[std::size_t(k) * nx + i]; };
  const auto speed = [](const CellState& cell) { return std::hypot(cell.u, cell.w); };
  std::vector<diagnostics::FlowCell> flow;
  for (int k = 0; k < nz; ++k) {
    for (int i = 0; i < nx; ++i) {
      const CellState& cell = at(i, k);
      const bool flows = H[i] > thinnest && speed(cell) > slowest * speed(at(i, nz - 1)) && cell.I >= 0.0;
      const double thickness = context.z[context.at(i, k + 1)] - context.z[context.at(i, k)];
      flow.push_back({cell.I, class_of(cell), flows ? layer.columns().dx() * thickness : 0.0, speed(cell)});
    }
  }
  return diagnostics::flow_shares(par.law, flow);
}

diagnostics::FlowClass class_of(const CellState& cell) {
  return diagnostics::flow_class({cell.mu, cell.nu, cell.q}, cell.capped);
}

}  // namespace talus::layer
