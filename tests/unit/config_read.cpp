#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "config/read.hpp"
#include "core/errors.hpp"

namespace {
using namespace talus::config;

Schema sample() {
  Schema s;
  s.section("box", "the box");
  s.add(number("gap", "m", "distance of the side walls").above(0.0));
  s.add(number("tilt", "degree", "of the base").above(-90.0).below(90.0).fallback(0.0));
  s.section("grid", "cells");
  s.add(integer("columns", "along the base").at_least(2).at_most(1000).fallback(std::int64_t{10}));
  s.add(boolean("periodic", "ends joined").fallback(false));
  s.section("law", "friction");
  s.add(choice("name", {"classical", "constant"}, "which law"));
  s.add(number("mu_d", "1", "upper friction").above(0.0).required_if("name is classical", [](const Values& v) {
    return v.text("law.name") == "classical";
  }));
  s.add(number("I_N", "1", "crossover").above(0.0).optional("computed"));
  s.section("output", "records");
  s.add(ascending_numbers("times", "s", "of records").at_least(0.0).fallback(std::vector<double>{}));
  s.add(text("title", "in words").fallback(std::string("untitled")));
  s.add(numbers("tilts", "degree", "in any order").above(-90.0).below(90.0).optional("none"));
  return s;
}

const Schema schema = sample();
const std::string good = "[box]\ngap = 0.003\n[law]\nname = \"constant\"\n";

Values accept(const std::string& toml, const std::vector<std::string>& overrides = {}) {
  return read_text(schema, toml, "s.toml", overrides);
}

std::string refusal(const std::string& toml, const std::vector<std::string>& overrides = {}) {
  try {
    (void)accept(toml, overrides);
  } catch (const talus::core::ConfigError& error) { return error.what(); }
  return "accepted";
}

TEST(ConfigRead, FillsInDefaultsAndKeepsWhatWasGiven) {
  const Values v = accept(good + "[grid]\ncolumns = 7\n[output]\ntimes = [1, 2.5]\n");
  EXPECT_EQ(v.number("box.gap"), 0.003);
  EXPECT_EQ(v.number("box.tilt"), 0.0);
  EXPECT_EQ(v.integer("grid.columns"), 7);
  EXPECT_FALSE(v.boolean("grid.periodic"));
  EXPECT_EQ(v.numbers("output.times"), (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(v.text("output.title"), "untitled");
  EXPECT_FALSE(v.has("law.I_N"));
  EXPECT_EQ(v.place("box.gap"), "s.toml:2:1");
  EXPECT_EQ(v.place("box.tilt"), "s.toml");
}

TEST(ConfigRead, TakesAnIntegerForANumberButNotTheOtherWay) {
  EXPECT_EQ(accept("box.gap = 1\nlaw.name = 'constant'").number("box.gap"), 1.0);
  EXPECT_EQ(refusal(good + "[grid]\ncolumns = 7.0\n"),
            "s.toml:6:1: grid.columns: expected an integer of at least 2 and of at most 1000, found the number 7");
}

TEST(ConfigRead, OffersTheNearestSpelling) {
  EXPECT_EQ(refusal(good + "[grid]\ncolunms = 7\n"),
            "s.toml:6:1: grid.colunms: unknown key (did you mean grid.columns?)");
  EXPECT_EQ(refusal(good + "[gird]\ncolumns = 7\n"), "s.toml:5:2: gird: unknown section (did you mean grid?)");
  EXPECT_EQ(refusal(good + "[grid]\ngap = 7\n"), "s.toml:6:1: grid.gap: unknown key (did you mean box.gap?)");
  EXPECT_EQ(refusal(good + "[grid]\nviscosity_of_air = 7\n"), "s.toml:6:1: grid.viscosity_of_air: unknown key");
  EXPECT_EQ(refusal("columns = 3\n" + good), "s.toml:1:1: columns: key outside a section (did you mean grid.columns?)");
}

TEST(ConfigRead, RefusesMistypedValues) {
  EXPECT_EQ(refusal("[box]\ngap = \"3 mm\"\n[law]\nname = \"constant\"\n"),
            "s.toml:2:1: box.gap: expected a number above 0 [m], found the text \"3 mm\"");
  EXPECT_EQ(refusal(good + "[grid]\nperiodic = 1\n"),
            "s.toml:6:1: grid.periodic: expected true or false, found the integer 1");
  EXPECT_EQ(refusal("grid = 3\n" + good), "s.toml:1:1: grid: expected a section [grid], found the integer 3");
  EXPECT_EQ(refusal(good + "[output]\ntimes = [1, \"two\"]\n"),
            "s.toml:6:1: output.times: expected an ascending list of numbers of at least 0 [s], found a list that "
            "holds something else");
}

TEST(ConfigRead, RefusesNumbersThatAreNotFiniteOrOutOfRange) {
  const auto gap = [](const std::string& value) {
    return refusal("[law]\nname = \"constant\"\n[box]\ngap = " + value + "\n");
  };
  EXPECT_EQ(gap("nan"),
            "s.toml:4:1: box.gap: expected a number above 0 [m], found the number nan, which is not finite");
  EXPECT_EQ(gap("inf"),
            "s.toml:4:1: box.gap: expected a number above 0 [m], found the number inf, which is not finite");
  EXPECT_EQ(gap("-0.003"), "s.toml:4:1: box.gap: expected a number above 0 [m], found -0.003");
  EXPECT_EQ(gap("0.0"), "s.toml:4:1: box.gap: expected a number above 0 [m], found 0.0");
  EXPECT_NE(refusal(good + "[grid]\ncolumns = 1\n"), "accepted");
  EXPECT_EQ(refusal(good + "[grid]\ncolumns = 2\n"), "accepted");
  EXPECT_NE(refusal(good + "[output]\ntimes = [1, nan]\n"), "accepted");
  EXPECT_NE(refusal(good + "[output]\ntimes = [2, 2]\n"), "accepted");
  EXPECT_NE(refusal(good + "[output]\ntimes = [-1, 2]\n"), "accepted");
}

TEST(ConfigRead, ListsOfNumbersNeedNotAscendUnlessTheirKeySaysSo) {
  const std::vector<double> tilts{30.0, -5.0, -5.0, 20.0};
  const Values v = accept(good + "[output]\ntilts = [30.0, -5, -5.0, 20]\n");
  EXPECT_EQ(v.numbers("output.tilts"), tilts);
  EXPECT_EQ(accept(v.to_toml()).numbers("output.tilts"), tilts);
  EXPECT_EQ(accept(good, {"output.tilts=[3, 1]"}).numbers("output.tilts"), (std::vector<double>{3.0, 1.0}));
  EXPECT_FALSE(accept(good).has("output.tilts"));
  const std::string expected = "s.toml:6:1: output.tilts: expected a list of numbers above -90 and below 90 [degree], ";
  EXPECT_EQ(refusal(good + "[output]\ntilts = [30, 90]\n"), expected + "found [30.0, 90.0]");
  EXPECT_EQ(refusal(good + "[output]\ntilts = [30, inf]\n"), expected + "found a list that holds something else");
  EXPECT_EQ(refusal(good + "[output]\ntilts = 30\n"), expected + "found the integer 30");
}

TEST(ConfigRead, RefusesDuplicatesAndBrokenSyntaxWithItsPlace) {
  const std::string twice = refusal(good + "[grid]\ncolumns = 7\ncolumns = 8\n");
  EXPECT_EQ(twice.substr(0, 9), "s.toml:7:");
  EXPECT_NE(twice.find("'columns'"), std::string::npos) << twice;
  EXPECT_EQ(refusal("[box]\ngap = = 3\n").substr(0, 9), "s.toml:2:");
}

TEST(ConfigRead, ReportsEveryProblemInTheOrderOfTheFile) {
  EXPECT_EQ(refusal("[law]\nname = \"clasical\"\n[grid]\nzoom = 1\ncolumns = 1\n"),
            "s.toml:2:1: law.name: expected one of classical, constant, found \"clasical\" (did you mean classical?)\n"
            "s.toml:4:1: grid.zoom: unknown key\n"
            "s.toml:5:1: grid.columns: expected an integer of at least 2 and of at most 1000, found 1\n"
            "s.toml: box.gap: missing; expected a number above 0 [m]: distance of the side walls");
}

TEST(ConfigRead, AsksForAKeyOnlyWhereItIsNeeded) {
  EXPECT_EQ(refusal("[box]\ngap = 1\n[law]\nname = \"classical\"\n"),
            "s.toml:3:2: law.mu_d: missing; expected a number above 0 [1]: upper friction");
  EXPECT_EQ(refusal("[box]\ngap = 1\n[law]\nname = \"classical\"\nmu_d = 1"), "accepted");
}

TEST(ConfigRead, OverridesPassTheSameChecks) {
  const Values v = accept(
      good, {"box.gap=0.01", "law.name=classical", "law.mu_d = 0.9", "output.title=a \"b\" c", "output.times=[3]"});
  EXPECT_EQ(v.number("box.gap"), 0.01);
  EXPECT_EQ(v.text("law.name"), "classical");
  EXPECT_EQ(v.text("output.title"), "a \"b\" c");
  EXPECT_EQ(v.numbers("output.times"), std::vector<double>{3.0});
  EXPECT_EQ(v.place("box.gap"), "--set");
  EXPECT_EQ(refusal(good, {"box.gap=-1"}), "--set: box.gap: expected a number above 0 [m], found -1.0");
  EXPECT_EQ(refusal(good, {"box.gap=wide"}), "--set: box.gap: expected a number above 0 [m], found wide");
  EXPECT_EQ(refusal(good, {"box.gpa=1"}), "--set: box.gpa: unknown key (did you mean box.gap?)");
  EXPECT_EQ(refusal(good, {"box.gap"}), "--set box.gap: expected key=value");
  EXPECT_EQ(refusal(good, {"box.gap=1", "box.gap=2"}), "--set: box.gap: given twice");
  EXPECT_NE(refusal(good, {"box.gap=1\nother = 2"}), "accepted");
}

Schema with_repeats() {
  Schema s;
  s.section("scene", "");
  s.add(texts("set", "").fallback(std::vector<std::string>{}));
  s.repeated_section("axis", "what varies");
  s.add(text("key", ""));
  s.add(scalars("values", "").optional("count"));
  s.add(integer("count", "").required_if("values is absent", [](const Values& v) { return !v.has("axis.values"); }));
  s.add(number("from", "m", "").fallback(0.5));
  return s;
}

TEST(ConfigRead, GivesEachTableOfARepeatedSectionItsOwnValues) {
  const Schema repeats = with_repeats();
  const Values v = read_text(
      repeats,
      "[scene]\nset = ['a=1']\n[[axis]]\nkey = 'a'\nvalues = [1, 2.5, true, 'b']\n[[axis]]\nkey = 'c'\ncount = 3\n",
      "s.toml");
  EXPECT_EQ(v.texts("scene.set"), std::vector<std::string>{"a=1"});
  ASSERT_EQ(v.tables("axis").size(), 2U);
  const Values &first = v.tables("axis")[0], &second = v.tables("axis")[1];
  EXPECT_EQ(first.scalars("axis.values"), (std::vector<Scalar>{std::int64_t{1}, 2.5, true, std::string("b")}));
  EXPECT_EQ(first.place("axis.values"), "s.toml:5:1");
  EXPECT_EQ(first.number("axis.from"), 0.5);
  EXPECT_FALSE(first.has("axis.count"));
  EXPECT_EQ(second.text("axis.key"), "c");
  EXPECT_EQ(second.integer("axis.count"), 3);
  EXPECT_FALSE(v.has("axis.key"));
  EXPECT_TRUE(read_text(repeats, "[scene]\n", "s.toml").tables("axis").empty());
}

TEST(ConfigRead, HoldsEachTableOfARepeatedSectionToItsSchema) {
  const Schema repeats = with_repeats();
  try {
    (void)read_text(repeats, "[[axis]]\nkey = 3\ncount = 1\n[[axis]]\nkey = 'c'\nvaleus = [1]\n[[axis]]\n", "s.toml");
    FAIL() << "accepted";
  } catch (const talus::core::ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "s.toml:2:1: axis.key: expected a text in quotes, found the integer 3\n"
                 "s.toml:6:1: axis.valeus: unknown key (did you mean axis.values?)\n"
                 "s.toml:7:1: axis.key: missing; expected a text in quotes: ");
  }
  EXPECT_EQ(explain(repeats, "axis").substr(0, 8), "[[axis]]");
}

TEST(ConfigRead, ShowsControlCharactersOfItsInputAsText) {
  EXPECT_EQ(refusal("\"\\u0000b\\u001Bx\" = 1\n" + good), "s.toml:1:1: \\x00b\\x1bx: key outside a section");
}

TEST(ConfigRead, NamesAFileThatCannotBeRead) {
  try {
    (void)read(schema, "/no/such/scene.toml");
    FAIL() << "accepted";
  } catch (const talus::core::ConfigError& error) {
    EXPECT_STREQ(error.what(), "/no/such/scene.toml: cannot be read as a TOML file");
  }
}

TEST(ConfigValues, TheEffectiveSceneReadsBackToItself) {
  const Values v = accept(
      good, {"output.title=say \"hi\"\\ \t\n now", "box.tilt=0.1", "output.times=[1e-7, 0.30000000000000004, 1e22]"});
  const std::string printed = v.to_toml();
  const Values again = accept(printed);
  EXPECT_EQ(again.number("box.tilt"), 0.1);
  EXPECT_EQ(again.numbers("output.times"), v.numbers("output.times"));
  EXPECT_EQ(again.text("output.title"), "say \"hi\"\\ \t\n now");
  EXPECT_EQ(again.integer("grid.columns"), 10);
  EXPECT_NE(printed.find("columns = 10  # default"), std::string::npos) << printed;
  EXPECT_NE(printed.find("# I_N: optional; absent: computed"), std::string::npos) << printed;
}

TEST(ConfigValues, AFaultOfTheProgramIsNotBlamedOnTheScene) {
  const Values v = accept(good);
  EXPECT_THROW((void)v.number("box.width"), std::logic_error);
  EXPECT_THROW((void)v.integer("box.gap"), std::logic_error);
}

TEST(ConfigSchema, RefusesContradictoryDeclarations) {
  Schema s;
  EXPECT_THROW(s.add(number("a", "m", "")), std::logic_error);
  s.section("x", "").add(number("a", "m", ""));
  EXPECT_THROW(s.add(text("a", "")), std::logic_error);
  EXPECT_THROW(s.section("x", ""), std::logic_error);
  EXPECT_THROW(s.add(number("b", "m", "").above(0.0).fallback(0.0)), std::logic_error);
}

TEST(ConfigSchema, ExplainsEveryKeyFromItsDeclaration) {
  const std::string box = explain(schema, "box");
  EXPECT_EQ(box,
            "[box]  the box\n"
            "  gap\n      distance of the side walls\n      a number above 0 [m]; required\n"
            "  tilt\n      of the base\n      a number above -90 and below 90 [degree]; default 0.0\n");
  const std::string all = explain(schema);
  for (const auto& section : schema.sections()) EXPECT_NE(all.find(explain(schema, section.name)), std::string::npos);
  EXPECT_THROW((void)explain(schema, "bocks"), talus::core::ConfigError);
}
}  // namespace
