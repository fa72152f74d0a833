#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "output/table_file.hpp"
#include "symbol/growth_map.hpp"

namespace talus::app {

/// The Fourier symbol of the layer's operator for a scene's law over inertial numbers and grids, against the closed form.
struct SymbolStudy {
  std::vector<double> I;
  std::vector<int> sizes;  ///< cells a side, powers of 2, ascending
  double length;           ///< of the square that they part [m]: the depth that flows, or the layer's thickness
  /// Fastest waves over the shear rate, shape (I, size): of the layer, of the textbook staggered grid with direct and with averaged viscosity.
  std::vector<symbol::FastestWave> layer, direct, averaged;
  std::vector<double> unit;       ///< eta/(rho h^2) over the shear rate, shape (I, size): what growth is counted in
  std::vector<double> closed;     ///< rheology::max_growth at each I, over eta k^2/rho
  std::vector<double> condition;  ///< C of (3.18)
  std::vector<double> q;          ///< mu - I mu'/2
  std::vector<std::vector<double>> damped_from_to;     ///< ranges of I in which no wave grows, by the linear theory
  std::vector<std::vector<double>> condition_from_to;  ///< and in which C is not positive

  [[nodiscard]] const symbol::FastestWave& at(const std::vector<symbol::FastestWave>& map, std::size_t i,
                                              std::size_t size) const {
    return map[i * sizes.size() + size];
  }
};

/// What the grids say of one inertial number.
struct SymbolVerdict {
  enum class Word : std::uint8_t { well_posed, ill_posed, cannot_tell };
  Word word;
  int first_seen;   ///< the coarsest grid with a growing wave; 0: none
  double exponent;  ///< n of a rate that grows as k^n, from the two finest grids; NaN where nothing grows there
};
std::string_view word_of(SymbolVerdict::Word word);

/// `sizes`: powers of 2, ascending. Throws std::invalid_argument otherwise. `jobs`: inertial numbers at a time; 0: one on each core.
SymbolStudy symbol_study(const Scene& scene, const std::vector<double>& I, const std::vector<int>& sizes, int jobs);

/// Ill-posed where waves grow on the two finest grids, at a rate that rises with the grid's wave number (n > 1); well-posed where none grows on
/// any; else the grids cannot tell, and one twice as fine may.
SymbolVerdict verdict_at(const SymbolStudy& study, std::size_t i);

/// In words, for people.
std::string sentence_of(const SymbolStudy& study);
nlohmann::ordered_json json_of(const SymbolStudy& study);
/// Adds variables symbol_... along `symbol_I` and `symbol_cells`.
void add_to(output::Table& table, const SymbolStudy& study);

}  // namespace talus::app
