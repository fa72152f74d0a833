#include "app/steady_modes.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/layer_model.hpp"
#include "app/sweep_work.hpp"
#include "app/table.hpp"
#include "core/errors.hpp"
#include "kinsol/kinsol.hpp"
#include "layer/layer.hpp"
#include "output/checkpoint_folder.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;
using modes::Complex;

constexpr std::size_t most_kept = 6;  ///< modes whose fields are kept

/// A sweep of one member: the scene up to the end of its inflow, with a checkpoint there.
SweepPlan plan_of(const SteadyModesRequest& request, double time) {
  const auto* key = scene_schema().find("time.end");
  const sweep::Dimension end{"time_end", {{key->name, key->unit, key->doc, {time}}}};
  const auto settings = overridden(request.overrides, {"checkpoint.exact=false", "output.times=[]"});
  SweepPlan plan{{request.scene.name + "_steady", request.scene.title, request.scene_file,
                  settings_beside(end, settings), sweep::Design({end})},
                 {}};
  plan.scenes = member_scenes(plan.file, "study wellposed " + request.scene_file.string());
  return plan;
}

/// Where the run ended; nothing where a signal stopped it.
std::optional<output::Checkpoint> run_to(const SteadyModesRequest& request, double time) {
  SweepWork work(plan_of(request, time), request.scene_file.string(), request.folder, request.force);
  const auto code = work.run(request.jobs);
  if (code == core::ExitCode::restartable) return std::nullopt;
  const auto run_folder = request.folder / work.folder().member(0);
  if (code != core::ExitCode::ok)
    throw core::IntegrationError("study wellposed: the scene did not run to t = " + std::to_string(time) + " s; see " +
                                 (run_folder / "run.log").string());
  auto found = output::CheckpointFolder(run_folder).newest();
  if (!found.checkpoint)
    throw core::OutputError(core::ExitCode::bad_restart,
                            run_folder.string() + ": holds no whole checkpoint of its end");
  return std::move(found.checkpoint);
}

/// Shifts a factor of ten apart, from slower than the heap grows to the fastest that its cells could show.
std::vector<double> shifts() { return {0.1, 1.0, 10.0, 100.0, 1000.0}; }

/// Whether a mode is but an accumulated mass: neutral, as nothing depends on it.
bool is_neutral(const modes::Mode& mode) { return std::abs(mode.rate) < 1e-6; }

class Fields {
 public:
  Fields(const layer::Layer& layer, const modes::Mode& mode) : layer_(layer), mode_(mode) {
    const auto& c = layer.columns();
    double largest = 0.0;
    for (int k = 0; k < c.n_layers; ++k)
      for (int i = 0; i < c.n_columns; ++i) largest = std::max(largest, std::abs(speed(i, k)));
    scale_ = largest > 0.0 ? 1.0 / largest : 1.0;
  }
  [[nodiscard]] std::vector<Complex> u() const {
    return over(layer_.columns().n_layers, [&](int i, int k) { return speed(i, k); });
  }
  [[nodiscard]] std::vector<Complex> p() const {
    return over(layer_.columns().n_layers, [&](int i, int k) { return of(layer_.unknowns().p(i, k)); });
  }
  [[nodiscard]] std::vector<Complex> H() const {
    return over(1, [&](int i, int) { return of(layer_.unknowns().H(i)); });
  }

 private:
  [[nodiscard]] Complex of(core::Index unknown) const { return unknown < 0 ? 0.0 : mode_.shape.at(unknown); }
  [[nodiscard]] Complex speed(int i, int k) const {
    return 0.5 * (of(layer_.unknowns().u(i, k)) + of(layer_.unknowns().u(i + 1, k)));
  }
  template <class Value>
  [[nodiscard]] std::vector<Complex> over(int layers, const Value& value) const {
    std::vector<Complex> out;
    for (int k = 0; k < layers; ++k)
      for (int i = 0; i < layer_.columns().n_columns; ++i) out.push_back(scale_ * value(i, k));
    return out;
  }
  const layer::Layer& layer_;
  const modes::Mode& mode_;
  double scale_ = 1.0;
};

void describe_grid(const layer::Layer& layer, std::span<const double> y, SteadyModes& study) {
  const auto& c = layer.columns();
  const auto& context = layer.context(study.time, y);
  study.n_columns = c.n_columns;
  study.n_layers = c.n_layers;
  for (int i = 0; i < c.n_columns; ++i) {
    study.x.push_back(c.x_centre(i));
    study.height.push_back(y[layer.unknowns().H(i)]);
  }
  for (int k = 0; k < c.n_layers; ++k)
    for (int i = 0; i < c.n_columns; ++i)
      study.height_of_layers.push_back(0.5 * (context.z[context.at(i, k)] + context.z[context.at(i, k + 1)]));
}

void tell(const modes::Searched& about) {
  if (about.radius > 0.0)
    std::fprintf(stderr, "  about %g 1/s: %d modes, all within %.4g 1/s\n", about.shift, about.n_found, about.radius);
  else std::fprintf(stderr, "  about %g 1/s: %d modes, not all that were sought\n", about.shift, about.n_found);
}

/// Frequencies [rad/s] up to which no mode that grows faster than `growth` can have been missed.
double complete_up_to(const SteadyModes& study, double growth) {
  double frequency = 0.0;
  for (const auto& about : study.found.searched) {
    const double along = about.shift - growth;
    if (about.radius > std::abs(along))
      frequency = std::max(frequency, std::sqrt(about.radius * about.radius - along * along));
  }
  return frequency;
}

}  // namespace

std::optional<SteadyModes> steady_modes(const SteadyModesRequest& request) {
  const Scene& scene = request.scene;
  if (scene.model != "layer")
    throw core::ConfigError("study wellposed: modes of a scene with ends need model.name = \"layer\", found \"" +
                            scene.model + "\"");
  SteadyModes study{};
  study.time = std::min(scene.end, scene.inflow.stop);
  const auto reached = run_to(request, study.time);
  if (!reached) return std::nullopt;

  const layer::Layer layer(make_layer_parameters(scene));
  kinsol::Options options;
  options.rtol = scene.integration.rtol;
  options.linear.choice = scene.integration.linear_solver;
  kinsol::Kinsol steady(layer, options);
  core::Observer nobody;
  steady.start(study.time, reached->y, reached->yp);
  std::fprintf(stderr, "steady state of t = %g s ...\n", study.time);
  steady.advance(study.time, nobody);
  study.steady = steady.describe();
  describe_grid(layer, steady.current().y, study);

  std::fprintf(stderr, "modes of %lld unknowns ...\n", static_cast<long long>(layer.layout().size()));
  study.found = modes::leading_modes(
      layer, study.time, steady.current().y,
      {.shifts = shifts(), .n_modes = 40, .n_vectors = 160, .linear = options.linear, .progress = tell});
  study.n_neutral = static_cast<int>(std::erase_if(study.found.modes, is_neutral));
  for (const auto& mode : study.found.modes) {
    if (study.u.size() == most_kept) break;
    const Fields fields(layer, mode);
    study.u.push_back(fields.u());
    study.p.push_back(fields.p());
    study.H.push_back(fields.H());
  }
  return study;
}

std::string sentence_of(const SteadyModes& study) {
  std::string out = fmt::format("Modes of the steady state under the inflow of t = {:g} s, {}x{} cells: ", study.time,
                                study.n_columns, study.n_layers);
  if (study.found.modes.empty()) return out + "none was found.";
  const auto& lead = study.found.modes.front();
  out += lead.rate.real() > 0.0 ? "unstable" : "stable";
  out += fmt::format(", the leading rate is {:.4g} 1/s", lead.rate.real());
  if (std::abs(lead.rate.imag()) > 0.0)
    out += fmt::format(" with a period of {:.3g} s", 6.283185307179586 / std::abs(lead.rate.imag()));
  const double complete = complete_up_to(study, lead.rate.real());
  return out + (complete > 0.0 ? fmt::format("; none that grows faster was missed up to {:.3g} rad/s.", complete)
                               : "; the search does not say whether a faster one was missed.");
}

Json json_of(const SteadyModes& study) {
  Json all = Json::array(), searched = Json::array();
  for (const auto& mode : study.found.modes)
    all.push_back(
        {{"growth_1_s", mode.rate.real()}, {"frequency_rad_s", mode.rate.imag()}, {"residual", mode.residual}});
  for (const auto& about : study.found.searched)
    searched.push_back({{"shift_1_s", about.shift}, {"radius_1_s", about.radius}, {"found", about.n_found}});
  return {{"words", sentence_of(study)},  {"time_s", study.time},
          {"steady_state", study.steady}, {"neutral_modes_of_accumulated_masses", study.n_neutral},
          {"modes", std::move(all)},      {"searched", std::move(searched)}};
}

void add_to(output::Table& table, const SteadyModes& study) {
  const std::size_t n = study.found.modes.size(), kept = study.u.size();
  if (n == 0) return;
  table.dimensions.insert(table.dimensions.end(), {{"mode", n},
                                                   {"kept_mode", kept},
                                                   {"mode_layer", std::size_t(study.n_layers)},
                                                   {"mode_column", std::size_t(study.n_columns)}});
  std::vector<double> growth, frequency, residual;
  for (const auto& mode : study.found.modes) {
    growth.push_back(mode.rate.real());
    frequency.push_back(mode.rate.imag());
    residual.push_back(mode.residual);
  }
  table.variables.push_back({"mode_growth", {"mode"}, "s-1", "growth rate", growth});
  table.variables.push_back({"mode_frequency", {"mode"}, "rad s-1", "angular frequency", frequency});
  table.variables.push_back(
      {"mode_residual", {"mode"}, "1", "what is left of its equation over the size of the terms", residual});
  table.variables.push_back({"mode_x", {"mode_column"}, "m", "distance down the base", study.x});
  table.variables.push_back({"mode_base_height", {"mode_column"}, "m", "thickness of the steady state", study.height});
  table.variables.push_back({"mode_z",
                             {"mode_layer", "mode_column"},
                             "m",
                             "height of the cell's middle over the base",
                             study.height_of_layers});
  const auto shape = [&](const std::string& name, const char* unit, const std::string& words,
                         std::vector<std::string> dimensions, const std::vector<std::vector<Complex>>& modes) {
    std::vector<double> real, imaginary;
    for (const auto& mode : modes) {
      for (const auto& value : mode) {
        real.push_back(value.real());
        imaginary.push_back(value.imag());
      }
    }
    dimensions.insert(dimensions.begin(), "kept_mode");
    table.variables.push_back({"mode_" + name + "_real", dimensions, unit, words + ", real part", real});
    table.variables.push_back({"mode_" + name + "_imag", dimensions, unit, words + ", imaginary part", imaginary});
  };
  shape("u", "m s-1", "velocity down the base of the mode, at most 1", {"mode_layer", "mode_column"}, study.u);
  shape("p", "Pa", "pressure of the mode", {"mode_layer", "mode_column"}, study.p);
  shape("height", "m", "thickness of the mode", {"mode_column"}, study.H);
}

}  // namespace talus::app
