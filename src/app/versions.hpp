#pragma once

#include <string>
#include <vector>

namespace talus::app {

/// The libraries behind Talus with their versions, "SUNDIALS 6.4.1" and so on; netCDF's is the one in use, the others
/// are those that Talus was built with.
std::vector<std::string> library_versions();
/// What `talus --version` prints.
std::string version_text();

}  // namespace talus::app
