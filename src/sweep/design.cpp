#include "sweep/design.hpp"

#include <algorithm>

namespace talus::sweep {

std::string netcdf_name(std::string key) {
  std::ranges::replace(key, '.', '_');
  return key;
}

std::string heading(const Axis& axis) { return axis.unit.empty() ? axis.key : axis.key + " [" + axis.unit + "]"; }

std::string plain(const config::Scalar& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : config::to_toml(config::value_of(value));
}

std::size_t Design::size() const {
  std::size_t n = 1;
  for (const auto& dimension : dimensions_) n *= dimension.size();
  return n;
}

std::vector<std::size_t> Design::point(std::size_t member) const {
  std::vector<std::size_t> point(dimensions_.size());
  for (std::size_t i = dimensions_.size(); i-- > 0;) {
    point[i] = member % dimensions_[i].size();
    member /= dimensions_[i].size();
  }
  return point;
}

std::vector<Setting> Design::settings(std::size_t member) const {
  const auto at = point(member);
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < dimensions_.size(); ++i) {
    for (const auto& axis : dimensions_[i].axes) settings.push_back({axis, axis.values[at[i]]});
  }
  return settings;
}

std::string Design::describe(std::size_t member) const {
  std::string out;
  const auto at = point(member);
  for (std::size_t i = 0; i < dimensions_.size(); ++i) {
    const auto& dimension = dimensions_[i];
    if (!dimension.labels.empty()) {
      out += (out.empty() ? "" : ", ") + dimension.labels[at[i]];
      continue;
    }
    for (const auto& axis : dimension.axes) {
      out += (out.empty() ? "" : ", ") + axis.key + " = " + config::to_toml(config::value_of(axis.values[at[i]]));
      if (!axis.unit.empty() && axis.unit != "1") out += " " + axis.unit;
    }
  }
  return out;
}

}  // namespace talus::sweep
