#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "support/nc_reader.hpp"

namespace talus::support {

/// Names of the variables whose values are not the same bits in two netCDF files, or that only one of them has. Times
/// of the processor (cpu_...) do not count.
inline std::vector<std::string> differing_variables(const std::filesystem::path& one,
                                                    const std::filesystem::path& other) {
  const NcReader a(one), b(other);
  int n_a = 0, n_b = 0;
  nc_inq_nvars(a.file(), &n_a);
  nc_inq_nvars(b.file(), &n_b);
  std::vector<std::string> differing;
  if (n_a != n_b) differing.emplace_back("(number of variables)");
  for (int id = 0; id < n_a; ++id) {
    char name[NC_MAX_NAME + 1];
    nc_inq_varname(a.file(), id, name);
    if (std::string(name).starts_with("cpu_")) continue;
    int other_id = -1;
    if (nc_inq_varid(b.file(), name, &other_id) != NC_NOERR) {
      differing.emplace_back(name);
      continue;
    }
    const auto x = a.values(name), y = b.values(name);
    if (x.size() != y.size() || std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) != 0)
      differing.emplace_back(name);
  }
  return differing;
}

}  // namespace talus::support
