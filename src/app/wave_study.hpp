#pragma once

#include <complex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "output/table_file.hpp"

namespace talus::app {

/// The fastest growing mode of a wave on a uniform layer.
struct WaveMode {
  double wavelength;          ///< [m]
  std::complex<double> rate;  ///< growth and angular frequency [1/s]
  double residual;            ///< modes::Mode::residual
  std::vector<std::complex<double>> u, omega,
      p;                        ///< from the base up, at faces, upper interfaces, cells; the largest speed is 1 m/s
  std::complex<double> height;  ///< of the surface [m]
};

/// Small waves on the discrete steady state of a periodic scene: a uniform layer on its slope.
struct WaveStudy {
  double thickness;             ///< of the layer [m]
  double froude;                ///< mean speed over sqrt(g H cos zeta)
  double surface_speed;         ///< of the uppermost layer [m/s]
  double dx;                    ///< columns of the grid [m]
  std::vector<double> z, base;  ///< middles of the layers [m]; speed there [m/s]
  double steady_residual;       ///< largest row left of the steady state over the layer's weight
  std::vector<WaveMode> waves;  ///< by wavelength, descending
};

/// Where long waves on the scene's layer begin to grow as it is tilted: the slope and Froude number of the threshold.
struct RollWaves {
  double tilt;  ///< [rad]
  double froude;
  double wavelength;  ///< of the first wave that grows [m]
};

/// Throws core::ConfigError for a scene that is not periodic, of another model than layer or column, or that has no steady state at its slope;
/// core::IntegrationError where it is not found. Modes of `n_waves` wavelengths between 200 thicknesses and three columns.
WaveStudy wave_study(const Scene& scene, int n_waves);

/// The lowest slope between the scene's own and the angle of its friction at rest above which waves of 20 to 200 thicknesses grow; none where
/// the scene's own slope has no such wave, or where they grow however slowly the layer flows.
std::optional<RollWaves> roll_waves(const Scene& scene);

std::string sentence_of(const WaveStudy& study, const std::optional<RollWaves>& threshold);
nlohmann::ordered_json json_of(const WaveStudy& study, const std::optional<RollWaves>& threshold);
/// Adds variables wave_... along `wave` and `wave_layer`.
void add_to(output::Table& table, const WaveStudy& study);

}  // namespace talus::app
