#include "linear/memory_limit.hpp"

#include <SuiteSparse_config.h>

#include <cstdlib>

namespace talus::linear {
namespace {

thread_local std::size_t limit = 0;
thread_local bool has_refused = false;

void* limited_realloc(void* block, std::size_t bytes) {
  if (limit == 0 || bytes <= limit) return std::realloc(block, bytes);
  has_refused = true;
  return nullptr;
}

}  // namespace

MemoryLimit::MemoryLimit(std::size_t bytes) {
  SuiteSparse_config.realloc_func = limited_realloc;
  limit = bytes;
}

MemoryLimit::~MemoryLimit() {
  limit = 0;
  has_refused = false;
}

bool MemoryLimit::refused() { return has_refused; }

}  // namespace talus::linear
