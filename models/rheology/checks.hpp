#pragma once

#include <string>

/// Checks shared by the factories and inverses of this room.
namespace talus::rheology::checks {

/// Throws std::invalid_argument "<law>: <name> = <value> must be <expected>" unless `ok`.
void require(bool ok, const char* law, const char* name, double value, const std::string& expected);
/// Widest range of a scale: far beyond any material, and such that no law overflows at an I up to 1e300.
inline constexpr double least = 1e-100, most = 1e100, most_friction = 1e6;
/// require(low <= value <= high), which a number that is none fails.
void within(double low, double high, const char* law, const char* name, double value);
/// A coefficient of friction: within(least, most_friction).
void friction(const char* law, const char* name, double value);
/// require(value is finite and above `bound`).
void above(double bound, const char* law, const char* name, double value);

/// Throws std::domain_error: no I has this mu; `bound` states the admissible range.
[[noreturn]] void no_inverse(const char* law, double mu, const std::string& bound);

/// Shortest text that reads back as the same number.
[[nodiscard]] std::string text(double value);

}  // namespace talus::rheology::checks
