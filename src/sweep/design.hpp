#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/key.hpp"

namespace talus::sweep {

/// A scene key that a sweep varies, and its value at each point of its dimension.
struct Axis {
  std::string key;   ///< dotted, "inflow.rate"
  std::string unit;  ///< of the scene's key; "" where it has none
  std::string doc;   ///< of the scene's key
  std::vector<config::Scalar> values;
};

/// "inflow_rate": a scene key as a netCDF name.
std::string netcdf_name(std::string key);
/// "inflow.rate [kg/s]", for the head of a column.
std::string heading(const Axis& axis);
/// A value for a table: texts without quotes, numbers in the shortest form that reads back to the same bits.
std::string plain(const config::Scalar& value);

/// Axes that move together: one, several zipped, or those of a sample. All of the same length, at least 1.
struct Dimension {
  std::string name;  ///< as a netCDF dimension
  std::vector<Axis> axes;
  std::vector<std::string>
      labels{};  ///< what its points are called, where their axes would be a long story; else empty
  [[nodiscard]] std::size_t size() const { return axes.front().values.size(); }
};

struct Setting {
  const Axis& axis;
  const config::Scalar& value;
};

/// Every combination of the points of its dimensions, numbered from 0; the last dimension runs fastest.
class Design {
 public:
  /// Precondition: at least one dimension, and a product of lengths of at most `most_members`.
  explicit Design(std::vector<Dimension> dimensions) : dimensions_(std::move(dimensions)) {}

  [[nodiscard]] const std::vector<Dimension>& dimensions() const { return dimensions_; }
  [[nodiscard]] std::size_t size() const;
  /// The point of each dimension at which a member stands.
  [[nodiscard]] std::vector<std::size_t> point(std::size_t member) const;
  /// What the axes are there, in their order.
  [[nodiscard]] std::vector<Setting> settings(std::size_t member) const;
  /// The same in words: "inflow.rate = 0.002 kg/s, rheology.law = \"classical\"".
  [[nodiscard]] std::string describe(std::size_t member) const;

 private:
  std::vector<Dimension> dimensions_;
};

/// A sweep has no more members than this: what is more is a slip in a range.
inline constexpr std::size_t most_members = 100'000;

}  // namespace talus::sweep
