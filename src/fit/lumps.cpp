#include "fit/lumps.hpp"

#include <cmath>
#include <initializer_list>
#include <utility>

namespace talus::fit {

namespace {

using steady::Gradient;
using P = steady::Parameter;

Gradient powers(std::initializer_list<std::pair<P, double>> all) {
  Gradient out{};
  for (const auto& [parameter, power] : all) out[static_cast<std::size_t>(parameter)] = power;
  return out;
}

}  // namespace

std::vector<Lump> lumps(const steady::VariedChannel& varied) {
  const double root = std::sqrt(varied.channel.gravity);
  const Lump rate{"rate factor", "sqrt(Phi g)/d", "m-0.5 s-1", powers({{P::Phi, 0.5}, {P::d, -1.0}}), root};
  const Lump flux{"flux factor K", "rho_star Phi W sqrt(Phi g)/d (W/mu_w)^(5/2)", "kg s-1",
                  powers({{P::rho_star, 1.0}, {P::Phi, 1.5}, {P::W, 3.5}, {P::mu_w, -2.5}, {P::d, -1.0}}), root};
  std::vector<Lump> out{
      {"friction gradient", "mu_w/W", "m-1", powers({{P::mu_w, 1.0}, {P::W, -1.0}}), 1.0},
      rate,
      {"mass per area", "rho_star Phi W", "kg m-2", powers({{P::rho_star, 1.0}, {P::Phi, 1.0}, {P::W, 1.0}}), 1.0},
      flux};
  const auto* partial = std::get_if<rheology::PartiallyRegularised>(&varied.channel.law);
  const bool scales =
      std::holds_alternative<rheology::Classical>(varied.channel.law) || (partial != nullptr && varied.I_N_follows);
  if (!scales) return out;
  const auto times_I_0 = [](Lump lump) {
    lump.name += " times I_0", lump.formula = "I_0 " + lump.formula;
    lump.power[static_cast<std::size_t>(P::I_0)] = 1.0;
    return lump;
  };
  out.push_back(times_I_0(rate));
  out.push_back(times_I_0(flux));
  if (partial != nullptr)
    out.push_back({"rise at large I", "mu_inf I_0", "1", powers({{P::mu_inf, 1.0}, {P::I_0, 1.0}}), 1.0});
  return out;
}

double value_of(const Lump& lump, const Gradient& parameters) {
  double value = lump.factor;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (lump.power[i] != 0.0) value *= std::pow(parameters[i], lump.power[i]);
  return value;
}

}  // namespace talus::fit
