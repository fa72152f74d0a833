#include "app/fit_layer_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/measured_columns.hpp"
#include "app/table.hpp"

namespace talus::app {
namespace {

using config::CsvColumn;
using config::Problems;
using config::Values;

constexpr double any = 1e300, none = std::numeric_limits<double>::quiet_NaN();

/// A number of run.nc that a series may be of, and its columns in a CSV file.
struct Quantity {
  std::string name, column, unit;
};
const std::vector<Quantity> quantities{{"mass_stored", "mass_kg", "kg"},
                                       {"mass_outflow_left", "mass_kg", "kg"},
                                       {"mass_outflow_right", "mass_kg", "kg"},
                                       {"outflow_rate_left", "rate_kg_s", "kg/s"},
                                       {"outflow_rate_right", "rate_kg_s", "kg/s"},
                                       {"heap_angle", "angle_deg", "degree"}};

/// "mass_error_kg" of "mass_kg".
std::string error_column(const std::string& column) {
  return column.substr(0, column.find('_')) + "_error" + column.substr(column.find('_'));
}

class Reader {
 public:
  Reader(std::filesystem::path folder, const std::filesystem::path& scene_file, const Scene& scene,
         fit::LayerStage& stage, Problems& problems)
      : folder_(std::move(folder)), stage_(stage), problems_(problems) {
    time_ = {"time_s", "s",  "since the start of the scene",      0.0, scene.end,
             true,     true, "time.end of " + scene_file.string()};
    place_ = {"x_m", "m",  "down the base from its left end",     0.0, scene.box.length,
              true,  true, "box.length of " + scene_file.string()};
  }

  void read_shape(const Values& table) {
    const auto file = folder_ / table.text("shape.file");
    const CsvColumn height{"height_m", "m", "H, of the grains above the base and normal to it, the film included",
                           0.0,        any, true};
    const auto add = [&](const std::string& row, double t, double x, double value, double error) {
      stage_.data.push_back({table.text("shape.file") + " " + row, "height", "m", t, x, value, error});
    };
    const bool run_file = is_netcdf(file);
    if (!keys_fit(table, "shape", run_file, true)) return;
    if (!run_file) {
      const auto rows =
          config::read_csv(file, {time_, place_, height, {"height_error_m", "m", "its standard deviation", 0.0, any}});
      need_rows(table, "shape.file", rows[0].size());
      for (std::size_t i = 0; i < rows[0].size(); ++i)
        add("row " + std::to_string(i + 1), rows[0][i], rows[1][i], rows[2][i], rows[3][i]);
      return;
    }
    const auto run = open_netcdf(file);
    const auto times = read_variable(run, file, "series_time", time_), x = read_variable(run, file, "x", place_);
    const auto heights = read_variable(run, file, "height_series", height);
    for (const std::size_t k : records_at(table, "shape.times", times.values))
      for (std::size_t i = 0; i < x.values.size(); ++i)
        add("column " + std::to_string(i + 1), times.values[k], x.values[i], heights.values[k * x.values.size() + i],
            table.number("shape.error"));
  }

  void read_series(const Values& table) {
    const auto& quantity = *std::ranges::find(quantities, table.text("series.quantity"), &Quantity::name);
    const auto file = folder_ / table.text("series.file");
    const CsvColumn column{quantity.column, quantity.unit, quantity.name, -any, any};
    const auto add = [&](std::size_t row, double t, double value, double error) {
      stage_.data.push_back({table.text("series.file") + " row " + std::to_string(row + 1), quantity.name,
                             quantity.unit, t, none, value, error});
    };
    const bool run_file = is_netcdf(file);
    if (!keys_fit(table, "series", run_file, false)) return;
    if (!run_file) {
      const auto rows = config::read_csv(
          file, {time_, column, {error_column(column.name), column.unit, "its standard deviation", 0.0, any}});
      need_rows(table, "series.file", rows[0].size());
      for (std::size_t i = 0; i < rows[0].size(); ++i) add(i, rows[0][i], rows[1][i], rows[2][i]);
      return;
    }
    const auto run = open_netcdf(file);
    const auto times = read_variable(run, file, "series_time", time_),
               values = read_variable(run, file, quantity.name, column);
    for (const std::size_t k : records_at(table, "series.times", times.values))
      add(k, times.values[k], values.values[k], table.number("series.error"));
  }

 private:
  /// Times to be taken from a run file, found among those recorded.
  std::vector<std::size_t> records_at(const Values& table, const char* key, const std::vector<double>& recorded) {
    std::vector<std::size_t> out;
    if (!table.has(key)) {
      for (std::size_t i = 0; i < recorded.size(); ++i) out.push_back(i);
      return out;
    }
    for (const double t : table.numbers(key)) {
      const auto found =
          std::ranges::find_if(recorded, [&](double each) { return std::abs(each - t) <= 1e-9 * std::max(1.0, t); });
      if (found == recorded.end())
        problems_.add(table.place(key), key, "nothing is recorded at " + shortest(t) + " s in the file");
      else out.push_back(static_cast<std::size_t>(found - recorded.begin()));
    }
    return out;
  }

  /// Whether `error` and `times` stand where they should: with run files, and not with CSV.
  bool keys_fit(const Values& table, const std::string& section, bool run_file, bool needs_times) {
    const std::string error = section + ".error", times = section + ".times";
    const std::size_t before = n_refused_;
    const auto refuse = [&](const std::string& key, const std::string& what) {
      problems_.add(table.place(table.has(key) ? key : section + ".file"), key, what);
      ++n_refused_;
    };
    if (run_file && !table.has(error)) refuse(error, "missing; a run file states no errors of measurement");
    if (run_file && needs_times && !table.has(times))
      refuse(times, "missing; which of the times of the run file are meant [s]");
    if (!run_file && table.has(error)) refuse(error, "is for run files; a CSV file has a column of its own");
    if (!run_file && table.has(times)) refuse(times, "is for run files; of a CSV file all rows count");
    return n_refused_ == before;
  }

  void need_rows(const Values& table, const char* key, std::size_t n) {
    if (n == 0) problems_.add(table.place(key), key, table.text(key) + ": expected at least 1 row of data, found 0");
  }

  std::filesystem::path folder_;
  fit::LayerStage& stage_;
  Problems& problems_;
  CsvColumn time_{}, place_{};
  std::size_t n_refused_ = 0;
};

}  // namespace

std::vector<std::string> series_quantities() {
  std::vector<std::string> names;
  for (const auto& q : quantities) names.push_back(q.name);
  return names;
}

void read_layer_data(const Values& values, const std::filesystem::path& folder, const std::filesystem::path& scene_file,
                     const Scene& scene, fit::LayerStage& stage, Problems& problems) {
  Reader reader(folder, scene_file, scene, stage, problems);
  for (const auto& table : values.tables("shape")) reader.read_shape(table);
  for (const auto& table : values.tables("series")) reader.read_series(table);
}

}  // namespace talus::app
