#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "support/nc_reader.hpp"
#include "support/small_runs.hpp"

/// What accuracy costs, on a layer that starts: thirty runs of a hundredth of a second.
namespace {
using namespace talus::support;
using Rows = std::map<std::string, std::map<std::string, std::string>>;  ///< of "group choice", by column

const std::string scene = TALUS_SOURCE_DIR "/runs/examples/column_start.toml";

Words trade(const std::filesystem::path& out, const Words& more = {}) {
  return with_settings({"study", "trade", scene, "--out", out.string(), "--jobs", "2"}, [&] {
    Words settings{
        "grid.layers=32",          "time.end=0.2",        "schedule.times=[0,1]",      "schedule.tilt=[45,45]",
        "output.times=[0.05,0.1]", "output.interval=0.1", "output.series_interval=0.1"};
    settings.insert(settings.end(), more.begin(), more.end());
    return settings;
  }());
}

/// Precondition: no field holds a comma within quotes, as all but reasons and words of a grid with its rtol.
Rows rows_of(const std::filesystem::path& csv) {
  std::istringstream in(contents(csv));
  const auto fields = [](const std::string& line) {
    std::vector<std::string> out(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      else if (c == ',' && !quoted) out.emplace_back();
      else out.back() += c;
    }
    return out;
  };
  std::string line;
  std::getline(in, line);
  const auto names = fields(line);
  Rows rows;
  while (std::getline(in, line)) {
    const auto values = fields(line);
    auto& row = rows[values[0] + " " + values[1]];
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values.at(i);
  }
  return rows;
}

double number(const Rows& rows, const std::string& row, const std::string& column) {
  return std::stod(rows.at(row).at(column));
}

/// Of the mass flow, over the recorded times and the end, from what the runs left.
double largest_difference(const std::filesystem::path& run, const std::filesystem::path& other) {
  const auto a = summary_in(run), b = summary_in(other);
  double worst = std::abs(a.at("final").at("mass_flow").get<double>() - b.at("final").at("mass_flow").get<double>());
  for (std::size_t i = 0; i < a.at("records").size(); ++i) {
    const auto &here = a.at("records")[i], &there = b.at("records").at(i);
    EXPECT_EQ(here.at("time"), there.at("time"));
    worst = std::max(worst, std::abs(here.at("mass_flow").get<double>() - there.at("mass_flow").get<double>()));
  }
  return worst;
}

TEST(CliStudyTrade, ErrorsFallAsTheGridDoesAndWhatAChoiceCostsIsTold) {
  const TemporaryFolder folder;
  const auto outcome = run_talus(trade(folder / "study"));
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_TRUE(says(outcome, "Errors are those of mass_flow [kg s-1]")) << outcome.output;
  EXPECT_TRUE(says(outcome, "For 1 % in mass_flow: ")) << outcome.output;
  const auto rows = rows_of(folder / "study" / "trade.csv");
  ASSERT_TRUE(rows.contains("scene as it stands") && rows.contains("reference cells halved, rtol a tenth"));
  const std::string error = "error_mass_flow [kg s-1]";
  const double own = number(rows, "scene as it stands", error), half = number(rows, "grid 16", error),
               quarter = number(rows, "grid 8", error);
  // of second order at least, against a reference of half the cells: (4 - 1/4)/(1 - 1/4) and (16 - 1/4)/(4 - 1/4)
  EXPECT_GT(half / own, 4.5);
  EXPECT_GT(quarter / half, 3.8);
  EXPECT_EQ(own, largest_difference(folder / "study" / "members" / "0000", folder / "study" / "members" / "0001"));
  EXPECT_EQ(rows.at("reference cells halved, rtol a tenth").at(error), "");
  EXPECT_LT(number(rows, "rtol 0.01", "n_steps"), number(rows, "scene as it stands", "n_steps"));
  EXPECT_GT(number(rows, "max_order 1", "n_steps"), number(rows, "scene as it stands", "n_steps"));
  for (const auto& [name, row] : rows) EXPECT_EQ(row.at("status"), "finished") << name;
  // the same from netCDF
  const NcReader nc(folder / "study" / "study.nc");
  const auto errors = nc.values("error_mass_flow");
  ASSERT_EQ(errors.size(), rows.size());
  EXPECT_EQ(errors[0], own);
  EXPECT_TRUE(std::isnan(errors[1]));
  EXPECT_TRUE(std::filesystem::file_size(folder / "study" / "study.png") > 10'000);
  const auto verdict = nlohmann::json::parse(contents(folder / "study" / "verdict.json"));
  EXPECT_EQ(verdict.at("judge"), "mass_flow");
  EXPECT_GT(verdict.at("front").size(), 1U);
  // once more: nothing is run again
  const auto again = run_talus(trade(folder / "study"));
  EXPECT_TRUE(says(again, "(" + std::to_string(rows.size()) + " of them before)")) << again.output;
}

TEST(CliStudyTrade, WithoutItsReferenceThereIsNoAnswer) {
  const TemporaryFolder folder;
  // far below round-off: neither the scene nor its reference comes to its end
  const auto outcome = run_talus(trade(folder / "study", {"integrator.atol_velocity=1e-30", "integrator.rtol=1e-15"}));
  EXPECT_EQ(outcome.code, 2) << outcome.output;
  EXPECT_TRUE(says(outcome, "the reference did not finish")) << outcome.output;
}

TEST(CliStudyTrade, AnUnknownNumberIsRefusedWithTheNearest) {
  const TemporaryFolder folder;
  auto words = trade(folder / "study");
  words.insert(words.end(), {"--by", "mass_flaw"});
  const auto outcome = run_talus(words);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(says(outcome, "did you mean mass_flow?")) << outcome.output;
}
}  // namespace
