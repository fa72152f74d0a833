#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.hpp"

/// `talus hstop`: to the law, back, and round the loop through its own CSV.
namespace {
using nlohmann::json;
using talus::support::contents;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::TemporaryFolder;

const std::string heap = TALUS_SOURCE_DIR "/runs/examples/heap_q46.toml";

Outcome hstop(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "hstop");
  return outcome_of(TALUS_PROGRAM, std::move(arguments));
}

TEST(HstopCommand, LawToDepositsToLawIsALoop) {
  const TemporaryFolder folder;
  const std::string file = (folder / "deposits.csv").string();
  const Outcome there = hstop({"--law", heap, "--beta", "0.136", "--zeta", "23:40:1", "--csv", file, "--json"});
  ASSERT_EQ(there.code, 0) << there.output;
  const json law = json::parse(there.output);
  EXPECT_NEAR(law["curve"]["L_m"].get<double>(), 2.5 * 0.136 * 0.00073 / (std::sqrt(0.6) * 1.3), 1e-18);
  const Outcome back = hstop({"--data", file, "--beta", "0.136", "--d", "0.00073", "--Phi", "0.6", "--json"});
  ASSERT_EQ(back.code, 0) << back.output;
  const json fit = json::parse(back.output);
  EXPECT_NEAR(fit["law"]["mu_s"].get<double>(), 0.4, 1e-10);
  EXPECT_NEAR(fit["law"]["mu_d"].get<double>(), 0.9, 1e-10);
  EXPECT_NEAR(fit["law"]["I_0"].get<double>(), 1.3, 1e-9);
  EXPECT_EQ(fit["fit"]["points"], 18);
  EXPECT_EQ(fit["points"]["residual_deg"]["values"].size(), 18U);
}

TEST(HstopCommand, AKnownCurveGivesTheLaw) {
  const Outcome outcome =
      hstop({"--curve", "0.38,0.64,8e-4", "--beta", "0.136", "--d", "5e-4", "--Phi", "0.6", "--zeta", "20,21,33"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.output.find("I_0    0.2743363204\n"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("20        -\n"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("33        0\n"), std::string::npos) << outcome.output;
}

TEST(HstopCommand, BadInputIsRefusedWithCodeTwo) {
  const TemporaryFolder folder;
  const std::string file = (folder / "deposits.csv").string();
  std::ofstream(file) << "zeta_deg,h_stop_m\n24,0.002\n24,0.003\n24,0.004\n24,0.005\n";
  const auto refusal = [](std::vector<std::string> options) {
    const Outcome outcome = hstop(std::move(options));
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    return outcome.output;
  };
  const auto says = [](const std::string& output, const std::string& words) {
    EXPECT_NE(output.find(words), std::string::npos) << output;
  };
  says(refusal({"--beta", "0.1"}), "expected one of --data, --curve and --law, found 0");
  says(refusal({"--law", heap}), "--beta is required");
  says(refusal({"--law", heap, "--curve", "0.3,0.6,1e-3", "--beta", "0.1"}), "found 2");
  says(refusal({"--law", heap, "--d", "1e-3", "--beta", "0.1"}), "--d, --Phi: not with --law");
  says(refusal({"--law", heap, "--beta", "-0.1"}), "beta = -0.1 must be from 1e-100 to 1e+100");
  says(refusal({"--curve", "0.3,0.6,1e-3", "--beta", "0.1"}), "--d, --Phi: expected");
  says(refusal({"--curve", "0.3,0.6", "--beta", "0.1", "--d", "1e-3", "--Phi", "0.6"}), "expected three numbers");
  says(refusal({"--curve", "0.6,0.3,1e-3", "--beta", "0.1", "--d", "1e-3", "--Phi", "0.6"}),
       "mu_d = 0.3 must be above mu_s = 0.6");
  says(refusal({"--curve", "0.3,0.6,1e-3", "--beta", "0.1", "--d", "1e-3", "--Phi", "1.6"}), "Phi = 1.6 must be");
  says(refusal({"--data", file, "--beta", "0.1", "--d", "1e-3", "--Phi", "0.6"}),
       "deposits.csv: h_stop data: all points lie at 1 angle(s); expected at least 3 different ones");
  says(refusal({"--law", heap, "--beta", "0.1", "--zeta", "20:100:20"}), "expected angles above 0 and below 90");
  says(refusal({"--law", heap, "--beta", "0.1", "--csv", file}), "--csv: expected --zeta as well");
}
}  // namespace
