#pragma once

#include <string>

namespace talus::app {

/// What `talus list` prints: the models, and the example scenes with their titles.
std::string list();

}  // namespace talus::app
