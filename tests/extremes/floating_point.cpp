#include <gtest/gtest.h>

#include <cfenv>
#include <string>

#include "support/example_scene.hpp"
#include "support/scene_run.hpp"

/// No example divides by zero, overflows or makes a NaN on its way, not even in a value that nobody uses.
namespace {

using namespace talus;

class FloatingPoint : public testing::TestWithParam<tests::Case> {};
INSTANTIATE_TEST_SUITE_P(EveryModel, FloatingPoint, testing::ValuesIn(tests::every_case()),
                         [](const auto& each) { return each.param.model + "_" + each.param.scene; });

std::string raised() {
  std::string words;
  for (const auto& [flag, word] : {std::pair{FE_INVALID, "invalid "}, std::pair{FE_DIVBYZERO, "divide-by-zero "},
                                   std::pair{FE_OVERFLOW, "overflow "}})
    if (std::fetestexcept(flag)) words += word;
  return words;
}

TEST_P(FloatingPoint, RaisesNoExceptionFromTheStartThroughGrowthAndShutOff) {
  const bool heap = GetParam().scene.starts_with("heap");
  const auto scene = GetParam().read(
      24, 8, heap ? std::vector<std::string>{"inflow.stop=2", "output.times=[]"} : std::vector<std::string>{});
  std::feclearexcept(FE_ALL_EXCEPT);
  tests::SceneRun run(scene);
  EXPECT_EQ(raised(), "") << "at the start";
  for (const double t : {0.01, 0.5, 1.0, 3.0}) {
    run.advance(t);
    EXPECT_EQ(raised(), "") << "on the way to " << t << " s";
    std::feclearexcept(FE_ALL_EXCEPT);
    (void)run.field(heap ? "heap_angle" : "u");
    EXPECT_EQ(raised(), "") << "in the fields at " << t << " s";
    std::feclearexcept(FE_ALL_EXCEPT);
  }
}

}  // namespace
