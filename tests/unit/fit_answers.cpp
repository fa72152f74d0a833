#include <gtest/gtest.h>

#include <cmath>

#include "support/fit_problems.hpp"

/// What a fit says, and what it refuses to say.
namespace {
using namespace talus;
using P = steady::Parameter;
using support::Laboratory;
using support::table_2;
using support::unknown;

std::vector<fit::Unknown> factors() {
  return {unknown(P::rho_star, 2600.0, 2000.0, 3000.0), unknown(P::Phi, 0.58, 0.5, 0.65),
          unknown(P::d, 8e-4, 5e-4, 1e-3), unknown(P::W, 0.0031, 0.0028, 0.0033), unknown(P::mu_w, 0.36, 0.3, 0.45)};
}

fit::Problem slopes_only(steady::VariedChannel truth, std::vector<double> flows, unsigned seed = 0) {
  Laboratory laboratory(truth, seed);
  fit::Problem problem{truth};
  for (const double Q : flows) problem.slopes.push_back(laboratory.slope(Q, 0.1));
  problem.starts = 2;
  return problem;
}

const fit::LumpEstimate* lump_named(const fit::Fit& found, const std::string& name) {
  for (const auto& lump : found.lumps)
    if (lump.lump.name == name) return &lump;
  return nullptr;
}

TEST(FitAnswers, SlopesSeeTheFactorsOfTheFluxAsOneLump) {
  auto problem = slopes_only(table_2(), {0.001, 0.002, 0.003, 0.0046, 0.006});
  problem.unknowns = factors();
  problem.unknowns.push_back(unknown(P::mu_inf, 1.0, 0.3, 3.0));
  const auto found = fit::fit(problem).value();
  EXPECT_EQ(found.data.rank, 2);
  ASSERT_EQ(found.lumps.size(), 1U);
  const auto& K = found.lumps.front();
  EXPECT_EQ(K.lump.name, "flux factor K");
  EXPECT_EQ(K.of.size(), 5U);
  const double truth = 2500.0 * 0.6 * 0.003 * std::sqrt(0.6 * 9.81) / 0.00073 * std::pow(0.003 / 0.3727, 2.5);
  EXPECT_NEAR(K.value, truth, 1e-5 * truth);
  EXPECT_GT(K.error, 0.0);
  for (int i = 0; i < 5; ++i) {
    const auto& e = found.estimates[static_cast<std::size_t>(i)];
    EXPECT_FALSE(e.error) << e.variable.name;
    EXPECT_TRUE(e.profile_at.empty());
    EXPECT_NE(e.why_no_error.find("only flux factor K = rho_star Phi W sqrt(Phi g)/d (W/mu_w)^(5/2)"),
              std::string::npos)
        << e.why_no_error;
  }
  ASSERT_TRUE(found.estimates[5].error);
  EXPECT_NEAR(found.estimates[5].value, 1.3, 1e-4);
}

TEST(FitAnswers, AProfilePartsTheLumpIntoThree) {
  Laboratory laboratory(table_2());
  fit::Problem problem{table_2()};
  problem.unknowns = factors();
  problem.profiles = {laboratory.profile(0.0046, 1e-3)};
  problem.slopes = {laboratory.slope(0.0046, 0.1), laboratory.slope(0.002, 0.1)};
  problem.starts = 1;
  const auto found = fit::fit(problem).value();
  EXPECT_EQ(found.data.rank, 3);
  EXPECT_EQ(found.lumps.size(), 3U);
  for (const char* name : {"friction gradient", "rate factor", "mass per area"})
    EXPECT_NE(lump_named(found, name), nullptr) << name;
  for (const auto& e : found.estimates) EXPECT_FALSE(e.error) << e.variable.name;
}

TEST(FitAnswers, TheClassicalLawHidesI_0InTheLump) {
  auto problem = slopes_only(table_2(false), {0.001, 0.002, 0.003});
  problem.unknowns = {unknown(P::I_0, 1.0, 0.5, 2.0), unknown(P::d, 7e-4, 5e-4, 1e-3),
                      unknown(P::mu_w, 0.36, 0.3, 0.45)};
  const auto found = fit::fit(problem).value();
  EXPECT_EQ(found.data.rank, 1);
  ASSERT_EQ(found.lumps.size(), 1U);
  EXPECT_EQ(found.lumps.front().lump.name, "flux factor K times I_0");
}

TEST(FitAnswers, FlowsThatTheLawCannotCarryRejectIt) {
  auto problem = slopes_only(table_2(), {0.002, 0.0046, 0.006});
  problem.varied = table_2(false);
  problem.unknowns = {unknown(P::mu_s, 0.4, 0.35, 0.5)};
  const auto answer = fit::fit(problem);
  ASSERT_FALSE(answer);
  EXPECT_NE(answer.reason().find("the data reject the classical law"), std::string::npos) << answer.reason();
  EXPECT_NE(answer.reason().find("0.0046 kg/s exceeds the largest flux"), std::string::npos) << answer.reason();
}

TEST(FitAnswers, ALossTakesTheWeightFromAnOutlier) {
  auto problem = slopes_only(table_2(), {0.001, 0.0015, 0.002, 0.003, 0.0046, 0.006}, 7);
  problem.slopes[2].zeta += 3.0 * support::degree;
  problem.unknowns = {unknown(P::mu_w, 0.36, 0.3, 0.45)};
  const auto off = [&](fit::Loss loss) {
    problem.loss = loss;
    const auto found = fit::fit(problem).value();
    EXPECT_GT(std::abs(found.residuals[2]), 20.0);
    return std::abs(found.x[0] / 0.3727 - 1.0);
  };
  const double square = off(fit::Loss::square), huber = off(fit::Loss::huber), cauchy = off(fit::Loss::cauchy);
  EXPECT_GT(square, 0.03);
  EXPECT_LT(huber, 0.2 * square);
  EXPECT_LT(cauchy, 0.1 * square);
}

TEST(FitAnswers, AConditionOfWellPosednessIsKept) {
  auto problem = slopes_only(table_2(), {0.002, 0.0046, 0.0062});
  problem.unknowns = {unknown(P::I_0, 1.2, 0.3, 4.0)};
  problem.likelihoods = false;
  const auto free = fit::fit(problem).value();
  EXPECT_GT(free.margins.back().C, 1e-3);
  EXPECT_LT(*free.margins.back().C_margin, 0.0);
  problem.condition = fit::Condition::C;
  const auto kept = fit::fit(problem).value();
  EXPECT_NEAR(kept.worst_condition, 0.0, 2e-6);
  EXPECT_NEAR(*kept.margins.back().C_margin, 0.0, 1e-4);
  EXPECT_GT(kept.chi2, free.chi2 + 1.0);
  problem.condition = fit::Condition::q;
  const auto linear = fit::fit(problem).value();
  EXPECT_LT(linear.worst_condition, -1e-3);  // q < 1 holds by itself there
  EXPECT_NEAR(linear.x[0], free.x[0], 1e-6);
}

TEST(FitAnswers, AConditionThatNoParametersKeepIsSaid) {
  auto problem = slopes_only(table_2(), {0.002, 0.012});
  problem.unknowns = {unknown(P::I_0, 1.2, 0.3, 4.0)};
  problem.condition = fit::Condition::C;
  const auto answer = fit::fit(problem);
  ASSERT_FALSE(answer);
  EXPECT_NE(answer.reason().find("keep C <= 0"), std::string::npos) << answer.reason();
}

TEST(FitAnswers, APriorFixesWhatTheDataDoNotSee) {
  auto problem = slopes_only(table_2(), {0.002, 0.0046, 0.006});
  problem.unknowns = {unknown(P::W, 0.0031, 0.0028, 0.0033), unknown(P::d, 8e-4, 5e-4, 1e-3)};
  problem.unknowns[1].prior = {7.3e-4, 2e-5};
  const auto found = fit::fit(problem).value();
  for (const auto& e : found.estimates) {
    ASSERT_TRUE(e.error) << e.variable.name;
    EXPECT_TRUE(e.from_prior);
  }
  EXPECT_NEAR(*found.estimates[1].error, 2e-5, 1e-9);
  EXPECT_EQ(found.data.rank, 1);
}

TEST(FitAnswers, WhatEndsAtABoundHasNoError) {
  auto problem = slopes_only(table_2(), {0.002, 0.0046, 0.006});
  problem.unknowns = {unknown(P::mu_w, 0.35, 0.3, 0.36)};
  const auto found = fit::fit(problem).value();
  EXPECT_FALSE(found.estimates[0].error);
  EXPECT_EQ(found.estimates[0].why_no_error, "at its upper bound");
}

TEST(FitAnswers, AnUncertainFlowCountsThroughTheSlopeOfTheCurve) {
  auto problem = slopes_only(table_2(), {0.002, 0.0046, 0.006});
  for (auto& point : problem.slopes) point.Q_error = 1e-4;
  problem.unknowns = {unknown(P::mu_w, 0.35, 0.3, 0.45)};
  const auto found = fit::fit(problem).value();
  for (std::size_t i = 0; i < 3; ++i) {
    const double Q = problem.slopes[i].Q, step = 1e-6;
    const auto zeta = [&](double at) { return *steady::slope_of_flux(found.best.channel, at); };
    const double by_flux = (zeta(Q + step) - zeta(Q - step)) / (2.0 * step);
    EXPECT_NEAR(found.slope_sigma[i], std::hypot(0.1 * support::degree, 1e-4 * by_flux), 1e-6 * found.slope_sigma[i]);
  }
}

TEST(FitAnswers, AHeldBackFlowIsPredictedWithItsError) {
  auto problem = slopes_only(table_2(), {0.001, 0.002, 0.006});
  problem.unknowns = {unknown(P::mu_w, 0.35, 0.3, 0.45)};
  problem.predict = {0.0046};
  const auto found = fit::fit(problem).value();
  ASSERT_EQ(found.predictions.size(), 1U);
  const auto& p = found.predictions.front();
  EXPECT_NEAR(p.zeta / support::degree, 48.8125930897339, 1e-5);
  ASSERT_TRUE(p.zeta_error && p.speed_error);
  // One parameter: the error of the slope is that of mu_w times dzeta/dmu_w.
  auto shifted = found.best.values();
  shifted[static_cast<std::size_t>(P::mu_w)] += 1e-6;
  const double by = (*steady::slope_of_flux(found.best.with(shifted).channel, 0.0046) - p.zeta) / 1e-6;
  EXPECT_NEAR(*p.zeta_error, by * *found.estimates[0].error, 1e-4 * *p.zeta_error);
  // zeta(Q) sees mu_w and W as one: the slope is predicted, the speed is not.
  problem.unknowns = {unknown(P::mu_w, 0.35, 0.3, 0.45), unknown(P::W, 0.0031, 0.0028, 0.0033)};
  const auto lumped = fit::fit(problem).value();
  EXPECT_TRUE(lumped.predictions.front().zeta_error);
  EXPECT_FALSE(lumped.predictions.front().speed_error);
}
TEST(FitAnswers, AProfileLikelihoodRisesAsItsErrorSays) {
  auto problem = slopes_only(table_2(), {0.001, 0.002, 0.0046, 0.006});
  for (auto& point : problem.slopes) point.zeta_error = 0.01 * support::degree;  // so near that all is a parabola
  problem.unknowns = {unknown(P::mu_w, 0.35, 0.3, 0.45), unknown(P::mu_inf, 1.0, 0.3, 3.0)};
  const auto found = fit::fit(problem).value();
  for (const auto& e : found.estimates) {
    ASSERT_EQ(e.profile_at.size(), 9U) << e.variable.name;
    int near = 0;
    for (std::size_t k = 0; k < e.profile_at.size(); ++k) {
      const double off = (e.profile_at[k] - e.value) / *e.error;
      if (std::abs(off) > 0.8) continue;
      ++near;
      EXPECT_NEAR(e.profile_rise[k], off * off, 0.05) << e.variable.name << " " << off;
    }
    EXPECT_EQ(near, 3);
    EXPECT_GT(std::max(e.profile_rise.front(), e.profile_rise.back()), 4.0);
  }
}

TEST(FitAnswers, EveryStartIsToldAndTheyMeet) {
  auto problem = slopes_only(table_2(), {0.002, 0.0046, 0.006}, 3);
  problem.unknowns = {unknown(P::mu_w, 0.35, 0.2, 0.6)};
  problem.starts = 5;
  const auto found = fit::fit(problem).value();
  ASSERT_EQ(found.starts.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(found.starts[i].converged) << found.starts[i].failure;
    EXPECT_NEAR(found.starts[i].chi2, found.chi2, 1e-6);
    if (i == 0) continue;
    EXPECT_GT(std::abs(found.starts[i].from[0] - found.starts[0].from[0]), 1e-3);
  }
}

TEST(FitAnswers, ThreeProfilesFixMoreThanOne) {
  Laboratory laboratory(table_2());
  fit::Problem problem{table_2()};
  problem.unknowns = {unknown(P::mu_s, 0.42, 0.2, 0.6), unknown(P::mu_d, 0.8, 0.5, 2.0),
                      unknown(P::mu_w, 0.4, 0.2, 0.6)};
  problem.likelihoods = false;
  problem.starts = 1;
  problem.profiles = {laboratory.profile(0.0046, 2e-3)};
  problem.slopes = {laboratory.slope(0.0046, 0.1)};
  const auto one = fit::fit(problem).value();
  for (const double Q : {0.002, 0.006}) {
    problem.profiles.push_back(laboratory.profile(Q, 2e-3));
    problem.slopes.push_back(laboratory.slope(Q, 0.1));
  }
  const auto three = fit::fit(problem).value();
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(three.estimates[i].error);
    // Three times the data alone would make errors smaller by the root of three.
    if (!one.estimates[i].error) continue;
    EXPECT_LT(*three.estimates[i].error, *one.estimates[i].error / std::sqrt(3.0));
  }
}

TEST(FitAnswers, AStartAtTheEndOfTheLawIsNotTheEndOfTheFit) {
  auto problem = slopes_only(table_2(false), {0.001, 0.002, 0.003});
  for (auto& point : problem.slopes) point.Q_error = 1e-5;
  // The largest flux of the classical law falls as mu_w^(-5/2) from 4.59312 g/s: this start barely carries 3 g/s.
  const double end = 0.3727 * std::pow(4.59312 / 3.0, 0.4);
  problem.unknowns = {unknown(P::mu_w, end * (1.0 - 1e-6), 0.3, 0.6)};
  problem.starts = 3;
  const auto found = fit::fit(problem).value();
  EXPECT_NEAR(found.x[0], 0.3727, 1e-5);
  EXPECT_GE(found.infeasible_draws, 1);
}

// Its best mu_w lets the law's largest flux be the largest measured: there the quadrature fails or not, by rounding.
TEST(FitAnswers, AStartWhoseQuadratureFailsIsToldAndNotTheEndOfTheFit) {
  fit::Problem problem{table_2(false)};
  const double printed[][2] = {{0.0020, 43.3769}, {0.0046, 47.9899}, {0.0060, 49.5276}};
  for (const auto& [Q, zeta] : printed)
    problem.slopes.push_back({Q, 2.9e-5, zeta * support::degree, 1e-4 * support::degree, "slope"});
  problem.unknowns = {unknown(P::mu_w, 0.3727, 0.1, 1.0)};
  problem.starts = 3;
  problem.likelihoods = false;
  const auto found = fit::fit(problem).value();
  EXPECT_NEAR(found.x[0], 0.33492, 1e-4);
  ASSERT_EQ(found.starts.size(), 3U);
  for (const auto& start : found.starts) EXPECT_EQ(start.converged, start.failure.empty()) << start.failure;
}
}  // namespace
