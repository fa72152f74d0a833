#include "kinsol/held_system.hpp"

#include <algorithm>
#include <cmath>

namespace talus::kinsol {

HeldSystem::HeldSystem(const core::DaeSystem& system) : system_(system) {
  const auto& pattern = system.pattern();
  const auto starts = pattern.column_starts();
  for (core::Index j = 0; j < pattern.n(); ++j) {
    if (starts[j + 1] == starts[j] + 1 && pattern.rows()[starts[j]] == j) alone_.push_back(j);
  }
}

void HeldSystem::hold(double t, std::span<const double> y) {
  release();
  if (alone_.empty()) return;
  const auto starts = pattern().column_starts();
  const std::vector<double> at_rest(y.size(), 0.0);
  std::vector<double> elsewhere(y.begin(), y.end()), here_values(pattern().n_nonzeros()), values(here_values.size());
  // A slope may vanish at y by chance, as that of y^2 does at 0.
  for (const auto j : alone_) elsewhere[j] += std::max(std::abs(y[j]), layout().field(j).absolute_tolerance);
  system_.jacobian(t, y, at_rest, 0.0, here_values);
  system_.jacobian(t, elsewhere, at_rest, 0.0, values);
  for (const auto j : alone_) {
    if (here_values[starts[j]] == 0.0 && values[starts[j]] == 0.0) held_.push_back({j, y[j]});
  }
  const auto rows = pattern().rows();
  for (core::Index k = 0; k < pattern().n_nonzeros(); ++k) {
    if (holds(rows[k])) row_entries_.push_back(k);
  }
}

void HeldSystem::release() {
  held_.clear();
  row_entries_.clear();
}

bool HeldSystem::holds(core::Index unknown) const {
  return std::any_of(held_.begin(), held_.end(), [unknown](const Held& held) { return held.unknown == unknown; });
}

void HeldSystem::residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const {
  system_.residual(t, y, yp, r);
  for (const auto& held : held_) r[held.unknown] = y[held.unknown] - held.value;
}

void HeldSystem::jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                          std::span<double> values) const {
  system_.jacobian(t, y, yp, c_j, values);
  for (const auto k : row_entries_) values[k] = 0.0;
  for (const auto& held : held_) values[pattern().column_starts()[held.unknown]] = 1.0;
}

}  // namespace talus::kinsol
