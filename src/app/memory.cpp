#include "app/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/check.hpp"
#include "core/errors.hpp"

namespace talus::app {
namespace {

/// The number in a file; infinite where there is no such file or it says "max".
double bytes_in(const std::filesystem::path& file) {
  double bytes = 0.0;
  return std::ifstream(file) >> bytes ? bytes : HUGE_VAL;
}

/// Of the control groups of this process and those above them.
double control_group_bytes() {
  double least = HUGE_VAL;
  std::ifstream groups("/proc/self/cgroup");  // lines "number:controllers:/path"
  for (std::string line; std::getline(groups, line);) {
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    if (!controllers.empty() && controllers != "memory") continue;
    const std::filesystem::path root = controllers.empty() ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    const char* file = controllers.empty() ? "memory.max" : "memory.limit_in_bytes";
    for (std::filesystem::path group = line.substr(second + 2);; group = group.parent_path()) {
      least = std::min(least, bytes_in(root / group / file));
      if (group.empty()) break;
    }
  }
  return least;
}

double limit_bytes(int resource) {
  rlimit limit{};
  const bool limited =
      getrlimit(static_cast<__rlimit_resource>(resource), &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? static_cast<double>(limit.rlim_cur) : HUGE_VAL;
}

void refuse_beyond_bound(double bytes) {
  const MemoryBound bound = memory_bound();
  if (bytes <= bound.bytes) return;
  std::array<char, 200> words{};
  std::snprintf(words.data(), words.size(),
                "needs about %.0f MB of memory, %s is %.0f MB: take a coarser grid or more memory", bytes / 1e6,
                bound.name.c_str(), bound.bytes / 1e6);
  throw core::Error(core::ExitCode::memory, words.data());
}

}  // namespace

MemoryBound memory_bound() {
  const auto pages = static_cast<double>(sysconf(_SC_PHYS_PAGES)), page = static_cast<double>(sysconf(_SC_PAGESIZE));
  MemoryBound bound{pages * page, "the machine's"};
  const auto consider = [&](double bytes, const char* name) {
    if (bytes < bound.bytes) bound = {bytes, name};
  };
  consider(control_group_bytes(), "the limit of the control group");
  consider(limit_bytes(RLIMIT_AS), "the limit on the address space (ulimit -v)");
  consider(limit_bytes(RLIMIT_DATA), "the limit on data (ulimit -d)");
  return bound;
}

Simulation build_within_memory(const Scene& scene) {
  constexpr double bytes_a_cell = 10e3;  // no model can be built with less: the layer takes 15 kB
  refuse_beyond_bound(bytes_a_cell * std::max(scene.cells.columns, 1) * scene.cells.layers);
  Simulation simulation = model(scene.model).build(scene);
  refuse_beyond_bound(expected_memory(simulation.system->pattern()));
  return simulation;
}

}  // namespace talus::app
