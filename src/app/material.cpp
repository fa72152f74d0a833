#include "app/material.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "app/scene.hpp"
#include "config/problems.hpp"
#include "config/read.hpp"

namespace talus::app {
namespace {

constexpr std::array<std::string_view, 8> needed{"box.gap",  "box.gravity",  "grains.rho_star", "grains.Phi",
                                                 "grains.d", "rheology.law", "rheology.mu_s",   "wall.mu_w"};

}  // namespace

const config::Schema& material_schema() {
  static const config::Schema schema = scene_schema().with_requirements(
      [](std::string_view key) { return std::ranges::find(needed, key) != needed.end(); });
  return schema;
}

rheology::Law law_of(const config::Values& v) {
  const double mu_s = v.number("rheology.mu_s");
  const std::string& word = v.text("rheology.law");
  if (word == "constant") return rheology::constant(mu_s);
  const auto base = rheology::classical(mu_s, v.number("rheology.mu_d"), v.number("rheology.I_0"));
  if (word == "classical") return base;
  const auto I_N = v.has("rheology.I_N") ? std::optional(v.number("rheology.I_N")) : std::nullopt;
  return rheology::partially_regularised(base, v.number("rheology.mu_inf"), v.number("rheology.alpha"), I_N);
}

steady::Channel read_material(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const auto v = config::read(material_schema(), file, overrides);
  steady::Channel channel{.grains = {v.number("grains.rho_star"), v.number("grains.Phi"), v.number("grains.d")},
                          .law = rheology::Constant{v.number("rheology.mu_s")},
                          .gap = v.number("box.gap"),
                          .mu_w = v.number("wall.mu_w"),
                          .gravity = v.number("box.gravity")};
  config::Problems problems;
  try {
    channel.law = law_of(v);
  } catch (const std::invalid_argument& error) { problems.add(v.place("rheology.law"), "rheology.law", error.what()); }
  problems.throw_if_any();
  return channel;
}

}  // namespace talus::app
