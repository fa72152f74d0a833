#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/nc_reader.hpp"
#include "support/program.hpp"
#include "support/reference.hpp"

/// `talus steady` as its users call it.
namespace {
using nlohmann::json;
using talus::support::Outcome;
using talus::support::outcome_of;

const std::string q46 = TALUS_SOURCE_DIR "/runs/examples/heap_q46.toml";

Outcome steady(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "steady");
  return outcome_of(TALUS_PROGRAM, std::move(arguments));
}

bool says(const Outcome& outcome, const std::string& words) { return outcome.output.find(words) != std::string::npos; }

double off(const json& value, const json& reference) {
  return std::abs(value.get<double>() / reference.get<double>() - 1.0);
}

/// The parameters of a reference case, and nothing else, as a material file's text.
std::string material(const json& p) {
  const auto line = [&](const char* key, const char* name) {
    return std::string(key) + " = " + p.at(name).dump() + "\n";
  };
  return "[box]\n" + line("gap", "W") + line("gravity", "g") + "[grains]\n" + line("rho_star", "rho_star") +
         line("Phi", "Phi") + line("d", "d") + "[wall]\n" + line("mu_w", "mu_w") +
         "[rheology]\nlaw = \"partially_regularised\"\n" + line("mu_s", "mu_s") + line("mu_d", "mu_d") +
         line("mu_inf", "mu_inf") + line("I_0", "I_0") + line("I_N", "I_N") + line("alpha", "alpha");
}

TEST(CliSteady, JsonEqualsTheReferenceForEveryParameterSetAndBothLaws) {
  const talus::support::TemporaryFolder folder;
  int compared = 0;
  const json reference = talus::support::reference("steady_uniform.json");
  for (const auto& each : reference.at("cases")) {
    const auto file = folder / "material.toml";
    std::ofstream(file) << material(each["parameters"]);
    std::string angles;
    for (const auto& row : each["flows"]) angles += (angles.empty() ? "" : ",") + row["zeta_deg"].dump();
    for (const std::string law : {"partial", "classical"}) {
      const Outcome outcome = steady({file.string(), "--zeta", angles, "--law", law, "--json"});
      ASSERT_EQ(outcome.code, 0) << outcome.output;
      const json out = json::parse(outcome.output);
      EXPECT_EQ(out["law"], law == "partial" ? "partially_regularised" : law);
      EXPECT_LT(off(out["Q_max_classical_kg_s"], each["Q_max_classical"]), 1e-12);
      for (std::size_t i = 0; i < each["flows"].size(); ++i) {
        const auto& exact = each["flows"][i][law];
        const auto& found = out["cases"][i];
        ASSERT_EQ(found["exists"], exact.is_object()) << found;
        if (exact.is_null()) {
          EXPECT_TRUE(found["reason"].is_string());
          continue;
        }
        EXPECT_LT(off(found["z_st_m"], exact["z_st"]), 1e-10);
        EXPECT_LT(off(found["surface_inertial_number"], exact["I_surf"]), 1e-10);
        EXPECT_LT(off(found["surface_speed_m_s"], exact["u_surf"]), 1e-10);
        EXPECT_LT(off(found["Q_kg_s"], exact["Q_kg_s"]), 1e-10);
        EXPECT_LT(off(found["volume_flux_m2_s"], exact["vol_flux_per_width_m2_s"]), 1e-10);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 40);
}

TEST(CliSteady, AFlowAboveTheLargestIsAnAnswerNotAnError) {
  const Outcome outcome = steady({q46, "--Q", "0.002,0.0046", "--law", "classical", "--json"});
  EXPECT_EQ(outcome.code, 0);
  const json out = json::parse(outcome.output);
  EXPECT_LT(off(out["cases"][0]["zeta_deg"], 39.4734395735856), 1e-12);
  EXPECT_FALSE(out["cases"][1]["exists"].get<bool>());
  EXPECT_NE(out["cases"][1]["reason"].get<std::string>().find("exceeds the largest flux, 0.00459326"),
            std::string::npos);
}

TEST(CliSteady, SlopesFluxesAndSpeedsLeadBackToOneAnother) {
  const json by_zeta = json::parse(steady({q46, "--zeta", "45", "--json"}).output)["cases"][0];
  for (const auto& [option, key] :
       {std::pair{"--Q", "Q_kg_s"}, {"--depth-averaged-speed", "depth_averaged_speed_m_s"}}) {
    const json back = json::parse(steady({q46, option, by_zeta[key].dump(), "--json"}).output)["cases"][0];
    EXPECT_LT(off(back["zeta_deg"], 45.0), 1e-12) << option;
    EXPECT_LT(off(back[key], by_zeta[key]), 1e-12) << option;
  }
}

TEST(CliSteady, JsonTellsWhereInItsDepthAFlowIsIllPosed) {
  const json steep = json::parse(steady({q46, "--zeta", "40", "--law", "classical", "--json"}).output);
  EXPECT_EQ(steep["neutral_points_I"].size(), 2U);
  const json& flow = steep["cases"][0];
  EXPECT_EQ(flow["C_inside_at_surface"], false);
  EXPECT_EQ(flow["C_inside_everywhere"], false);
  ASSERT_EQ(flow["C_positive_depths_m"].size(), 2U);
  EXPECT_EQ(flow["C_positive_below_m"], flow["C_positive_depths_m"][1][0]);
  EXPECT_LT(flow["C_margin_in_I"], 0.0);
  EXPECT_EQ(flow["q_inside_everywhere"], true);
  const json gentle = json::parse(steady({q46, "--zeta", "30", "--law", "classical", "--json"}).output)["cases"][0];
  EXPECT_EQ(gentle["C_inside_at_surface"], true);
  EXPECT_EQ(gentle["C_inside_everywhere"], false);
  const json regular = json::parse(steady({q46, "--zeta", "45", "--json"}).output)["cases"][0];
  EXPECT_EQ(regular["C_inside_everywhere"], true);
  EXPECT_TRUE(regular["C_positive_below_m"].is_null());
}

TEST(CliSteady, TheTableShowsWhatExistsAndSaysWhatDoesNot) {
  const Outcome outcome = steady({q46, "--zeta", "20,40,45", "--law", "classical"});
  EXPECT_EQ(outcome.code, 0);
  for (const char* words : {"zeta_deg", "Q_kg_s", "0.00235206", "0.7278 to 3.38", "zeta = 20 degrees: at rest",
                            "zeta = 45 degrees: no steady state", "below 41.9872 degrees", "Q_max = 0.00459327 kg/s"})
    EXPECT_TRUE(says(outcome, words)) << words << "\n" << outcome.output;
  const Outcome profile = steady({q46, "--zeta", "45", "--points", "3"});
  EXPECT_TRUE(says(profile, "depth_m")) << profile.output;
}

TEST(CliSteady, TheFileHoldsTheProfilesOfJson) {
  const talus::support::TemporaryFolder folder;
  const auto path = folder / "steady.nc";
  const Outcome outcome =
      steady({q46, "--zeta", "40,43", "--law", "classical", "--points", "21", "--json", "--out", path.string()});
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const json out = json::parse(outcome.output);
  const talus::support::NcReader file(path);
  EXPECT_EQ(file.dimensions("speed"), (std::vector<std::string>{"case", "point"}));
  EXPECT_EQ(file.length("case"), 2U);
  EXPECT_EQ(file.length("point"), 21U);
  EXPECT_EQ(file.text("speed", "units"), "m s-1");
  EXPECT_EQ(file.text("depth", "positive"), "down");
  EXPECT_EQ(file.number("", "mu_w"), 0.3727);
  EXPECT_EQ(file.text("", "law"), "classical");
  EXPECT_NE(file.text("", "history").find("steady"), std::string::npos);
  const auto& profile = out["cases"][0]["profile"];
  for (const auto& [name, key] : {std::pair{"depth", "depth_m"},
                                  {"speed", "speed_m_s"},
                                  {"friction", "friction"},
                                  {"inertial_number", "inertial_number"},
                                  {"C", "C"},
                                  {"q", "q"}}) {
    const auto values = file.values(name);
    for (std::size_t i = 0; i < 21; ++i) EXPECT_EQ(values[i], profile[key][i].get<double>()) << name << i;
    EXPECT_TRUE(std::isnan(values[21])) << name;
  }
  EXPECT_EQ(file.values("Q")[0], out["cases"][0]["Q_kg_s"].get<double>());
  EXPECT_EQ(file.texts("reason")[0], "");
  EXPECT_EQ(file.texts("reason")[1], out["cases"][1]["reason"]);
  EXPECT_EQ(steady({q46, "--zeta", "40", "--out", (folder / "nowhere/x.nc").string()}).code, 5);
}

TEST(CliSteady, NothingIsNotANumberAtTheEndsOfTheRange) {
  const std::vector<std::vector<std::string>> all{
      {"--zeta", "1e-20,1e-3,1,21.8014094863,41.98721249,41.98721250,60,89,89.999999,89.9999999999999"},
      {"--Q", "1e-300,1e-12:1e6:x10,1e250"},
      {"--depth-averaged-speed", "1e-300,1e-9:1e3:x7,1e250"},
      {"--zeta", "30,89", "--thickness", "1e-6"},
      {"--zeta", "30", "--set", "wall.mu_w=1e-300", "--thickness", "0.01"},
      {"--zeta", "30", "--set", "wall.mu_w=1e-300"},
      {"--Q", "1e-12,1e6", "--set", "box.gap=1e-6"},
      {"--Q", "1e-12,1e6", "--set", "box.gap=1e6"},
      {"--zeta", "30", "--set", "grains.d=1e-6", "--set", "box.gravity=1e-3"},
      {"--zeta", "45", "--set", "rheology.mu_inf=0"},
      {"--Q", "0.001,1", "--set", "rheology.mu_inf=0"}};
  for (const char* law : {"partial", "classical", "constant"})
    for (auto arguments : all) {
      arguments.insert(arguments.begin(), q46);
      arguments.insert(arguments.end(), {"--law", law, "--points", "11", "--json"});
      const Outcome outcome = steady(arguments);
      ASSERT_EQ(outcome.code, 0) << outcome.output;
      for (const auto& each : json::parse(outcome.output)["cases"]) {
        EXPECT_EQ(each["reason"].is_null(), each["exists"].get<bool>());
        if (!each["exists"]) continue;
        for (const char* key : {"zeta_deg", "Q_kg_s", "flowing_depth_m", "surface_speed_m_s", "surface_inertial_number",
                                "depth_50_percent_m", "depth_1_percent_m", "depth_averaged_speed_m_s", "froude_number",
                                "surface_C", "surface_q"})
          EXPECT_TRUE(each[key].is_number()) << key << each;
        for (const auto& values : each["profile"])
          for (const auto& value : values) EXPECT_TRUE(value.is_number()) << each["profile"];
      }
    }
}

TEST(CliSteady, BadInputIsRefused) {
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{q46},
                                             {q46, "--zeta", "30", "--Q", "0.001"},
                                             {q46, "--zeta", ""},
                                             {q46, "--zeta", "90"},
                                             {q46, "--zeta", "0"},
                                             {q46, "--Q", "-1"},
                                             {q46, "--Q", "1e-3", "--law", "linear"},
                                             {"no_such_file.toml", "--zeta", "30"},
                                             {q46, "--zeta", "30", "--thickness", "0"},
                                             {q46, "--zeta", "30", "--points", "1"},
                                             {q46, "--zeta", "30", "--set", "wall.mu_w=0"},
                                             {q46, "--zeta", "30", "--set", "rheology.mu_d=0.3"}})
    EXPECT_EQ(steady(arguments).code, 2) << steady(arguments).output;
  EXPECT_TRUE(says(steady({q46, "--zeta", ""}), "--zeta: expected finite numbers [degree], found ''"));
  EXPECT_TRUE(says(steady({q46, "--zeta", "90"}), "--zeta: 90 must be above 0 and below 90 degrees"));
}
}  // namespace
