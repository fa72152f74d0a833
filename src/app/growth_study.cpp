#include "app/growth_study.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>

#include "app/refinement.hpp"
#include "app/steady_layer.hpp"
#include "app/table.hpp"
#include "core/errors.hpp"
#include "ida/ida.hpp"
#include "modes/plane_waves.hpp"
#include "output/atomic_file.hpp"
#include "output/text_file.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double noise_share = 1e-4;  // of the fastest speed
constexpr double mode_times = 6.0;    // to run
constexpr double fitted_share = 0.5;  // the last part of it
constexpr double steps_a_time = 25.0;
constexpr std::uint64_t seed = 1;
constexpr int fewest_columns = 9;  // of a ring for plane waves

Scene refined(Scene scene, int level) {
  for (int i = 0; i < level; ++i) {
    scene.cells.columns *= refinement_ratio;
    scene.cells.layers *= refinement_ratio;
  }
  // Far below the noise, which the steps resolve by their length alone.
  scene.integration.rtol = std::min(scene.integration.rtol, 1e-7);
  scene.integration.atol_velocity = std::min(scene.integration.atol_velocity, 1e-9);
  scene.integration.atol_pressure = std::min(scene.integration.atol_pressure, 1e-5);
  scene.integration.atol_height = std::min(scene.integration.atol_height, 1e-10);
  return scene;
}

/// Of the waves that fit the box, two columns excepted.
double fastest_wave(const Scene& scene) {
  const SteadyLayer steady(scene, fewest_columns);
  const modes::PlaneWaves waves(steady.layer(), 0.0, steady.state(), fewest_columns);
  double fastest = -std::numeric_limits<double>::infinity();
  for (int m = 1; 2 * m < scene.cells.columns; ++m) {
    const auto found = waves.modes(2.0 * std::numbers::pi * m / scene.cells.columns);
    if (!found.empty()) fastest = std::max(fastest, found.front().rate.real());
  }
  return fastest;
}

/// Root mean square over cells of what departs from the mean along x, and of the flux across layers.
double departure(const layer::Layer& layer, std::span<const double> y) {
  const auto& c = layer.columns();
  const auto& at = layer.unknowns();
  double squares = 0.0;
  for (int k = 0; k < c.n_layers; ++k) {
    double mean = 0.0;
    for (int i = 0; i < c.n_columns; ++i) mean += y[at.u(i, k)] / c.n_columns;
    for (int i = 0; i < c.n_columns; ++i)
      squares += std::pow(y[at.u(i, k)] - mean, 2) + std::pow(y[at.omega(i, k + 1)], 2);
  }
  return std::sqrt(squares / (static_cast<double>(c.n_layers) * c.n_columns));
}

class Watch final : public core::Observer {
 public:
  Watch(const layer::Layer& layer, GrowthRun& run) : layer_(layer), run_(run) {}
  bool on_step(const core::Snapshot& now) override {
    run_.times.push_back(now.t);
    run_.amplitudes.push_back(departure(layer_, now.y));
    return true;
  }

 private:
  const layer::Layer& layer_;
  GrowthRun& run_;
};

void integrate(const Scene& scene, GrowthRun& run) {
  const SteadyLayer steady(scene, scene.cells.columns);
  const auto& layer = steady.layer();
  std::vector<double> y(steady.state().begin(), steady.state().end()), yp(y.size(), 0.0);
  const double noise = noise_share * std::ranges::max(steady.speeds());
  std::mt19937_64 random(seed);
  for (int k = 0; k < layer.columns().n_layers; ++k)
    for (int i = 0; i < layer.columns().n_columns; ++i)
      y[layer.unknowns().u(i, k)] += noise * (static_cast<double>(random() >> 11U) * 0x1p-52 - 1.0);
  auto options = make_integrator_options(scene);
  options.max_step = 1.0 / (steps_a_time * std::abs(run.predicted));
  Watch watch(layer, run);
  try {
    ida::Ida integrator(layer, options);
    integrator.start(0.0, y, yp);
    integrator.advance(run.duration, watch);
  } catch (const core::IntegrationError& error) {
    run.end = std::string(error.what()).substr(0, std::string(error.what()).find('\n'));
  }
}

Json as_json(const GrowthRun& run, const Scene& scene) {
  return {{"scene", scene.effective},     {"columns", run.columns},
          {"layers", run.layers},         {"predicted", run.predicted},
          {"duration", run.duration},     {"times", run.times},
          {"amplitudes", run.amplitudes}, {"end", run.end}};
}

/// True where the file holds this run of this scene.
bool read(const std::filesystem::path& file, const Scene& scene, GrowthRun& run) {
  const auto json = Json::parse(output::contents(file), nullptr, false);
  if (!json.is_object() || json.value("scene", "") != scene.effective || json.value("columns", 0) != run.columns)
    return false;
  run.predicted = json.at("predicted");
  run.duration = json.at("duration");
  run.times = json.at("times").get<std::vector<double>>();
  run.amplitudes = json.at("amplitudes").get<std::vector<double>>();
  run.end = json.at("end");
  return true;
}

GrowthRun run_on(const Scene& own, int level, const std::filesystem::path& folder) {
  const Scene scene = refined(own, level);
  GrowthRun run{scene.cells.columns, scene.cells.layers, 0.0, 0.0, {}, {}, "", {}};
  const auto file = folder / fmt::format("growth_{}x{}.json", run.columns, run.layers);
  if (!read(file, own, run)) {
    std::fprintf(stderr, "noise on %dx%d cells ...\n", run.columns, run.layers);
    run.predicted = fastest_wave(scene);
    run.duration = mode_times / std::abs(run.predicted);
    integrate(scene, run);
    output::write_atomically(file, as_json(run, own).dump());
  }
  const double last = run.times.empty() ? 0.0 : run.times.back();
  run.fit = study::fit_growth(run.times, run.amplitudes, (1.0 - fitted_share) * last, last);
  return run;
}

}  // namespace

GrowthStudy growth_study(const Scene& scene, int levels, const std::filesystem::path& folder) {
  if (scene.cells.columns < 3)
    throw core::ConfigError("study wellposed --parts time: expected grid.columns of at least 3, found " +
                            std::to_string(scene.cells.columns));
  GrowthStudy study{0.0, seed, {}, {}};
  study.noise = noise_share * std::ranges::max(SteadyLayer(scene, fewest_columns).speeds());
  std::vector<study::GrowthFit> fits;
  for (int level = 0; level < levels; ++level) {
    study.runs.push_back(run_on(scene, level, folder));
    fits.push_back(study.runs.back().fit);
  }
  study.verdict = study::growth_verdict(fits, refinement_ratio);
  return study;
}

std::string sentence_of(const GrowthStudy& study) {
  std::string out = fmt::format("Noise of {:.2g} m/s in time: {}", study.noise, word_of(study.verdict.tendency));
  if (study.verdict.tendency == study::GrowthTendency::blows_up)
    out += fmt::format(" with a rate as k^{:.2f}", study.verdict.exponent);
  for (const auto& run : study.runs) {
    out += fmt::format("; {}x{}: {:.4g} +- {:.2g} 1/s (its modes say {:.4g})", run.columns, run.layers, run.fit.rate,
                       run.fit.uncertainty, run.predicted);
    if (!run.end.empty())
      out += fmt::format(", broke down at t = {:.3g} s", run.times.empty() ? 0.0 : run.times.back());
  }
  if (study.verdict.tendency == study::GrowthTendency::cannot_tell)
    out += fmt::format("; {}x{} cells may tell", refinement_ratio * study.runs.back().columns,
                       refinement_ratio * study.runs.back().layers);
  return out + ".";
}

Json json_of(const GrowthStudy& study) {
  Json runs = Json::array();
  for (const auto& run : study.runs)
    runs.push_back({{"columns", run.columns},
                    {"layers", run.layers},
                    {"rate_1_s", json_of(run.fit.rate)},
                    {"uncertainty_1_s", json_of(run.fit.uncertainty)},
                    {"window_s", {run.fit.from, run.fit.to}},
                    {"rate_of_modes_1_s", json_of(run.predicted)},
                    {"broke_down", run.end.empty() ? Json(nullptr) : Json(run.end)}});
  return {{"words", sentence_of(study)},
          {"verdict", word_of(study.verdict.tendency)},
          {"rate_exponent", json_of(study.verdict.exponent)},
          {"noise_m_s", study.noise},
          {"seed", study.seed},
          {"runs", std::move(runs)}};
}

void add_to(output::Table& table, const GrowthStudy& study) {
  std::size_t most = 0;
  for (const auto& run : study.runs) most = std::max(most, run.times.size());
  if (most == 0) return;
  table.dimensions.emplace_back("growth_grid", study.runs.size());
  table.dimensions.emplace_back("growth_point", most);
  std::vector<std::int64_t> columns, layers;
  std::vector<double> rate, uncertainty, predicted, times, amplitudes;
  const auto filled = [&](std::vector<double> values) {
    values.resize(most, std::numeric_limits<double>::quiet_NaN());
    return values;
  };
  for (const auto& run : study.runs) {
    columns.push_back(run.columns);
    layers.push_back(run.layers);
    rate.push_back(run.fit.rate);
    uncertainty.push_back(run.fit.uncertainty);
    predicted.push_back(run.predicted);
    const auto t = filled(run.times), a = filled(run.amplitudes);
    times.insert(times.end(), t.begin(), t.end());
    amplitudes.insert(amplitudes.end(), a.begin(), a.end());
  }
  const std::vector<std::string> grid{"growth_grid"}, both{"growth_grid", "growth_point"};
  table.variables.insert(
      table.variables.end(),
      {{"growth_columns", grid, "1", "columns of the grid", columns},
       {"growth_layers", grid, "1", "layers of the grid", layers},
       {"growth_rate", grid, "s-1", "growth rate fitted to the last half of the run", rate},
       {"growth_uncertainty", grid, "s-1", "its uncertainty", uncertainty},
       {"growth_predicted", grid, "s-1", "fastest growth rate of the waves that fit the box, from the modes",
        predicted},
       {"growth_time", both, "s", "simulated time", times},
       {"growth_amplitude", both, "m s-1", "root mean square of what departs from a uniform layer", amplitudes}});
}

}  // namespace talus::app
