#include "config/problems.hpp"

#include <array>
#include <cstdio>

#include "core/errors.hpp"

namespace talus::config {
namespace {

/// With "\x1b" for control characters: they would cut a message short or steer the terminal that shows it.
std::string printable(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if ((code >= 0x20 && code != 0x7f) || c == '\n') {
      out += c;
      continue;
    }
    std::array<char, 8> escape{};
    std::snprintf(escape.data(), escape.size(), "\\x%02x", static_cast<unsigned>(code));
    out += escape.data();
  }
  return out;
}

}  // namespace

void Problems::add(const std::string& place, const std::string& key, const std::string& what) {
  lines_.push_back(printable(place + ": " + key + (key.empty() ? "" : ": ") + what));
}

void Problems::throw_if_any() const {
  if (none()) return;
  std::string message;
  for (const auto& line : lines_) message += (message.empty() ? "" : "\n") + line;
  throw core::ConfigError(message);
}

}  // namespace talus::config
