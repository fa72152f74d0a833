#include <algorithm>

#include "app/models.hpp"
#include "app/scene.hpp"
#include "app/words.hpp"
#include "config/schema.hpp"

namespace talus::app {
namespace {

using namespace config;  // NOLINT(google-build-using-namespace): a list of declarations

void experiment(Schema& s) {
  s.section("scene", "what this is");
  s.add(text("name", "short name: letters, digits, - and _; the default output folder is out/<name>"));
  s.add(text("title", "one line for pictures").fallback(std::string()));
  s.add(text("description", "what happens and where it comes from").fallback(std::string()));

  s.section("box", "the box between two side walls; x runs down the base from the left end, z normal to it");
  s.add(number("length", "m", "along the base").above(0.0));
  s.add(number("height", "m", "normal to the base; the inlet lies there").above(0.0));
  s.add(number("tilt", "degree", "of the base against the horizontal, positive down to the right")
            .above(-90.0)
            .below(90.0));
  s.add(number("gap", "m", "between the side walls, W").above(0.0));
  s.add(number("gravity", "m/s2", "acceleration of gravity, g").above(0.0));
  s.add(boolean("periodic", "the right end continues at the left end").fallback(false));
  s.add(choice("left", words::of(words::ends), "the left end: grains may leave, or a wall")
            .fallback(std::string("open")));
  s.add(choice("right", words::of(words::ends), "the right end, likewise").fallback(std::string("open")));
  s.add(choice("end_walls", words::of(words::contacts), "how grains meet the ends that are walls")
            .fallback(std::string("free_slip")));
  s.add(choice("base", words::of(words::contacts), "how grains meet the base").fallback(std::string("no_slip")));
  s.add(number("base_speed", "m/s", "of a base to which grains stick, along x").fallback(0.0));
  s.add(number("base_friction", "1",
               "mu_b of a no-slip base: grains slide on it where they would pull harder than mu_b p")
            .above(0.0)
            .optional("they stick, whatever the shear"));
  s.add(number("base_slip_length", "m",
               "Navier's l of a no-slip base: grains slip on it at l du/dz; with base_friction the smaller stress acts")
            .at_least(0.0)
            .fallback(0.0));
  s.add(number("base_slope", "1", "rise of the base over x against the grid's x axis; column lines stay normal to x")
            .fallback(0.0));
  const auto has_lid = [](const Values& v) { return words::meaning(words::surfaces, v.text("box.surface")); };
  s.add(choice("surface", words::of(words::surfaces),
               "above the grains: nothing, or a rigid lid at model.initial_thickness that keeps the box full")
            .fallback(std::string("free")));
  s.add(choice("lid", words::of(words::contacts), "how grains meet the lid").fallback(std::string("no_slip")));
  s.add(number("lid_speed", "m/s", "of a lid to which grains stick, along x").fallback(0.0));
  s.add(number("lid_pressure", "Pa", "of the grains on the lid, at its right end")
            .at_least(0.0)
            .required_if("box.surface is lid", has_lid));

  s.section("schedule", "how the box moves: tilt and gap linear between times, constant before and after");
  const auto moves = [](const Values& v) { return v.has("schedule.tilt") || v.has("schedule.gap"); };
  s.add(ascending_numbers("times", "s", "of the values below")
            .required_if("schedule.tilt or schedule.gap is given", moves));
  s.add(numbers("tilt", "degree", "box.tilt at those times").above(-90.0).below(90.0).optional("box.tilt throughout"));
  s.add(numbers("gap", "m", "box.gap at those times").above(0.0).optional("box.gap throughout"));

  s.section("grains", "the material");
  s.add(number("rho_star", "kg/m3", "intrinsic density of the grains").above(0.0));
  s.add(number("Phi", "1", "solids fraction within the grains").above(0.0).at_most(1.0));
  s.add(number("d", "m", "diameter").above(0.0));

  s.section("wall", "friction of the side walls, tanh(|u|/u_c) mu_w p");
  s.add(number("mu_w", "1", "coefficient; 0 switches the side walls off").at_least(0.0));
  s.add(number("u_c", "m/s", "speed at which wall friction turns on").above(0.0));

  s.section("inflow", "grains poured from the inlet");
  const auto pours = [](const Values& v) { return v.number("inflow.rate") > 0.0; };
  s.add(number("rate", "kg/s", "mass flow Q; 0: none").at_least(0.0).fallback(0.0));
  s.add(number("position", "m", "x of the inlet's centre, at z = box.height")
            .required_if("inflow.rate is above 0", pours));
  s.add(number("width", "m", "standard deviation of the jet's footprint along x")
            .above(0.0)
            .required_if("inflow.rate is above 0", pours));
  s.add(number("start", "s", "time at which the inlet opens").at_least(0.0).fallback(0.0));
  s.add(number("stop", "s", "time at which the inlet begins to close").above(0.0).optional("it stays open"));
  s.add(number("ramp", "s", "duration of the smooth ramp that follows each change").above(0.0).fallback(0.2));
  const auto changes = [](const char* other) { return [other](const Values& v) { return v.has(other); }; };
  s.add(ascending_numbers("times", "s", "at which the open inlet changes its flow")
            .at_least(0.0)
            .required_if("inflow.shares is given", changes("inflow.shares")));
  s.add(numbers("shares", "1", "of inflow.rate that pour from each of inflow.times on; before, all of it")
            .at_least(0.0)
            .required_if("inflow.times is given", changes("inflow.times")));
  s.add(boolean("along_gravity", "the jet falls along gravity, not normal to the base").fallback(true));
  s.add(boolean("momentum", "the jet brings the momentum of its free fall, not that of the grains it meets")
            .fallback(false));
}

void rheology_of(Schema& s) {
  const auto law_is = [](std::vector<std::string> laws) {
    return [laws = std::move(laws)](const Values& v) {
      return std::ranges::find(laws, v.text("rheology.law")) != laws.end();
    };
  };
  const auto mu_of_I = law_is({"classical", "partially_regularised"});
  const auto partial = law_is({"partially_regularised"});
  s.section("rheology", "the friction law mu(I), (1.3), (3.19), and its named regularisations");
  s.add(choice("law", words::of(words::laws), "friction law"));
  s.add(number("mu_s", "1", "friction at rest of (1.3); the friction of the constant law").above(0.0));
  s.add(number("mu_d", "1", "friction at large I of (1.3)")
            .above(0.0)
            .required_if("rheology.law is not constant", mu_of_I));
  s.add(number("I_0", "1", "scale of I in (1.3)").above(0.0).required_if("rheology.law is not constant", mu_of_I));
  s.add(number("mu_inf", "1", "slope of mu at large I, (3.19)")
            .at_least(0.0)
            .required_if("rheology.law is partially_regularised", partial));
  s.add(number("alpha", "1", "creep coefficient of (3.19)")
            .above(0.0)
            .required_if("rheology.law is partially_regularised", partial));
  s.add(number("I_N", "1", "where creep ends, (3.19)")
            .above(0.0)
            .optional("the lower neutral point of the classical law"));
  s.add(number("p_0", "Pa", "smoothing of the positive part of the pressure; 0: none").at_least(0.0).fallback(0.1));
  s.add(number("rate_floor", "1/s", "constant floor under the strain rate D_norm").at_least(0.0).fallback(0.0));
  s.add(number("rate_speed", "m/s", "u_r of the floor u_r/H under D_norm").at_least(0.0).fallback(1e-2));
  s.add(
      choice("cap", words::of(words::caps), "how the viscosity is kept below eta_max").fallback(std::string("smooth")));
  s.add(number("eta_max", "Pa s", "cap of the viscosity").above(0.0).fallback(1e4));
}

void numerics(Schema& s) {
  s.section("model", "which rung of the ladder computes the scene, and its switches");
  s.add(choice("name", model_names(), "model; `talus list` tells them apart"));
  s.add(number("initial_thickness", "m", "thickness of the layer at rest at the start")
            .above(0.0)
            .optional("model.film"));
  s.add(choice("advection", words::of(words::advections),
               "inertia carried along: none, first-order upwind, or second-order central")
            .fallback(std::string("upwind")));
  s.add(number("film", "m", "thickness of the immobile film on the base; its mass is in the budget")
            .above(0.0)
            .fallback(5e-4));
  s.add(number("film_blend", "1", "flux is taken from the giving column up to this many films above the film")
            .above(0.0)
            .fallback(4.0));
  s.add(number("jump_from", "1",
               "flux is taken from the giving column where thickness changes by more than this share of itself")
            .above(0.0)
            .fallback(0.04));
  s.add(number("jump_to", "1", "and from it alone beyond this share; above jump_from").above(0.0).fallback(0.12));
  s.add(number("film_speed", "m/s", "speed at which the giving column changes sides").above(0.0).fallback(1e-5));
  s.add(number("left_slope", "degree", "slope of the triangle's left face against the horizontal")
            .above(0.0)
            .below(90.0)
            .optional("the angle of repose, atan(rheology.mu_s)"));

  s.section("two_fluid",
            "numerics of model.name = \"two_fluid\": grains and air on a grid of columns and layers over the box");
  s.add(choice("sharpening", words::of(words::sharpenings),
               "what keeps grains and air apart: nothing, (5.13), or the counter-gradient (5.8)")
            .fallback(std::string("segregation")));
  s.add(number("segregation_speed", "m/s", "f_ga of (5.13)").at_least(0.0).fallback(0.1));
  s.add(number("counter_gradient", "1", "c_ag of (5.8)").at_least(0.0).fallback(1.0));
  s.add(choice("direction", words::of(words::directions),
               "e of (5.13): along gravity, normal to the base, or settling: along gravity, but over grains not along "
               "the base")
            .fallback(std::string("gravity")));
  s.add(choice("jet", words::of(words::jets),
               "from the inlet to the heap: resolved like all else, or known: grains in free fall that enter the cells "
               "within jet_clearance above the heap")
            .fallback(std::string("resolved")));
  s.add(boolean("jet_segregation", "segregation acts in the jet region, too, where Omega of (5.13) is 0")
            .fallback(false));
  s.add(
      choice(
          "transport", words::of(words::transports),
          "volume fractions on faces: second order with a smooth limiter, first-order upwind, or the former in the jet "
          "region and the latter where segregation keeps grains and air apart")
          .fallback(std::string("jet")));
  s.add(choice("averaging", words::of(words::averagings), "of the viscosities of grains and air: (5.7), or harmonic")
            .fallback(std::string("arithmetic")));
  s.add(boolean("base_film", "grains that do not fill the cells on the base lie there as a film of its own thickness")
            .fallback(false));
  s.add(number("upwind_speed", "m/s", "over which the giving side of a flux changes").above(0.0).fallback(1e-8));
  s.add(number("return_speed", "m/s", "at which volume fractions out of [0, 1] are evened out; 0: not at all")
            .at_least(0.0)
            .fallback(0.1));
  s.add(choice("cells", words::of(words::extents),
               "which cells have unknowns: all of the box, or those that the jet or a heap can reach")
            .fallback(std::string("box")));
  s.add(number("reach_slope", "degree", "against the horizontal, of the steepest surface for cells = reachable")
            .above(0.0)
            .below(90.0)
            .optional("that of the exact flow of the largest inflow"));
  s.add(number("reach_margin", "m", "of reachable cells above the highest heap and beside the jet")
            .at_least(0.0)
            .fallback(0.06));
  s.add(number("x_grading", "1", "width of the last column over that of the first").above(0.0).fallback(1.0));
  s.add(number("z_grading", "1", "height of the top layer over that of the lowest").above(0.0).fallback(1.0));
  s.add(
      number("atol_fraction", "1", "absolute tolerance of the volume fraction").above(0.0).optional("a tenth of rtol"));
  s.add(number("inlet_fraction", "1", "volume fraction of the grains as they are poured")
            .above(0.0)
            .at_most(1.0)
            .fallback(0.2));
  s.add(number("jet_margin", "m", "of the jet region beyond the inlet's edges, across gravity (5.11)")
            .at_least(0.0)
            .fallback(0.025));
  s.add(number("jet_clearance", "m", "of the jet region above the heap (5.12)").above(0.0).fallback(0.02));
  s.add(number("air_density", "kg/m3", "of the excess air").above(0.0).fallback(1.0));
  s.add(number("air_viscosity", "Pa s", "of the excess air, thickened to calm it").above(0.0).fallback(1e-2));
  s.add(number("air_drag_viscosity", "Pa s", "in the drag 12 eta/W^2 of the side walls on the air; 0: none")
            .at_least(0.0)
            .fallback(1.81e-5));

  s.section("initial", "how the grains move at the start");
  const auto starts = [](const char* state) {
    return [state](const Values& v) { return v.text("initial.state") == state; };
  };
  s.add(choice("state", words::of(words::initial_states),
               "at rest, with the speeds given below, or as the steady flow at initial.tilt")
            .fallback(std::string("rest")));
  s.add(ascending_numbers("depths", "m", "below the surface, of the speeds")
            .at_least(0.0)
            .required_if("initial.state is profile", starts("profile")));
  s.add(numbers("speeds", "m/s", "down the slope at those depths; linear between, constant outside")
            .required_if("initial.state is profile", starts("profile")));
  s.add(number("tilt", "degree", "of the box in the steady state from which the run starts")
            .above(-90.0)
            .below(90.0)
            .optional("box.tilt"));

  s.section("disturbance",
            "of the speed along the base at the start, on a periodic layer: waves along x times profiles across, "
            "zero on the base, of random phases");
  s.add(number("speed", "m/s", "amplitude of each wave and profile; 0: none").at_least(0.0).fallback(0.0));
  s.add(integer("first_wave", "longest wave: so many fit the box").at_least(1).at_most(10000).fallback(1));
  s.add(integer("last_wave", "shortest wave, likewise").at_least(1).at_most(10000).optional("disturbance.first_wave"));
  s.add(integer("profiles", "quarter waves across the layer: 1, 3, 5, ..., so many of them")
            .at_least(1)
            .at_most(2000)
            .fallback(1));
  s.add(integer("seed", "of the phases; those of a wave and profile do not hang on what else there is")
            .at_least(0)
            .at_most(1'000'000'000)
            .fallback(1));

  s.section("grid", "cells");
  s.add(
      integer("columns", "along the base")
          .at_least(1)
          .at_most(20000)
          .required_if("the model has columns",
                       // a material file names no model
                       [](const Values& v) { return v.has("model.name") && model(v.text("model.name")).has_columns; }));
  s.add(integer("layers", "from the base to the surface").at_least(2).at_most(2000));
  s.add(choice("spacing", words::of(words::spacings), "of layers: clustered under the surface, or all alike")
            .fallback(std::string("clustered")));
  s.add(number("cluster_depth", "m",
               "clustered layers are uniform where the heap is much thinner, geometric where much deeper")
            .above(0.0)
            .fallback(3e-3));

  s.section("integrator", "how the equations are carried through time");
  s.add(choice("method", words::of(words::methods),
               "bdf: step by step, by IDA; steady: the steady state that belongs to each recorded time, by KINSOL")
            .fallback(std::string("bdf")));
  s.add(number("rtol", "1", "relative tolerance of a step").above(0.0).below(1.0).fallback(1e-4));
  s.add(number("atol_velocity", "m/s", "absolute tolerance").above(0.0).optional("rtol times 0.1 m/s"));
  s.add(number("atol_pressure", "Pa", "absolute tolerance").above(0.0).optional("rtol times 1 kPa"));
  s.add(number("atol_height", "m", "absolute tolerance").above(0.0).optional("rtol times 1 cm"));
  s.add(number("atol_mass", "kg", "absolute tolerance of the budgets").above(0.0).optional("rtol times 0.1 kg"));
  s.add(
      integer("max_order", "of the backward differentiation formula").at_least(1).at_most(5).fallback(std::int64_t{5}));
  s.add(choice("linear_solver", words::of(words::linear_solvers),
               "for the Jacobian; automatic takes the fastest on the first one of all but dissected and mumps")
            .fallback(std::string("automatic")));
  s.add(
      choice("newton", words::of(words::newtons), "damped: our full Newton iteration; stock: IDA's own, for comparison")
          .fallback(std::string("damped")));
  s.add(number("newton_tolerance", "1",
               "what Newton's method may leave of a correction, as a share of the step's tolerance")
            .above(0.0)
            .below(1.0)
            .fallback(ida::NewtonOptions{}.tolerance));
  s.add(number("max_step", "s", "longest step").above(0.0).optional("no limit"));

  s.section("time", "duration");
  s.add(number("end", "s", "when the run ends; it starts at 0").above(0.0));

  s.section("output", "what is recorded; the start and the end always are");
  s.add(ascending_numbers("times", "s", "of field records, also reported in summary.json")
            .at_least(0.0)
            .fallback(std::vector<double>{}));
  s.add(number("interval", "s", "further field records at its multiples").above(0.0).optional("none"));
  s.add(boolean("fields", "record the two-dimensional fields; without them only surface and series").fallback(true));
  s.add(number("series_interval", "s", "budgets, angles and statistics at its multiples").above(0.0).fallback(1.0));

  s.section("checkpoint",
            "what a run saves so that `talus restart` can go on; a stop by a signal saves one in any case");
  s.add(number("interval", "s", "simulated time between checkpoints, at its multiples").above(0.0).optional("none"));
  s.add(number("wall_interval", "s", "wall time between checkpoints").above(0.0).optional("none"));
  s.add(boolean("exact",
                "start afresh at each: a continued run then has the same bits as the one that wrote it, and with an "
                "interval as one that was never stopped")
            .fallback(true));
  s.add(number("wall_limit", "s", "wall time after which the run saves a checkpoint and ends with exit code 75")
            .above(0.0)
            .optional("no limit"));
}

}  // namespace

const Schema& scene_schema() {
  static const Schema schema = [] {
    Schema s;
    experiment(s);
    rheology_of(s);
    numerics(s);
    return s;
  }();
  return schema;
}

}  // namespace talus::app
