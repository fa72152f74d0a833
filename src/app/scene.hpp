#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/values.hpp"
#include "experiment/experiment.hpp"
#include "grid/layering.hpp"
#include "ida/options.hpp"
#include "layer/parameters.hpp"
#include "linear/direct_solver.hpp"
#include "two_fluid/parameters.hpp"

namespace talus::app {

/// How the scene is to be integrated; the integrator's own settings are made from it.
struct Integration {
  /// `bdf`: through time, by IDA; `steady`: the steady state of each recorded time, by KINSOL.
  enum class Method : std::uint8_t { bdf, steady };
  Method method;
  double rtol;           ///< [1]
  double atol_velocity;  ///< [m/s]
  double atol_pressure;  ///< [Pa]
  double atol_height;    ///< [m]
  double atol_mass;      ///< of the budgets [kg]
  int max_order;         ///< 1..5
  linear::Choice linear_solver;
  ida::Newton newton;
  double newton_tolerance;  ///< as ida::NewtonOptions::tolerance [1]
  double max_step;          ///< [s]; 0: no limit
};

/// Cells of a model's grid, as far as it has such.
struct Cells {
  int columns;  ///< 0: not given
  int layers;
  grid::Spacing spacing;
  double cluster_depth;  ///< [m]
};

/// How the grains lie and move at the start.
struct Initial {
  enum class State : std::uint8_t { rest, profile, steady };
  double thickness;  ///< [m], everywhere
  State state;
  experiment::PiecewiseLinear profile;  ///< of State::profile: speed down the slope [m/s] over depth [m]
  double tilt;                          ///< of State::steady: the box's tilt to which that state belongs [rad]
  std::optional<layer::Disturbance> disturbance;
};

/// When results are recorded; every record is exactly at its time [s].
struct Recording {
  bool fields;                       ///< two-dimensional variables are recorded
  std::vector<double> field_times;   ///< ascending, from 0 to the end: fields and series
  std::vector<double> series_times;  ///< ascending, from 0 to the end: budgets, angles, statistics
  std::vector<double> listed_times;  ///< those of `output.times`, reported in summary.json
};

/// When a run saves what it needs to go on later, and when it ends of itself. Wall times [s] are infinite where none is set.
struct Checkpointing {
  bool exact;                 ///< the run starts afresh at each checkpoint, as one that is continued from there does
  std::vector<double> times;  ///< simulated [s], ascending: multiples of `interval` up to the end
  bool by_interval;           ///< an interval is set, though no multiple may lie before the end
  double wall_interval;       ///< between checkpoints
  double wall_limit;          ///< of this run; it then stops as on SIGTERM
  /// Checkpoints that a clock or a signal brings about would change the bits of an exact run: where an interval is set,
  /// a stop leaves the last one in place instead.
  [[nodiscard]] bool saves_at_a_stop() const { return !(exact && by_interval); }
};

/// A scene as its file states it, in SI units and radians, checked.
struct Scene {
  std::string name;
  std::string title;
  std::string description;
  experiment::Box box;  ///< at t = 0
  experiment::Motion motion;
  rheology::Grains grains;
  rheology::Law law;
  rheology::Regularisation regularisation;
  experiment::Wall wall;
  experiment::Inflow inflow;
  std::string model;
  layer::Numerics numerics;
  two_fluid::Numerics two_fluid;
  Initial initial;
  double left_slope;  ///< of the triangle's left face against the horizontal [rad]
  Cells cells;
  Integration integration;
  double end;  ///< [s]
  Recording recording;
  Checkpointing checkpointing;
  std::string effective;  ///< the scene as TOML, overrides applied and defaults filled in
};

/// Every key of a scene file.
const config::Schema& scene_schema();

/// Reads and checks a scene. Throws core::ConfigError, see config::read. A check of several keys names one's place.
Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});
/// As `read_scene`, from text; `name` stands for the file in messages.
Scene read_scene_text(std::string_view toml, const std::string& name, const std::vector<std::string>& overrides = {});

ida::Options make_integrator_options(const Scene& scene);

}  // namespace talus::app
