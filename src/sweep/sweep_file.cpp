#include "sweep/sweep_file.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "config/name.hpp"
#include "config/problems.hpp"
#include "config/read.hpp"
#include "sweep/axis_table.hpp"
#include "sweep/sampling.hpp"

namespace talus::sweep {
namespace {

using config::Problems;
using config::Values;

/// Names that a collected file gives to dimensions of its own.
constexpr std::array<std::string_view, 4> reserved{"member", "sample", "record_time", "series_time"};

/// Gathers axes into dimensions, in the order of the file.
class Builder {
 public:
  Builder(const Values& values, Problems& problems) : values_(values), problems_(problems) {}

  void read(const config::Schema& scene_schema) {
    const bool samples = values_.has("sample.members");
    std::set<std::string> keys;
    for (const auto& table : values_.tables("axis")) {
      const auto axis = read_axis(table, scene_schema, samples, problems_);
      if (!axis) continue;
      if (!keys.insert(axis->axis.key).second) {
        problems_.add(table.place("axis.key"), "axis.key", axis->axis.key + ": expected one axis for a key");
        continue;
      }
      place(*axis);
    }
    if (values_.tables("axis").empty())
      problems_.add(values_.place(""), "axis", "missing; expected [[axis]], at least one");
    if (samples && sample_.empty() && problems_.none()) {
      problems_.add(values_.place("sample.members"), "sample.members",
                    "expected an axis to draw, with axis.from and axis.to but without axis.count");
    }
    for (const auto& setting : values_.texts("sweep.set")) {
      const std::string key = setting.substr(0, setting.find_first_of(" ="));
      if (keys.contains(key)) problems_.add(values_.place("sweep.set"), "sweep.set", key + ": is an axis, too");
    }
    check_product();
  }

  std::vector<Dimension> take() {
    if (!sample_.empty()) draw();
    if (dimensions_.size() == 1 && (dimensions_.front().axes.size() > 1 || !sample_.empty()))
      dimensions_.front().name = "member";
    return std::move(dimensions_);
  }

 private:
  void place(const AxisTable& axis) {
    if (axis.sampled) {
      if (sample_.empty()) {
        sample_dimension_ = dimensions_.size();
        dimensions_.push_back({"sample", {}});
      }
      sample_.push_back(axis);
    } else if (axis.zip.empty()) {
      check_distinct(axis);
      const std::string name = netcdf_name(axis.axis.key);
      if (zips_.contains(name))
        problems_.add(axis.table->place("axis.key"), "axis.key", "expected no other axes with zip = \"" + name + "\"");
      dimensions_.push_back({name, {axis.axis}});
    } else {
      zip(axis);
    }
  }

  void zip(const AxisTable& axis) {
    const auto refuse = [&](const std::string& what) {
      problems_.add(axis.table->place("axis.zip"), "axis.zip", what);
    };
    if (!config::is_plain_name(axis.zip)) refuse(std::string("expected ") + config::plain_name);
    if (std::ranges::find(reserved, axis.zip) != reserved.end()) refuse("expected another word than " + axis.zip);
    const bool first = zips_.insert(axis.zip).second;
    const auto found = std::ranges::find(dimensions_, axis.zip, &Dimension::name);
    if (first && found != dimensions_.end()) {
      refuse("expected another word than " + axis.zip + ", the name of another dimension");
    } else if (first) {
      dimensions_.push_back({axis.zip, {axis.axis}});
    } else if (found->size() != axis.axis.values.size()) {
      refuse("expected " + std::to_string(found->size()) + " values as " + found->axes.front().key + " has, found " +
             std::to_string(axis.axis.values.size()));
    } else {
      found->axes.push_back(axis.axis);
    }
  }

  void check_distinct(const AxisTable& axis) {
    const auto& all = axis.axis.values;
    for (auto value = all.begin(); value != all.end(); ++value) {
      if (std::find(all.begin(), value, *value) == value) continue;
      const bool listed = axis.table->has("axis.values");
      problems_.add(axis.table->place(listed ? "axis.values" : "axis.count"), listed ? "axis.values" : "axis.count",
                    axis.axis.key + ": expected different values, found " + config::to_toml(config::value_of(*value)) +
                        " more than once");
      return;
    }
  }

  void check_product() {
    std::size_t n = 1;
    for (std::size_t i = 0; i < dimensions_.size(); ++i) {
      const bool sample = !sample_.empty() && i == sample_dimension_;
      n *= sample ? static_cast<std::size_t>(values_.integer("sample.members")) : dimensions_[i].size();
      if (n > most_members) {
        problems_.add(values_.place(""), "axis",
                      "expected at most " + std::to_string(most_members) + " members in all");
        return;
      }
    }
  }

  void draw() {
    const auto n = static_cast<std::size_t>(values_.integer("sample.members"));
    const auto seed = static_cast<std::uint64_t>(values_.integer("sample.seed"));
    const auto points = values_.text("sample.method") == "random" ? random_points(sample_.size(), n, seed)
                                                                  : latin_hypercube(sample_.size(), n, seed);
    for (std::size_t i = 0; i < sample_.size(); ++i) {
      Axis axis = sample_[i].axis;
      for (const double share : points[i]) axis.values.push_back(value_at(sample_[i], share));
      dimensions_[sample_dimension_].axes.push_back(std::move(axis));
    }
  }

  const Values& values_;
  Problems& problems_;
  std::vector<Dimension> dimensions_;
  std::set<std::string> zips_;
  std::vector<AxisTable> sample_;
  std::size_t sample_dimension_ = 0;
};

}  // namespace

SweepFile read_sweep(const std::filesystem::path& file, const config::Schema& scene_schema) {
  const Values values = config::read(sweep_schema(), file);
  Problems problems;
  const std::string& name = values.text("sweep.name");
  if (!config::is_plain_name(name)) {
    problems.add(values.place("sweep.name"), "sweep.name", std::string("expected ") + config::plain_name);
  }
  Builder builder(values, problems);
  builder.read(scene_schema);
  problems.throw_if_any();
  return {name, values.text("sweep.title"), file.parent_path() / values.text("sweep.scene"), values.texts("sweep.set"),
          Design(builder.take())};
}

}  // namespace talus::sweep
