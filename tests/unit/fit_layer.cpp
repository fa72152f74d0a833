#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "support/fit_problems.hpp"

/// The second stage beside a stand-in for the layer: heights h(t, x) = mu_w t exp(-b x), b a number of the scene.
namespace {
using namespace talus;
using Eigen::VectorXd;
using P = steady::Parameter;
using support::Laboratory;
using support::table_2;
using support::unknown;
using Answer = steady::Answer<VectorXd>;

constexpr double mu_w = 0.3727, b = 5.0;
const double none = std::numeric_limits<double>::quiet_NaN();

/// Unknowns of a point: those of the problem, of which mu_w is the first, then b.
class StandIn : public fit::LayerRuns {
 public:
  explicit StandIn(const fit::LayerStage& stage) : stage_(stage) {}
  std::vector<Answer> at(const std::vector<VectorXd>& points) override {
    std::vector<Answer> out;
    for (const auto& point : points) {
      ++n_runs;
      if (fails(point)) {
        out.push_back(Answer::none("IDA_CONV_FAIL"));
        continue;
      }
      VectorXd model(static_cast<Eigen::Index>(stage_.data.size()));
      for (Eigen::Index i = 0; i < model.size(); ++i) {
        const auto& datum = stage_.data[static_cast<std::size_t>(i)];
        // Two runs differ by the steps that they took.
        model[i] = height(datum, point[0], point[point.size() - 1]) *
                   (1.0 + noise * std::sin(1e9 * point.sum() * (1.0 + double(i))));
      }
      out.emplace_back(model);
    }
    return out;
  }
  void told(int, const VectorXd&, double chi2) override { told_chi2.push_back(chi2); }
  static double height(const fit::LayerDatum& d, double wall, double decay) {
    return wall * d.time * std::exp(-decay * d.x);
  }

  int n_runs = 0;
  double noise = 0.0;
  std::function<bool(const VectorXd&)> fails = [](const VectorXd&) { return false; };
  std::vector<double> told_chi2;

 private:
  const fit::LayerStage& stage_;
};

fit::LayerStage stage_of(unsigned seed, double error = 1e-3) {
  fit::LayerStage stage;
  stage.unknowns = {{"scene.b", "m-1", 3.0, 0.5, 20.0, {}}};
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  for (const double t : {1.0, 2.0})
    for (int i = 0; i < 15; ++i) {
      fit::LayerDatum d{"h", "height", "m", t, 0.02 * i, 0.0, error};
      d.value = StandIn::height(d, mu_w, b) + (seed > 0 ? error * normal(engine) : 0.0);
      stage.data.push_back(d);
    }
  return stage;
}

fit::Problem problem_of(unsigned seed) {
  Laboratory laboratory(table_2(), seed);
  fit::Problem problem{table_2()};
  problem.unknowns = {unknown(P::mu_w, 0.5, 0.2, 0.6)};
  problem.slopes = {laboratory.slope(0.002, 0.1), laboratory.slope(0.006, 0.1)};
  problem.starts = 1;
  return problem;
}

TEST(FitLayer, BothStagesInOneSumGiveTheParametersBack) {
  const auto stage = stage_of(0);
  StandIn runs(stage);
  const auto found = fit::fit(problem_of(0), stage, runs).value();
  EXPECT_NEAR(found.x[0], mu_w, 1e-4);
  EXPECT_NEAR(found.x[1], b, 2e-3);
  EXPECT_EQ(found.residuals.size(), 32);
  ASSERT_TRUE(found.layer);
  EXPECT_TRUE(found.layer->converged);
  EXPECT_EQ(found.layer->n_runs, runs.n_runs);
  EXPECT_LE(found.layer->n_runs, 22);
  EXPECT_EQ(found.layer->seen_by_layer_only, std::vector<std::string>{"scene.b"});
  EXPECT_NEAR(found.layer->before[0].value, mu_w, 1e-6);
  EXPECT_LT(*found.estimates[0].error, *found.layer->before[0].error);  // the heights know mu_w, too
  EXPECT_GT(found.layer->chi2_before, 100.0);
}

TEST(FitLayer, NoisyDataGiveThemWithinTwoStandardDeviations) {
  constexpr int repeats = 100;
  int within[2] = {};
  double chi2 = 0.0, freedom = 0.0;
  for (unsigned seed = 1; seed <= repeats; ++seed) {
    const auto stage = stage_of(seed);
    StandIn runs(stage);
    runs.noise = 1e-5;
    const auto found = fit::fit(problem_of(seed), stage, runs).value();
    chi2 += found.chi2, freedom += found.freedom;
    const double truth[] = {mu_w, b};
    for (int i = 0; i < 2; ++i) {
      const auto& e = found.estimates[static_cast<std::size_t>(i)];
      ASSERT_TRUE(e.error) << e.why_no_error;
      if (std::abs(e.value - truth[i]) <= 2.0 * *e.error) ++within[i];
    }
  }
  for (const int n : within) {
    EXPECT_GE(n, 90);
    EXPECT_LE(n, 99);
  }
  EXPECT_NEAR(chi2 / freedom, 1.0, 4.0 * std::sqrt(2.0 / freedom));
}

TEST(FitLayer, ARunThatFailsIsAStepNotTakenAndIsSaid) {
  auto stage = stage_of(0);
  stage.unknowns[0].start = 12.0;
  StandIn runs(stage);
  runs.fails = [](const VectorXd& point) { return point[1] < 4.5; };  // Newton's first step from 12 goes beyond
  const auto found = fit::fit(problem_of(0), stage, runs).value();
  EXPECT_TRUE(std::ranges::any_of(runs.told_chi2, [](double chi2) { return std::isinf(chi2); }));
  EXPECT_NEAR(found.x[1], b, 0.02);
  ASSERT_FALSE(found.layer->failures.empty());
  EXPECT_NE(found.layer->failures.front().find("scene.b = "), std::string::npos) << found.layer->failures.front();
  EXPECT_NE(found.layer->failures.front().find("IDA_CONV_FAIL"), std::string::npos);
}

TEST(FitLayer, ADifferenceThatFailsIsTakenOnTheOtherSide) {
  const auto stage = stage_of(0);
  StandIn runs(stage);
  runs.fails = [](const VectorXd& point) { return point[1] > 5.02; };  // 2 % above the truth
  const auto found = fit::fit(problem_of(0), stage, runs).value();
  EXPECT_FALSE(found.layer->failures.empty());
  EXPECT_NEAR(found.x[1], b, 0.02);
  EXPECT_TRUE(found.estimates[1].error) << found.estimates[1].why_no_error;
}

TEST(FitLayer, AFirstRunThatFailsIsAnAnswer) {
  const auto stage = stage_of(0);
  StandIn runs(stage);
  runs.fails = [](const VectorXd&) { return true; };
  const auto answer = fit::fit(problem_of(0), stage, runs);
  ASSERT_FALSE(answer);
  EXPECT_NE(answer.reason().find("the first run of the layer failed"), std::string::npos) << answer.reason();
}

TEST(FitLayer, RunsAllowedAreNotExceeded) {
  auto stage = stage_of(0);
  stage.evaluations = 8;
  StandIn runs(stage);
  const auto found = fit::fit(problem_of(0), stage, runs).value();
  EXPECT_LE(runs.n_runs, 8);
  EXPECT_FALSE(found.layer->converged);
  EXPECT_LT(found.chi2, found.layer->chi2_before);
  stage.evaluations = 3;  // a base, two differences and the noise are four
  EXPECT_FALSE(fit::fit(problem_of(0), stage, runs));
}

TEST(FitLayer, WhatIsNoiseBetweenRunsIsNotCalledSeen) {
  auto stage = stage_of(0);
  stage.unknowns.insert(stage.unknowns.begin(), {"scene.idle", "1", 1.0, 0.5, 2.0, {}});  // moves no datum
  StandIn runs(stage);
  runs.noise = 1e-4;
  const auto found = fit::fit(problem_of(0), stage, runs).value();
  EXPECT_GT(found.layer->noise, 1e-3);
  EXPECT_FALSE(found.estimates[1].error) << *found.estimates[1].error;
  EXPECT_TRUE(found.estimates[2].error) << found.estimates[2].why_no_error;
  EXPECT_EQ(found.data.rank, 2);
}

TEST(FitLayer, WithoutSteadyDataTheLayerStartsFromWhatIsStated) {
  auto problem = problem_of(0);
  problem.slopes.clear();
  problem.unknowns[0].start = 0.4;
  const auto stage = stage_of(0);
  StandIn runs(stage);
  const auto found = fit::fit(problem, stage, runs).value();
  EXPECT_NEAR(found.x[0], mu_w, 1e-4);
  EXPECT_TRUE(found.layer->before.empty());
  EXPECT_EQ(found.layer->seen_by_layer_only.size(), 2U);
}

TEST(FitLayer, APriorOfANumberOfTheSceneCounts) {
  auto stage = stage_of(0);
  for (auto& d : stage.data) d.error = 10.0;  // says nothing
  stage.unknowns[0].prior = {4.0, 0.5};
  StandIn runs(stage);
  const auto found = fit::fit(problem_of(0), stage, runs).value();
  EXPECT_NEAR(found.x[1], 4.0, 1e-2);
  ASSERT_TRUE(found.estimates[1].error) << found.estimates[1].why_no_error;
  EXPECT_NEAR(*found.estimates[1].error, 0.5, 1e-3);
}
}  // namespace
