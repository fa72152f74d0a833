#include <gtest/gtest.h>

#include "app/presets.hpp"
#include "core/errors.hpp"
#include "support/example_scene.hpp"

namespace {
using namespace talus;

app::Scene with(const std::string& scene, const std::string& preset, std::vector<std::string> overrides = {}) {
  return app::read_scene(tests::example(scene), app::with_preset(tests::example(scene), preset, std::move(overrides)));
}

TEST(Presets, DivideTheCellsOfTheScene) {
  const auto own = app::read_scene(tests::example("heap_q46"));
  const auto draft = with("heap_q46", "draft"), standard = with("heap_q46", "standard"),
             fine = with("heap_q46", "fine");
  EXPECT_EQ(draft.cells.columns, own.cells.columns / 5);
  EXPECT_EQ(draft.cells.layers, own.cells.layers / 4);
  EXPECT_DOUBLE_EQ(draft.integration.rtol, 3.0 * own.integration.rtol);
  EXPECT_EQ(standard.cells.columns, own.cells.columns / 2);
  EXPECT_EQ(standard.integration.rtol, own.integration.rtol);
  EXPECT_EQ(fine.effective, own.effective);
}

TEST(Presets, WhatIsSetByHandStays) {
  const auto scene = with("heap_q46", "draft", {"grid.layers=20", "integrator.rtol=1e-5"});
  EXPECT_EQ(scene.cells.layers, 20);
  EXPECT_EQ(scene.integration.rtol, 1e-5);
  EXPECT_EQ(scene.cells.columns, 60);
}

TEST(Presets, LeaveFewCellsAsTheyAre) {
  const auto scene = with("heap_q46", "draft", {"model.name=triangle"});
  EXPECT_EQ(scene.cells.columns,
            app::read_scene(tests::example("heap_q46")).cells.columns);  // the triangle only writes them
  const auto own = app::read_scene(tests::example("chute_periodic"));
  EXPECT_EQ(with("chute_periodic", "draft").cells.columns, std::min(own.cells.columns, 8));
}

TEST(Presets, AreExplainedEach) {
  const auto text = app::explain_presets();
  for (const auto& name : app::preset_names()) EXPECT_NE(text.find("\n" + name + ": "), std::string::npos) << name;
}
}  // namespace
