#pragma once

#include <string>

#include "app/models.hpp"

namespace talus::app {

/// The least of what bounds the memory of this process.
struct MemoryBound {
  double bytes;
  std::string name;  ///< what sets it, for example "the limit on its address space (ulimit -v)"
};

/// Of the machine's memory, the limits of the process and those of its control groups (versions 1 and 2).
MemoryBound memory_bound();

/// Builds a scene's model, unless it or its integration is expected to need more than memory_bound(): then throws
/// core::Error(memory) with both figures, before the machine runs out.
Simulation build_within_memory(const Scene& scene);

}  // namespace talus::app
