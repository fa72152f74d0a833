#include "app/recorder.hpp"

#include <algorithm>
#include <numbers>

#include "app/versions.hpp"
#include "output/atomic_file.hpp"
#include "output/provenance.hpp"

namespace talus::app {
namespace {

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

output::Attributes attributes_of(const Scene& scene, const Theory& theory, const std::string& command) {
  auto libraries = library_versions();
  std::erase(libraries, output::netcdf_version());  // the provenance adds it
  auto attributes = output::provenance_attributes({scene.effective, command, libraries});
  attributes["title"] = scene.title.empty() ? scene.name : scene.title;
  attributes["scene_name"] = scene.name;
  attributes["model"] = scene.model;
  attributes["box_tilt_deg"] = degrees(scene.box.tilt);
  attributes["film_m"] = scene.numerics.film;
  attributes["inflow_rate_kg_s"] = scene.inflow.rate;
  attributes["wall_friction"] = scene.wall.mu_w;
  if (theory.steady) {
    const auto& steady = *theory.steady;
    attributes["exact_mass_flow_kg_s"] = steady.flow.flux();
    attributes["exact_slope_deg"] = degrees(steady.flow.zeta());
    if (steady.regularised_slope) attributes["regularised_slope_deg"] = degrees(*steady.regularised_slope);
    attributes["flowing_depth_m"] = steady.depth;
    attributes["layers_in_flow"] = steady.layers;
    attributes["fewest_layers_in_flow"] = fewest_layers;
  }
  if (!scene.description.empty()) attributes["comment"] = scene.description;
  return attributes;
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Theory& theory, core::FieldSource& model, const RunFolder& folder,
                   const std::string& command, Summary& summary, const output::Checkpoint* from)
    : recording_(scene.recording),
      summary_(summary),
      model_(model),
      fields_(model_, scene.recording.fields ? Selection::fields : Selection::surface),
      exact_(theory),
      fields_and_exact_({fields_, exact_}),
      numbers_(model_, Selection::numbers),
      lines_(model_, Selection::series),
      series_({lines_, statistics_}),
      file_(from == nullptr ? folder.data() : output::aside(folder.data()), fields_and_exact_,
            attributes_of(scene, theory, command)),
      series_stream_(file_.add_stream("series_time", series_)) {
  if (from == nullptr) return;
  file_.take_place_of(folder.data(), from->n_records);
  last_ = file_.last_time(series_stream_);
}

std::vector<std::size_t> Recorder::bring_to_disk() {
  file_.bring_to_disk();
  std::vector<std::size_t> n;
  for (std::size_t i = 0; i < file_.n_streams(); ++i) n.push_back(file_.n_records(i));
  return n;
}

void Recorder::at_output(const core::Snapshot& snapshot) {
  series(snapshot, std::ranges::binary_search(recording_.listed_times, snapshot.t));
  if (std::ranges::binary_search(recording_.field_times, snapshot.t)) file_.append(snapshot);
}

void Recorder::at_end(const core::Snapshot& snapshot) {
  if (snapshot.t <= last_) return;
  series(snapshot, false);
  file_.append(snapshot);
}

void Recorder::series(const core::Snapshot& snapshot, bool listed) {
  file_.append(snapshot, series_stream_);
  numbers_.evaluate(snapshot, values_);
  summary_.record(snapshot, numbers_.variables(), values_, listed);
  last_ = snapshot.t;
}

}  // namespace talus::app
