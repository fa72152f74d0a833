#include <cstdio>

#include "app/command_line.hpp"
#include "core/errors.hpp"

int main(int argc, char** argv) {
#ifdef __AVX2__
  if (!__builtin_cpu_supports("avx2")) {
    std::fputs("talus: built for processors with AVX2, which this one lacks: build again with -D TALUS_AVX2=OFF\n",
               stderr);
    return static_cast<int>(talus::core::ExitCode::internal);
  }
#endif
  return talus::app::command_line(argc, argv);
}
