#include "config/schema.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "config/spelling.hpp"
#include "core/errors.hpp"

namespace talus::config {
namespace {

std::string offer(const std::optional<std::string>& name) { return name ? " (did you mean " + *name + "?)" : ""; }

std::string presence(const Key& key) {
  if (key.required) return "required";
  if (key.value_if_absent) return "default " + to_toml(*key.value_if_absent);
  return key.condition;
}

std::string local_name(std::string_view dotted) { return std::string(dotted.substr(dotted.find('.') + 1)); }

std::string heading(const Section& section) {
  return section.repeated ? "[[" + section.name + "]]" : "[" + section.name + "]";
}

std::string explain_section(const Section& section) {
  std::string out = heading(section) + "  " + section.doc + "\n";
  for (const Key& key : section.keys) {
    out += "  " + local_name(key.name) + "\n      " + key.doc + "\n      " + key.expectation() + "; " + presence(key) +
           "\n";
  }
  return out;
}

}  // namespace

Schema& Schema::section(std::string name, std::string doc) {
  if (find_section(name) != nullptr) throw std::logic_error("schema: section " + name + " declared twice");
  sections_.push_back({std::move(name), std::move(doc), {}});
  return *this;
}

Schema& Schema::repeated_section(std::string name, std::string doc) {
  section(std::move(name), std::move(doc));
  sections_.back().repeated = true;
  return *this;
}

Schema& Schema::add(Key key) {
  if (sections_.empty()) throw std::logic_error("schema: key " + key.name + " outside a section");
  key.name = sections_.back().name + "." + key.name;
  if (find(key.name) != nullptr) throw std::logic_error("schema: key " + key.name + " declared twice");
  if (key.value_if_absent && key.complaint(*key.value_if_absent)) {
    throw std::logic_error("schema: the default of " + key.name + " is not allowed");
  }
  sections_.back().keys.push_back(std::move(key));
  return *this;
}

Schema Schema::with_requirements(const std::function<bool(std::string_view)>& required) const {
  Schema changed = *this;
  for (auto& section : changed.sections_) {
    for (auto& key : section.keys) {
      if (!key.value_if_absent && !key.is_needed && key.condition.empty()) key.required = required(key.name);
      if (!key.required && key.condition.empty()) key.condition = "optional";
    }
  }
  return changed;
}

const Section* Schema::find_section(std::string_view name) const {
  const auto found = std::ranges::find(sections_, name, &Section::name);
  return found == sections_.end() ? nullptr : &*found;
}

const Key* Schema::find(std::string_view name) const {
  const Section* section = find_section(name.substr(0, name.find('.')));
  if (section == nullptr) return nullptr;
  const auto found = std::ranges::find(section->keys, name, &Key::name);
  return found == section->keys.end() ? nullptr : &*found;
}

std::string Schema::suggest_key(std::string_view name) const {
  std::vector<std::string> dotted;
  for (const auto& section : sections_) {
    for (const auto& key : section.keys) {
      if (local_name(key.name) == local_name(name)) return offer(key.name);
      dotted.push_back(key.name);
    }
  }
  // The section is right more often than not: the letters of the key alone decide there.
  if (const Section* section = find_section(name.substr(0, name.find('.')))) {
    std::vector<std::string> local;
    for (const auto& key : section->keys) local.push_back(local_name(key.name));
    if (const auto found = nearest(local_name(name), local)) return offer(section->name + "." + *found);
  }
  return offer(nearest(name, dotted));
}

std::string Schema::suggest_section(std::string_view name) const {
  std::vector<std::string> names;
  for (const auto& section : sections_) names.push_back(section.name);
  return offer(nearest(name, names));
}

std::string explain(const Schema& schema, std::string_view section) {
  if (!section.empty()) {
    if (const Section* found = schema.find_section(section)) return explain_section(*found);
    throw core::ConfigError("unknown section " + std::string(section) + schema.suggest_section(section));
  }
  std::string out;
  for (const auto& each : schema.sections()) out += (out.empty() ? "" : "\n") + explain_section(each);
  return out;
}

}  // namespace talus::config
