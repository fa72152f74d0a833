#include "app/recorder.hpp"

#include <algorithm>

#include "app/versions.hpp"
#include "output/provenance.hpp"

namespace talus::app {
namespace {

output::Attributes attributes_of(const Scene& scene, const std::string& command) {
  auto attributes = output::provenance_attributes({scene.effective, command, library_versions()});
  attributes["title"] = scene.title.empty() ? scene.name : scene.title;
  if (!scene.description.empty()) attributes["comment"] = scene.description;
  return attributes;
}

}  // namespace

Recorder::Recorder(const Scene& scene, core::FieldSource& model, const RunFolder& folder, const std::string& command, Summary& summary)
    : recording_(scene.recording),
      summary_(summary),
      fields_(model, scene.recording.fields ? Selection::fields : Selection::surface),
      numbers_(model, Selection::series),
      series_({numbers_, statistics_}),
      file_(folder.data(), fields_, attributes_of(scene, command)),
      series_stream_(file_.add_stream("series_time", series_)) {}

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
