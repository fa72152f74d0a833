#include "output/run_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <numeric>

#include "core/errors.hpp"
#include "output/statistics_fields.hpp"
#include "support/heap_fields.hpp"
#include "support/nc_reader.hpp"
#include "support/temporary_folder.hpp"

namespace talus::output {
namespace {

using support::HeapFields;
using support::NcReader;

core::Snapshot at(double t, const core::Statistics& statistics) { return {t, {}, {}, statistics}; }

/// A file with two records of HeapFields, at 0.5 s and 2 s.
class RunFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    HeapFields fields;
    RunFile file(path, fields, {{"scene_name", "heap"}, {"box_tilt_deg", 29.2}, {"answer", 42}});
    file.append(at(0.5, statistics));
    file.append(at(2.0, statistics));
    EXPECT_EQ(file.n_records(), 2u);
    file.close();
  }

  support::TemporaryFolder folder;
  std::filesystem::path path = folder / "run.nc";
  core::Statistics statistics;
};

TEST_F(RunFileTest, ReturnsWhatWasWritten) {
  const NcReader run(path);
  EXPECT_EQ(run.values("time"), (std::vector<double>{0.5, 2.0}));
  const auto height = run.values("height");
  const auto mass = run.values("mass_stored");
  ASSERT_EQ(height.size(), 2 * HeapFields::n_columns);
  for (std::size_t i = 0; i < HeapFields::n_columns; ++i) {
    EXPECT_EQ(height[i], HeapFields::value(0.5, i));
    EXPECT_EQ(height[HeapFields::n_columns + i], HeapFields::value(2.0, i));
    EXPECT_EQ(run.values("x")[i], HeapFields::value(0.0, i));
  }
  EXPECT_EQ(mass[1], HeapFields::value(2.0, 0));
}

TEST_F(RunFileTest, FieldsAreSinglePrecisionWithHolesAndNoRangeError) {
  const NcReader run(path);
  const auto speed = run.values("speed");
  const std::size_t n = HeapFields::n_columns * HeapFields::n_layers;
  ASSERT_EQ(speed.size(), 2 * n);
  EXPECT_EQ(run.type("speed"), NC_FLOAT);
  EXPECT_TRUE(std::isnan(speed[n]));
  EXPECT_TRUE(std::isinf(speed[n + 1]));
  EXPECT_FLOAT_EQ(static_cast<float>(speed[n + 7]), static_cast<float>(HeapFields::value(2.0, 7)));
}

TEST_F(RunFileTest, DimensionsPutTimeFirstAndOnlyOnRecords) {
  const NcReader run(path);
  EXPECT_EQ(run.dimensions("speed"), (std::vector<std::string>{"time", "layer", "column"}));
  EXPECT_EQ(run.dimensions("x"), (std::vector<std::string>{"column"}));
  EXPECT_EQ(run.dimensions("mass_stored"), (std::vector<std::string>{"time"}));
  EXPECT_TRUE(run.dimensions("mesh").empty());
}

TEST_F(RunFileTest, AttributesKeepTheirTypes) {
  const NcReader run(path);
  EXPECT_EQ(run.text("", "Conventions"), "CF-1.8");
  EXPECT_EQ(run.text("", "scene_name"), "heap");
  EXPECT_EQ(run.number("", "box_tilt_deg"), 29.2);
  EXPECT_EQ(run.attribute_type("", "answer"), NC_INT);
  EXPECT_EQ(run.text("time", "units"), "s");
  EXPECT_EQ(run.text("time", "axis"), "T");
  EXPECT_EQ(run.text("speed", "units"), "m s-1");
  EXPECT_EQ(run.text("speed", "long_name"), "speed");
  EXPECT_EQ(run.text("speed", "coordinates"), "x");
  EXPECT_EQ(run.attribute_type("speed", "_FillValue"), NC_FLOAT);
  EXPECT_TRUE(std::isnan(run.number("speed", "_FillValue")));
  EXPECT_TRUE(std::isnan(run.number("height", "_FillValue")));
}

TEST_F(RunFileTest, FlagsAreNumbersOfTheVariablesOwnType) {
  struct Flagged : HeapFields {
    [[nodiscard]] std::vector<core::Variable> variables() const override {
      auto all = HeapFields::variables();
      all.at(2).flags = {"slow", "fast"};
      return all;
    }
  } fields;
  RunFile(folder / "flags.nc", fields, {}).close();
  const NcReader run(folder / "flags.nc");
  EXPECT_EQ(run.text("speed", "flag_meanings"), "slow fast");
  EXPECT_EQ(run.attribute_type("speed", "flag_values"), run.type("speed"));
  float values[2] = {};
  ASSERT_EQ(nc_get_att_float(run.file(), run.variable("speed"), "flag_values", values), NC_NOERR);
  EXPECT_EQ(values[0], 0.0F);
  EXPECT_EQ(values[1], 1.0F);
}

TEST_F(RunFileTest, TopologyIsAnIntegerThatCarriesIntegers) {
  const NcReader run(path);
  EXPECT_EQ(run.type("mesh"), NC_INT);
  EXPECT_EQ(run.text("mesh", "cf_role"), "grid_topology");
  EXPECT_EQ(run.attribute_type("mesh", "topology_dimension"), NC_INT);
  EXPECT_EQ(run.number("mesh", "topology_dimension"), 2);
}

TEST_F(RunFileTest, RecordsAreCompressedSlabs) {
  const NcReader run(path);
  int storage = -1, shuffle = 0, deflate = 0, level = 0;
  std::size_t chunks[3] = {};
  ASSERT_EQ(nc_inq_var_chunking(run.file(), run.variable("speed"), &storage, chunks), NC_NOERR);
  ASSERT_EQ(nc_inq_var_deflate(run.file(), run.variable("speed"), &shuffle, &deflate, &level), NC_NOERR);
  EXPECT_EQ(storage, NC_CHUNKED);
  EXPECT_EQ(chunks[0], 1u);
  EXPECT_EQ(chunks[1], HeapFields::n_layers);
  EXPECT_EQ(chunks[2], HeapFields::n_columns);
  EXPECT_EQ(shuffle, 1);
  EXPECT_EQ(level, 1);
}

TEST_F(RunFileTest, RefusesAnExistingFileUnlessToldToReplaceIt) {
  HeapFields fields;
  try {
    const RunFile again(path, fields, {});
    FAIL() << "an existing run was overwritten";
  } catch (const core::OutputError& error) {
    EXPECT_EQ(error.code(), core::ExitCode::io_setup);
    EXPECT_NE(std::string(error.what()).find("exists already"), std::string::npos);
  }
  EXPECT_EQ(NcReader(path).length("time"), 2u);
  { const RunFile replaced(path, fields, {}, {.replace = true}); }
  EXPECT_EQ(NcReader(path).length("time"), 0u);
}

TEST(RunFileStreams, EachHasItsOwnTimes) {
  const support::TemporaryFolder folder;
  const core::Statistics statistics{.steps = 7, .order = 2, .last_step = 0.125};
  HeapFields fields;
  StatisticsFields series;
  RunFile file(folder / "run.nc", fields, {});
  const std::size_t dense = file.add_stream("series_time", series);
  for (const double t : {0.0, 0.1, 0.2}) file.append(at(t, statistics), dense);
  file.append(at(0.2, statistics));
  file.close();

  const NcReader run(folder / "run.nc");
  EXPECT_EQ(run.values("series_time"), (std::vector<double>{0.0, 0.1, 0.2}));
  EXPECT_EQ(run.values("time"), (std::vector<double>{0.2}));
  EXPECT_EQ(run.dimensions("n_steps"), (std::vector<std::string>{"series_time"}));
  EXPECT_EQ(run.values("n_steps"), (std::vector<double>{7, 7, 7}));
  EXPECT_EQ(run.values("last_step")[2], 0.125);
}

/// A source whose answers can be bent away from what it declares.
class BentFields : public HeapFields {
 public:
  std::vector<std::pair<std::string, std::size_t>> named = HeapFields::dimensions();
  std::size_t cut = 0;

  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override { return named; }
  void evaluate(const core::Snapshot& s, std::vector<std::vector<double>>& values) override {
    HeapFields::evaluate(s, values);
    values[3].resize(values[3].size() - cut);
  }
};

template <class Action>
std::string internal_error_of(Action&& action) {
  try {
    action();
  } catch (const core::Error& error) {
    EXPECT_EQ(error.code(), core::ExitCode::internal);
    return error.what();
  }
  return "no error";
}

TEST(RunFileSources, WrongShapesAreNamed) {
  const support::TemporaryFolder folder;
  const core::Statistics statistics;
  BentFields short_of_values;
  short_of_values.cut = 2;
  EXPECT_EQ(internal_error_of([&] { RunFile(folder / "a.nc", short_of_values, {}).append(at(0.0, statistics)); }),
            "output variable 'height' has 3 values instead of 5");
  BentFields without_layer;
  without_layer.named = {{"column", 5}};
  EXPECT_EQ(internal_error_of([&] { RunFile(folder / "b.nc", without_layer, {}); }),
            "output variable 'speed' names the unknown dimension 'layer'");
  BentFields two_lengths;
  two_lengths.named.emplace_back("column", 6);
  EXPECT_EQ(internal_error_of([&] { RunFile(folder / "c.nc", two_lengths, {}); }),
            "output dimension 'column' has two lengths, 5 and 6");
}

/// A file of two streams: HeapFields at 0.5, 2 and 3 s, statistics at 0.5, 1, 2 and 3 s.
void write_two_streams(const std::filesystem::path& path) {
  HeapFields fields;
  StatisticsFields counters;
  RunFile file(path, fields, {{"history", "first"}});
  const auto second = file.add_stream("series_time", counters);
  core::Statistics statistics;
  for (const double t : {0.5, 1.0, 2.0, 3.0}) {
    statistics.steps = static_cast<std::int64_t>(100.0 * t);
    file.append(at(t, statistics), second);
    if (t != 1.0) file.append(at(t, statistics));
  }
}

TEST_F(RunFileTest, GoesOnWhereAnEarlierFileIsToEnd) {
  const auto earlier = folder / "two.nc";
  write_two_streams(earlier);
  const NcReader before(earlier);
  HeapFields fields;
  StatisticsFields counters;
  RunFile file(folder / "two.nc.part", fields, {{"history", "second"}});
  file.add_stream("series_time", counters);
  file.take_place_of(earlier, {1, 2});
  EXPECT_EQ(file.last_time(0), 0.5);
  EXPECT_EQ(file.last_time(1), 1.0);
  statistics.steps = 7;
  file.append(at(4.0, statistics), 1);
  file.append(at(4.0, statistics));
  file.close();
  EXPECT_FALSE(std::filesystem::exists(folder / "two.nc.part"));

  const NcReader run(earlier);
  EXPECT_EQ(run.values("time"), (std::vector<double>{0.5, 4.0}));
  EXPECT_EQ(run.values("series_time"), (std::vector<double>{0.5, 1.0, 4.0}));
  EXPECT_EQ(run.values("n_steps"), (std::vector<double>{50.0, 100.0, 7.0}));
  EXPECT_EQ(run.values("x"), before.values("x"));
  EXPECT_EQ(run.text("", "history"), "first\nsecond");
  const auto speed = run.values("speed"), speed_before = before.values("speed");
  const std::size_t n = HeapFields::n_columns * HeapFields::n_layers;
  EXPECT_TRUE(std::isnan(speed[0]) && std::isinf(speed[1]));
  EXPECT_TRUE(std::equal(speed.begin() + 1, speed.begin() + n, speed_before.begin() + 1));
  EXPECT_EQ(run.values("height").back(), HeapFields::value(4.0, HeapFields::n_columns - 1));
  EXPECT_EQ(before.values("time"), (std::vector<double>{0.5, 2.0, 3.0})) << "a reader keeps what it has open";
}

TEST_F(RunFileTest, RefusesToGoOnFromAFileThatLacksRecords) {
  HeapFields fields;
  const auto aside = folder / "run.nc.part";
  const auto code_of = [&](const std::filesystem::path& earlier, std::size_t n) {
    RunFile file(aside, fields, {});
    try {
      file.take_place_of(earlier, {n});
    } catch (const core::OutputError& error) { return error.code(); }
    return core::ExitCode::ok;
  };
  EXPECT_EQ(code_of(path, 3), core::ExitCode::bad_restart);
  EXPECT_EQ(code_of(folder / "none.nc", 0), core::ExitCode::bad_restart);
  std::ofstream(folder / "rubbish.nc") << "not netCDF";
  EXPECT_EQ(code_of(folder / "rubbish.nc", 0), core::ExitCode::bad_restart);
  EXPECT_FALSE(std::filesystem::exists(aside));
  EXPECT_EQ(NcReader(path).values("time").size(), 2U) << "the earlier file is as it was";
  EXPECT_EQ(code_of(path, 2), core::ExitCode::ok);
}

TEST_F(RunFileTest, NoticesThatItsFileIsGone) {
  HeapFields fields;
  for (const bool replaced : {false, true}) {
    const auto other = folder / (replaced ? "b.nc" : "a.nc");
    RunFile file(other, fields, {});
    file.append(at(0.0, statistics));
    std::filesystem::remove(other);
    if (replaced) std::ofstream(other) << "another";
    try {
      file.append(at(1.0, statistics));
      ADD_FAILURE() << "a record went to a file without a name";
    } catch (const core::OutputError& error) {
      EXPECT_EQ(error.code(), core::ExitCode::output_failed);
      EXPECT_NE(std::string(error.what()).find("removed or replaced"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace talus::output
