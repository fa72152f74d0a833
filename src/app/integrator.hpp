#pragma once

#include <memory>

#include "app/scene.hpp"
#include "core/dae_system.hpp"
#include "core/integrator.hpp"

namespace talus::app {

/// The integrator that a scene asks for, `integrator.method`. `system` must outlive it.
std::unique_ptr<core::Integrator> make_integrator(const Scene& scene, const core::DaeSystem& system);

}  // namespace talus::app
