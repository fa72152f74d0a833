#include "config/problems.hpp"

#include "core/errors.hpp"

namespace talus::config {

void Problems::add(const std::string& place, const std::string& key, const std::string& what) {
  lines_.push_back(place + ": " + key + (key.empty() ? "" : ": ") + what);
}

void Problems::throw_if_any() const {
  if (none()) return;
  std::string message;
  for (const auto& line : lines_) message += (message.empty() ? "" : "\n") + line;
  throw core::ConfigError(message);
}

}  // namespace talus::config
