#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "config/key.hpp"
#include "config/schema.hpp"

namespace talus::config {

/// The checked values of a scene: every key of its schema that was given or has a default.
class Values {
 public:
  /// `file` names the source in messages.
  Values(const Schema& schema, std::string file) : schema_(&schema), file_(std::move(file)) {}
  Values(Schema&&, std::string) = delete;

  [[nodiscard]] const Schema& schema() const { return *schema_; }
  [[nodiscard]] bool has(std::string_view name) const { return entries_.contains(name); }
  // Getters throw std::logic_error for a key that is absent or of another type: the program's fault, not the scene's.
  [[nodiscard]] double number(std::string_view name) const { return get<double>(name); }
  [[nodiscard]] std::int64_t integer(std::string_view name) const { return get<std::int64_t>(name); }
  [[nodiscard]] bool boolean(std::string_view name) const { return get<bool>(name); }
  [[nodiscard]] const std::string& text(std::string_view name) const { return get<std::string>(name); }
  [[nodiscard]] const std::vector<double>& numbers(std::string_view name) const {
    return get<std::vector<double>>(name);
  }

  [[nodiscard]] const std::vector<std::string>& texts(std::string_view name) const {
    return get<std::vector<std::string>>(name);
  }
  [[nodiscard]] const std::vector<Scalar>& scalars(std::string_view name) const {
    return get<std::vector<Scalar>>(name);
  }
  /// The tables of a repeated section as they stand in the file, each with its own values of the section's keys.
  [[nodiscard]] const std::vector<Values>& tables(std::string_view section) const;
  /// The value as TOML; "" for a key that is absent.
  [[nodiscard]] std::string toml(std::string_view name) const;
  /// Where the key was given: "scene.toml:12:1", "--set", or the file's name for a default.
  [[nodiscard]] std::string place(std::string_view name) const;
  /// Stores a value that its key accepts. An empty place marks a default.
  void set(const std::string& name, Value value, std::string place);
  /// Stores the next table of a repeated section.
  void add_table(const std::string& section, Values table);
  /// The scene with all defaults filled in, as TOML that reads back to the same values; without repeated sections.
  [[nodiscard]] std::string to_toml() const;

 private:
  struct Entry {
    Value value;
    std::string place;
  };
  template <class T>
  const T& get(std::string_view name) const;

  const Schema* schema_;
  std::string file_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::map<std::string, std::vector<Values>, std::less<>> tables_;
};

/// A key with one value here and another there, as TOML; "" where it is absent.
struct Difference {
  std::string key;
  std::string before, after;
};

/// Keys on which two sets of values of one schema differ, in the schema's order.
std::vector<Difference> differences(const Values& before, const Values& after);

}  // namespace talus::config
