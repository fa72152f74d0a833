#include "sweep/axis_table.hpp"

#include <algorithm>
#include <cmath>

namespace talus::sweep {
namespace {

using config::Key;
using config::Problems;
using config::Scalar;
using config::Type;
using config::Values;

bool is_number(const Key& key) { return key.type == Type::number || key.type == Type::integer; }

Scalar nearest(const Key& key, double x) {
  if (key.type == Type::integer) return static_cast<std::int64_t>(std::llround(x));
  return x;
}

/// Checks a table step by step; each returns false after a complaint.
class Check {
 public:
  Check(const Values& table, const config::Schema& scene, Problems& problems)
      : table_(table), scene_(scene), problems_(problems) {}

  /// Whether the table names a key that can be an axis.
  const Key* key() {
    const std::string& name = table_.text("axis.key");
    const Key* key = scene_.find(name);
    if (key == nullptr) {
      refuse("axis.key", name + ": unknown key of a scene" + scene_.suggest_key(name));
    } else if (key->type == Type::numbers || key->type == Type::texts || key->type == Type::scalars) {
      refuse("axis.key", name + ": expected a key with a single value; this one takes " + key->expectation());
      return nullptr;
    }
    return key;
  }

  bool either_values_or_range() {
    for (const char* other : {"axis.from", "axis.to", "axis.count"}) {
      if (table_.has("axis.values") && table_.has(other)) return refuse(other, "expected values or a range, not both");
    }
    return true;
  }

  /// Whether the scene's key takes the value; converts it to the key's type.
  bool accept(const Key& key, const char* where, Scalar& value) {
    const auto converted = key.converted(value);
    const auto complaint =
        converted ? key.complaint(*converted)
                  : "expected " + key.expectation() + ", found " + config::to_toml(config::value_of(value));
    if (complaint) return refuse(where, key.name + ": " + *complaint);
    if (const auto* number = std::get_if<double>(&*converted)) value = *number;
    return true;
  }

  bool range(const Key& key, const Interval& interval) {
    if (!is_number(key))
      return refuse("axis.from", key.name + ": expected values; this key takes " + key.expectation());
    for (const auto& [where, number] : {std::pair{"axis.from", interval.from}, std::pair{"axis.to", interval.to}}) {
      if (key.type == Type::integer && number != std::round(number))
        return refuse(where, key.name + ": expected an integer, found " + config::to_toml(number));
      Scalar value = nearest(key, number);
      if (!accept(key, where, value)) return false;
      if (interval.spacing == Spacing::logarithmic && !(number > 0.0))
        return refuse(where, "expected a number above 0, since the spacing is logarithmic");
    }
    if (interval.from == interval.to) return refuse("axis.to", "expected a number other than axis.from");
    return true;
  }

  bool refuse(const std::string& where, const std::string& what) {
    problems_.add(table_.place(where), where, what);
    return false;
  }

 private:
  const Values& table_;
  const config::Schema& scene_;
  Problems& problems_;
};

Interval interval_of(const Values& table) {
  const bool linear = table.text("axis.spacing") == "linear";
  return {table.number("axis.from"), table.number("axis.to"), linear ? Spacing::linear : Spacing::logarithmic};
}

}  // namespace

std::optional<AxisTable> read_axis(const Values& table, const config::Schema& scene_schema, bool samples,
                                   Problems& problems) {
  Check check(table, scene_schema, problems);
  const Key* key = check.key();
  if (key == nullptr || !check.either_values_or_range()) return std::nullopt;
  AxisTable out{&table, key, {key->name, key->unit, key->doc, {}}, std::nullopt, ""};
  if (table.has("axis.zip")) out.zip = table.text("axis.zip");
  if (table.has("axis.values")) {
    out.axis.values = table.scalars("axis.values");
    const bool good =
        std::ranges::all_of(out.axis.values, [&](Scalar& value) { return check.accept(*key, "axis.values", value); });
    return good ? std::optional(out) : std::nullopt;
  }
  const Interval interval = interval_of(table);
  if (!check.range(*key, interval)) return std::nullopt;
  if (table.has("axis.count")) {
    const auto numbers = spaced(interval, static_cast<std::size_t>(table.integer("axis.count")));
    for (const double x : numbers) out.axis.values.push_back(nearest(*key, x));
    return out;
  }
  if (!samples) {
    check.refuse("axis.from", "expected axis.count with it, or a section [sample] with members");
    return std::nullopt;
  }
  if (!out.zip.empty()) {
    check.refuse("axis.zip", "expected none: a sample moves this axis together with the others that it draws");
    return std::nullopt;
  }
  out.sampled = interval;
  return out;
}

Scalar value_at(const AxisTable& axis, double share) {
  const Interval& interval = *axis.sampled;
  if (axis.key->type != Type::integer) return interval.at(share);
  const double low = std::min(interval.from, interval.to), high = std::max(interval.from, interval.to);
  const double x = Interval{low - 0.5, high + 0.5, interval.spacing}.at(share);
  return static_cast<std::int64_t>(std::llround(std::clamp(x, low, high)));
}

}  // namespace talus::sweep
