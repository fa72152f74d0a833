#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "config/key.hpp"

namespace talus::config {

/// A table of the file and its keys.
struct Section {
  std::string name;
  std::string doc;
  std::vector<Key> keys;
  bool repeated = false;  ///< stands any number of times, as [[name]]
};

/// Every key that a scene file may hold, in the order in which scenes are printed.
class Schema {
 public:
  /// Opens a section; the keys added next belong to it.
  Schema& section(std::string name, std::string doc);
  /// Opens a section that may stand any number of times in the file, each time as [[name]].
  Schema& repeated_section(std::string name, std::string doc);
  /// Throws std::logic_error outside a section, for a name already declared, or for a default that the key refuses.
  Schema& add(Key key);

  /// The same keys, of which those without a default are required if and only if `required` holds for their dotted name;
  /// a condition stays a condition.
  [[nodiscard]] Schema with_requirements(const std::function<bool(std::string_view)>& required) const;

  [[nodiscard]] const std::vector<Section>& sections() const { return sections_; }
  /// By dotted name, or null.
  [[nodiscard]] const Key* find(std::string_view name) const;
  [[nodiscard]] const Section* find_section(std::string_view name) const;
  /// " (did you mean box.gap?)" for the nearest known key, or "".
  [[nodiscard]] std::string suggest_key(std::string_view name) const;
  [[nodiscard]] std::string suggest_section(std::string_view name) const;

 private:
  std::vector<Section> sections_;
};

/// The reference text of one section, or of all for an empty name: each key with type, range, unit, default and doc.
/// Throws core::ConfigError for an unknown section.
std::string explain(const Schema& schema, std::string_view section = {});

}  // namespace talus::config
