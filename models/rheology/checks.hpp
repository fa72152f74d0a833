#pragma once

#include <string>

/// Checks shared by the factories and inverses of this room.
namespace talus::rheology::checks {

/// Throws std::invalid_argument "<law>: <name> = <value> must be <expected>" unless `ok`.
void require(bool ok, const char* law, const char* name, double value, const std::string& expected);
/// require(value is finite and above `bound`).
void above(double bound, const char* law, const char* name, double value);

/// Throws std::domain_error: no I has this mu; `bound` states the admissible range.
[[noreturn]] void no_inverse(const char* law, double mu, const std::string& bound);

/// Shortest text that reads back as the same number.
[[nodiscard]] std::string text(double value);

}  // namespace talus::rheology::checks
