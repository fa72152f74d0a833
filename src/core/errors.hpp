#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace talus::core {

/// Exit codes of the `talus` program.
enum class ExitCode : std::uint8_t {
  ok = 0,
  internal = 1,
  configuration = 2,
  io_setup = 3,
  bad_restart = 4,
  output_failed = 5,
  solver = 6,
  locked = 7,
  memory = 8,
  members_failed = 9,  ///< of a sweep
  restartable = 75
};

/// An error that ends the program with a stated exit code.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Bad input, found before any work. The message names file:line:column, the key, what was expected and in what unit.
class ConfigError : public Error {
 public:
  explicit ConfigError(const std::string& message) : Error(ExitCode::configuration, message) {}
};

/// A state that is not finite or outside its domain. The integrator cuts the step and counts it.
class InadmissibleState : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The integrator gave up. The message names time, step, order, flag and the ten worst rows.
class IntegrationError : public Error {
 public:
  explicit IntegrationError(const std::string& message) : Error(ExitCode::solver, message) {}
};

/// Output folder or file that cannot be set up (io_setup) or that failed during the run (output_failed).
class OutputError : public Error {
 public:
  using Error::Error;
};

}  // namespace talus::core
