#include "app/wave_study.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/steady_layer.hpp"
#include "app/table.hpp"
#include "core/errors.hpp"
#include "modes/plane_waves.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;
using Complex = std::complex<double>;

constexpr int n_columns = 9;  // rows reach four columns at most: neighbours can be told apart
constexpr double longest = 200.0, shortest_roll_wave = 20.0;  // in thicknesses
/// In columns. A wave of two has no inertia across layers on this grid: symbol::ShearedLayer::growth.
constexpr double fewest_columns = 3.0;
constexpr double pi = std::numbers::pi;

WaveMode mode_of(const SteadyLayer& steady, const modes::PlaneWaves& waves, double wavelength) {
  const auto& columns = steady.layer().columns();
  const auto found = waves.modes(2.0 * pi * columns.dx() / wavelength);
  if (found.empty()) throw core::IntegrationError("study wellposed: no mode was found");
  const auto& lead = found.front();
  WaveMode mode{wavelength, lead.rate, lead.residual, {}, {}, {}, 0.0};
  const auto& at = steady.layer().unknowns();
  const auto of = [&](core::Index unknown) { return lead.shape.at(unknown % waves.block_size()); };
  double largest = 0.0;
  for (int k = 0; k < columns.n_layers; ++k) {
    mode.u.push_back(of(at.u(0, k)));
    mode.omega.push_back(of(at.omega(0, k + 1)));
    mode.p.push_back(of(at.p(0, k)));
    largest = std::max({largest, std::abs(mode.u.back()), std::abs(mode.omega.back())});
  }
  mode.height = of(at.H(0)) / largest;
  for (auto* part : {&mode.u, &mode.omega, &mode.p})
    for (auto& value : *part) value /= largest;
  return mode;
}

/// The fastest of the long waves on the scene's layer with another tilt.
struct LongWave {
  double growth, wavelength, froude;
};

LongWave long_wave(Scene scene, double tilt) {
  scene.box.tilt = tilt;
  scene.motion = {};
  const SteadyLayer steady(scene, n_columns);
  const modes::PlaneWaves waves(steady.layer(), 0.0, steady.state(), n_columns);
  LongWave fastest{-1e300, 0.0, steady.froude()};
  for (double length = shortest_roll_wave; length <= longest * 1.001;
       length *= std::pow(longest / shortest_roll_wave, 0.25)) {
    const double wavelength = length * steady.thickness();
    const auto found = waves.modes(2.0 * pi * steady.layer().columns().dx() / wavelength);
    if (found.front().rate.real() > fastest.growth) fastest = {found.front().rate.real(), wavelength, steady.froude()};
  }
  return fastest;
}

bool is_long(const WaveStudy& study, const WaveMode& wave) {
  return wave.wavelength >= shortest_roll_wave * study.thickness * 0.999;
}

}  // namespace

WaveStudy wave_study(const Scene& scene, int n_waves) {
  const SteadyLayer steady(scene, n_columns);
  const modes::PlaneWaves waves(steady.layer(), 0.0, steady.state(), n_columns);
  const double dx = steady.layer().columns().dx(), H = steady.thickness();
  WaveStudy study{H,
                  steady.froude(),
                  steady.speeds().back(),
                  dx,
                  steady.column().heights().centre,
                  steady.speeds(),
                  steady.residual(),
                  {}};
  const double from = std::max(longest * H, 4.0 * dx), to = fewest_columns * dx;
  for (int i = 0; i < n_waves; ++i)
    study.waves.push_back(mode_of(steady, waves, from * std::pow(to / from, double(i) / (n_waves - 1))));
  return study;
}

std::optional<RollWaves> roll_waves(const Scene& scene) {
  const double own = experiment::box_at(scene.box, scene.motion, scene.end).tilt;
  if (!(long_wave(scene, own).growth > 0.0)) return std::nullopt;
  constexpr int n_slopes = 12, n_halvings = 20;
  const double rest = std::atan(rheology::friction_at_rest(scene.law));
  double grows = own, decays = own;
  for (int i = 1; i < n_slopes && decays == grows; ++i) {
    const double tilt = own + (rest - own) * i / n_slopes;
    if (long_wave(scene, tilt).growth > 0.0) grows = decays = tilt;
    else decays = tilt;
  }
  if (decays == grows) return std::nullopt;
  for (int i = 0; i < n_halvings; ++i) {
    const double middle = 0.5 * (grows + decays);
    (long_wave(scene, middle).growth > 0.0 ? grows : decays) = middle;
  }
  const auto at = long_wave(scene, grows);
  return RollWaves{grows, at.froude, at.wavelength};
}

std::string sentence_of(const WaveStudy& study, const std::optional<RollWaves>& threshold) {
  const auto fastest = std::ranges::max_element(study.waves, {}, [](const WaveMode& wave) { return wave.rate.real(); });
  std::string out =
      fmt::format("Modes of the uniform layer, {:.3g} mm, Froude number {:.4g}: ", 1e3 * study.thickness, study.froude);
  if (fastest->rate.real() <= 0.0) {
    out += fmt::format("stable to waves from {:.3g} mm to {:.3g} mm (the slowest to decay: {:.3g} mm, at {:.3g} 1/s)",
                       1e3 * study.waves.front().wavelength, 1e3 * study.waves.back().wavelength,
                       1e3 * fastest->wavelength, fastest->rate.real());
  } else {
    out += fmt::format("unstable, fastest a wave of {:.3g} mm at {:.4g} 1/s, running at {:.3g} m/s",
                       1e3 * fastest->wavelength, fastest->rate.real(),
                       -fastest->rate.imag() * fastest->wavelength / (2.0 * pi));
    out += is_long(study, *fastest)               ? ": long roll waves"
           : fastest->wavelength < 6.0 * study.dx ? ": as short as the columns allow, so a finer grid would grow faster"
                                                  : "";
  }
  if (threshold)
    out += fmt::format("; long waves grow from {:.4f} degrees on, Froude number {:.4f} (first a wave of {:.3g} mm)",
                       threshold->tilt * 180.0 / pi, threshold->froude, 1e3 * threshold->wavelength);
  return out + ".";
}

Json json_of(const WaveStudy& study, const std::optional<RollWaves>& threshold) {
  Json waves = Json::array();
  for (const auto& wave : study.waves)
    waves.push_back({{"wavelength_m", wave.wavelength},
                     {"growth_1_s", wave.rate.real()},
                     {"frequency_rad_s", wave.rate.imag()},
                     {"residual", wave.residual}});
  Json roll = nullptr;
  if (threshold)
    roll = {{"tilt_deg", threshold->tilt * 180.0 / pi},
            {"froude", threshold->froude},
            {"wavelength_m", threshold->wavelength}};
  return {{"words", sentence_of(study, threshold)},
          {"thickness_m", study.thickness},
          {"froude", study.froude},
          {"steady_residual", study.steady_residual},
          {"waves", std::move(waves)},
          {"roll_wave_threshold", std::move(roll)}};
}

void add_to(output::Table& table, const WaveStudy& study) {
  table.dimensions.emplace_back("wave", study.waves.size());
  table.dimensions.emplace_back("wave_layer", study.z.size());
  const auto along = [&](const char* name, const char* unit, const char* words, auto value) {
    std::vector<double> values;
    for (const auto& wave : study.waves) values.push_back(value(wave));
    table.variables.push_back({name, {"wave"}, unit, words, values});
  };
  along("wave_length", "m", "wavelength", [](const WaveMode& w) { return w.wavelength; });
  along("wave_growth", "s-1", "growth rate of the fastest growing mode",
        [](const WaveMode& w) { return w.rate.real(); });
  along("wave_frequency", "rad s-1", "its angular frequency, negative for waves that run down the slope",
        [](const WaveMode& w) { return w.rate.imag(); });
  along("wave_residual", "1", "what is left of its equation over the size of the terms",
        [](const WaveMode& w) { return w.residual; });
  along("wave_height_real", "m", "its height of the surface, real part",
        [](const WaveMode& w) { return w.height.real(); });
  along("wave_height_imag", "m", "its height of the surface, imaginary part",
        [](const WaveMode& w) { return w.height.imag(); });
  table.variables.push_back({"wave_layer_z", {"wave_layer"}, "m", "height of the layer's middle", study.z});
  table.variables.push_back({"wave_layer_speed", {"wave_layer"}, "m s-1", "speed of the steady state", study.base});
  const auto shape = [&](const std::string& name, const char* unit, const std::string& words,
                         std::vector<Complex> WaveMode::*part) {
    std::vector<double> real, imaginary;
    for (const auto& wave : study.waves) {
      for (const auto& value : wave.*part) {
        real.push_back(value.real());
        imaginary.push_back(value.imag());
      }
    }
    table.variables.push_back({"wave_" + name + "_real", {"wave", "wave_layer"}, unit, words + ", real part", real});
    table.variables.push_back(
        {"wave_" + name + "_imag", {"wave", "wave_layer"}, unit, words + ", imaginary part", imaginary});
  };
  shape("u", "m s-1", "velocity down the slope of the mode, at its column's left face", &WaveMode::u);
  shape("omega", "m s-1", "flux through the layer's upper interface", &WaveMode::omega);
  shape("p", "Pa", "pressure", &WaveMode::p);
}

}  // namespace talus::app
