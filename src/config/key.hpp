#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace talus::config {

class Values;

enum class Type : std::uint8_t { number, integer, boolean, text, choice, numbers, texts, scalars };

/// A single value: number, integer, boolean, text (also a chosen word).
using Scalar = std::variant<double, std::int64_t, bool, std::string>;
/// The value of a key: a single one, or a list of numbers, of texts, or of any single values.
using Value = std::variant<double, std::int64_t, bool, std::string, std::vector<double>, std::vector<std::string>,
                           std::vector<Scalar>>;

/// An interval; each end may be open. Infinite ends do not restrict.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  [[nodiscard]] bool contains(double x) const;
};

/// All that is known of one key of a scene file, declared once. Required unless `fallback`, `optional` or `required_if`
/// says otherwise. Numbers are always finite.
struct Key {
  std::string name;  ///< within its section until Schema::add makes it dotted, "box.gap"
  Type type = Type::number;
  std::string unit;  ///< "" where a unit has no meaning
  std::string doc;   ///< one line
  Range range{};
  std::vector<std::string> words{};  ///< of a choice
  bool ascending = false;            ///< of a list: strictly
  bool required = true;
  std::optional<Value> value_if_absent{};
  std::string condition{};  ///< in words: when an otherwise optional key is required
  std::function<bool(const Values&)> is_needed{};

  Key&& above(double low) &&;  ///< open lower end
  Key&& at_least(double low) &&;
  Key&& below(double high) &&;  ///< open upper end
  Key&& at_most(double high) &&;
  Key&& fallback(Value value) &&;  ///< the default
  Key&& optional(std::string meaning_of_absence) &&;
  /// Optional, but required where `needed` holds; `when` says so in words.
  Key&& required_if(std::string when, std::function<bool(const Values&)> needed) &&;

  /// What the key accepts, with range and unit: "a number above 0 m".
  [[nodiscard]] std::string expectation() const;
  /// What is wrong with a finite value of the right type, or nothing.
  [[nodiscard]] std::optional<std::string> complaint(const Value& value) const;
  /// `value` as the key's type, or nothing. An integer passes for a number; nothing else is converted.
  [[nodiscard]] std::optional<Value> converted(const Scalar& value) const;
};

Key number(std::string name, std::string unit, std::string doc);
Key integer(std::string name, std::string doc);
Key boolean(std::string name, std::string doc);
Key text(std::string name, std::string doc);
Key choice(std::string name, std::vector<std::string> words, std::string doc);
/// A list of numbers in any order.
Key numbers(std::string name, std::string unit, std::string doc);
/// A list of numbers, strictly ascending.
Key ascending_numbers(std::string name, std::string unit, std::string doc);
/// A list of texts.
Key texts(std::string name, std::string doc);
/// A list of one or more single values of any types; whoever knows which are right checks them.
Key scalars(std::string name, std::string doc);

/// A value as TOML source; doubles in the shortest form that reads back to the same bits.
std::string to_toml(const Value& value);
Value value_of(const Scalar& scalar);

}  // namespace talus::config
