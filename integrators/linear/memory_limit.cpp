#include "linear/memory_limit.hpp"

#include <SuiteSparse_config.h>

#include <cstdlib>

namespace talus::linear {
namespace {

thread_local std::size_t limit = 0;

void* limited_realloc(void* block, std::size_t bytes) {
  return limit > 0 && bytes > limit ? nullptr : std::realloc(block, bytes);
}

}  // namespace

MemoryLimit::MemoryLimit(std::size_t bytes) {
  SuiteSparse_config.realloc_func = limited_realloc;
  limit = bytes;
}

MemoryLimit::~MemoryLimit() { limit = 0; }

}  // namespace talus::linear
