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
  const bool list = key.type == Type::numbers || key.type == Type::texts || key.type == Type::scalars;
  if (list && node.is_array()) return "a list that holds something else";
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

std::optional<Scalar> single(const toml::node& node) {
  if (const auto* i = node.as_integer()) return **i;
  if (const auto* x = node.as_floating_point(); x != nullptr && std::isfinite(**x)) return **x;
  if (const auto* b = node.as_boolean()) return **b;
  if (const auto* s = node.as_string()) return **s;
  return std::nullopt;
}

/// An array's items, each as what `item` makes of a single value; nothing if that fails for any of them.
template <class T, class Item>
std::optional<Value> list_of(const toml::node& node, const Item& item) {
  const auto* array = node.as_array();
  if (array == nullptr) return std::nullopt;
  std::vector<T> list;
  for (const auto& each : *array) {
    const auto value = single(each);
    const std::optional<T> fitting = value ? item(*value) : std::nullopt;
    if (!fitting) return std::nullopt;
    list.push_back(*fitting);
  }
  return list;
}

std::optional<double> as_number(const Scalar& value) {
  if (const auto* i = std::get_if<std::int64_t>(&value)) return static_cast<double>(*i);
  const auto* x = std::get_if<double>(&value);
  return x == nullptr ? std::nullopt : std::optional(*x);
}

std::optional<std::string> as_text(const Scalar& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr ? std::nullopt : std::optional(*text);
}

/// The node as the key's type, or nothing.
std::optional<Value> convert(const Key& key, const toml::node& node) {
  switch (key.type) {
    case Type::numbers: return list_of<double>(node, as_number);
    case Type::texts: return list_of<std::string>(node, as_text);
    case Type::scalars: return list_of<Scalar>(node, [](const Scalar& value) { return std::optional(value); });
    default: break;
  }
  const auto value = single(node);
  return value ? key.converted(*value) : std::nullopt;
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
      if (!section.repeated) complete(section);
    }
    if (problems_.none()) {
      for (const auto& section : schema_.sections()) {
        if (!section.repeated) require_conditional_keys(section);
      }
    }
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
      } else if (schema_.find_section(section)->repeated) {
        walk_repeated(*schema_.find_section(section), *node, at(name->source()));
      } else if (const auto* table = node->as_table()) {
        section_place_[section] = at(name->source());
        walk_section(section, *table);
      } else {
        problems_.add(at(name->source()), section, "expected a section [" + section + "], found " + kind_of(*node));
      }
    }
  }

  /// Each table has values of its own, complete in themselves.
  void walk_repeated(const Section& section, const toml::node& node, const std::string& place) {
    const auto* list = node.as_array();
    if (list == nullptr || !list->is_homogeneous(toml::node_type::table)) {
      problems_.add(place, section.name,
                    "expected [[" + section.name + "]], once for each, found " +
                        (list == nullptr ? kind_of(node) : "a list that holds something else"));
      return;
    }
    for (const auto& each : *list) {
      Reader reader(schema_, file_);
      reader.section_place_[section.name] = at(each.source());
      reader.walk_section(section.name, *each.as_table());
      reader.complete(section);
      if (reader.problems_.none()) reader.require_conditional_keys(section);
      problems_.add(reader.problems_);
      values_.add_table(section.name, std::move(reader.values_));
    }
  }

  void complete(const Section& section) {
    for (const auto& key : section.keys) {
      if (values_.has(key.name) || refused_.contains(key.name)) continue;
      if (key.value_if_absent) values_.set(key.name, *key.value_if_absent, "");
      if (key.required) missing(key, section);
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

  void require_conditional_keys(const Section& section) {
    for (const auto& key : section.keys) {
      if (key.is_needed && !values_.has(key.name) && key.is_needed(values_)) missing(key, section);
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
    throw core::ConfigError(file.string() + ": cannot be read as a TOML file");
  }
  return read_text(schema, text, file.string(), overrides);
}

}  // namespace talus::config
