#include "app/scene_checks.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "config/name.hpp"

namespace talus::app {
namespace {

using config::Problems;
using config::Values;

/// Metres along x at which the jet meets the bare base.
double landing(const Scene& scene) {
  const double drift = scene.inflow.along_gravity ? std::tan(scene.box.tilt) : 0.0;
  return scene.inflow.position + drift * scene.box.height;
}

std::string in_metres(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g m", x);
  return text.data();
}

/// What no single key can tell.
class CrossChecks {
 public:
  CrossChecks(const Values& v, Problems& problems) : v_(v), problems_(problems) {}

  void flux(const Scene& scene) {
    if (!(scene.numerics.jump_to > scene.numerics.jump_from)) refuse("model.jump_to", "expected above model.jump_from");
  }

  void viscosity(const Scene& scene) {
    const auto& reg = scene.regularisation;
    if (reg.cap == rheology::Cap::none && reg.rate_floor == 0.0 && reg.rate_speed == 0.0) {
      refuse("rheology.cap",
             "without a cap the viscosity needs a floor: rheology.rate_floor or rheology.rate_speed above 0");
    }
  }

  void inflow(const Scene& scene) {
    if (!(scene.inflow.rate > 0.0)) return;
    const double L = scene.box.length, reach = 3.0 * scene.inflow.width;
    if (scene.box.periodic) refuse("inflow.rate", "a periodic box takes no inflow; expected 0 kg/s");
    if (scene.inflow.position < 0.0 || scene.inflow.position > L) {
      refuse("inflow.position",
             "the inlet is outside the box; expected a number from 0 to box.length = " + in_metres(L));
    } else if (landing(scene) - reach < 0.0 || landing(scene) + reach > L) {
      refuse("inflow.position", "the jet meets the base at x = " + in_metres(landing(scene)) +
                                    " and its footprint, 3 inflow.width = " + in_metres(reach) +
                                    " to either side, leaves the box of length " + in_metres(L));
    }
    if (scene.inflow.stop <= scene.inflow.start) refuse("inflow.stop", "expected a time after inflow.start [s]");
  }

  void heights(const Scene& scene) {
    const double film = scene.numerics.film, H = scene.initial_thickness;
    if (H < film) refuse("model.initial_thickness", "expected at least model.film = " + in_metres(film));
    if (H >= scene.box.height)
      refuse("model.initial_thickness", "expected below box.height = " + in_metres(scene.box.height));
    if (film >= scene.box.height) refuse("model.film", "expected below box.height = " + in_metres(scene.box.height));
  }

  void times(const Scene& scene) {
    constexpr double most = 1e6;
    const double end = scene.end;
    const auto& listed = v_.numbers("output.times");
    if (!listed.empty() && listed.back() > end) {
      refuse("output.times",
             "expected times up to time.end = " + config::to_toml(end) + " s, found " + config::to_toml(listed.back()));
    }
    for (const char* key : {"output.interval", "output.series_interval"}) {
      if (v_.has(key) && end / v_.number(key) > most)
        refuse(key, "would make more than a million records; expected a longer interval [s]");
    }
  }

  void name(const std::string& name) {
    if (!config::is_plain_name(name)) refuse("scene.name", std::string("expected ") + config::plain_name);
  }

 private:
  void refuse(const std::string& key, const std::string& what) { problems_.add(v_.place(key), key, what); }
  const Values& v_;
  Problems& problems_;
};

}  // namespace

void check_together(const Scene& scene, const Values& values, Problems& problems) {
  CrossChecks check(values, problems);
  check.name(scene.name);
  check.flux(scene);
  check.viscosity(scene);
  check.inflow(scene);
  check.heights(scene);
  check.times(scene);
}

}  // namespace talus::app
