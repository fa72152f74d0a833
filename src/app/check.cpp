#include "app/check.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/models.hpp"
#include "app/theory.hpp"
#include "rheology/well_posedness.hpp"

namespace talus::app {
namespace {

template <class... Arguments>
std::string line(const char* pattern, Arguments... arguments) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), pattern, arguments...);
  return std::string(text.data()) + "\n";
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

std::string size_of(const Scene& scene) {
  const Simulation simulation = model(scene.model).build(scene);
  const auto n = static_cast<long long>(simulation.system->layout().size());
  const auto n_nonzeros = static_cast<long long>(simulation.system->pattern().n_nonzeros());
  std::string out = line("model      %s: %s", scene.model.c_str(), model(scene.model).doc.c_str());
  const auto& cells = scene.cells;
  out += model(scene.model).has_columns
             ? line("grid       %d columns x %d layers = %lld cells; a column is %.3g mm wide", cells.columns,
                    cells.layers, static_cast<long long>(cells.columns) * cells.layers,
                    1e3 * scene.box.length / cells.columns)
             : line("grid       %d layers", cells.layers);
  out += line("size       %lld unknowns, %lld non-zeros of the Jacobian", n, n_nonzeros);
  out += line("memory     about %.0f MB", expected_memory(simulation.system->pattern()) / 1e6);
  out += line("output     %zu records of fields, %zu of series", scene.recording.field_times.size(),
              scene.recording.series_times.size());
  return out;
}

std::string steady_of(const Theory& theory) {
  if (!theory.steady) return theory.reason.empty() ? "" : line("steady     %s", theory.reason.c_str());
  const auto& s = *theory.steady;
  std::string out = line("steady     %s of slope %.4f degrees, flow %.6g kg/s (exact, for u_c -> 0)",
                         s.heap ? "a heap" : "a layer over the base", degrees(s.flow.zeta()), s.flow.flux());
  out += line(
      "           surface speed %.4g m/s; flowing layer %.2f mm deep (down to 1 %% of that speed), thickest column "
      "%.1f mm",
      s.flow.surface_speed(), 1e3 * s.depth, 1e3 * s.thickness);
  if (s.regularised_slope) {
    out +=
        line("           slope %.2f degrees with this scene's u_c and regularisations", degrees(*s.regularised_slope));
  }
  out += line("resolution %.1f layers within the flowing layer", s.layers);
  return out;
}

}  // namespace

double expected_memory(const core::SparsePattern& pattern) {
  constexpr double base = 40e6, bytes = 180.0;
  double distance = 0.0;
  for (core::Index column = 0; column < pattern.n(); ++column) {
    for (auto i = pattern.column_starts()[column]; i < pattern.column_starts()[column + 1]; ++i) {
      distance += std::abs(static_cast<double>(pattern.rows()[i] - column));
    }
  }
  const double mean_distance = distance / static_cast<double>(pattern.n_nonzeros());
  return base + bytes * static_cast<double>(pattern.n()) * mean_distance;
}

std::string check_report(const Scene& scene) {
  const Theory theory = theory_of(scene);
  std::string out = line("scene      %s%s%s", scene.name.c_str(), scene.title.empty() ? "" : ": ", scene.title.c_str());
  out += size_of(scene) + steady_of(theory);
  if (const auto* law = std::get_if<rheology::PartiallyRegularised>(&scene.law)) {
    out += line("rheology   partially regularised, I_N = %.6g, A = %.6g", law->I_N, law->A);
  }
  for (const auto& warning : theory.warnings) out += "warning    " + warning + "\n";
  return out;
}

}  // namespace talus::app
