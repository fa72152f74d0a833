#pragma once

#include <exception>
#include <new>

#include "core/errors.hpp"

namespace talus::app {

/// The exit code that an exception stands for.
inline int exit_code_of(const std::exception& error) {
  if (const auto* known = dynamic_cast<const core::Error*>(&error)) return static_cast<int>(known->code());
  const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  return static_cast<int>(memory ? core::ExitCode::memory : core::ExitCode::internal);
}

}  // namespace talus::app
