#include <gtest/gtest.h>

#include <algorithm>

#include "app/layer_model.hpp"
#include "app/progress.hpp"
#include "app/scene.hpp"
#include "app/selected_fields.hpp"
#include "app/theory.hpp"
#include "app/two_fluid_model.hpp"
#include "support/heap_fields.hpp"

namespace {
using namespace talus;

TEST(Progress, SpeaksOfDurationsAsPeopleDo) {
  EXPECT_EQ(app::duration(0.4), "0 s");
  EXPECT_EQ(app::duration(59.4), "59 s");
  EXPECT_EQ(app::duration(185.0), "3 min 05 s");
  EXPECT_EQ(app::duration(7620.0), "2 h 07 min");
  EXPECT_EQ(app::bar(0.5, 4), "[##..]");
  EXPECT_EQ(app::bar(1.0, 4), "[####]");
}

std::vector<std::string> names(const core::FieldSource& source) {
  std::vector<std::string> out;
  for (const auto& variable : source.variables()) out.push_back(variable.name);
  return out;
}

TEST(SelectedFields, PartAModelsVariablesByPlaceAndTime) {
  support::HeapFields heap;
  app::EvaluatedFields model(heap);
  using Names = std::vector<std::string>;
  app::SelectedFields fields(model, app::Selection::fields), surface(model, app::Selection::surface);
  app::SelectedFields series(model, app::Selection::series), numbers(model, app::Selection::numbers);
  EXPECT_EQ(names(fields), (Names{"mesh", "x", "speed", "height"}));
  EXPECT_EQ(names(surface), (Names{"mesh", "x", "height"}));
  EXPECT_EQ(names(series), (Names{"height_series", "mass_stored"}));
  EXPECT_EQ(names(numbers), (Names{"mass_stored"}));
  EXPECT_EQ(surface.dimensions().size(), 1U);

  std::vector<std::vector<double>> values;
  series.evaluate({2.0, {}, {}, core::Statistics{}}, values);
  ASSERT_EQ(values.size(), 2U);
  EXPECT_EQ(values[0].size(), support::HeapFields::n_columns);
  EXPECT_EQ(values[1].at(0), support::HeapFields::value(2.0, 0));
}

/// Fields over layers alone, as a model in one dimension has them.
class Profiles : public core::FieldSource {
 public:
  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override { return {{"layer", 2}}; }
  [[nodiscard]] std::vector<core::Variable> variables() const override {
    constexpr auto storage = core::Storage::double_precision;
    return {{"z", {"layer"}, "m", "height", storage, true},
            {"speed", {"layer"}, "m s-1", "speed", storage, false},
            {"mass_flow", {}, "kg s-1", "mass flow", storage, false}};
  }
  void evaluate(const core::Snapshot&, std::vector<std::vector<double>>& values) override {
    values = {{0.1, 0.3}, {1.0, 2.0}, {5.0}};
  }
};

TEST(SelectedFields, ProfilesAreTheFieldsOfAModelInOneDimension) {
  Profiles profiles;
  app::EvaluatedFields model(profiles);
  using Names = std::vector<std::string>;
  const auto selected = [&](app::Selection selection) { return names(app::SelectedFields(model, selection)); };
  EXPECT_EQ(selected(app::Selection::fields), (Names{"z", "speed"}));
  EXPECT_EQ(selected(app::Selection::surface), (Names{"z"}));
  EXPECT_EQ(selected(app::Selection::series), (Names{"mass_flow"}));
  EXPECT_EQ(selected(app::Selection::numbers), (Names{"mass_flow"}));
}

TEST(Scene, RecordTimesUniteListIntervalStartAndEnd) {
  const auto scene = app::read_scene(TALUS_SOURCE_DIR "/runs/examples/chute_periodic.toml",
                                     {"time.end=0.35", "output.times=[0.05, 0.30000000000000004]",
                                      "output.interval=0.1", "output.series_interval=0.05"});
  const std::vector<double> fields{0.0, 0.05, 0.1, 0.2, 0.30000000000000004, 0.35};
  EXPECT_EQ(scene.recording.field_times, fields);
  EXPECT_EQ(scene.recording.series_times.size(), 8U);
  for (const double t : fields) EXPECT_TRUE(std::ranges::binary_search(scene.recording.series_times, t)) << t;
}

TEST(Scene, GoesIntoTheModelInSiUnitsAndRadians) {
  const auto scene = app::read_scene(TALUS_SOURCE_DIR "/runs/examples/heap_q46.toml",
                                     {"box.left=wall", "rheology.cap=hard", "rheology.eta_max=500", "model.film=4e-4"});
  const auto p = app::make_layer_parameters(scene);
  EXPECT_DOUBLE_EQ(p.box.tilt, 29.2 * 3.14159265358979323846 / 180.0);
  EXPECT_FALSE(p.box.left_open);
  EXPECT_EQ(p.regularisation.cap, rheology::Cap::hard);
  EXPECT_EQ(p.regularisation.eta_max, 500.0);
  EXPECT_EQ(p.initial.thickness, 4e-4);
  EXPECT_EQ(p.inflow.rate, 0.0046);
  EXPECT_EQ(p.inflow.stop, 150.0);
  EXPECT_NEAR(std::get<rheology::PartiallyRegularised>(p.law).A, 2257.43947669322, 1e-8);
}

TEST(Scene, GivesNewtonsMethodItsTolerance) {
  const auto scene =
      app::read_scene(TALUS_SOURCE_DIR "/runs/examples/heap_q46.toml", {"integrator.newton_tolerance=3e-4"});
  EXPECT_EQ(app::make_integrator_options(scene).newton.tolerance, 3e-4);
}

TEST(Scene, HasALidAndWallsWhereItSaysSo) {
  const auto shear_cell = TALUS_SOURCE_DIR "/runs/examples/shear_cell.toml";
  const auto sheared = app::make_layer_parameters(app::read_scene(shear_cell, {"box.base_speed=-0.02"})).box;
  ASSERT_TRUE(sheared.lid);
  EXPECT_EQ(sheared.lid->contact, experiment::Contact::no_slip);
  EXPECT_EQ(sheared.lid->speed, 0.05);
  EXPECT_EQ(sheared.lid->pressure, 500.0);
  EXPECT_EQ(sheared.base, experiment::Contact::no_slip);
  EXPECT_EQ(sheared.base_speed, -0.02);
  EXPECT_EQ(sheared.end_walls, experiment::Contact::free_slip);
  const auto box = app::make_layer_parameters(
                       app::read_scene(shear_cell, {"box.surface=free", "box.lid_speed=0", "box.base=free_slip",
                                                    "box.periodic=false", "box.right=wall", "box.end_walls=no_slip"}))
                       .box;
  EXPECT_FALSE(box.lid);
  EXPECT_EQ(box.base, experiment::Contact::free_slip);
  EXPECT_TRUE(box.left_open);
  EXPECT_FALSE(box.right_open);
  EXPECT_EQ(box.end_walls, experiment::Contact::no_slip);
}

/// The steady heap is that of the last flow, the grid is held against the largest, and so is what grains can reach.
TEST(Theory, FollowsTheFlowsThatTheInletPasses) {
  const auto heap = [](std::vector<std::string> settings) {
    settings.insert(settings.end(), {"grid.columns=60", "grid.layers=16"});
    return app::read_scene(TALUS_SOURCE_DIR "/runs/examples/heap_q46.toml", settings);
  };
  const auto slope = [&](const std::vector<std::string>& settings) {
    return app::theory_of(heap(settings)).steady->flow.zeta();
  };
  const double half = slope({"inflow.rate=0.0023"}), whole = slope({});
  EXPECT_LT(half, whole - 0.05);
  EXPECT_EQ(slope({"inflow.times=[10, 60]", "inflow.shares=[2, 0.5]"}), half);
  EXPECT_EQ(slope({"inflow.times=[10, 200]", "inflow.shares=[0.5, 2]"}), half) << "closed by then";
  EXPECT_EQ(slope({"inflow.times=[400]", "inflow.shares=[0.5]"}), whole) << "after the end";
  EXPECT_FALSE(app::theory_of(heap({"inflow.times=[60]", "inflow.shares=[0]"})).steady);

  EXPECT_EQ(app::theory_of(heap({"inflow.rate=0.0005"})).warnings.size(), 1U) << "a layer of 3.7 layers of the grid";
  EXPECT_TRUE(app::theory_of(heap({})).warnings.empty());
  EXPECT_TRUE(app::theory_of(heap({"inflow.times=[60]", "inflow.shares=[0.11]"})).warnings.empty());

  const auto reached = [&](std::vector<std::string> settings) {
    settings.insert(settings.end(), {"model.name=two_fluid", "two_fluid.cells=reachable"});
    return *app::make_two_fluid_parameters(heap(settings)).numerics.reach.slope;
  };
  const double doubled = reached({"inflow.rate=0.0092"});
  EXPECT_GT(doubled, reached({}) + 0.02);
  EXPECT_EQ(reached({"inflow.times=[10, 60]", "inflow.shares=[2, 0.5]"}), doubled);
  EXPECT_EQ(reached({"inflow.times=[10]", "inflow.shares=[0.5]"}), reached({}));
}

TEST(Scene, RecomputesTheCrossoverWhereItIsNotGiven) {
  auto toml = app::read_scene(TALUS_SOURCE_DIR "/runs/examples/heap_q46.toml").effective;
  const auto at = toml.find("I_N = 0.05178");
  ASSERT_NE(at, std::string::npos);
  const auto scene = app::read_scene_text(toml.erase(at, 13), "scene.toml");
  EXPECT_NEAR(std::get<rheology::PartiallyRegularised>(scene.law).I_N, 0.0517818300563480, 1e-12);
  EXPECT_NE(scene.effective.find("# I_N: optional; absent: the lower neutral point"), std::string::npos);
}
}  // namespace
