#include "app/parameter_names.hpp"

namespace talus::app {

std::vector<std::pair<std::string, double>> named_parameters(const steady::Channel& c) {
  std::vector<std::pair<std::string, double>> out{{"rho_star_kg_m3", c.grains.rho_star},
                                                  {"Phi", c.grains.Phi},
                                                  {"d_m", c.grains.d},
                                                  {"gap_m", c.gap},
                                                  {"mu_w", c.mu_w},
                                                  {"gravity_m_s2", c.gravity}};
  std::visit(
      [&](const auto& law) {
        out.emplace_back("mu_s", law.mu_s);
        if constexpr (requires { law.I_0; }) {
          out.emplace_back("mu_d", law.mu_d);
          out.emplace_back("I_0", law.I_0);
        }
        if constexpr (requires { law.mu_inf; }) {
          out.emplace_back("mu_inf", law.mu_inf);
          out.emplace_back("alpha", law.alpha);
          out.emplace_back("I_N", law.I_N);
          out.emplace_back("A", law.A);
        }
      },
      c.law);
  return out;
}

}  // namespace talus::app
