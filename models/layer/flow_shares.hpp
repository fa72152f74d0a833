#pragma once

#include <span>

#include "diagnostics/flow_shares.hpp"
#include "layer/cell_state.hpp"

namespace talus::layer {

/// Shares of what flows: cells faster than 1 % of their column's surface in columns well above the film, in which u means nothing.
/// `H`: of each column. `cells`: shape (n_layers, n_columns). `context` must be that of the state.
diagnostics::FlowShares flow_shares(const Layer& layer, const Context& context, std::span<const double> H,
                                    std::span<const CellState> cells);

/// The class of a cell, flowing or not.
diagnostics::FlowClass class_of(const CellState& cell);

}  // namespace talus::layer
