#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "output/table_file.hpp"
#include "support/program.hpp"

/// `talus fit`: from a fit file and its data to answers, files and a page; and what it says of bad input.
namespace {
using nlohmann::json;
using talus::support::contents;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::TemporaryFolder;

const std::string material = TALUS_SOURCE_DIR "/runs/paper/table_2.toml";
const std::string study = TALUS_SOURCE_DIR "/runs/studies/fit/table_2_slopes.toml";

/// A fit file of mu_w with data of one's own, in a folder of its own.
class FitCommand : public testing::Test {
 protected:
  Outcome fit(const std::string& rest, std::vector<std::string> options = {}) {
    std::ofstream(folder_ / "fit.toml") << "[fit]\nname = \"f\"\nmaterial = \"" << material << "\"\n" << rest;
    options.insert(options.begin(), {"fit", (folder_ / "fit.toml").string(), "--out", (folder_ / "out").string()});
    return outcome_of(TALUS_PROGRAM, std::move(options));
  }
  void data(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  void refused(const std::string& rest, const std::vector<std::string>& words) {
    const Outcome outcome = fit(rest);
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    for (const auto& each : words)
      EXPECT_NE(outcome.output.find(each), std::string::npos) << each << "\n" << outcome.output;
  }
  TemporaryFolder folder_;
};

const std::string mu_w = "[[unknown]]\nparameter = \"mu_w\"\nlow = 0.2\nhigh = 0.5\n";
const std::string slopes = "[[slopes]]\nfile = \"s.csv\"\n", profile = "[[profile]]\nfile = \"p.csv\"\nflow = 0.0046\n";
const std::string slope_header = "Q_kg_s,Q_error_kg_s,zeta_deg,zeta_error_deg\n",
                  profile_header = "depth_m,speed_m_s,speed_error_m_s\n";

TEST_F(FitCommand, StudyOfTable2SaysWhatItsSlopesDoNotFix) {
  const std::string out = (folder_ / "out").string();
  const Outcome outcome = outcome_of(TALUS_PROGRAM, {"fit", study, "--json", "--out", out});
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const json answer = json::parse(outcome.output);
  EXPECT_EQ(answer, json::parse(contents(folder_ / "out" / "fit.json")));
  EXPECT_EQ(answer["freedom"], 2);
  EXPECT_EQ(answer["unknown"]["name"]["values"], json({"mu_w", "W", "d"}));
  EXPECT_EQ(answer["unknown"]["error"]["values"], json({nullptr, nullptr, nullptr}));
  EXPECT_EQ(answer["covariance"][1][1], nullptr);
  EXPECT_EQ(answer["lump"]["name"]["values"], json({"flux factor K"}));
  const double printed = 2500.0 * 0.6 * 0.003 * std::sqrt(0.6 * 9.81) / 0.00073 * std::pow(0.003 / 0.3727, 2.5);
  EXPECT_NEAR(answer["lump"]["value"]["values"][0].get<double>() / printed, 1.144, 0.001);
  EXPECT_EQ(answer["direction"]["seen"]["values"], json({"yes", "no", "no"}));
  EXPECT_EQ(answer["prediction"]["Q_kg_s"]["values"], json({0.0033}));
  const Outcome page = outcome_of(TALUS_PROGRAM, {"plot", out});
  EXPECT_EQ(page.code, 0) << page.output;
  EXPECT_GT(std::filesystem::file_size(folder_ / "out" / "fit.png"), 20000U);
}

TEST_F(FitCommand, ExactSlopesAndSpeedsGiveTheParameterBack) {
  data("s.csv", slope_header + "0.002,0,44.0963873575666,0.1\n0.006,0,50.4151895425335,0.1\n");
  const Outcome outcome = fit(mu_w + "start = 0.45\n" + slopes, {"--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_NEAR(json::parse(outcome.output)["unknown"]["value"]["values"][0].get<double>(), 0.3727, 1e-7);
}

TEST_F(FitCommand, AClassicalLawIsRejectedWithTheFlowThatItCannotCarry) {
  data("s.csv", slope_header + "0.002,0,41.63,0.5\n0.006,0,49.80,0.5\n");
  const std::string classical = "set = [\"rheology.law=classical\"]\n";
  const Outcome outcome = fit(classical + "[[unknown]]\nparameter = \"mu_s\"\nlow = 0.35\nhigh = 0.5\n" + slopes);
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("No fit: the data reject the classical law"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("s.csv row 2: no steady state: the flux 0.006 kg/s exceeds the largest flux"),
            std::string::npos)
      << outcome.output;
  EXPECT_EQ(json::parse(contents(folder_ / "out" / "fit.json"))["exists"], false);
}

TEST_F(FitCommand, AnOutlierIsNamed) {
  data("s.csv", slope_header + "0.002,0,44.0964,0.1\n0.0046,0,51,0.1\n0.006,0,50.4152,0.1\n");
  const Outcome outcome = fit("loss = \"cauchy\"\n" + mu_w + slopes);
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  const auto row = outcome.output.find("s.csv row 2");
  ASSERT_NE(row, std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.substr(row, 200).find("outlier"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("does not fit within the errors stated"), std::string::npos) << outcome.output;
}

TEST_F(FitCommand, BadDataAreRefusedWithTheirPlace) {
  data("s.csv", "");
  refused(mu_w + slopes, {"s.csv: has no header"});
  data("s.csv", slope_header);
  refused(mu_w + slopes, {"fit.toml:9:1: slopes.file", "s.csv: expected at least 1 rows of data, found 0"});
  data("s.csv", "Q_g_s,Q_error_kg_s,zeta_deg,zeta_error_deg\n2,0,44,0.1\n");
  refused(mu_w + slopes, {"s.csv:1: Q_kg_s: missing column", "Q_g_s: unknown column (did you mean Q_kg_s?)"});
  data("s.csv", slope_header + "0.002,0,44,0\n0.002,-1,440,0.1\n");
  refused(mu_w + slopes, {"s.csv:2: zeta_error_deg: expected a number above 0", "found '0'",
                          "s.csv:3: Q_error_kg_s: expected a number at least 0", "found '-1'",
                          "s.csv:3: zeta_deg: expected a number above 0 and below 90 [degree], found '440'"});
  data("p.csv", profile_header + "0.001,0.2,0.01\n0.002,0.1,0.01\n");
  refused(mu_w + profile, {"profile.file", "p.csv: expected at least 3 rows of data, found 2"});
  data("p.csv", "depth_mm,speed_m_s,speed_error_m_s\n1,0.2,0.01\n");
  refused(mu_w + profile, {"p.csv:1: depth_m: missing column; expected a number [m]", "depth_mm: unknown column"});
  refused(mu_w + "[[slopes]]\nfile = \"nowhere.csv\"\n", {"nowhere.csv: cannot be read"});
}

/// Columns of a netCDF file along one dimension.
talus::output::Table columns(const std::vector<std::pair<std::string, std::string>>& names_and_units,
                             const std::vector<std::vector<double>>& values) {
  talus::output::Table table;
  table.dimensions = {{"point", values.front().size()}};
  for (std::size_t i = 0; i < values.size(); ++i)
    table.variables.push_back({names_and_units[i].first, {"point"}, names_and_units[i].second, "", values[i]});
  return table;
}

TEST_F(FitCommand, AProfileInNetCdfSaysWhatItsCsvSays) {
  const std::vector<std::vector<double>> values{
      {0.001, 0.002, 0.003, 0.004}, {0.2, 0.15, 0.1, 0.07}, {0.01, 0.01, 0.01, 0.01}};
  std::string csv = profile_header;
  for (std::size_t i = 0; i < 4; ++i)
    csv +=
        std::to_string(values[0][i]) + "," + std::to_string(values[1][i]) + "," + std::to_string(values[2][i]) + "\n";
  data("p.csv", csv);
  ASSERT_EQ(fit(mu_w + profile).code, 0);
  const json by_csv = json::parse(contents(folder_ / "out" / "fit.json"));
  write_table(folder_ / "p.nc", columns({{"z", "m"}, {"u", "m s-1"}, {"speed_error", "m/s"}}, values));
  const std::string named = "[[profile]]\nfile = \"p.nc\"\nflow = 0.0046\ndepth = \"z\"\nspeed = \"u\"\n";
  const Outcome outcome = fit(mu_w + named);
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const json by_netcdf = json::parse(contents(folder_ / "out" / "fit.json"));
  EXPECT_EQ(by_netcdf["unknown"], by_csv["unknown"]);
  EXPECT_EQ(by_netcdf["chi2"], by_csv["chi2"]);
}

TEST_F(FitCommand, BadNetCdfProfilesAreRefusedWithTheirVariable) {
  const std::string plain = "[[profile]]\nfile = \"p.nc\"\nflow = 0.0046\n";
  const std::vector<std::vector<double>> good{{0.001, 0.002, 0.003}, {0.2, 0.15, 0.1}, {0.01, 0.01, 0.01}};
  const auto write = [&](const std::vector<std::pair<std::string, std::string>>& names,
                         const std::vector<std::vector<double>>& values) {
    write_table(folder_ / "p.nc", columns(names, values));
  };
  refused(mu_w + plain, {"p.nc: cannot be read as netCDF"});
  data("p.nc", "");
  refused(mu_w + plain, {"p.nc: cannot be read as netCDF"});
  write({{"depths", "m"}, {"speed", "m/s"}, {"speed_error", "m/s"}}, good);
  refused(mu_w + plain, {"p.nc: depth: no such variable (did you mean depths?); expected a number [m]"});
  write({{"depth", "mm"}, {"speed", "m/s"}, {"speed_error", "m/s"}}, good);
  refused(mu_w + plain, {"p.nc: depth: expected the attribute units = \"m\", found \"mm\""});
  write({{"depth", "m"}, {"speed", "m/s"}, {"speed_error", "m/s"}}, {good[0], good[1], {0.01, 0.0, 0.01}});
  refused(mu_w + plain, {"p.nc: speed_error[1]: expected a number above 0 [m/s], found 0"});
  write({{"depth", "m"}, {"speed", "m/s"}, {"speed_error", "m/s"}}, {good[0], {0.2, std::nan(""), 0.1}, good[2]});
  refused(mu_w + plain, {"p.nc: speed[1]: expected a number [m/s], found nan"});
  write({{"depth", "m"}, {"speed", "m/s"}, {"speed_error", "m/s"}}, {{0.001, 0.002}, {0.2, 0.1}, {0.01, 0.01}});
  refused(mu_w + plain, {"profile.file", "p.nc: expected at least 3 rows of data, found 2"});
  data("p.csv", profile_header + "0.001,0.2,0.01\n0.002,0.1,0.01\n0.003,0.1,0.01\n");
  refused(mu_w + profile + "depth = \"z\"\n", {"profile.depth: is for netCDF files (.nc)"});
}

TEST_F(FitCommand, BadFitFilesAreRefusedWithTheirKey) {
  data("s.csv", slope_header + "0.002,0,44,0.1\n");
  data("p.csv", profile_header + "0.001,0.2,0.01\n0.002,0.1,0.01\n0.003,0.1,0.01\n");
  const auto unknown = [](const std::string& lines) { return "[[unknown]]\nparameter = " + lines; };
  refused(slopes, {"missing; expected [[unknown]], at least one"});
  refused(mu_w, {"no data to fit; expected [[slopes]] or [[profile]]"});
  refused(unknown("\"mu_x\"\nlow = 1.0\nhigh = 2.0\n") + slopes, {"unknown.parameter", "mu_w"});
  refused(unknown("\"mu_w\"\nlow = 0.5\nhigh = 0.4\n") + slopes,
          {"unknown.high: mu_w: expected above unknown.low = 0.5"});
  refused(unknown("\"mu_w\"\nlow = 0.5\nhigh = 0.6\n") + slopes,
          {"unknown.low: mu_w: the start 0.3727, the material's, is not between 0.5 and 0.6"});
  refused(mu_w + "prior = 0.3\n" + slopes, {"expected unknown.prior and unknown.prior_error together"});
  refused(mu_w + mu_w + slopes, {"mu_w: is unknown twice"});
  refused("set = [\"rheology.law=classical\"]\n" + unknown("\"alpha\"\nlow = 1.0\nhigh = 2.0\n") + slopes,
          {"alpha: the classical law has no such parameter"});
  refused("set = [\"rheology.law=constant\"]\n" + mu_w + slopes, {"constant friction selects no speed"});
  refused("set = [\"wall.mu_w=0\"]\n" + unknown("\"I_0\"\nlow = 1.0\nhigh = 2.0\n") + slopes,
          {"wall.mu_w: expected above 0"});
  refused(mu_w + "[[profile]]\nfile = \"p.csv\"\n", {"expected one of profile.flow [kg/s] and profile.slope [degree]"});
}
}  // namespace
