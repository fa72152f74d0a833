#include "bridge/failure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

namespace talus::bridge {

std::string report(const Failure& failure, const core::DaeSystem& system, std::span<const double> size,
                   std::span<const double> y) {
  constexpr std::size_t n_rows = 10;
  std::ostringstream text;
  text << failure.what;
  if (!failure.refusal.empty()) text << "\n  last refused: " << failure.refusal;

  const auto rank = [size](core::Index i) { return std::isnan(size[i]) ? HUGE_VAL : std::abs(size[i]); };
  std::vector<core::Index> rows(size.size());
  std::iota(rows.begin(), rows.end(), core::Index{0});
  const auto end = rows.begin() + static_cast<std::ptrdiff_t>(std::min(n_rows, rows.size()));
  std::partial_sort(rows.begin(), end, rows.end(), [&](core::Index a, core::Index b) { return rank(a) > rank(b); });
  rows.erase(std::find_if(rows.begin(), end, [&](core::Index i) { return rank(i) == 0.0; }), rows.end());
  if (!rows.empty()) text << "\n  worst rows by " << failure.measure << ':';
  text.precision(4);
  for (const core::Index i : rows) {
    text << "\n    " << size[i] << "  " << system.describe(i) << ", value " << y[i] << ' '
         << system.layout().field(i).unit;
  }
  return text.str();
}

}  // namespace talus::bridge
