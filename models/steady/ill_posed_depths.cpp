#include "steady/ill_posed_depths.hpp"

#include <cmath>

namespace talus::steady {

namespace {

/// Depths at which `is_inside` holds for the inertial number; it changes only at the numbers `bounds`, ascending.
template <class F>
std::vector<DepthRange> depths_where(F&& is_inside, const std::vector<double>& bounds, const UniformFlow& flow) {
  std::vector<double> edges{0.0};
  for (auto I = bounds.rbegin(); I != bounds.rend(); ++I)
    if (const double depth = flow.depth_of_inertial_number(*I); depth > edges.back()) edges.push_back(depth);
  if (flow.depth() > edges.back()) edges.push_back(flow.depth());
  std::vector<DepthRange> ranges;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (!is_inside(flow.inertial_number(-0.5 * (edges[i] + edges[i + 1])))) continue;
    if (!ranges.empty() && ranges.back().to == edges[i]) ranges.back().to = edges[i + 1];
    else ranges.push_back({edges[i], edges[i + 1]});
  }
  return ranges;
}

}  // namespace

PosednessBounds posedness_bounds(const rheology::Law& law) {
  return {rheology::neutral_points(law), rheology::ellipticity_bounds(law)};
}

IllPosedDepths ill_posed_depths(const UniformFlow& flow, const PosednessBounds& bounds) {
  const auto response_at = [&](double I) { return rheology::response(flow.law(), I); };
  const auto margin = [&](const std::vector<double>& all) {
    return all.empty() ? std::nullopt : std::optional(all.back() - flow.inertial_number(0.0));
  };
  const auto C = [&](double I) { return rheology::condition_C(response_at(I)); };
  const auto q = [&](double I) { return response_at(I).q; };
  const double I_surface = flow.inertial_number(0.0);
  return {.C_surface = C(I_surface),
          .q_surface = q(I_surface),
          .C_positive = depths_where([&](double I) { return C(I) > 0.0; }, bounds.neutral, flow),
          .q_beyond = depths_where([&](double I) { return q(I) >= 1.0; }, bounds.q_is_one, flow),
          .C_margin = margin(bounds.neutral),
          .q_margin = margin(bounds.q_is_one)};
}

}  // namespace talus::steady
