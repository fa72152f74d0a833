#pragma once

#include <string>
#include <utility>
#include <vector>

#include "steady/channel.hpp"

namespace talus::app {

/// The parameters of a channel, its grains and their law under names that end in their SI unit, as results echo them.
std::vector<std::pair<std::string, double>> named_parameters(const steady::Channel& channel);

}  // namespace talus::app
