#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

#include "core/errors.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/sweep_file.hpp"

namespace {
using namespace talus;
using config::Scalar;

/// A few keys, as a scene would have them.
const config::Schema& scene() {
  static const config::Schema schema = [] {
    config::Schema s;
    s.section("box", "");
    s.add(config::number("gap", "m", "between the walls").above(0.0));
    s.add(config::number("tilt", "degree", "").above(-90.0).below(90.0));
    s.section("grid", "");
    s.add(config::integer("columns", "").at_least(2).at_most(1000));
    s.add(config::integer("layers", "").at_least(2));
    s.section("law", "");
    s.add(config::choice("name", {"classical", "constant"}, ""));
    s.add(config::ascending_numbers("times", "s", ""));
    return s;
  }();
  return schema;
}

const std::string head = "[sweep]\nname = \"s\"\nscene = \"scene.toml\"\n";

sweep::SweepFile read(const std::string& rest, const std::string& start = head) {
  const support::TemporaryFolder folder;
  const auto file = folder / "s.toml";
  std::ofstream(file) << start + rest;
  try {
    return sweep::read_sweep(file, scene());
  } catch (const core::ConfigError& error) {
    std::string message = error.what();
    for (std::size_t at; (at = message.find(file.string())) != std::string::npos;)
      message.replace(at, file.string().size(), "s.toml");
    throw core::ConfigError(message);
  }
}

std::string refusal(const std::string& rest, const std::string& start = head) {
  try {
    (void)read(rest, start);
  } catch (const core::ConfigError& error) { return error.what(); }
  return "accepted";
}

std::string axis(const std::string& key, const std::string& rest) {
  return "[[axis]]\nkey = \"" + key + "\"\n" + rest + "\n";
}

TEST(SweepFile, MakesTheProductOfItsAxesLastOneFastest) {
  const auto s =
      read(axis("box.gap", "values = [0.003, 0.01]") + axis("law.name", "values = ['classical', 'constant']") +
           axis("grid.columns", "from = 10\nto = 30\ncount = 3"));
  EXPECT_EQ(s.name, "s");
  EXPECT_EQ(s.scene.filename(), "scene.toml");
  ASSERT_EQ(s.design.size(), 12U);
  EXPECT_EQ(s.design.describe(0), "box.gap = 0.003 m, law.name = \"classical\", grid.columns = 10");
  EXPECT_EQ(s.design.describe(1), "box.gap = 0.003 m, law.name = \"classical\", grid.columns = 20");
  EXPECT_EQ(s.design.describe(11), "box.gap = 0.01 m, law.name = \"constant\", grid.columns = 30");
  EXPECT_EQ(s.design.point(7), (std::vector<std::size_t>{1, 0, 1}));
  EXPECT_EQ(s.design.dimensions()[0].name, "box_gap");
  EXPECT_EQ(s.design.dimensions()[0].axes[0].unit, "m");
}

TEST(SweepFile, MovesZippedAxesTogether) {
  const auto s = read(axis("grid.columns", "values = [10, 20, 40]\nzip = 'grid'") + axis("box.gap", "values = [1, 2]") +
                      axis("grid.layers", "values = [2, 4, 8]\nzip = 'grid'"));
  ASSERT_EQ(s.design.size(), 6U);
  EXPECT_EQ(s.design.describe(3), "grid.columns = 20, grid.layers = 4, box.gap = 2.0 m");
  EXPECT_EQ(s.design.dimensions()[0].name, "grid");
  const auto alone =
      read(axis("grid.columns", "values = [10, 20]\nzip = 'z'") + axis("box.gap", "values = [1, 1]\nzip = 'z'"));
  EXPECT_EQ(alone.design.size(), 2U);
  EXPECT_EQ(alone.design.dimensions()[0].name, "member");
}

TEST(SweepFile, DrawsWhatHasEndsButNoCount) {
  const std::string axes = axis("box.gap", "from = 0.001\nto = 0.1\nspacing = 'logarithmic'") +
                           axis("law.name", "values = ['classical', 'constant']") +
                           axis("grid.columns", "from = 3\nto = 6");
  const auto s = read(axes + "[sample]\nmembers = 40\nseed = 7\n");
  ASSERT_EQ(s.design.dimensions().size(), 2U);
  EXPECT_EQ(s.design.size(), 80U);
  EXPECT_EQ(s.design.dimensions()[0].name, "sample");
  const auto& drawn = s.design.dimensions()[0].axes;
  ASSERT_EQ(drawn.size(), 2U);
  int below_a_hundredth = 0;
  for (const auto& value : drawn[0].values) {
    EXPECT_GE(std::get<double>(value), 0.001);
    EXPECT_LE(std::get<double>(value), 0.1);
    below_a_hundredth += std::get<double>(value) < 0.01 ? 1 : 0;
  }
  EXPECT_EQ(below_a_hundredth, 20);
  std::multiset<std::int64_t> columns;
  for (const auto& value : drawn[1].values) columns.insert(std::get<std::int64_t>(value));
  for (const int n : {3, 4, 5, 6}) EXPECT_EQ(columns.count(n), 10U) << n;

  const auto random = read(axes + "[sample]\nmethod = 'random'\nmembers = 40\nseed = 7\n");
  EXPECT_NE(random.design.dimensions()[0].axes[0].values, drawn[0].values);
}

TEST(SweepFile, AnIntegerPassesForANumberAndKeepsToIntegersElsewhere) {
  const auto s = read(axis("box.gap", "values = [1, 2.5]") + axis("grid.layers", "from = 2\nto = 4\ncount = 3"));
  EXPECT_EQ(s.design.dimensions()[0].axes[0].values, (std::vector<Scalar>{1.0, 2.5}));
  EXPECT_EQ(s.design.dimensions()[1].axes[0].values,
            (std::vector<Scalar>{std::int64_t{2}, std::int64_t{3}, std::int64_t{4}}));
}

struct Mistake {
  std::string name, rest, message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.rest; }

class SweepMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SweepMistake, IsRefusedWithItsPlace) { EXPECT_EQ(refusal(GetParam().rest), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    Sweep, SweepMistake,
    testing::Values(
        Mistake{"NoAxis", "", "s.toml: axis: missing; expected [[axis]], at least one"},
        Mistake{"AxisThatIsNoTable", "[axis]\nkey = 'box.gap'\n",
                "s.toml:4:2: axis: expected [[axis]], once for each, found a table"},
        Mistake{"NoKey", "[[axis]]\nvalues = [1]\n",
                "s.toml:4:1: axis.key: missing; expected a text in quotes: dotted key of the scene, for example "
                "inflow.rate"},
        Mistake{"UnknownKey", axis("box.gpa", "values = [1]"),
                "s.toml:5:1: axis.key: box.gpa: unknown key of a scene (did you mean box.gap?)"},
        Mistake{
            "KeyOfAList", axis("law.times", "values = [1]"),
            "s.toml:5:1: axis.key: law.times: expected a key with a single value; this one takes an ascending list of "
            "numbers [s]"},
        Mistake{"KeyTwice", axis("box.gap", "values = [1]") + axis("box.gap", "values = [2]"),
                "s.toml:8:1: axis.key: box.gap: expected one axis for a key"},
        Mistake{"TypoInAnAxis", axis("box.gap", "vlaues = [1]\nvalues = [2]"),
                "s.toml:6:1: axis.vlaues: unknown key (did you mean axis.values?)"},
        Mistake{
            "NothingToTake", axis("box.gap", ""),
            "s.toml:4:1: axis.from: missing; expected a number: first number, in the key's unit; an integer key takes "
            "the nearest integers\ns.toml:4:1: axis.to: missing; expected a number: last number"},
        Mistake{"ValuesAndRange", axis("box.gap", "values = [1]\ncount = 3"),
                "s.toml:7:1: axis.count: expected values or a range, not both"},
        Mistake{"EmptyList", axis("box.gap", "values = []"),
                "s.toml:6:1: axis.values: expected a list of one or more values, found []"},
        Mistake{"ValueOutOfRange", axis("box.gap", "values = [0.003, -0.003]"),
                "s.toml:6:1: axis.values: box.gap: expected a number above 0 [m], found -0.003"},
        Mistake{
            "ValueOfAnotherType", axis("grid.columns", "values = [10, 20.5]"),
            "s.toml:6:1: axis.values: grid.columns: expected an integer of at least 2 and of at most 1000, found 20.5"},
        Mistake{
            "UnknownWord", axis("law.name", "values = ['clasical']"),
            "s.toml:6:1: axis.values: law.name: expected one of classical, constant, found \"clasical\" (did you mean "
            "classical?)"},
        Mistake{"ValueTwice", axis("box.gap", "values = [1, 2, 1.0]"),
                "s.toml:6:1: axis.values: box.gap: expected different values, found 1.0 more than once"},
        Mistake{
            "ListInAList", axis("box.gap", "values = [[1], [2]]"),
            "s.toml:6:1: axis.values: expected a list of one or more values, found a list that holds something else"},
        Mistake{
            "NotFinite", axis("box.gap", "values = [1, nan]"),
            "s.toml:6:1: axis.values: expected a list of one or more values, found a list that holds something else"},
        Mistake{"RangeOfWords", axis("law.name", "from = 1\nto = 2\ncount = 2"),
                "s.toml:6:1: axis.from: law.name: expected values; this key takes one of classical, constant"},
        Mistake{"RangeOutOfRange", axis("box.tilt", "from = 0\nto = 95\ncount = 2"),
                "s.toml:7:1: axis.to: box.tilt: expected a number above -90 and below 90 [degree], found 95.0"},
        Mistake{"RangeOfAPoint", axis("box.tilt", "from = 5\nto = 5\ncount = 2"),
                "s.toml:7:1: axis.to: expected a number other than axis.from"},
        Mistake{"LogarithmOfZero", axis("box.tilt", "from = 0\nto = 5\ncount = 2\nspacing = 'logarithmic'"),
                "s.toml:6:1: axis.from: expected a number above 0, since the spacing is logarithmic"},
        Mistake{"TooFewIntegers", axis("grid.layers", "from = 2\nto = 4\ncount = 5"),
                "s.toml:8:1: axis.count: grid.layers: expected different values, found 3 more than once"},
        Mistake{"HalfAnInteger", axis("grid.layers", "from = 2.5\nto = 4\ncount = 2"),
                "s.toml:6:1: axis.from: grid.layers: expected an integer, found 2.5"},
        Mistake{"OneNumber", axis("box.tilt", "from = 1\nto = 2\ncount = 1"),
                "s.toml:8:1: axis.count: expected an integer of at least 2, found 1"},
        Mistake{"NothingDraws", axis("box.tilt", "from = 1\nto = 2"),
                "s.toml:6:1: axis.from: expected axis.count with it, or a section [sample] with members"},
        Mistake{
            "NothingToDraw", axis("box.tilt", "values = [1]") + "[sample]\nmembers = 3\nseed = 1\n",
            "s.toml:8:1: sample.members: expected an axis to draw, with axis.from and axis.to but without axis.count"},
        Mistake{
            "NoSeed", axis("box.tilt", "from = 1\nto = 2") + "[sample]\nmembers = 3\n",
            "s.toml:8:2: sample.seed: missing; expected an integer of at least 0: the same seed draws the same points "
            "on every machine"},
        Mistake{"ZippedUnevenly",
                axis("box.tilt", "values = [1, 2]\nzip = 'a'") + axis("box.gap", "values = [1]\nzip = 'a'"),
                "s.toml:11:1: axis.zip: expected 2 values as box.tilt has, found 1"},
        Mistake{"ZippedUnderADimension", axis("box.tilt", "values = [1, 2]\nzip = 'sample'"),
                "s.toml:7:1: axis.zip: expected another word than sample"},
        Mistake{"ZippedUnderAKey",
                axis("box.gap", "values = [1, 2]") + axis("box.tilt", "values = [1, 2]\nzip = 'box_gap'"),
                "s.toml:10:1: axis.zip: expected another word than box_gap, the name of another dimension"},
        Mistake{"ZippedSample", axis("box.tilt", "from = 1\nto = 2\nzip = 'a'") + "[sample]\nmembers = 3\nseed = 1\n",
                "s.toml:8:1: axis.zip: expected none: a sample moves this axis together with the others that it draws"},
        Mistake{"TooManyMembers",
                axis("box.tilt", "from = 1\nto = 2\ncount = 1000") + axis("box.gap", "from = 1\nto = 2\ncount = 101"),
                "s.toml: axis: expected at most 100000 members in all"}),
    [](const auto& mistake) { return mistake.param.name; });

TEST(SweepFile, IsHeldToItsOwnHead) {
  EXPECT_EQ(
      refusal(axis("box.gap", "values = [1]"), "[sweep]\nname = \"../s\"\nscene = \"a\"\nset = [\"box.gap=1\"]\n"),
      "s.toml:2:1: sweep.name: expected letters, digits, - and _ only\n"
      "s.toml:4:1: sweep.set: box.gap: is an axis, too");
  EXPECT_EQ(refusal(axis("box.gap", "values = [1]"), "[sweep]\nname = \"s\"\nscene = \"a\"\nset = [1]\n"),
            "s.toml:4:1: sweep.set: expected a list of texts in quotes, found a list that holds something else");
}

TEST(SweepFile, ThatCannotBeReadIsNamed) {
  try {
    (void)sweep::read_sweep("no_such_sweep.toml", scene());
    FAIL() << "accepted";
  } catch (const core::ConfigError& error) {
    EXPECT_STREQ(error.what(), "no_such_sweep.toml: cannot be read as a TOML file");
  }
}
}  // namespace
