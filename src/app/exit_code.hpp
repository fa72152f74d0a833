#pragma once

#include <exception>
#include <new>
#include <string>

#include "core/errors.hpp"

namespace talus::app {

inline bool is_lack_of_memory(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
}

/// The exit code that an exception stands for.
inline int exit_code_of(const std::exception& error) {
  if (const auto* known = dynamic_cast<const core::Error*>(&error)) return static_cast<int>(known->code());
  return static_cast<int>(is_lack_of_memory(error) ? core::ExitCode::memory : core::ExitCode::internal);
}

/// What it says to people.
inline std::string words_of(const std::exception& error) {
  return is_lack_of_memory(error) ? "out of memory: take a coarser grid, or give the run more memory" : error.what();
}

}  // namespace talus::app
