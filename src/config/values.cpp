#include "config/values.hpp"

#include <stdexcept>

namespace talus::config {

template <class T>
const T& Values::get(std::string_view name) const {
  const auto found = entries_.find(name);
  if (found == entries_.end()) throw std::logic_error("no value for key " + std::string(name));
  const T* value = std::get_if<T>(&found->second.value);
  if (value == nullptr) throw std::logic_error("key " + std::string(name) + " is of another type");
  return *value;
}
template const double& Values::get<double>(std::string_view) const;
template const std::int64_t& Values::get<std::int64_t>(std::string_view) const;
template const bool& Values::get<bool>(std::string_view) const;
template const std::string& Values::get<std::string>(std::string_view) const;
template const std::vector<double>& Values::get<std::vector<double>>(std::string_view) const;
template const std::vector<std::string>& Values::get<std::vector<std::string>>(std::string_view) const;
template const std::vector<Scalar>& Values::get<std::vector<Scalar>>(std::string_view) const;

const std::vector<Values>& Values::tables(std::string_view section) const {
  static const std::vector<Values> none;
  const auto found = tables_.find(section);
  return found == tables_.end() ? none : found->second;
}

std::string Values::toml(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? "" : config::to_toml(found->second.value);
}

std::string Values::place(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() || found->second.place.empty() ? file_ : found->second.place;
}

void Values::set(const std::string& name, Value value, std::string place) {
  entries_.insert_or_assign(name, Entry{std::move(value), std::move(place)});
}

void Values::add_table(const std::string& section, Values table) { tables_[section].push_back(std::move(table)); }

std::string Values::to_toml() const {
  std::string out;
  for (const auto& section : schema_->sections()) {
    if (section.repeated) continue;
    out += (out.empty() ? "[" : "\n[") + section.name + "]\n";
    for (const auto& key : section.keys) {
      const auto found = entries_.find(key.name);
      const std::string local = key.name.substr(section.name.size() + 1);
      if (found == entries_.end()) {
        out += "# " + local + ": " + key.condition + "\n";
        continue;
      }
      out += local + " = " + config::to_toml(found->second.value);
      if (!key.unit.empty()) out += "  # " + key.unit;
      if (found->second.place.empty()) out += key.unit.empty() ? "  # default" : ", default";
      out += "\n";
    }
  }
  return out;
}

std::vector<Difference> differences(const Values& before, const Values& after) {
  std::vector<Difference> all;
  for (const auto& section : before.schema().sections()) {
    for (const auto& key : section.keys) {
      Difference each{key.name, before.toml(key.name), after.toml(key.name)};
      if (each.before != each.after) all.push_back(std::move(each));
    }
  }
  return all;
}

}  // namespace talus::config
