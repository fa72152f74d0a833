#pragma once

#include <span>
#include <vector>

namespace talus::diagnostics {

/// Observed orders of convergence between neighbours in a table: log(e_i/e_(i+1))/log(h_i/h_(i+1)); shape one less than
/// the table. h: cell sizes, e: errors, both positive, h without repeats. Throws std::invalid_argument otherwise or for
/// fewer than two rows.
[[nodiscard]] std::vector<double> observed_orders(std::span<const double> h, std::span<const double> e);

/// One order for the whole table: the slope of the least-squares line through (log h, log e).
[[nodiscard]] double fitted_order(std::span<const double> h, std::span<const double> e);

}  // namespace talus::diagnostics
