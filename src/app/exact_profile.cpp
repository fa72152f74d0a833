#include "app/exact_profile.hpp"

#include <algorithm>

namespace talus::app {
namespace {

constexpr std::size_t n_points = 201;
constexpr double drawn_over_depth = 1.5;  ///< the creeping tail, too

}  // namespace

ExactProfile::ExactProfile(const Theory& theory) {
  if (!theory.steady) return;
  const auto& steady = *theory.steady;
  const double lowest = std::min(drawn_over_depth * steady.depth, steady.thickness);
  values_.resize(3);
  for (std::size_t i = 0; i < n_points; ++i) {
    const double depth = lowest * static_cast<double>(i) / static_cast<double>(n_points - 1);
    values_[0].push_back(depth);
    values_[1].push_back(steady.flow.speed(-depth));
    values_[2].push_back(steady.flow.inertial_number(-depth));
  }
}

std::vector<std::pair<std::string, std::size_t>> ExactProfile::dimensions() const {
  if (values_.empty()) return {};
  return {{"exact_point", n_points}};
}

std::vector<core::Variable> ExactProfile::variables() const {
  if (values_.empty()) return {};
  constexpr auto storage = core::Storage::double_precision;
  return {{"exact_depth", {"exact_point"}, "m", "depth normal to the surface of the exact steady flow", storage, true},
          {"exact_speed", {"exact_point"}, "m s-1", "speed of the exact steady flow, u_c -> 0", storage, true},
          {"exact_inertial_number", {"exact_point"}, "1", "inertial number of the exact steady flow", storage, true}};
}

void ExactProfile::evaluate(const core::Snapshot&, std::vector<std::vector<double>>& values) { values = values_; }

}  // namespace talus::app
