#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "support/reference.hpp"

/// `talus rheology` against independent values, and what it says to bad input.
namespace {
using nlohmann::json;
using talus::support::contents;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::TemporaryFolder;

const std::string heap = TALUS_SOURCE_DIR "/runs/examples/heap_q46.toml";

const json& reference_laws() {
  static const json all = talus::support::reference("rheology.json").at("laws");
  return all;
}

Outcome rheology(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "rheology");
  return outcome_of(TALUS_PROGRAM, std::move(arguments));
}

std::string number(const json& value) { return value.dump(); }

/// The options that turn the heap's material into that of a reference law.
std::vector<std::string> material(const json& parameters) {
  std::vector<std::string> options{heap};
  for (const auto& [key, section] :
       {std::pair{"mu_s", "rheology"}, std::pair{"mu_d", "rheology"}, std::pair{"mu_inf", "rheology"},
        std::pair{"I_0", "rheology"}, std::pair{"I_N", "rheology"}, std::pair{"alpha", "rheology"},
        std::pair{"Phi", "grains"}, std::pair{"d", "grains"}})
    options.insert(options.end(), {"--set", std::string(section) + "." + key + "=" + number(parameters.at(key))});
  return options;
}

double off(const json& value, const json& reference) {
  return std::abs(value.get<double>() / reference.get<double>() - 1.0);
}

TEST(RheologyCommand, JsonEqualsTheReference) {
  int compared = 0;
  for (const auto& law : reference_laws()) {
    std::string list;
    for (const auto& row : law["curves"]) list += (list.empty() ? "" : ",") + number(row["I"]);
    auto options = material(law["parameters"]);
    options.insert(options.end(), {"--law", "classical,partially_regularised", "--I", list, "--json"});
    const Outcome outcome = rheology(options);
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    const json laws = json::parse(outcome.output).at("laws");
    ASSERT_EQ(laws.size(), 2U);
    for (std::size_t i = 0; i < law["curves"].size(); ++i) {
      const auto& row = law["curves"][i];
      for (const auto& [which, suffix] : {std::pair{0, "_c"}, std::pair{1, "_p"}}) {
        const auto at = [&](const char* name) { return laws[which]["points"][name]["values"][i]; };
        EXPECT_LT(off(at("mu"), row["mu" + std::string(suffix)]), 1e-12);
        EXPECT_LT(off(at("dmu_dI"), row["dmu" + std::string(suffix)]), 1e-12);
        EXPECT_LT(off(at("nu"), row["nu" + std::string(suffix)]), 1e-12);
        EXPECT_LT(off(at("q"), row["q" + std::string(suffix)]), 1e-12);
        EXPECT_NEAR(at("C").get<double>(), row["C" + std::string(suffix)].get<double>(), 1e-12);
        ++compared;
      }
    }
    EXPECT_LT(off(laws[1]["A"], law["A"]), 1e-12);
    EXPECT_LT(off(laws[1]["mu_at_I_N"], law["mu_N"]), 1e-12);
    ASSERT_EQ(laws[0]["neutral_points"].size(), 2U);
    for (int i = 0; i < 2; ++i) EXPECT_LT(off(laws[0]["neutral_points"][i]["I"], law["neutral_classical"][i]), 1e-12);
    EXPECT_LT(off(laws[1]["well_posed_by_C"][0][1], law["neutral_partial"]), 1e-12);
    EXPECT_LT(off(laws[1]["well_posed_by_linear_theory"][0][1], law["ellipticity_bound"]), 1e-12);
    EXPECT_EQ(laws[1]["well_posed_by_C"][0][0], 0.0);
  }
  EXPECT_EQ(compared, 88);
}

/// What the command says of the reference's stability rows of one law, with k = 1/d.
void expect_growth(const json& law, const std::string& kind, int& compared) {
  std::vector<json> rows;
  std::string list;
  for (const auto& row : law["stability"]) {
    if (row["law"] != kind) continue;
    list += (list.empty() ? "" : ",") + number(row["I"]);
    rows.push_back(row);
  }
  auto options = material(law["parameters"]);
  options.insert(options.end(), {"--I", list, "--k", number(1.0 / law["parameters"]["d"].get<double>()), "--json",
                                 "--law", kind == "partial" ? "partially_regularised" : "classical"});
  const Outcome outcome = rheology(options);
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const json points = json::parse(outcome.output).at("laws")[0].at("points");
  json growth_at_k;
  for (const auto& [name, column] : points.items())
    if (name.starts_with("growth_k")) growth_at_k = column["values"];
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto at = [&](const char* name) { return points[name]["values"][i]; };
    EXPECT_EQ(at("state") == "ill_posed", rows[i]["ill_posed"].get<bool>()) << rows[i]["I"];
    ++compared;
    if (rows[i]["max_growth"].is_null()) {
      EXPECT_TRUE(at("growth_max").is_null());
      EXPECT_TRUE(growth_at_k[i].is_null());
      continue;
    }
    EXPECT_NEAR(at("growth_max").get<double>(), rows[i]["max_growth"].get<double>(), 1e-12);
    EXPECT_NEAR(growth_at_k[i].get<double>(), rows[i]["sigma_max_over_gamma_per_kd2"].get<double>(),
                1e-12 * at("scale").get<double>());
    EXPECT_NEAR(at("worst_angle_deg").get<double>(), rows[i]["worst_angle_deg"].get<double>(), 1e-10);
  }
}

TEST(RheologyCommand, GrowthEqualsTheReference) {
  int compared = 0;
  for (const auto& law : reference_laws())
    for (const char* kind : {"classical", "partial"}) expect_growth(law, kind, compared);
  EXPECT_GT(compared, 20);
}

TEST(RheologyCommand, CsvHoldsTheTableOfEachLaw) {
  const TemporaryFolder folder;
  const std::string file = (folder / "curve.csv").string();
  const Outcome outcome = rheology({heap, "--law", "classical,constant", "--I", "0,0.3", "--csv", file});
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("0.05178183006 to 2.995711728"), std::string::npos) << outcome.output;
  std::istringstream lines(contents(file));
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_TRUE(rows[0].starts_with("law,I,mu,dmu_dI,I_of_mu,nu,q,C,state,")) << rows[0];
  EXPECT_TRUE(rows[1].starts_with("classical,0,0.4,0.384")) << rows[1];
  EXPECT_TRUE(rows[2].starts_with("classical,0.3,0.49375,")) << rows[2];
  EXPECT_TRUE(rows[3].starts_with("constant,0,0.4,0,,0,0.4,")) << rows[3];  // no I for its mu
  EXPECT_TRUE(rows[4].starts_with("constant,0.3,0.4,0,,0,0.4,")) << rows[4];
}

TEST(RheologyCommand, AFrictionWithoutInertialNumberIsALineWithItsReason) {
  const Outcome outcome = rheology({heap, "--law", "classical", "--mu", "0.5,0.95", "--json"});
  EXPECT_EQ(outcome.code, 0);
  const json law = json::parse(outcome.output).at("laws")[0];
  EXPECT_NEAR(law["points"]["I"]["values"][0].get<double>(), 0.325, 1e-15);
  EXPECT_TRUE(law["points"]["I"]["values"][1].is_null());
  EXPECT_EQ(law["notes"][0],
            "classical: no inertial number has the friction mu = 0.95 (needs mu_s = 0.4 <= mu < mu_d = 0.9)");
}

TEST(RheologyCommand, SlopesStandForFrictionsAndCarryBagnoldsFlow) {
  int compared = 0;
  const json cases = talus::support::reference("steady_uniform.json").at("cases");
  for (const auto& each : cases)
    for (const auto& row : each["bagnold"]) {
      auto options = material(each["parameters"]);
      options.insert(options.end(), {"--zeta", number(row["zeta_deg"]), "--thickness", number(row["h"]), "--json",
                                     "--set", "box.gravity=" + number(each["parameters"]["g"])});
      const Outcome outcome = rheology(options);
      ASSERT_EQ(outcome.code, 0) << outcome.output;
      const json points = json::parse(outcome.output).at("laws")[0].at("points");
      const auto at = [&](const char* name) { return points[name]["values"][0]; };
      EXPECT_LT(off(at("I"), row["partial"]["I"]), 1e-12);
      EXPECT_LT(off(at("bagnold_surface_m_s"), row["partial"]["u_surf"]), 1e-12);
      const double rho = each["parameters"]["rho_star"].get<double>() * each["parameters"]["Phi"].get<double>();
      EXPECT_LT(off(at("bagnold_flux_kg_m_s"), rho * row["partial"]["q_m2_s"].get<double>()), 1e-12);
      if (++compared == 4) return;
    }
}

TEST(RheologyCommand, BadInputIsRefusedWithCodeTwo) {
  const auto refusal = [](std::vector<std::string> options) {
    const Outcome outcome = rheology(std::move(options));
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    return outcome.output;
  };
  EXPECT_EQ(refusal({heap, "--I", "0.1", "--mu", "0.4"}), "talus: --I, --mu, --zeta: expected one of them\n");
  EXPECT_EQ(refusal({heap, "--I", "0.1,-2"}), "talus: --I: expected numbers of at least 0 [1], found -2\n");
  EXPECT_EQ(refusal({heap, "--k", "-1"}), "talus: --k: expected numbers of at least 0 [1/m], found -1\n");
  EXPECT_NE(refusal({heap, "--law", "classic"}).find("expected one of classical, partially_regularised, constant"),
            std::string::npos);
  EXPECT_NE(refusal({heap, "--set", "rheology.mu_d=0.3"}).find("must be at least mu_s = 0.4, or friction would fall"),
            std::string::npos);
  EXPECT_NE(refusal({heap, "--csv", "x.csv"}).find("--csv: expected --I, --mu or --zeta"), std::string::npos);
  EXPECT_NE(refusal({"no_such_file.toml"}).find("no_such_file.toml"), std::string::npos);
  EXPECT_EQ(refusal({heap, "--zeta", "30,90"}),
            "talus: --zeta: expected angles above 0 and below 90 [degree], found 90\n");
  EXPECT_EQ(refusal({heap, "--thickness", "0.01"}), "talus: --thickness: expected --zeta as well\n");
  EXPECT_EQ(refusal({heap, "--zeta", "30", "--thickness", "-1"}),
            "talus: --thickness: expected a number above 0 [m], found -1\n");
  refusal({});
}
}  // namespace
