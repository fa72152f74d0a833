#pragma once

#include <cstddef>

namespace talus::linear {

/// While alive, SuiteSparse on this thread may not enlarge a block beyond `bytes`: a factorisation that fills in too much then ends
/// with "out of memory" instead of running on. 0: no limit.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t bytes);
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  ~MemoryLimit();
};

}  // namespace talus::linear
