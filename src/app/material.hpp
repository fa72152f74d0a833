#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/values.hpp"
#include "steady/channel.hpp"

namespace talus::app {

/// Every key of a scene, those of the material and its channel required, the others not: box.gap, box.gravity, [grains],
/// the law's part of [rheology], wall.mu_w. A scene is a material file, too.
const config::Schema& material_schema();

/// The grains, their law and the channel they flow in, from a scene or a material file; `overrides` as `config::read`.
/// Throws core::ConfigError.
steady::Channel read_material(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The friction law that checked values state. Throws std::invalid_argument naming the parameter that the law refuses.
rheology::Law law_of(const config::Values& values);

}  // namespace talus::app
