#include "config/read.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "config/problems.hpp"
#include "core/errors.hpp"

namespace talus::config {
namespace {

std::string kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "a list";
    case toml::node_type::string: return "the text \"" + **node.as_string() + "\"";
    case toml::node_type::integer: return "the integer " + std::to_string(**node.as_integer());
    case toml::node_type::floating_point: {
      std::ostringstream out;
      out << "the number " << **node.as_floating_point();
      return out.str();
    }
    case toml::node_type::boolean: return **node.as_boolean() ? "true" : "false";
    default: return "a date or time";
  }
}

/// What stands where `key` expected something else.
std::string found_instead(const Key& key, const toml::node& node) {
  if (const auto* x = node.as_floating_point(); x != nullptr && !std::isfinite(**x))
    return kind_of(node) + ", which is not finite";
  if (key.type == Type::numbers && node.is_array()) return "a list that holds something else";
  return kind_of(node);
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

using Item = std::pair<const toml::key*, const toml::node*>;

/// A table's items as they stand in the file; the library sorts them by name.
std::vector<Item> in_file_order(const toml::table& table) {
  std::vector<Item> items;
  for (const auto& [name, node] : table) items.emplace_back(&name, &node);
  std::ranges::sort(items,
                    [](const Item& a, const Item& b) { return a.first->source().begin < b.first->source().begin; });
  return items;
}

std::optional<double> finite_number(const toml::node& node) {
  if (const auto* i = node.as_integer()) return static_cast<double>(**i);
  if (const auto* x = node.as_floating_point(); x != nullptr && std::isfinite(**x)) return **x;
  return std::nullopt;
}

/// The node as the key's type, or nothing. An integer passes for a number; nothing else is converted.
std::optional<Value> convert(const Key& key, const toml::node& node) {
  switch (key.type) {
    case Type::number:
      if (const auto x = finite_number(node)) return *x;
      break;
    case Type::integer:
      if (const auto* i = node.as_integer()) return **i;
      break;
    case Type::boolean:
      if (const auto* b = node.as_boolean()) return **b;
      break;
    case Type::text:
    case Type::choice:
      if (const auto* s = node.as_string()) return **s;
      break;
    case Type::numbers:
      if (const auto* array = node.as_array()) {
        std::vector<double> list;
        for (const auto& item : *array) {
          const auto x = finite_number(item);
          if (!x) return std::nullopt;
          list.push_back(*x);
        }
        return list;
      }
      break;
  }
  return std::nullopt;
}

class Reader {
 public:
  Reader(const Schema& schema, std::string file) : schema_(schema), file_(std::move(file)), values_(schema, file_) {}

  void parse(std::string_view source) {
    try {
      walk_top(toml::parse(source, file_));
    } catch (const toml::parse_error& error) {
      problems_.add(at(error.source()), "", "not valid TOML: " + std::string(error.description()));
      problems_.throw_if_any();  // nothing else is known of the file
    }
  }

  void override_with(const std::string& assignment) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
      problems_.add("--set " + assignment, "", "expected key=value");
      return;
    }
    const std::string name = trimmed(assignment.substr(0, equals));
    const std::string value = trimmed(assignment.substr(equals + 1));
    const Key* key = schema_.find(name);
    if (key == nullptr) {
      problems_.add("--set", name, "unknown key" + schema_.suggest_key(name));
      return;
    }
    if (!overridden_.insert(name).second) {
      problems_.add("--set", name, "given twice");
      return;
    }
    const bool bare_text = (key->type == Type::text || key->type == Type::choice) && !value.starts_with('"');
    if (bare_text) {
      accept(*key, toml::value<std::string>(value), "--set");
      return;
    }
    try {
      const toml::table parsed = toml::parse("value = " + value);
      if (parsed.size() == 1) {
        accept(*key, *parsed.get("value"), "--set");
        return;
      }
    } catch (const toml::parse_error&) {
      // reported below, in the key's own terms
    }
    problems_.add("--set", name, "expected " + key->expectation() + ", found " + value);
  }

  Values finish() {
    for (const auto& section : schema_.sections()) {
      for (const auto& key : section.keys) {
        if (values_.has(key.name) || refused_.contains(key.name)) continue;
        if (key.value_if_absent) values_.set(key.name, *key.value_if_absent, "");
        if (key.required) missing(key, section);
      }
    }
    if (problems_.none()) require_conditional_keys();
    problems_.throw_if_any();
    return std::move(values_);
  }

 private:
  [[nodiscard]] std::string at(const toml::source_region& source) const {
    return file_ + ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column);
  }

  void walk_top(const toml::table& root) {
    for (const auto& [name, node] : in_file_order(root)) {
      const std::string section(name->str());
      if (schema_.find_section(section) == nullptr) {
        problems_.add(at(name->source()), section,
                      node->is_table() ? "unknown section" + schema_.suggest_section(section)
                                       : "key outside a section" + schema_.suggest_key(section));
      } else if (const auto* table = node->as_table()) {
        section_place_[section] = at(name->source());
        walk_section(section, *table);
      } else {
        problems_.add(at(name->source()), section, "expected a section [" + section + "], found " + kind_of(*node));
      }
    }
  }

  void walk_section(const std::string& section, const toml::table& table) {
    for (const auto& [local, node] : in_file_order(table)) {
      const std::string name = section + "." + std::string(local->str());
      if (const Key* key = schema_.find(name)) {
        accept(*key, *node, at(local->source()));
      } else {
        problems_.add(at(local->source()), name, "unknown key" + schema_.suggest_key(name));
      }
    }
  }

  void accept(const Key& key, const toml::node& node, const std::string& place) {
    refused_.erase(key.name);
    const auto value = convert(key, node);
    if (!value) {
      refuse(key, place, "expected " + key.expectation() + ", found " + found_instead(key, node));
    } else if (const auto complaint = key.complaint(*value)) {
      refuse(key, place, *complaint);
    } else {
      values_.set(key.name, *value, place);
    }
  }

  void refuse(const Key& key, const std::string& place, const std::string& complaint) {
    problems_.add(place, key.name, complaint);
    refused_.insert(key.name);
  }

  void missing(const Key& key, const Section& section) {
    const auto found = section_place_.find(section.name);
    problems_.add(found == section_place_.end() ? file_ : found->second, key.name,
                  "missing; expected " + key.expectation() + ": " + key.doc);
  }

  void require_conditional_keys() {
    for (const auto& section : schema_.sections()) {
      for (const auto& key : section.keys) {
        if (key.is_needed && !values_.has(key.name) && key.is_needed(values_)) missing(key, section);
      }
    }
  }

  const Schema& schema_;
  std::string file_;
  Values values_;
  Problems problems_;
  std::map<std::string, std::string> section_place_;
  std::set<std::string> overridden_;
  std::set<std::string> refused_;
};

}  // namespace

Values read_text(const Schema& schema, std::string_view toml, const std::string& name,
                 const std::vector<std::string>& overrides) {
  Reader reader(schema, name);
  reader.parse(toml);
  for (const auto& assignment : overrides) reader.override_with(assignment);
  return reader.finish();
}

Values read(const Schema& schema, const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  std::ifstream in(file);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (std::filesystem::is_directory(file) || !in) {
    throw core::ConfigError(file.string() + ": cannot be read as a scene file");
  }
  return read_text(schema, text, file.string(), overrides);
}

}  // namespace talus::config
