#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfenv>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <set>

#include "app/models.hpp"
#include "ida/ida.hpp"
#include "support/continued_run.hpp"
#include "support/example_scene.hpp"
#include "support/program.hpp"
#include "support/random_state.hpp"

/// The contract that every model of the registry keeps, on every example that it can represent. What only one model can
/// promise (which of its fluxes telescope, which states are exact) stands in a file of that model's name beside this one.
namespace {

using namespace talus;
using tests::Case;

app::Simulation build(const app::Scene& scene) { return app::model(scene.model).build(scene); }

class EveryModel : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Conformance, EveryModel, testing::ValuesIn(tests::every_case()),
                         [](const auto& each) { return each.param.model + "_" + each.param.scene; });

/// Variants of a scene in which other branches of the physics are taken.
const std::vector<std::vector<std::string>> variants{{"rheology.cap=smooth"},
                                                     {"rheology.cap=hard", "rheology.eta_max=20"},
                                                     {"rheology.cap=none", "rheology.rate_speed=1e-2"},
                                                     {"rheology.law=classical", "rheology.p_0=5"},
                                                     {"rheology.law=constant", "rheology.rate_floor=0.1"},
                                                     {"wall.u_c=0.1", "rheology.p_0=0"},
                                                     {"box.base_friction=0.3"},
                                                     {"box.base_slip_length=2e-3", "box.base_friction=0.6"},
                                                     {"inflow.momentum=true"},
                                                     {"inflow.along_gravity=false"}};

TEST_P(EveryModel, JacobianEqualsCentralDifferencesColumnByColumn) {
  int n_tried = 0;
  for (const auto& settings : variants) {
    if (!GetParam().represents(settings)) continue;
    ++n_tried;
    const auto simulation = build(GetParam().read(9, 5, settings));
    const auto& system = *simulation.system;
    std::vector<double> y, yp;
    for (const unsigned seed : {1u, 2u}) {
      tests::RandomState{}.fill(system, seed, y, yp);
      core::Index worst = 0;
      EXPECT_LT(tests::jacobian_error(system, 0.1, y, yp, 50.0, worst), 1e-6)
          << settings[0] << ", seed " << seed << ": " << system.describe(worst);
    }
  }
  EXPECT_GE(n_tried, 6) << "a model that refuses most variants has hardly been tested";
}

TEST_P(EveryModel, PlacesInPacksGiveTheBitsOfPlacesOneByOne) {
  for (const auto& settings : variants) {
    if (!GetParam().represents(settings)) continue;
    const auto simulation = build(GetParam().read(9, 7, settings));
    const auto& system = *simulation.system;
    std::vector<double> y, yp;
    for (const unsigned seed : {1u, 2u}) {
      tests::RandomState{}.fill(system, seed, y, yp);
      std::vector<double> in_packs(y.size()), one_by_one(y.size());
      system.residual(0.1, y, yp, in_packs);
      ASSERT_EQ(fegetexcept(), 0);
      feenableexcept(FE_DIVBYZERO);  // what asks for places one by one
      system.residual(0.1, y, yp, one_by_one);
      fedisableexcept(FE_DIVBYZERO);
      for (std::size_t i = 0; i < y.size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint64_t>(in_packs[i]), std::bit_cast<std::uint64_t>(one_by_one[i]))
            << settings[0] << ", seed " << seed << ": " << system.describe(static_cast<core::Index>(i));
    }
  }
}

/// What a sweep of states must have met, or the test above it says little.
struct Met {
  std::set<std::string> names;
  double least_I = std::numeric_limits<double>::infinity(), most_I = 0.0;
  bool capped = false, uncapped = false, forward = false, backward = false;

  void see(const app::Simulation& simulation, std::span<const double> y, std::span<const double> yp) {
    std::vector<std::vector<double>> values;
    simulation.fields->evaluate({0.1, y, yp, core::Statistics{}}, values);
    const auto variables = simulation.fields->variables();
    for (std::size_t i = 0; i < variables.size(); ++i)
      for (const double value : values[i]) {
        const auto& name = variables[i].name;
        names.insert(name);
        if (name == "inertial_number") least_I = std::min(least_I, value), most_I = std::max(most_I, value);
        if (name == "cap_active") (value > 0.5 ? capped : uncapped) = true;
        if (name == "u") forward |= value > 0.0, backward |= value < 0.0;
      }
  }
};

TEST_P(EveryModel, JacobianAtRestCreepingAcrossTheCapAcrossINAndWithReversingWallFriction) {
  const auto scene = GetParam().read(9, 5, {"rheology.cap=hard", "rheology.eta_max=20", "rheology.rate_speed=0"});
  const auto simulation = build(scene);
  const auto& system = *simulation.system;
  std::vector<double> y, yp;
  Met met;
  unsigned seed = 0;
  for (const double speed : {0.0, 0.1 * scene.wall.u_c, scene.wall.u_c, 1e-3, 1e-2, 0.1, 1.0}) {
    tests::RandomState{speed}.fill(system, ++seed, y, yp);
    met.see(simulation, y, yp);
    core::Index worst = 0;
    EXPECT_LT(tests::jacobian_error(system, 0.1, y, yp, 50.0, worst), 1e-6)
        << speed << " m/s: " << system.describe(worst);
  }
  const double I_N = std::get<rheology::PartiallyRegularised>(scene.law).I_N;
  // A model without a field has nothing to meet there.
  if (met.names.contains("inertial_number")) {
    EXPECT_LT(met.least_I, I_N);
    EXPECT_GT(met.most_I, I_N);
  }
  EXPECT_EQ(met.capped && met.uncapped, met.names.contains("cap_active"));
  EXPECT_EQ(met.forward && met.backward, met.names.contains("u"));
}

/// Where pressure is an unknown: zero everywhere, about zero, and far below.
TEST_P(EveryModel, JacobianWhereThePressureIsZeroAndBelow) {
  const auto simulation = build(GetParam().read(9, 5));
  const auto& system = *simulation.system;
  std::vector<double> y, yp;
  for (const auto& [least, most] : {std::pair{0.0, 0.0}, {-1e-3, 1e-3}, {-1.0, 1.0}}) {
    tests::RandomState{.p_least = least, .p_most = most}.fill(system, 8, y, yp);
    core::Index worst = 0;
    EXPECT_LT(tests::jacobian_error(system, 0.1, y, yp, 50.0, worst), 1e-6)
        << "pressures from " << least << " to " << most << " of the lithostatic: " << system.describe(worst);
  }
}

TEST_P(EveryModel, NoRowAndNoColumnOfThePatternIsEmpty) {
  const auto simulation = build(GetParam().read(9, 5));
  const auto& pattern = simulation.system->pattern();
  std::vector<int> in_row(pattern.n(), 0);
  for (const auto row : pattern.rows()) ++in_row[row];
  for (core::Index i = 0; i < pattern.n(); ++i) {
    EXPECT_GT(in_row[i], 0) << simulation.system->describe(i);
    EXPECT_LT(pattern.column_starts()[i], pattern.column_starts()[i + 1]) << simulation.system->describe(i);
  }
}

TEST_P(EveryModel, EveryRowIsDescribedOnceAndHasAUnit) {
  const auto simulation = build(GetParam().read(4, 3));
  const auto& layout = simulation.system->layout();
  std::set<std::string> words;
  for (core::Index i = 0; i < layout.size(); ++i)
    EXPECT_TRUE(words.insert(simulation.system->describe(i)).second) << simulation.system->describe(i);
  for (const auto& field : layout.fields) {
    EXPECT_FALSE(field.unit.empty()) << field.name;
    EXPECT_GT(field.absolute_tolerance, 0.0) << field.name;
  }
}

TEST_P(EveryModel, EveryVariableHasAUnitItsOwnNameAndTheShapeOfItsDimensions) {
  const auto simulation = build(GetParam().read(4, 3));
  std::map<std::string, std::size_t> length;
  for (const auto& [name, n] : simulation.fields->dimensions()) EXPECT_TRUE(length.emplace(name, n).second) << name;
  std::vector<double> y, yp;
  tests::RandomState{}.fill(*simulation.system, 4, y, yp);
  std::vector<std::vector<double>> values;
  simulation.fields->evaluate({0.1, y, yp, core::Statistics{}}, values);
  const auto variables = simulation.fields->variables();
  ASSERT_EQ(values.size(), variables.size());
  std::set<std::string> names;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const auto& v = variables[i];
    EXPECT_TRUE(names.insert(v.name).second) << v.name;
    EXPECT_FALSE(v.unit.empty() || v.long_name.empty()) << v.name;
    std::size_t n = 1;
    for (const auto& dimension : v.dimensions) {
      ASSERT_TRUE(length.contains(dimension)) << v.name;
      n *= length[dimension];
    }
    EXPECT_EQ(values[i].size(), n) << v.name;
  }
}

/// The state at `t` after a run from the start.
std::vector<double> state_after(const app::Scene& scene, const app::Simulation& simulation, double t) {
  core::Observer nobody;
  std::vector<double> y(simulation.system->layout().size()), yp(y);
  simulation.system->initial_state(0.0, y, yp);
  ida::Ida integrator(*simulation.system, app::make_integrator_options(scene));
  integrator.start(0.0, y, yp);
  integrator.advance(t, nobody);
  const auto now = integrator.current();
  return {now.y.begin(), now.y.end()};
}

TEST_P(EveryModel, TheSameRunGivesTheSameBits) {
  const auto scene = GetParam().read(20, 8, {"integrator.linear_solver=klu"});
  const auto first = build(scene), second = build(scene);
  EXPECT_EQ(state_after(scene, first, 0.3), state_after(scene, second, 0.3));
}

TEST_P(EveryModel, ARunContinuedFromACheckpointEqualsTheOneThatWroteItBitByBit) {
  const auto scene = GetParam().read(20, 8, {"integrator.linear_solver=banded"});
  tests::expect_same_bits_when_continued(*build(scene).system, app::make_integrator_options(scene), 0.3, 0.6);
}

TEST(Models, EachRepresentsSomeExampleAndEachExampleNamesAModel) {
  std::set<std::string> models;
  for (const auto& each : tests::every_case()) models.insert(each.model);
  EXPECT_EQ(models.size(), app::models().size());
  for (const auto& name : tests::example_names()) EXPECT_NO_THROW((void)app::read_scene(tests::example(name))) << name;
}

TEST(Models, EachHasSourcesAReadmeWithItsEquationsAndTestsOfWhatIsItsOwn) {
  const std::filesystem::path root(TALUS_SOURCE_DIR);
  for (const auto& model : app::models()) {
    const auto room = root / "models" / model.name;
    for (const char* file : {"parameters.hpp", "fields.cpp"}) EXPECT_TRUE(std::filesystem::exists(room / file)) << room;
    const std::string readme = support::contents(room / "README.md");
    for (const char* words : {"## Equations", "**Assumed:**", "**Not modelled:**", "**Exact solutions:**", "Decisions"})
      EXPECT_NE(readme.find(words), std::string::npos) << model.name << ": " << words;
    EXPECT_TRUE(std::filesystem::exists(root / "tests" / "conformance" / (model.name + ".cpp"))) << model.name;
    EXPECT_FALSE(model.doc.empty());
  }
}

}  // namespace
