#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/fit_report.hpp"
#include "core/errors.hpp"
#include "steady/slope.hpp"

namespace talus::app {
namespace {

using Numbers = std::vector<double>;
using Words = std::vector<std::string>;

constexpr double degree = std::numbers::pi / 180.0;

/// None also where a quadrature fails, within rounding of the law's steepest slope.
std::optional<double> slope_at(const steady::Channel& channel, double Q) {
  try {
    if (const auto slope = steady::slope_of_flux(channel, Q)) return *slope;
  } catch (const core::Error&) { return {}; }
  return {};
}

}  // namespace

FitSection slope_curve(const FitFile& file, const fit::Fit& fit) {
  Numbers all;
  for (const auto* points : {&file.problem.slopes, &file.held_back})
    for (const auto& point : *points) all.push_back(point.Q);
  for (const auto& profile : file.problem.profiles)
    if (profile.Q) all.push_back(*profile.Q);
  Numbers flow, zeta;
  if (!all.empty()) {
    const auto [least, most] = std::ranges::minmax(all);
    for (int i = 0; i <= 60; ++i) {
      const double Q = least * 0.75 * std::pow(most / least / 0.75 * 1.25, i / 60.0);
      if (const auto slope = slope_at(fit.best.channel, Q)) flow.push_back(Q), zeta.push_back(*slope / degree);
    }
  }
  return {"curve",
          "Slope against flow",
          {{"Q_kg_s", "kg s-1", "mass flow", flow}, {"zeta_deg", "degree", "slope of the best model", zeta}}};
}

FitSection speed_curves(const FitFile& file, const fit::Fit& fit) {
  Words place;
  Numbers depth, speed;
  std::size_t variable = file.problem.unknowns.size();
  for (const auto& profile : file.problem.profiles) {
    const double offset = profile.offset_limit > 0.0 ? fit.x[static_cast<Eigen::Index>(variable++)] : 0.0;
    const auto flow = profile.Q ? steady::flow_of_flux(fit.best.channel, *profile.Q)
                                : steady::UniformFlow::at(fit.best.channel, *profile.zeta);
    const double end = 1.1 * (std::ranges::max(profile.depth) + offset);
    for (int i = 0; i <= 60; ++i) {
      const double h = end * i / 60.0;
      place.push_back(profile.name), depth.push_back(h - offset), speed.push_back(flow->speed(-h));
    }
  }
  return {"profile_curve",
          "Speed against depth",
          {{"place", "", "profile", place},
           {"depth_m", "m", "below what was taken for the surface", depth},
           {"speed_m_s", "m s-1", "speed of the best model", speed}}};
}

}  // namespace talus::app
