#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace talus::study {

/// What one choice costs and how far its answer is off; NaN in either stands for a choice that gave no answer.
struct Priced {
  double cost;   ///< in any unit
  double error;  ///< in any unit, at least 0
};

/// The choices that no other one beats in cost and error at once, from the cheapest to the dearest: each is more accurate than all
/// that are cheaper. Of equals the first stands.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const Priced> choices);

/// The cheapest choice whose error is at most `error`.
[[nodiscard]] std::optional<std::size_t> cheapest_within(std::span<const Priced> choices, double error);

/// Exponent n of cost = c size^n by least squares of the logarithms; nothing for fewer than two different sizes. Precondition: all
/// positive, of one length.
[[nodiscard]] std::optional<double> growth_exponent(std::span<const double> sizes, std::span<const double> costs);

}  // namespace talus::study
