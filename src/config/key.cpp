#include "config/key.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

#include "config/spelling.hpp"

namespace talus::config {
namespace {

std::string shortest(double x) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x).ptr;
  return {buffer.data(), end};
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (code < 0x20 || code == 0x7f) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04X", static_cast<unsigned>(code));
      out += escape.data();
    } else {
      out += c;
    }
  }
  return out + '"';
}

struct ToToml {
  std::string operator()(double x) const {
    const std::string s = shortest(x);
    return s.find_first_of(".en") == std::string::npos ? s + ".0" : s;
  }
  std::string operator()(std::int64_t i) const { return std::to_string(i); }
  std::string operator()(bool b) const { return b ? "true" : "false"; }
  std::string operator()(const std::string& s) const { return quoted(s); }
  std::string operator()(const Scalar& value) const { return std::visit(*this, value); }
  template <class T>
  std::string operator()(const std::vector<T>& list) const {
    std::string out = "[";
    for (const T& item : list) out += (out.size() > 1 ? ", " : "") + (*this)(item);
    return out + "]";
  }
};

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const auto& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

Key make(Type type, std::string name, std::string unit, std::string doc) {
  return {.name = std::move(name), .type = type, .unit = std::move(unit), .doc = std::move(doc)};
}

}  // namespace

bool Range::contains(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }

Key&& Key::above(double low) && {
  range.low = low;
  range.low_open = true;
  return std::move(*this);
}

Key&& Key::at_least(double low) && {
  range.low = low;
  range.low_open = false;
  return std::move(*this);
}

Key&& Key::below(double high) && {
  range.high = high;
  range.high_open = true;
  return std::move(*this);
}

Key&& Key::at_most(double high) && {
  range.high = high;
  range.high_open = false;
  return std::move(*this);
}

Key&& Key::fallback(Value value) && {
  required = false;
  value_if_absent = std::move(value);
  return std::move(*this);
}

Key&& Key::optional(std::string meaning_of_absence) && {
  required = false;
  condition = "optional; absent: " + std::move(meaning_of_absence);
  return std::move(*this);
}

Key&& Key::required_if(std::string when, std::function<bool(const Values&)> needed) && {
  required = false;
  condition = "required where " + std::move(when);
  is_needed = std::move(needed);
  return std::move(*this);
}

std::string Key::expectation() const {
  std::string what;
  switch (type) {
    case Type::number: what = "a number"; break;
    case Type::integer: what = "an integer"; break;
    case Type::boolean: return "true or false";
    case Type::text: return "a text in quotes";
    case Type::choice: return "one of " + joined(words);
    case Type::numbers: what = ascending ? "an ascending list of numbers" : "a list of numbers"; break;
    case Type::texts: return "a list of texts in quotes";
    case Type::scalars: return "a list of one or more values";
  }
  if (std::isfinite(range.low)) what += (range.low_open ? " above " : " of at least ") + shortest(range.low);
  if (std::isfinite(range.low) && std::isfinite(range.high)) what += " and";
  if (std::isfinite(range.high)) what += (range.high_open ? " below " : " of at most ") + shortest(range.high);
  return unit.empty() ? what : what + " [" + unit + "]";
}

std::optional<std::string> Key::complaint(const Value& value) const {
  const auto refused = [&] { return "expected " + expectation() + ", found " + to_toml(value); };
  const auto fits = [&](double x) { return std::isfinite(x) && range.contains(x); };
  if (const auto* x = std::get_if<double>(&value); x != nullptr && !fits(*x)) return refused();
  if (const auto* i = std::get_if<std::int64_t>(&value); i != nullptr && !fits(static_cast<double>(*i)))
    return refused();
  if (const auto* list = std::get_if<std::vector<double>>(&value)) {
    const bool in_order = !ascending || std::ranges::adjacent_find(*list, std::greater_equal{}) == list->end();
    if (!in_order || !std::ranges::all_of(*list, fits)) return refused();
  }
  if (const auto* list = std::get_if<std::vector<Scalar>>(&value); list != nullptr && list->empty()) return refused();
  if (const auto* word = std::get_if<std::string>(&value); word != nullptr && type == Type::choice) {
    if (std::ranges::find(words, *word) != words.end()) return std::nullopt;
    const auto meant = nearest(*word, words);
    return refused() + (meant ? " (did you mean " + *meant + "?)" : "");
  }
  return std::nullopt;
}

std::optional<Value> Key::converted(const Scalar& value) const {
  const auto* integer = std::get_if<std::int64_t>(&value);
  switch (type) {
    case Type::number:
      if (integer != nullptr) return static_cast<double>(*integer);
      if (const auto* x = std::get_if<double>(&value)) return *x;
      break;
    case Type::integer:
      if (integer != nullptr) return *integer;
      break;
    case Type::boolean:
      if (const auto* b = std::get_if<bool>(&value)) return *b;
      break;
    case Type::text:
    case Type::choice:
      if (const auto* s = std::get_if<std::string>(&value)) return *s;
      break;
    default: break;
  }
  return std::nullopt;
}

Key number(std::string name, std::string unit, std::string doc) {
  return make(Type::number, std::move(name), std::move(unit), std::move(doc));
}

Key integer(std::string name, std::string doc) { return make(Type::integer, std::move(name), "", std::move(doc)); }

Key boolean(std::string name, std::string doc) { return make(Type::boolean, std::move(name), "", std::move(doc)); }

Key text(std::string name, std::string doc) { return make(Type::text, std::move(name), "", std::move(doc)); }

Key choice(std::string name, std::vector<std::string> words, std::string doc) {
  Key key = make(Type::choice, std::move(name), "", std::move(doc));
  key.words = std::move(words);
  return key;
}

Key numbers(std::string name, std::string unit, std::string doc) {
  return make(Type::numbers, std::move(name), std::move(unit), std::move(doc));
}

Key ascending_numbers(std::string name, std::string unit, std::string doc) {
  Key key = numbers(std::move(name), std::move(unit), std::move(doc));
  key.ascending = true;
  return key;
}

Key texts(std::string name, std::string doc) { return make(Type::texts, std::move(name), "", std::move(doc)); }

Key scalars(std::string name, std::string doc) { return make(Type::scalars, std::move(name), "", std::move(doc)); }

Value value_of(const Scalar& scalar) {
  return std::visit([](const auto& x) { return Value(x); }, scalar);
}

std::string to_toml(const Value& value) { return std::visit(ToToml{}, value); }

}  // namespace talus::config
