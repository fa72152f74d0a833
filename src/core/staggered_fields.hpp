#pragma once

#include <functional>

#include "core/field_source.hpp"

namespace talus::core {

/// Variables of a model on a staggered grid of columns and layers, each with the way its values follow from a `View`: what the model
/// makes of a snapshot once for all of them. A View has nx(), nz() [1], and x_centre(i), x_face(f), z_centre(i, k), z_node(f, k) [m].
template <class View>
struct StaggeredFields {
  using Fill = std::function<void(const View&, std::vector<double>&)>;
  struct Entry {
    Variable variable;
    Fill fill;
  };
  using Entries = std::vector<Entry>;

  /// A value a place, in row-major order: columns or faces, layers, interfaces (one row beyond the layers) or one row.
  static Fill over(bool faces, int rows_beyond_layers, bool flat, std::function<double(const View&, int, int)> value) {
    return [=](const View& v, std::vector<double>& out) {
      const int n = v.nx() + (faces ? 1 : 0), rows = flat ? 1 : v.nz() + rows_beyond_layers;
      out.clear();
      for (int k = 0; k < rows; ++k)
        for (int i = 0; i < n; ++i) out.push_back(value(v, i, k));
    };
  }
  static Fill number(std::function<double(const View&)> value) {
    return [=](const View& v, std::vector<double>& out) { out.assign(1, value(v)); };
  }

  /// The grid as SGRID names it, and where its columns, faces, cells and corners lie.
  static Entries coordinates() {
    const auto as_double = Storage::double_precision;
    const std::map<std::string, std::string> sgrid{
        {"cf_role", "grid_topology"},
        {"topology_dimension", "2"},
        {"node_dimensions", "face interface"},
        {"face_dimensions", "column: face (padding: none) layer: interface (padding: none)"},
        {"edge1_dimensions", "face layer: interface (padding: none)"},
        {"edge2_dimensions", "interface column: face (padding: none)"},
        {"node_coordinates", "x_face z_node"},
        {"face_coordinates", "x z"}};
    const std::map<std::string, std::string> along{{"axis", "X"}}, upwards{{"axis", "Z"}, {"positive", "up"}};
    return {
        {{"grid", {}, "1", "staggered grid of columns and layers", as_double, true, sgrid},
         number([](const View&) { return 0.0; })},
        {{"x", {"column"}, "m", "distance down the base to the middle of the column", as_double, true, along},
         over(false, 0, true, [](const View& v, int i, int) { return v.x_centre(i); })},
        {{"x_face", {"face"}, "m", "distance down the base to the face", as_double, true, {}},
         over(true, 0, true, [](const View& v, int f, int) { return v.x_face(f); })},
        {{"z", {"layer", "column"}, "m", "height of the cell's middle, normal to the base", as_double, false, upwards},
         over(false, 0, false, [](const View& v, int i, int k) { return v.z_centre(i, k); })},
        {{"z_node",
          {"interface", "face"},
          "m",
          "height of the cell's corner, normal to the base",
          as_double,
          false,
          {}},
         over(true, 1, false, [](const View& v, int f, int k) { return v.z_node(f, k); })}};
  }
  /// A field in the middle of cells.
  static Entry cell_field(const char* name, const char* unit, const char* long_name, Fill fill) {
    return {{name,
             {"layer", "column"},
             unit,
             long_name,
             Storage::single_precision,
             false,
             {{"coordinates", "x z"}, {"grid", "grid"}, {"location", "face"}}},
            std::move(fill)};
  }
  /// A velocity where the model has it; `location` as SGRID names it.
  static Entry velocity(const char* name, std::vector<std::string> dimensions, const char* long_name,
                        const char* location, Fill fill) {
    return {{name,
             std::move(dimensions),
             "m s-1",
             long_name,
             Storage::single_precision,
             false,
             {{"grid", "grid"}, {"location", location}}},
            std::move(fill)};
  }
  /// A number of each record.
  static Entry scalar(std::string name, std::string unit, std::string long_name,
                      std::function<double(const View&)> value) {
    return {{std::move(name), {}, std::move(unit), std::move(long_name), Storage::double_precision, false, {}},
            number(std::move(value))};
  }

  /// Numbers without unit that have a name, a long_name and a value of what `part` takes from a view.
  template <class Numbers, class Part>
  static Entries shares(const Numbers& numbers, Part part) {
    Entries all;
    for (const auto& number : numbers)
      all.push_back(scalar(number.name, "1", number.long_name,
                           [value = number.value, part](const View& v) { return value(part(v)); }));
    return all;
  }

  static std::vector<std::pair<std::string, std::size_t>> dimensions(std::size_t columns, std::size_t layers) {
    return {{"column", columns}, {"face", columns + 1}, {"layer", layers}, {"interface", layers + 1}};
  }
  static std::vector<Variable> variables(Entries entries) {
    std::vector<Variable> out;
    for (auto& entry : entries) out.push_back(std::move(entry.variable));
    return out;
  }
  static void evaluate(const Entries& entries, const View& view, std::vector<std::vector<double>>& values) {
    values.resize(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) entries[i].fill(view, values[i]);
  }
};

}  // namespace talus::core
