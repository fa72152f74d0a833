#pragma once

#include <string>
#include <utility>
#include <vector>

#include "steady/channel.hpp"

namespace talus::app {

using NamedNumbers = std::vector<std::pair<std::string, double>>;

/// The parameters of a law, as its scene states them.
NamedNumbers named_parameters(const rheology::Law& law);

/// The parameters of a channel, its grains and their law under names that end in their SI unit, as results echo them.
NamedNumbers named_parameters(const steady::Channel& channel);

}  // namespace talus::app
