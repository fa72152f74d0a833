#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "support/nc_reader.hpp"
#include "support/small_sweep.hpp"

/// talus collect on real runs.
namespace {
using talus::support::contents;
using talus::support::NcReader;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::SmallSweep;
using Names = std::vector<std::string>;

Outcome collect(const SmallSweep& sweep, const Names& series = {}) {
  Names arguments{"collect", sweep.folder().string()};
  for (const auto& name : series) arguments.insert(arguments.end(), {"--series", name});
  return outcome_of(TALUS_PROGRAM, arguments);
}

Names lines_of(const std::string& text) {
  std::istringstream in(text);
  Names lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

const std::string product =
    "[[axis]]\nkey = \"box.tilt\"\nvalues = [40, 45]\n"
    "[[axis]]\nkey = \"integrator.linear_solver\"\nvalues = [\"condensed\", \"klu\"]\n";

TEST(Collect, GivesAProductItsAxesAsDimensions) {
  const SmallSweep sweep(product);
  ASSERT_EQ(sweep.sweep().code, 0);
  ASSERT_EQ(collect(sweep, {"mass_stored", "mass_flow"}).code, 0);
  const NcReader file(sweep.folder() / "sweep.nc");
  const Names along{"box_tilt", "integrator_linear_solver"};
  EXPECT_EQ(file.dimensions("status"), along);
  EXPECT_EQ(file.values("box_tilt"), (std::vector<double>{40.0, 45.0}));
  EXPECT_EQ(file.text("box_tilt", "units"), "degree");
  EXPECT_EQ(file.text("box_tilt", "scene_key"), "box.tilt");
  EXPECT_EQ(file.type("integrator_linear_solver"), NC_STRING);
  EXPECT_EQ(file.values("member"), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(file.values("status"), (std::vector<double>(4, 4.0)));
  EXPECT_EQ(file.text("status", "flag_meanings"), "planned unfinished stopped failed finished");

  EXPECT_EQ(file.dimensions("final_mass_stored"), along);
  EXPECT_EQ(file.values("final_mass_stored").at(2), sweep.summary(2)["final"]["mass_stored"].get<double>());
  EXPECT_EQ(file.text("final_mass_stored", "units"), "kg");
  EXPECT_EQ(file.text("final_mass_stored", "long_name"), "mass in the box, film included");
  EXPECT_EQ(file.values("n_steps").at(3), sweep.summary(3)["statistics"]["steps"].get<double>());
  EXPECT_EQ(file.values("n_steps").at(0), sweep.summary(0)["statistics"]["steps"].get<double>());
  EXPECT_NE(file.values("final_mass_flow").at(0), file.values("final_mass_flow").at(2));
  EXPECT_EQ(file.text("wall_seconds", "units"), "s");

  EXPECT_EQ(file.dimensions("record_mass_stored"), (Names{along[0], along[1], "record_time"}));
  EXPECT_EQ(file.values("record_time"), std::vector<double>{0.01});
  EXPECT_EQ(file.dimensions("series_mass_stored"), (Names{along[0], along[1], "series_time"}));
  EXPECT_EQ(file.values("series_time"), (std::vector<double>{0.0, 0.01, 0.02}));
  const NcReader run(sweep.folder() / "members" / "0001" / "run.nc");
  EXPECT_EQ(file.values("series_mass_stored").at(5), run.values("mass_stored").at(2));

  const auto rows = lines_of(contents(sweep.folder() / "sweep.csv"));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0].substr(0, 75), "member,folder,box.tilt [degree],integrator.linear_solver,status,exit_code,f");
  EXPECT_EQ(rows[2].find("1,members/0001,40.0,klu,finished,0,"), 0U);
}

TEST(Collect, MarksWhatIsMissing) {
  const SmallSweep sweep(product);
  ASSERT_EQ(sweep.sweep({"--write", "gnu-parallel"}).code, 0);
  const std::string folder = sweep.folder().string();
  for (const char* member : {"0", "3"}) ASSERT_EQ(outcome_of(TALUS_PROGRAM, {"member", folder, member}).code, 0);
  const Outcome outcome = collect(sweep, {"mass_stored"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.output.find("4 members, 2 finished; results in "), 0U) << outcome.output;
  const NcReader file(sweep.folder() / "sweep.nc");
  EXPECT_EQ(file.values("status"), (std::vector<double>{4, 0, 0, 4}));
  EXPECT_EQ(file.values("exit_code"), (std::vector<double>{0, -1, -1, 0}));
  const auto mass = file.values("final_mass_stored"), course = file.values("series_mass_stored");
  for (const int member : {0, 3}) {
    EXPECT_GT(mass.at(member), 0.0);
    EXPECT_GT(course.at(3 * member + 1), 0.0);
  }
  for (const int member : {1, 2}) {
    EXPECT_TRUE(std::isnan(mass.at(member)));
    EXPECT_TRUE(std::isnan(course.at(3 * member + 1)));
  }
  const auto rows = lines_of(contents(sweep.folder() / "sweep.csv"));
  EXPECT_EQ(rows.at(2).find("1,members/0001,40.0,klu,planned,,,"), 0U) << rows.at(2);
}

TEST(Collect, PutsSamplesAlongMembersAndUnitesTimes) {
  const SmallSweep sweep(
      "[[axis]]\nkey = \"wall.mu_w\"\nfrom = 0.3\nto = 0.4\n"
      "[[axis]]\nkey = \"output.series_interval\"\nfrom = 0.003\nto = 0.009\n[sample]\nmembers = 3\nseed = 1\n");
  const Outcome outcome = sweep.sweep();
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  ASSERT_EQ(collect(sweep, {"n_steps"}).code, 0);
  const NcReader file(sweep.folder() / "sweep.nc");
  EXPECT_EQ(file.dimensions("wall_mu_w"), Names{"member"});
  EXPECT_EQ(file.dimensions("output_series_interval"), Names{"member"});
  const auto times = file.values("series_time"), steps = file.values("series_n_steps");
  EXPECT_TRUE(std::ranges::is_sorted(times));
  for (std::size_t member = 0; member < 3; ++member) {
    const NcReader run(sweep.folder() / "members" / ("000" + std::to_string(member)) / "run.nc");
    const auto own_times = run.values("series_time"), own_steps = run.values("n_steps");
    EXPECT_LT(own_times.size(), times.size());
    std::vector<double> here, at;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const double n = steps[member * times.size() + k];
      if (std::isnan(n)) continue;
      at.push_back(times[k]);
      here.push_back(n);
    }
    EXPECT_EQ(at, own_times);
    EXPECT_EQ(here, own_steps);
  }
}

TEST(Collect, NamesTheSeriesThereAre) {
  const SmallSweep sweep("[[axis]]\nkey = \"box.tilt\"\nvalues = [40]\n");
  ASSERT_EQ(sweep.sweep().code, 0);
  const Outcome outcome = collect(sweep, {"mass_stord"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(
      outcome.output.find("--series mass_stord: no member has it (did you mean mass_stored?); there are mass_stored, "),
      std::string::npos)
      << outcome.output;
  EXPECT_EQ(outcome_of(TALUS_PROGRAM, {"collect", "no_such_folder"}).code, 2);
}
}  // namespace
