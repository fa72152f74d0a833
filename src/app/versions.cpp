#include "app/versions.hpp"

#include "app/build_info.hpp"
#include "output/provenance.hpp"

namespace talus::app {

std::vector<std::string> library_versions() {
  return {std::string("SUNDIALS ") + build::sundials,
          std::string("SuiteSparse ") + build::suitesparse,
          output::netcdf_version(),
          std::string("Eigen ") + build::eigen,
          std::string("toml++ ") + build::tomlplusplus,
          std::string("Ceres ") + build::ceres};
}

std::string version_text() {
  std::string text = "talus " + output::version() + " (" + output::git_revision() + ")";
  for (const auto& library : library_versions()) text += "\n" + library;
  return text;
}

}  // namespace talus::app
