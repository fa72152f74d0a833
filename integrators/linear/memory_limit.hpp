#pragma once

#include <cstddef>

namespace talus::linear {

/// Of a matrix entry with its index.
inline constexpr std::size_t bytes_an_entry = 16;

/// While alive, SuiteSparse on this thread may not enlarge a block beyond `bytes`: a factorisation that fills in too
/// much then ends with "out of memory" instead of running on. 0: no limit.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t bytes);
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  ~MemoryLimit();
  /// Whether one that is alive has refused something; where none has, "out of memory" means what it says.
  [[nodiscard]] static bool refused();
};

}  // namespace talus::linear
