#include "app/theory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "app/models.hpp"
#include "experiment/inflow.hpp"
#include "grid/layering.hpp"
#include "grid/rectilinear.hpp"
#include "steady/regularised_profile.hpp"
#include "steady/slope.hpp"

namespace talus::app {
namespace {

constexpr double share_at_depth = 0.01;

using steady::Answer;
using steady::UniformFlow;

template <class... Numbers>
std::string format(const char* pattern, Numbers... numbers) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), pattern, numbers...);
  return text.data();
}

double base_angle(const Scene& s) { return experiment::base_angle(s.box); }

Theory::Steady describe(const UniformFlow& flow, bool heap, double thickness) {
  return {.flow = flow,
          .heap = heap,
          .depth = flow.depth_at_share(share_at_depth),
          .thickness = thickness,
          .layers = 0.0,
          .regularised_slope = std::nullopt};
}

/// Thickness [m] of a heap where the jet meets it, its toe at the right end: the jet's line cut with the surface's.
double heap_thickness(const Scene& s, double slope) {
  const double rise = std::tan(slope - s.box.tilt);
  const double drift = s.inflow.along_gravity ? std::tan(s.box.tilt) : 0.0;
  return (s.box.length - s.inflow.position - drift * s.box.height) * rise / (1.0 - drift * rise);
}

/// The slope [rad] that carries the inflow with the scene's own u_c and regularisations.
std::optional<double> regularised_slope(const Scene& s, double thickness) {
  constexpr int cells = 500;  // slope to a few 1e-4 degrees, in some ten milliseconds
  const steady::RegularisedLayer layer{channel_of(s), s.regularisation, s.wall.u_c, thickness};
  const auto slope = steady::slope_of_flux(layer, s.inflow.rate, cells);
  return slope ? std::optional(*slope) : std::nullopt;
}

/// The flow over the base that carries the inflow, found by its thickness up to the box's height.
Answer<UniformFlow> flow_over_base(const Scene& s) {
  const auto channel = channel_of(s);
  double low = 0.0, high = s.box.height;
  auto flow = UniformFlow::at(channel, base_angle(s), high);
  if (!flow) return flow;
  if (flow->flux() < s.inflow.rate)
    return Answer<UniformFlow>::none("none: a layer over the base does not carry the inflow");
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    flow = UniformFlow::at(channel, base_angle(s), middle);
    (flow->flux() < s.inflow.rate ? low : high) = middle;
  }
  return flow;
}

void poured(const Scene& s, Theory& theory) {
  const auto channel = channel_of(s);
  const bool walls = s.wall.mu_w > 0.0;  // no heap stands without them
  const auto slope = walls ? steady::slope_of_flux(channel, s.inflow.rate) : Answer<double>::none("no side walls");
  if (slope && *slope > base_angle(s)) {
    const auto flow = UniformFlow::at(channel, *slope);
    theory.steady = describe(*flow, true, heap_thickness(s, *slope));
    theory.steady->regularised_slope = regularised_slope(s, 0.5 * theory.steady->thickness);
    if (theory.steady->thickness > s.box.height) {
      theory.warnings.push_back(format("the steady heap would be %.0f mm high, above the inlet at %.0f mm",
                                       1e3 * theory.steady->thickness, 1e3 * s.box.height));
    }
    return;
  }
  const auto maximum = steady::maximal_flux(channel);
  if (maximum && s.inflow.rate >= *maximum) {
    theory.reason = slope.reason();
    theory.warnings.push_back(
        format("no steady state exists: the inflow of %.6g kg/s is above the largest steady flow of the %s law, "
               "Q_max = %.6g kg/s",
               s.inflow.rate, rheology::name(s.law).data(), *maximum));
    return;
  }
  if (base_angle(s) <= 0.0) {
    theory.reason = "none: the base does not slope down to the right";
    return;
  }
  if (experiment::base_slides(s.box)) {
    theory.reason = "not known over a base on which grains may slide";
    return;
  }
  const auto flow = flow_over_base(s);
  if (flow) {
    theory.steady = describe(*flow, false, flow->depth());
  } else {
    theory.reason = flow.reason();
  }
}

void left_to_itself(const Scene& s, Theory& theory) {
  if (base_angle(s) <= 0.0) {
    theory.reason = "none: the base does not slope down to the right";
    return;
  }
  if (experiment::base_slides(s.box)) {
    theory.reason = "not known over a base on which grains may slide";
    return;
  }
  const double thickness = experiment::normal_thickness(s.box, s.initial.thickness);
  const auto flow = UniformFlow::at(channel_of(s), base_angle(s), thickness);
  if (flow) {
    theory.steady = describe(*flow, false, thickness);
  } else {
    theory.reason = flow.reason();
  }
}

/// Layers, counted from the surface, within `depth` of it in a column of thickness H, both normal to the base; fractions
/// count.
double layers_within(const Scene& s, double depth, double H) {
  const int n = s.cells.layers;
  if (model(s.model).fixed_grid) {
    const auto nodes = grid::geometric_nodes(n, s.box.height, s.two_fluid.z_grading);
    double count = 0.0;
    for (int k = 0; k < n; ++k) {
      const double within = std::min(nodes[k + 1], H) - std::max(nodes[k], H - depth);
      count += std::max(within, 0.0) / (nodes[k + 1] - nodes[k]);
    }
    return count;
  }
  std::vector<double> z(static_cast<std::size_t>(n) + 1), dz(z), d2z(z);
  grid::Layering(n, experiment::normal_thickness(s.box, s.cells.cluster_depth), s.cells.spacing).heights(H, z, dz, d2z);
  for (std::size_t k = z.size() - 1; k > 0; --k) {
    const double top = H - z[k], bottom = H - z[k - 1];
    if (bottom >= depth) return static_cast<double>(z.size() - 1 - k) + (depth - top) / (bottom - top);
  }
  return n;
}

/// Whether exact steady states are those of this box: a free surface over a base that holds the grains, an open right end.
bool known(const experiment::Box& box) {
  const bool holds = box.base == experiment::Contact::no_slip && box.base_speed == 0.0;
  return !box.lid && holds && (box.periodic || box.right_open);
}

/// The steady state of box and inlet at one time, its layers counted but not judged.
Theory theory_at(const Scene& stated, double t) {
  Scene scene = stated;
  scene.box = experiment::box_at(stated.box, stated.motion, t);
  scene.inflow.rate = experiment::open_rate(stated.inflow, t);
  Theory theory;
  if (!known(scene.box)) {
    theory.reason = "not known for such a box";
  } else if (scene.inflow.rate > 0.0) {
    poured(scene, theory);
  } else if (scene.box.periodic) {
    left_to_itself(scene, theory);
  } else {
    theory.reason = "none: no grains are poured in, those there are run out";
  }
  if (theory.steady) {
    auto& steady = *theory.steady;
    steady.layers = layers_within(scene, steady.depth, std::min(steady.thickness, scene.box.height));
  }
  return theory;
}

/// Of the steady states that a moving box or a changing inflow passes, the one that carries most.
std::optional<Theory::Steady> strongest(const Scene& s) {
  std::vector<double> times{0.0, s.end};
  for (const auto* changes : {&s.motion.tilt.at, &s.motion.gap.at, &s.inflow.times})
    std::ranges::copy_if(*changes, std::back_inserter(times), [&](double t) { return t > 0.0 && t < s.end; });
  std::optional<Theory::Steady> most;
  for (const double t : times) {
    auto steady = theory_at(s, t).steady;
    if (steady && (!most || steady->flow.flux() > most->flow.flux())) most = std::move(steady);
  }
  return most;
}

void judge_grid(const Scene& s, Theory& theory) {
  const double dx = s.cells.columns > 0 ? s.box.length / s.cells.columns : 0.0;
  const bool jet_is_known = s.model == "two_fluid" && s.two_fluid.jet == two_fluid::Jet::free_fall;
  if (s.inflow.rate > 0.0 && !jet_is_known && dx > 2.0 * s.inflow.width) {
    theory.warnings.push_back(format("columns of %.1f mm do not resolve the jet, whose standard deviation is %.1f mm",
                                     1e3 * dx, 1e3 * s.inflow.width));
  }
  const bool changes = !s.motion.tilt.at.empty() || !s.motion.gap.at.empty() || !s.inflow.times.empty();
  const auto judged = changes ? strongest(s) : theory.steady;
  if (judged && judged->layers < fewest_layers) {
    theory.warnings.push_back(
        format("the grid cannot resolve the flowing layer: %.1f layers within its %.1f mm, at least %.0f are needed "
               "(more grid.layers, or a smaller grid.cluster_depth)",
               judged->layers, 1e3 * judged->depth, fewest_layers));
  }
}

}  // namespace

steady::Channel channel_of(const Scene& s) {
  return {.grains = s.grains, .law = s.law, .gap = s.box.gap, .mu_w = s.wall.mu_w, .gravity = s.box.gravity};
}

Theory theory_of(const Scene& scene) {
  Theory theory = theory_at(scene, scene.end);
  judge_grid(scene, theory);
  return theory;
}

}  // namespace talus::app
