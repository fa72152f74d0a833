#include "app/scene_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/words.hpp"
#include "config/name.hpp"

namespace talus::app {
namespace {

using config::Problems;
using config::Values;
using words::in_metres;

/// Metres along x at which the jet meets the bare base.
double landing(const Scene& scene) {
  const double drift = scene.inflow.along_gravity ? std::tan(scene.box.tilt) : 0.0;
  return scene.inflow.position + drift * scene.box.height;
}

/// What no single key can tell.
class CrossChecks {
 public:
  CrossChecks(const Values& v, Problems& problems) : v_(v), problems_(problems) {}

  void viscosity(const Scene& scene) {
    const auto& reg = scene.regularisation;
    if (reg.cap == rheology::Cap::none && reg.rate_floor == 0.0 && reg.rate_speed == 0.0) {
      refuse("rheology.cap",
             "without a cap the viscosity needs a floor: rheology.rate_floor or rheology.rate_speed above 0");
    }
  }

  void walls(const Scene& scene) {
    const auto& box = scene.box;
    const auto slips = [&](const char* key) { return v_.text(key) == "free_slip"; };
    const auto moves = [&](const char* key) { return v_.number(key) != 0.0; };
    if (!box.lid && (slips("box.lid") || moves("box.lid_speed")))
      refuse(moves("box.lid_speed") ? "box.lid_speed" : "box.lid", "there is no lid; expected box.surface = \"lid\"");
    if (box.lid && slips("box.lid") && moves("box.lid_speed"))
      refuse("box.lid_speed", "grains slip along the lid; expected 0 m/s, or box.lid = \"no_slip\"");
    if (slips("box.base") && moves("box.base_speed"))
      refuse("box.base_speed", "grains slip along the base; expected 0 m/s, or box.base = \"no_slip\"");
    if (slips("box.base") && box.base_friction)
      refuse("box.base_friction",
             "grains slip along the base without friction; expected no such key, or box.base = \"no_slip\"");
    if (slips("box.base") && box.base_slip_length > 0.0)
      refuse("box.base_slip_length",
             "grains slip along the base without shear stress; expected 0 m, or box.base = \"no_slip\"");
    if (!slips("box.end_walls") && (box.periodic || (box.left_open && box.right_open)))
      refuse("box.end_walls", "neither end is a wall; expected \"wall\" for box.left or box.right");
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
    as_many("inflow.shares", "inflow.times");
    if (scene.inflow.stop <= scene.inflow.start) refuse("inflow.stop", "expected a time after inflow.start [s]");
  }

  void start(const Scene& scene) {
    const double H = scene.initial.thickness;
    if (v_.has("model.initial_thickness") && H >= scene.box.height)
      refuse("model.initial_thickness", "expected below box.height = " + in_metres(scene.box.height));
    as_many("initial.speeds", "initial.depths");
    if (scene.initial.disturbance && scene.model != "layer")
      refuse("disturbance.speed",
             "the " + scene.model + " model has no waves; expected 0 m/s, or model.name = \"layer\"");
    const auto& depths = scene.initial.profile.at;
    if (!depths.empty() && depths.back() > H)
      refuse("initial.depths", "expected depths within the layer, up to " + in_metres(H));
  }

  void schedule(const Scene& scene) {
    if (v_.has("schedule.times") && v_.numbers("schedule.times").empty())
      refuse("schedule.times", "expected at least one time [s]");
    if (!as_many("schedule.tilt", "schedule.times") || !as_many("schedule.gap", "schedule.times")) return;
    constexpr double degrees = 180.0 / std::numbers::pi;
    const auto at_start = experiment::box_at(scene.box, scene.motion, 0.0);
    agree("box.tilt", v_.number("box.tilt"), at_start.tilt * degrees, "schedule.tilt", "degree");
    agree("box.gap", v_.number("box.gap"), at_start.gap, "schedule.gap", "m");
  }

  void times(const Scene& scene) {
    constexpr double most = 1e6;
    const double end = scene.end;
    const auto& listed = v_.numbers("output.times");
    if (!listed.empty() && listed.back() > end) {
      refuse("output.times",
             "expected times up to time.end = " + config::to_toml(end) + " s, found " + config::to_toml(listed.back()));
    }
    for (const char* key : {"output.interval", "output.series_interval", "checkpoint.interval"}) {
      if (v_.has(key) && end / v_.number(key) > most)
        refuse(key, "would come more than a million times; expected a longer interval [s]");
    }
  }

  void name(const std::string& name) {
    if (!config::is_plain_name(name)) refuse("scene.name", std::string("expected ") + config::plain_name);
  }

 private:
  /// Whether two lists, where both are given, are of the same length.
  bool as_many(const char* values, const char* points) {
    if (!v_.has(values) || !v_.has(points) || v_.numbers(values).size() == v_.numbers(points).size()) return true;
    refuse(values,
           "expected as many numbers as " + std::string(points) + " has, " + std::to_string(v_.numbers(points).size()));
    return false;
  }
  /// The box as stated is the box at t = 0.
  void agree(const char* key, double stated, double scheduled, const char* schedule, const char* unit) {
    if (std::abs(stated - scheduled) > 1e-9 * std::max(std::abs(stated), std::abs(scheduled)))
      refuse(key,
             "expected what " + std::string(schedule) + " says of t = 0, " + config::to_toml(scheduled) + " " + unit);
  }
  void refuse(const std::string& key, const std::string& what) { problems_.add(v_.place(key), key, what); }
  const Values& v_;
  Problems& problems_;
};

}  // namespace

void check_together(const Scene& scene, const Values& values, Problems& problems) {
  CrossChecks check(values, problems);
  check.name(scene.name);
  check.viscosity(scene);
  check.walls(scene);
  check.inflow(scene);
  check.start(scene);
  check.schedule(scene);
  check.times(scene);
}

}  // namespace talus::app
