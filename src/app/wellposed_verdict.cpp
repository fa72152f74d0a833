#include "app/wellposed_verdict.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "app/growth_report.hpp"
#include "app/table.hpp"

namespace talus::app {

WellposedVerdict verdict_of(const GrowthStudy& study) {
  using study::GrowthTendency;
  const std::string by = fmt::format("disturbances in time on {} grids", study.rows.front().runs.size());
  switch (study.verdict.tendency) {
    case GrowthTendency::decays:
    case GrowthTendency::converges: return {"convergent", {}, "", by};
    case GrowthTendency::blows_up: return {"blows up", study.verdict.exponent, "", by};
    case GrowthTendency::not_convergent: return {"not convergent", {}, "", by};
    case GrowthTendency::cannot_tell: break;
  }
  return {"cannot tell", {}, grid_that_may_tell(study), by};
}

std::optional<WellposedVerdict> verdict_of(const SymbolStudy& study, std::optional<double> most) {
  using Word = SymbolVerdict::Word;
  int n = 0;
  bool ill = false, unknown = false;
  double exponent = 0.0, lowest = 0.0, highest = 0.0;
  for (std::size_t i = 0; i < study.I.size(); ++i) {
    if (most && study.I[i] > *most) continue;
    lowest = n > 0 ? std::min(lowest, study.I[i]) : study.I[i];
    highest = std::max(highest, study.I[i]);
    ++n;
    const auto at = verdict_at(study, i);
    if (at.word == Word::ill_posed) exponent = std::max(exponent, at.exponent);
    ill = ill || at.word == Word::ill_posed;
    unknown = unknown || at.word == Word::cannot_tell;
  }
  if (n == 0) return std::nullopt;
  const std::string by = fmt::format("the symbol at I from {:.3g} to {:.3g}{}", lowest, highest,
                                     most ? ", as far as the scene's steady flow goes" : "");
  if (ill) return WellposedVerdict{"blows up", exponent, "", by};
  const int finer = 2 * study.sizes.back();
  if (unknown) return WellposedVerdict{"cannot tell", {}, fmt::format("{}x{}", finer, finer), by};
  return WellposedVerdict{"convergent", {}, "", by};
}

std::string sentence_of(const WellposedVerdict& verdict) {
  std::string out = "Verdict: " + verdict.word;
  if (verdict.exponent) out += fmt::format(" with a rate as k^{:.2f}", *verdict.exponent);
  if (!verdict.grid.empty()) out += " from these grids, " + verdict.grid + " cells may";
  return out + "; by " + verdict.by + ".";
}

nlohmann::ordered_json json_of(const WellposedVerdict& verdict) {
  const auto or_null = [](bool there, auto value) {
    return there ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  };
  return {{"verdict", verdict.word},
          {"rate_exponent", or_null(verdict.exponent.has_value(), verdict.exponent.value_or(0.0))},
          {"grid_that_may_tell", or_null(!verdict.grid.empty(), verdict.grid)},
          {"by", verdict.by}};
}

}  // namespace talus::app
