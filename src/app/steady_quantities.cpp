#include "app/steady_quantities.hpp"

#include <array>
#include <limits>
#include <numbers>

namespace talus::app {
namespace {

using S = SteadyFlow;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

constexpr std::array quantities{
    SteadyQuantity{"zeta", "_deg", "degree", "slope of the surface",
                   [](const S& s) { return s.flow.zeta() * 180.0 / std::numbers::pi; }},
    SteadyQuantity{"tan_zeta", "", "1", "tangent of the slope", [](const S& s) { return s.flow.tan_zeta(); }},
    SteadyQuantity{"Q", "_kg_s", "kg s-1", "mass flow (4.13)", [](const S& s) { return s.flux; }},
    SteadyQuantity{"volume_flux", "_m2_s", "m2 s-1", "volume flux per unit width, Q/(rho W)",
                   [](const S& s) { return s.flow.volume_flux_above(s.flow.depth()); }},
    SteadyQuantity{"z_st", "_m", "m", "height below which nothing flows (4.9), from the surface",
                   [](const S& s) { return s.flow.z_st(); }},
    SteadyQuantity{"flowing_depth", "_m", "m", "depth of the flow", [](const S& s) { return s.flow.depth(); }},
    SteadyQuantity{"surface_speed", "_m_s", "m s-1", "speed at the surface",
                   [](const S& s) { return s.surface_speed; }},
    SteadyQuantity{"surface_inertial_number", "", "1", "inertial number at the surface",
                   [](const S& s) { return s.flow.inertial_number(0.0); }},
    SteadyQuantity{"depth_50_percent", "_m", "m", "depth at which the speed is half of that at the surface",
                   [](const S& s) { return s.half_depth; }},
    SteadyQuantity{"depth_1_percent", "_m", "m", "depth at which the speed is 1 % of that at the surface",
                   [](const S& s) { return s.percent_depth; }},
    SteadyQuantity{"averaged_depth", "_m", "m", "depth of the averages: to the base, or to 1 % of the surface speed",
                   [](const S& s) { return s.mean.depth; }},
    SteadyQuantity{"depth_averaged_speed", "_m_s", "m s-1", "mean speed over averaged_depth",
                   [](const S& s) { return s.mean.speed; }},
    SteadyQuantity{"froude_number", "", "1", "depth_averaged_speed/sqrt(g averaged_depth cos(zeta))",
                   [](const S& s) { return s.mean.froude; }},
    SteadyQuantity{"surface_C", "", "1", "C (3.18) at the surface; above 0: ill-posed",
                   [](const S& s) { return s.posed.C_surface; }},
    SteadyQuantity{"C_margin_in_I", "", "1", "highest neutral point less the inertial number at the surface",
                   [](const S& s) { return s.posed.C_margin.value_or(none); }},
    SteadyQuantity{"surface_q", "", "1", "mu - I mu'/2 at the surface; from 1 on the pressure equation is not elliptic",
                   [](const S& s) { return s.posed.q_surface; }},
    SteadyQuantity{"q_margin_in_I", "", "1", "inertial number of q = 1 less that at the surface",
                   [](const S& s) { return s.posed.q_margin.value_or(none); }},
};

rheology::Response response_at(const S& s, std::size_t i) {
  return rheology::response(s.flow.law(), s.flow.inertial_number(-s.depths[i]));
}

constexpr std::array profiles{
    SteadyProfile{"depth", "_m", "m", "depth below the surface, normal to it",
                  [](const S& s, std::size_t i) { return s.depths[i]; }},
    SteadyProfile{"speed", "_m_s", "m s-1", "speed, the integral of (4.12)",
                  [](const S& s, std::size_t i) { return s.speeds[i]; }},
    SteadyProfile{"friction", "", "1", "mu (4.8)",
                  [](const S& s, std::size_t i) { return s.flow.friction(-s.depths[i]); }},
    SteadyProfile{"inertial_number", "", "1", "I (4.11)",
                  [](const S& s, std::size_t i) { return s.flow.inertial_number(-s.depths[i]); }},
    SteadyProfile{"C", "", "1", "C (3.18); above 0: ill-posed",
                  [](const S& s, std::size_t i) { return rheology::condition_C(response_at(s, i)); }},
    SteadyProfile{"q", "", "1", "mu - I mu'/2; from 1 on the pressure equation is not elliptic",
                  [](const S& s, std::size_t i) { return response_at(s, i).q; }},
};

}  // namespace

std::span<const SteadyQuantity> steady_quantities() { return quantities; }
std::span<const SteadyProfile> steady_profiles() { return profiles; }

}  // namespace talus::app
