#include "diagnostics/flow_shares.hpp"

namespace talus::diagnostics {

FlowShares flow_shares(const rheology::Law& law, std::span<const FlowCell> cells) {
  std::vector<double> I, area, flux;
  std::vector<FlowClass> classes;
  for (const auto& cell : cells) {
    I.push_back(cell.I);
    classes.push_back(cell.flow_class);
    area.push_back(cell.area);
    flux.push_back(cell.area > 0.0 ? cell.area * cell.speed : 0.0);
  }
  return {ill_posedness(law, I, area), class_shares(classes, area), class_shares(classes, flux)};
}

std::vector<ShareNumber> share_numbers() {
  std::vector<ShareNumber> all{{"ill_posed_share", "share of the flowing area in which C of (3.18) is positive",
                                [](const FlowShares& s) { return s.criteria.C_positive; }},
                               {"growing_share", "share of the flowing area in which short waves grow by linear theory",
                                [](const FlowShares& s) { return s.criteria.growing; }},
                               {"not_elliptic_share", "share of the flowing area in which mu - I mu'/2 is not below 1",
                                [](const FlowShares& s) { return s.criteria.not_elliptic; }}};
  for (std::size_t c = 0; c < n_flow_classes; ++c) {
    const std::string name = std::string("class_") + flow_class_words.at(c);
    const std::string where = std::string(" where ") + flow_class_meanings.at(c);
    all.push_back({name + "_area", "share of the flowing area" + where, [c](const auto& s) { return s.area.at(c); }});
    all.push_back(
        {name + "_flux", "share of the flux, speed times area," + where, [c](const auto& s) { return s.flux.at(c); }});
  }
  return all;
}

}  // namespace talus::diagnostics
