#include "output/provenance.hpp"

#include <netcdf.h>

#include <array>
#include <ctime>

#include "output/revision.hpp"

namespace talus::output {

namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

}  // namespace

std::string version() { return TALUS_VERSION; }

std::string git_revision() { return revision; }

std::string netcdf_version() {
  const std::string words = nc_inq_libvers();  // "4.9.0 of <build date>"
  return "netCDF " + words.substr(0, words.find(' '));
}

Attributes provenance_attributes(const Provenance& provenance) {
  std::string libraries = netcdf_version();
  for (const std::string& library : provenance.libraries) libraries += ", " + library;
  Attributes all{{"source", "Talus " + version() + " (" + git_revision() + ")"},
                 {"talus_version", version()},
                 {"git_revision", git_revision()},
                 {"libraries", libraries},
                 {"history", utc_now() + " " + provenance.command}};
  if (!provenance.scene_text.empty()) all["scene"] = provenance.scene_text;
  return all;
}

}  // namespace talus::output
