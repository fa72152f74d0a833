#include "diagnostics/flow_class.hpp"

#include <stdexcept>

namespace talus::diagnostics {

std::string flow_class_legend() {
  std::string legend;
  for (std::size_t c = 0; c < n_flow_classes; ++c)
    legend += (c > 0 ? ", " : "") + std::to_string(c) + " " + flow_class_meanings.at(c);
  return legend;
}

std::vector<std::string> flow_class_flags() { return {flow_class_words.begin(), flow_class_words.end()}; }

FlowClass flow_class(const rheology::Response& response, bool capped) {
  if (capped) return FlowClass::capped;
  switch (rheology::well_posedness(response)) {
    case rheology::WellPosedness::well_posed: return FlowClass::well_posed;
    case rheology::WellPosedness::damped: return FlowClass::damped;
    case rheology::WellPosedness::ill_posed: break;
  }
  return FlowClass::ill_posed;
}

double growth_per_square(const rheology::Response& response, bool capped, double eta, double rho) {
  return (capped ? -1.0 : rheology::max_growth(response)) * eta / rho;
}

ClassShares class_shares(std::span<const FlowClass> classes, std::span<const double> weight) {
  if (classes.size() != weight.size()) throw std::invalid_argument("class_shares: classes and weights differ in size");
  ClassShares shares{};
  double total = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (!(weight[i] >= 0.0)) throw std::invalid_argument("class_shares: a weight is negative or not a number");
    shares.at(static_cast<std::size_t>(classes[i])) += weight[i];
    total += weight[i];
  }
  if (total > 0.0)
    for (double& share : shares) share /= total;
  return shares;
}

}  // namespace talus::diagnostics
