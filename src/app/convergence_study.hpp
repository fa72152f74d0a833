#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "study/convergence.hpp"
#include "study/nested_grids.hpp"
#include "sweep/manifest.hpp"

namespace talus::app {

/// One level of a refinement study.
struct StudyLevel {
  std::string words;  ///< "grid.columns = 60, grid.layers = 16"
  sweep::MemberState state;
  std::map<std::string, double> costs;
  double rtol;
};

/// One number of a scene on all levels.
struct StudiedNumber {
  std::string name;  ///< "heap_angle" at the end, "mass_stored@56" at an output time
  std::string unit;
  std::string long_name;
  std::vector<double> values;  ///< of each level; NaN where there is none
  study::Convergence limit;    ///< of the levels that count
};

/// A field or a line at the end: norms of the differences between neighbouring levels, of those that count.
struct StudiedField {
  std::string name, unit, long_name;
  std::vector<study::DifferenceNorms> differences;
  study::Convergence limit;  ///< by L2
};

/// The results of a scene on a row of refined grids, and what they say of its limit.
struct ConvergenceStudy {
  std::vector<StudyLevel> levels;
  std::size_t first = 0, n_counted = 0;  ///< the levels that count: neighbours that are finished, as many as there are
  std::vector<StudiedNumber> numbers;    ///< that have a value on a level that counts
  std::vector<std::string> without_value;
  std::vector<StudiedField> fields;
  std::vector<double>
      same_as_end;  ///< output times whose steady state is that of the end: they are no numbers of their own [s]
};

/// Output times at which a scene of integrator.method = "steady" stands as at its end: box and inflow are the same [s]. None of others.
std::vector<double> times_like_the_end(const Scene& scene);

/// Reads the members of a study of a scene from its folder. `rtols`: of the levels. Throws core::OutputError for a run.nc that cannot be read.
///
/// A difference below rtol times the largest number of the same unit is the integrator's, not the grid's; likewise of fields, whose
/// single precision resolves a millionth at best.
ConvergenceStudy read_convergence_study(const std::filesystem::path& folder, const sweep::Manifest& manifest,
                                        const Scene& scene, const std::vector<double>& rtols);

/// What the study says as a whole.
enum class ConvergenceVerdict : std::uint8_t {
  convergent,      ///< every number and field is settled or convergent
  partly,          ///< some fall slowly, oscillate, or lack values
  not_convergent,  ///< at least one does not fall
  cannot_tell      ///< fewer than three levels
};
ConvergenceVerdict verdict_of(const ConvergenceStudy& study);
std::string_view word_of(ConvergenceVerdict verdict);

}  // namespace talus::app
