#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/layout.hpp"
#include "core/statistics.hpp"

namespace talus::output {

/// All that a run needs to go on from time t as if it had not been stopped.
struct Checkpoint {
  double t = 0.0;         ///< [s]
  std::vector<double> y;  ///< shape n, in the units of the layout's fields; budgets are among the unknowns
  std::vector<double> yp;
  std::vector<std::string> fields;      ///< names of the layout's fields
  std::vector<std::uint8_t> field_of;   ///< shape n: what each unknown is
  core::Statistics statistics;          ///< of the integration up to t
  std::string linear_solver;            ///< what the integrator's trials came to
  std::vector<std::size_t> n_records;   ///< of each stream of the run's file, all at times up to t
  std::string scene;                    ///< the effective scene
  std::string summary;                  ///< what the summary has gathered up to t
  std::string talus_version, revision;  ///< of the program that wrote it

  void set_layout(const core::Layout& layout);
  /// The unknowns are those of `layout`, one by one.
  [[nodiscard]] bool fits(const core::Layout& layout) const;
};

/// A checkpoint as a netCDF-4 file in memory: float64, nothing left out. Throws core::IntegrationError where a number of
/// the state is not finite.
[[nodiscard]] std::string to_bytes(const Checkpoint& checkpoint);
/// The reverse. The bytes are trusted: check their sum first. Throws OutputError(bad_restart).
[[nodiscard]] Checkpoint checkpoint_from(std::string_view bytes);

}  // namespace talus::output
