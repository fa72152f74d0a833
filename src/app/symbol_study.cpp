#include "app/symbol_study.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <cmath>
#include <limits>

#include "app/side_by_side.hpp"
#include "app/table.hpp"
#include "app/theory.hpp"
#include "rheology/neutral_points.hpp"
#include "symbol/sheared_layer.hpp"
#include "symbol/staggered_symbol.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;
using symbol::CornerViscosity;
using symbol::FastestWave;

double length_of(const Scene& scene) {
  const auto theory = theory_of(scene);
  return theory.steady ? theory.steady->depth : scene.initial.thickness;
}

std::vector<std::vector<double>> pairs(const std::vector<rheology::Range>& ranges) {
  std::vector<std::vector<double>> out;
  for (const auto& range : ranges) out.push_back({range.from, range.to});
  return out;
}

/// All of one inertial number.
struct Point {
  rheology::Response response;
  std::vector<double> unit;
  std::vector<FastestWave> layer, direct, averaged;
};

Point point_at(const Scene& scene, double I, const std::vector<int>& sizes, double length) {
  Point point{};
  point.response = rheology::response(scene.law, I);
  const double per_square = rheology::growth_scale(scene.grains, point.response, I, 1.0);
  for (const int n : sizes) point.unit.push_back(per_square * std::pow(n / length, 2));
  // Growth comes in units of eta/(rho h^2).
  const auto scaled = [&](const auto& growth) {
    auto waves = symbol::fastest_waves(growth, sizes);
    for (std::size_t s = 0; s < sizes.size(); ++s) waves[s].growth *= point.unit[s];
    return waves;
  };
  const auto staggered = [&](CornerViscosity viscosity) {
    return scaled([&](double x, double z) { return symbol::staggered_growth(point.response, viscosity, x, z); });
  };
  const symbol::ShearedLayer flow(scene.grains, scene.law, I, 1.0);
  point.layer = scaled([&](double x, double z) { return flow.growth(x, z).real() / flow.shear() / per_square; });
  point.direct = staggered(CornerViscosity::direct);
  point.averaged = staggered(CornerViscosity::averaged);
  return point;
}

void append(std::vector<FastestWave>& map, const std::vector<FastestWave>& row) {
  map.insert(map.end(), row.begin(), row.end());
}

std::string ranges_text(const std::vector<std::vector<double>>& ranges) {
  std::string out;
  for (const auto& range : ranges)
    out += (out.empty() ? "" : ", ") + (std::isfinite(range[1]) ? fmt::format("{:.5g} to {:.5g}", range[0], range[1])
                                                                : fmt::format("above {:.5g}", range[0]));
  return out.empty() ? "nowhere" : out;
}

/// Runs of neighbouring inertial numbers with one word.
std::string runs_with(const SymbolStudy& study, SymbolVerdict::Word word) {
  std::string out;
  for (std::size_t i = 0; i < study.I.size(); ++i) {
    if (verdict_at(study, i).word != word) continue;
    const std::size_t first = i;
    while (i + 1 < study.I.size() && verdict_at(study, i + 1).word == word) ++i;
    out += (out.empty() ? "" : ", ") + (first == i ? fmt::format("{:.3g}", study.I[i])
                                                   : fmt::format("{:.3g} to {:.3g}", study.I[first], study.I[i]));
  }
  return out;
}

}  // namespace

std::string_view word_of(SymbolVerdict::Word word) {
  constexpr std::array<std::string_view, 3> words{"well-posed", "ill-posed", "cannot tell"};
  return words.at(static_cast<std::size_t>(word));
}

SymbolStudy symbol_study(const Scene& scene, const std::vector<double>& I, const std::vector<int>& sizes, int jobs) {
  SymbolStudy study{};
  study.I = I;
  study.sizes = sizes;
  study.length = length_of(scene);
  study.damped_from_to = pairs(rheology::ranges_of_damping(scene.law));
  study.condition_from_to = pairs(rheology::ranges_of_condition(scene.law));
  std::vector<Point> points(I.size());
  side_by_side(I.size(), jobs, [&](std::size_t i) { points[i] = point_at(scene, I[i], sizes, study.length); });
  for (const auto& point : points) {
    study.closed.push_back(rheology::max_growth(point.response));
    study.condition.push_back(rheology::condition_C(point.response));
    study.q.push_back(point.response.q);
    study.unit.insert(study.unit.end(), point.unit.begin(), point.unit.end());
    append(study.layer, point.layer);
    append(study.direct, point.direct);
    append(study.averaged, point.averaged);
  }
  return study;
}

SymbolVerdict verdict_at(const SymbolStudy& study, std::size_t i) {
  SymbolVerdict verdict{SymbolVerdict::Word::cannot_tell, 0, std::numeric_limits<double>::quiet_NaN()};
  const auto growth = [&](std::size_t s) { return study.at(study.layer, i, s).growth; };
  const std::size_t n = study.sizes.size();
  for (std::size_t s = n; s-- > 0;)
    if (growth(s) > 0.0) verdict.first_seen = study.sizes[s];
  if (verdict.first_seen == 0) {
    verdict.word = SymbolVerdict::Word::well_posed;
  } else if (n >= 2 && growth(n - 1) > 0.0 && growth(n - 2) > 0.0) {
    verdict.exponent =
        std::log2(growth(n - 1) / growth(n - 2)) / std::log2(double(study.sizes[n - 1]) / study.sizes[n - 2]);
    if (verdict.exponent > 1.0) verdict.word = SymbolVerdict::Word::ill_posed;
  }
  return verdict;
}

std::string sentence_of(const SymbolStudy& study) {
  using Word = SymbolVerdict::Word;
  std::string out = fmt::format("Symbol, grids of {} to {} cells over {:.3g} mm: ", study.sizes.front(),
                                study.sizes.back(), 1e3 * study.length);
  const auto ill = runs_with(study, Word::ill_posed), unknown = runs_with(study, Word::cannot_tell);
  if (ill.empty() && unknown.empty()) {
    out += "no wave grows at any I";
  } else {
    out += ill.empty() ? "nowhere ill-posed" : "ill-posed at I = " + ill;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    int seen = 0;
    for (std::size_t i = 0; i < study.I.size(); ++i) {
      const auto verdict = verdict_at(study, i);
      if (verdict.word != Word::ill_posed) continue;
      least = std::min(least, verdict.exponent);
      most = std::max(most, verdict.exponent);
      seen = std::max(seen, verdict.first_seen);
    }
    if (!ill.empty())
      out += fmt::format(" (the rate grows as k^{:.2f} to k^{:.2f}; every such I shows it from {} cells on)", least,
                         most, seen);
    if (!unknown.empty()) out += fmt::format("; cannot tell at I = {}: {} cells may", unknown, 2 * study.sizes.back());
  }
  return out + fmt::format(". By linear theory no wave grows at I {}; C of (3.18) is not positive at I {}.",
                           ranges_text(study.damped_from_to), ranges_text(study.condition_from_to));
}

Json json_of(const SymbolStudy& study) {
  Json points = Json::array();
  for (std::size_t i = 0; i < study.I.size(); ++i) {
    const auto verdict = verdict_at(study, i);
    Json rates = Json::array(), hidden = Json::array();
    for (std::size_t s = 0; s < study.sizes.size(); ++s) {
      rates.push_back(json_of(study.at(study.layer, i, s).growth));
      hidden.push_back(json_of(study.at(study.averaged, i, s).growth));
    }
    points.push_back({{"I", study.I[i]},
                      {"verdict", word_of(verdict.word)},
                      {"first_seen_at_cells", verdict.first_seen > 0 ? Json(verdict.first_seen) : Json(nullptr)},
                      {"rate_exponent", json_of(verdict.exponent)},
                      {"grows_by_linear_theory", study.closed[i] > 0.0},
                      {"C", json_of(study.condition[i])},
                      {"q", json_of(study.q[i])},
                      {"growth_over_shear", std::move(rates)},
                      {"growth_over_shear_with_averaged_viscosity", std::move(hidden)}});
  }
  return {
      {"words", sentence_of(study)}, {"cells", study.sizes}, {"length_m", study.length}, {"points", std::move(points)}};
}

void add_to(output::Table& table, const SymbolStudy& study) {
  table.dimensions.emplace_back("symbol_I", study.I.size());
  table.dimensions.emplace_back("symbol_cells", study.sizes.size());
  const std::vector<std::string> along{"symbol_I"}, over{"symbol_I", "symbol_cells"};
  table.variables.push_back({"symbol_I", along, "1", "inertial number", study.I});
  table.variables.push_back({"symbol_cells",
                             {"symbol_cells"},
                             "1",
                             "cells a side of the square",
                             std::vector<std::int64_t>(study.sizes.begin(), study.sizes.end())});
  table.variables.push_back({"symbol_closed_form", along, "1",
                             "largest growth over eta k^2/rho, closed form; infinite where q >= 1", study.closed});
  table.variables.push_back({"symbol_C", along, "1", "C of (3.18)", study.condition});
  table.variables.push_back({"symbol_q", along, "1", "mu - I mu'/2", study.q});
  table.variables.push_back(
      {"symbol_scale", over, "1", "eta/(rho h^2) over the shear rate, h the cells' size", study.unit});
  const auto bounds = [&](const std::string& name, const std::vector<std::vector<double>>& ranges, const char* words) {
    std::vector<double> ends;
    for (const auto& range : ranges)
      for (const double end : range)
        if (end > 0.0 && std::isfinite(end)) ends.push_back(end);
    if (ends.empty()) return;
    table.dimensions.emplace_back(name, ends.size());
    table.variables.push_back({name, {name}, "1", words, ends});
  };
  bounds("symbol_C_bound", study.condition_from_to, "inertial numbers at which C of (3.18) changes its sign");
  bounds("symbol_growth_bound", study.damped_from_to,
         "inertial numbers at which short waves begin or cease to grow, by linear theory");
  const auto map = [&](const std::string& name, const std::vector<FastestWave>& waves, const std::string& words) {
    std::vector<double> growth, x, z;
    for (const auto& wave : waves) {
      growth.push_back(wave.growth);
      x.push_back(wave.phase_x);
      z.push_back(wave.phase_z);
    }
    table.variables.push_back(
        {"symbol_" + name, over, "1", "growth rate over the shear rate of the fastest wave, " + words, growth});
    table.variables.push_back({"symbol_" + name + "_kx", over, "rad", "its phase advance a cell along x", x});
    table.variables.push_back({"symbol_" + name + "_kz", over, "rad", "and along z", z});
  };
  map("layer", study.layer, "of the layer's operator");
  map("direct", study.direct, "of the textbook staggered grid with viscosity taken at corners");
  map("averaged", study.averaged, "of the textbook staggered grid with viscosity averaged from cells");
  std::vector<std::int64_t> words;
  std::vector<double> exponents;
  for (std::size_t i = 0; i < study.I.size(); ++i) {
    words.push_back(static_cast<std::int64_t>(verdict_at(study, i).word));
    exponents.push_back(verdict_at(study, i).exponent);
  }
  output::TableVariable verdict{"symbol_verdict", along, "", "what these grids say", words};
  for (const auto word :
       {SymbolVerdict::Word::well_posed, SymbolVerdict::Word::ill_posed, SymbolVerdict::Word::cannot_tell}) {
    std::string flag(word_of(word));
    for (char& c : flag)
      if (c == ' ' || c == '-') c = '_';
    verdict.flags.push_back(flag);
  }
  table.variables.push_back(std::move(verdict));
  table.variables.push_back({"symbol_exponent", along, "1", "n of a rate that grows as k^n", exponents});
}

}  // namespace talus::app
