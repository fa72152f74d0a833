#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "core/errors.hpp"
#include "output/csv.hpp"
#include "output/run_file.hpp"
#include "output/run_reader.hpp"
#include "output/statistics_fields.hpp"
#include "output/table_file.hpp"
#include "support/heap_fields.hpp"
#include "support/nc_reader.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace talus;
using support::NcReader;
using support::TemporaryFolder;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

output::Table sample() {
  output::Table table;
  table.dimensions = {{"rate", 2}, {"law", 3}};
  table.variables.push_back(
      {"rate", {"rate"}, "kg/s", "mass flow", std::vector<double>{1e-3, 2e-3}, {{"scene_key", "inflow.rate"}}});
  table.variables.push_back({"law", {"law"}, "", "friction law", std::vector<std::string>{"a", "b c", ""}});
  table.variables.push_back(
      {"slope", {"rate", "law"}, "degree", "of the face", std::vector<double>{1, 2, missing, 4, 5, 6}});
  table.variables.push_back({"status",
                             {"rate", "law"},
                             "",
                             "what became of it",
                             std::vector<std::int64_t>{0, 1, 1, 0, 1, 0},
                             {},
                             {"planned", "finished"}});
  table.attributes = {{"title", "a table"}};
  return table;
}

TEST(TableFile, HoldsNumbersIntegersAndTextsWithUnits) {
  const TemporaryFolder folder;
  output::write_table(folder / "t.nc", sample());
  const NcReader file(folder / "t.nc");
  EXPECT_EQ(file.dimensions("slope"), (std::vector<std::string>{"rate", "law"}));
  EXPECT_EQ(file.text("slope", "units"), "degree");
  EXPECT_EQ(file.text("rate", "scene_key"), "inflow.rate");
  EXPECT_EQ(file.text("", "title"), "a table");
  const auto slope = file.values("slope");
  EXPECT_EQ(slope[1], 2.0);
  EXPECT_TRUE(std::isnan(slope[2]));
  EXPECT_TRUE(std::isnan(file.number("slope", "_FillValue")));
  EXPECT_EQ(file.values("status"), (std::vector<double>{0, 1, 1, 0, 1, 0}));
  EXPECT_EQ(file.text("status", "flag_meanings"), "planned finished");
  EXPECT_EQ(file.attribute_type("status", "flag_values"), file.type("status"));
  char* texts[3] = {};
  ASSERT_EQ(nc_get_var_string(file.file(), file.variable("law"), texts), NC_NOERR);
  EXPECT_STREQ(texts[1], "b c");
  nc_free_string(3, texts);
}

TEST(TableFile, ReplacesAnEarlierOneOrLeavesIt) {
  const TemporaryFolder folder;
  output::write_table(folder / "t.nc", sample());
  auto other = sample();
  other.attributes["title"] = std::string("another");
  output::write_table(folder / "t.nc", other);
  EXPECT_EQ(NcReader(folder / "t.nc").text("", "title"), "another");

  other.variables.back().values = std::vector<std::int64_t>{1};
  EXPECT_THROW(output::write_table(folder / "t.nc", other), core::Error);
  EXPECT_EQ(NcReader(folder / "t.nc").text("", "title"), "another");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_THROW(output::write_table(folder / "no" / "t.nc", sample()), core::OutputError);
}

TEST(RunReader, ReadsTheSeriesOfARunWithTheirUnits) {
  const TemporaryFolder folder;
  support::HeapFields heap;
  output::StatisticsFields statistics;
  {
    output::RunFile run(folder / "run.nc", statistics, {});
    const auto stream = run.add_stream("series_time", heap);
    for (const double t : {0.0, 0.5, 2.0}) run.append({t, {}, {}, core::Statistics{}}, stream);
    run.close();
  }
  const output::RunReader run(folder / "run.nc");
  ASSERT_EQ(run.series(), std::vector<std::string>{"mass_stored"});
  EXPECT_EQ(run.values("series_time"), (std::vector<double>{0.0, 0.5, 2.0}));
  EXPECT_EQ(run.values("mass_stored").at(2), support::HeapFields::value(2.0, 0));
  ASSERT_TRUE(run.describe("mass_stored"));
  EXPECT_EQ(run.describe("mass_stored")->unit, "kg");
  EXPECT_FALSE(run.describe("no_such_thing"));
  EXPECT_THROW((void)run.values("no_such_thing"), core::OutputError);
}

TEST(RunReader, RefusesWhatIsNoRun) {
  const TemporaryFolder folder;
  EXPECT_THROW(output::RunReader(folder / "run.nc"), core::OutputError);
  std::ofstream(folder / "run.nc") << "not netCDF";
  EXPECT_THROW(output::RunReader(folder / "run.nc"), core::OutputError);
}

TEST(CsvLine, QuotesWhatNeedsQuotes) {
  EXPECT_EQ(output::csv_line(std::vector<std::string>{"a", "", "b c", "d,e", "f \"g\"", "h\ni"}),
            "a,,b c,\"d,e\",\"f \"\"g\"\"\",\"h\ni\"\n");
}
}  // namespace
