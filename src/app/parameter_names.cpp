#include "app/parameter_names.hpp"

namespace talus::app {

NamedNumbers named_parameters(const rheology::Law& law) {
  if (const auto* constant = std::get_if<rheology::Constant>(&law)) return {{"mu_s", constant->mu_s}};
  if (const auto* c = std::get_if<rheology::Classical>(&law))
    return {{"mu_s", c->mu_s}, {"mu_d", c->mu_d}, {"I_0", c->I_0}};
  const auto& p = std::get<rheology::PartiallyRegularised>(law);
  return {{"mu_s", p.mu_s}, {"mu_d", p.mu_d}, {"mu_inf", p.mu_inf}, {"I_0", p.I_0}, {"I_N", p.I_N}, {"alpha", p.alpha}};
}

NamedNumbers named_parameters(const steady::Channel& c) {
  NamedNumbers out{{"rho_star_kg_m3", c.grains.rho_star},
                   {"Phi", c.grains.Phi},
                   {"d_m", c.grains.d},
                   {"gap_m", c.gap},
                   {"mu_w", c.mu_w},
                   {"gravity_m_s2", c.gravity}};
  const auto of_law = named_parameters(c.law);
  out.insert(out.end(), of_law.begin(), of_law.end());
  if (const auto* partial = std::get_if<rheology::PartiallyRegularised>(&c.law)) out.emplace_back("A", partial->A);
  return out;
}

}  // namespace talus::app
