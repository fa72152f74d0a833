#include "steady/layer_mean.hpp"

namespace talus::steady {

LayerMean layer_mean(const UniformFlow& flow) {
  const double depth = flow.on_base() ? flow.depth() : flow.depth_at_share(LayerMean::share);
  return {flow.on_base(), depth, flow.mean_speed(depth), flow.froude(depth)};
}

}  // namespace talus::steady
