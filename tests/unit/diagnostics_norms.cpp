#include "diagnostics/norms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "diagnostics/line_fit.hpp"
#include "diagnostics/observed_order.hpp"

namespace {
using namespace talus::diagnostics;

TEST(Norms, AreMeansAndMaximum) {
  const std::vector<double> e{3.0, -4.0, 0.0, 1.0}, w{1.0, 2.0, 1.0, 0.0};
  const Norms plain = norms(e), weighted = norms(e, w);
  EXPECT_DOUBLE_EQ(plain.l1, 2.0);
  EXPECT_DOUBLE_EQ(plain.l2, std::sqrt(26.0 / 4.0));
  EXPECT_DOUBLE_EQ(plain.linf, 4.0);
  EXPECT_DOUBLE_EQ(weighted.l1, 11.0 / 4.0);
  EXPECT_DOUBLE_EQ(weighted.l2, std::sqrt(41.0 / 4.0));
  EXPECT_DOUBLE_EQ(weighted.linf, 4.0);
  EXPECT_DOUBLE_EQ(norms(std::vector<double>{1.0, 9.0}, std::vector<double>{1.0, 0.0}).linf, 1.0);
}

TEST(Norms, DoNotLoseANaN) {
  for (const auto& e : {std::vector<double>{std::nan(""), 1.0}, std::vector<double>{1.0, std::nan("")}}) {
    const Norms n = norms(e);
    EXPECT_TRUE(std::isnan(n.l1) && std::isnan(n.l2) && std::isnan(n.linf));
  }
}

TEST(Norms, RelativeErrorScalesOut) {
  const std::vector<double> reference{1.0, 2.0, 2.0}, w{1.0, 1.0, 4.0};
  std::vector<double> value = reference;
  for (double& v : value) v *= 1.01;
  EXPECT_NEAR(relative_l2(value, reference, w), 0.01, 1e-15);
}

TEST(Norms, RefuseMeaninglessInput) {
  const std::vector<double> two{1.0, 2.0}, one{1.0}, zero{0.0, 0.0}, negative{1.0, -1.0};
  EXPECT_THROW((void)norms(two, one), std::invalid_argument);
  EXPECT_THROW((void)norms(two, zero), std::invalid_argument);
  EXPECT_THROW((void)norms(two, negative), std::invalid_argument);
  EXPECT_THROW((void)norms({}), std::invalid_argument);
  EXPECT_THROW((void)relative_l2(two, one, two), std::invalid_argument);
}

TEST(ObservedOrder, IsThePowerOfTheError) {
  const std::vector<double> h{0.4, 0.2, 0.05};
  std::vector<double> e;
  for (const double x : h) e.push_back(7.0 * std::pow(x, 1.5));
  for (const double order : observed_orders(h, e)) EXPECT_NEAR(order, 1.5, 1e-12);
  EXPECT_NEAR(fitted_order(h, e), 1.5, 1e-12);
  const std::vector<double> rough{8.0, 2.0, 1.0};
  EXPECT_NEAR(observed_orders(std::vector<double>{4.0, 2.0, 1.0}, rough)[0], 2.0, 1e-12);
  EXPECT_NEAR(observed_orders(std::vector<double>{4.0, 2.0, 1.0}, rough)[1], 1.0, 1e-12);
  EXPECT_NEAR(fitted_order(std::vector<double>{4.0, 2.0, 1.0}, rough), 1.5, 1e-12);
}

TEST(ObservedOrder, RefusesTablesWithoutAnOrder) {
  const std::vector<double> h{0.2, 0.1};
  EXPECT_THROW((void)observed_orders(h, std::vector<double>{1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW((void)observed_orders(h, std::vector<double>{1.0}), std::invalid_argument);
  EXPECT_THROW((void)observed_orders(std::vector<double>{0.1, 0.1}, h), std::invalid_argument);
  EXPECT_THROW((void)fitted_order(std::vector<double>{0.1, 0.1}, h), std::invalid_argument);
  EXPECT_THROW((void)fitted_order(h, std::vector<double>{1.0, std::nan("")}), std::invalid_argument);
}

TEST(LineFit, IsTheLeastSquaresLine) {
  const LineFit fit = fit_line(std::vector<double>{0.0, 1.0, 2.0, 3.0}, std::vector<double>{1.0, 3.0, 2.0, 6.0});
  EXPECT_NEAR(fit.slope, 1.4, 1e-14);
  EXPECT_NEAR(fit.y_mean - fit.slope * fit.x_mean, 0.9, 1e-14);
  EXPECT_NEAR(fit.rms, std::sqrt(4.2 / 4.0), 1e-14);
}
}  // namespace
