#include <gtest/gtest.h>

#include <cmath>

#include "support/fit_problems.hpp"

/// Parameters found again from measurements that they gave.
namespace {
using namespace talus;
using P = steady::Parameter;
using support::Laboratory;
using support::table_2;
using support::unknown;

fit::Problem three_parameters(const fit::SpeedProfile& profile, std::vector<fit::SlopePoint> slopes) {
  fit::Problem problem{table_2()};
  problem.unknowns = {unknown(P::mu_s, 0.42, 0.2, 0.6), unknown(P::mu_d, 0.8, 0.5, 2.0),
                      unknown(P::mu_w, 0.5, 0.2, 0.6)};
  problem.slopes = std::move(slopes);
  problem.profiles = {profile};
  problem.starts = 1;
  problem.likelihoods = false;
  return problem;
}

TEST(FitRecovery, ExactDataGiveTheParametersBack) {
  Laboratory laboratory(table_2());
  const auto problem = three_parameters(laboratory.profile(0.0046, 1e-3, 2e-4),
                                        {laboratory.slope(0.002, 0.1), laboratory.slope(0.006, 0.1)});
  const auto found = fit::fit(problem);
  ASSERT_TRUE(found) << found.reason();
  EXPECT_LT(found->chi2, 1e-10);
  const double truth[] = {0.4, 0.9, 0.3727, 2e-4};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(found->x[i], truth[i], 1e-5 * truth[i]) << found->estimates[i].variable.name;
}

TEST(FitRecovery, NoisyDataGiveThemWithinTwoStandardDeviations) {
  constexpr int repeats = 200;
  int within[4] = {};
  double chi2 = 0.0, freedom = 0.0;
  for (unsigned seed = 1; seed <= repeats; ++seed) {
    Laboratory laboratory(table_2(), seed);
    const auto profile = laboratory.profile(0.0046, 5e-4, 2e-4);
    const auto gentle = laboratory.slope(0.002, 0.05), steep = laboratory.slope(0.006, 0.05);
    const auto problem = three_parameters(profile, {gentle, steep});
    const auto found = fit::fit(problem);
    ASSERT_TRUE(found) << found.reason();
    chi2 += found->chi2, freedom += found->freedom;
    const double truth[] = {0.4, 0.9, 0.3727, 2e-4};
    for (int i = 0; i < 4; ++i) {
      const auto& e = found->estimates[static_cast<std::size_t>(i)];
      ASSERT_TRUE(e.error) << seed << " " << e.variable.name << ": " << e.why_no_error;
      if (std::abs(e.value - truth[i]) <= 2.0 * *e.error) ++within[i];
    }
  }
  for (const int n : within) {
    EXPECT_GE(n, repeats * 90 / 100);
    EXPECT_LE(n, repeats * 99 / 100);  // an error twice too large would put nearly all within
  }
  EXPECT_NEAR(chi2 / freedom, 1.0, 4.0 * std::sqrt(2.0 / freedom));
}
}  // namespace
