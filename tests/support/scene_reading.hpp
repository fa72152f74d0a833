#pragma once

#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene.hpp"
#include "config/read.hpp"
#include "core/errors.hpp"

namespace talus::support {

/// Reads any bytes as a scene: what stands behind each byte 1 is an override. True if it was accepted. Whatever is accepted
/// must read back to the same values from its effective scene, and whatever is refused must be refused in words; ends the
/// program where that does not hold.
inline bool read_as_scene(std::string_view input) {
  const auto fail = [](const std::string& why) {
    std::cerr << why << std::endl;
    std::abort();
  };
  std::vector<std::string> parts(1);
  for (const char c : input) {
    if (c == '\x01') parts.emplace_back();
    else parts.back() += c;
  }
  const std::vector<std::string> overrides(parts.begin() + 1, parts.end());
  std::string effective;
  try {
    effective = app::read_scene_text(parts.front(), "scene", overrides).effective;
  } catch (const core::ConfigError& error) {
    if (std::string_view(error.what()).size() < 10) fail("refused without words");
    return false;
  }
  try {
    app::read_scene_text(effective, "effective");
    const auto changed = config::differences(config::read_text(app::scene_schema(), parts.front(), "scene", overrides),
                                             config::read_text(app::scene_schema(), effective, "effective"));
    if (!changed.empty()) fail(changed.front().key + " does not survive: " + changed.front().before);
  } catch (const core::ConfigError& error) {
    fail(std::string("accepted, but not its effective scene: ") + error.what());
  }
  return true;
}

}  // namespace talus::support
