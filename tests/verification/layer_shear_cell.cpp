#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "kinsol/kinsol.hpp"
#include "support/layer_cases.hpp"
#include "support/layer_flow.hpp"
#include "support/table.hpp"
#include "support/tanh_sinh.hpp"

/// Grains sheared between a moving base and a moving lid, with their weight: the shear stress is the same at every height, the
/// pressure is not, so mu(I) = tau/p(z) gives the steady profile.
namespace {

using namespace talus;

constexpr double H = 0.01, lid_pressure = 500.0, lid_speed = 0.02, base_speed = -0.01;  // [m], [Pa], [m/s]

class ShearCell {
 public:
  explicit ShearCell(const layer::Parameters& par) : par_(par) {
    double low = 1.0, high = 1e4;
    while (high - low > 1e-13 * high) {
      tau_ = 0.5 * (low + high);
      (speed(H) < lid_speed ? low : high) = tau_;
    }
  }
  [[nodiscard]] double tau() const { return tau_; }
  [[nodiscard]] double pressure(double z) const {
    return lid_pressure + par_.grains.rho() * par_.box.gravity * (H - z);
  }
  [[nodiscard]] double speed(double z) const {
    return base_speed +
           support::tanh_sinh(
               [&](double above, double) {
                 const double p = pressure(above);
                 return rheology::inverse(par_.law, tau_ / p) * std::sqrt(p / par_.grains.rho_star) / par_.grains.d;
               },
               z);
  }

 private:
  layer::Parameters par_;
  double tau_ = 0.0;
};

TEST(LayerShearCell, SteadyProfileConvergesAtOrderTwo) {
  tests::Table table("layer_shear_cell",
                     {"layers", "L2 of u [m/s]", "Linf of u [m/s]", "Linf of p [Pa]", "order of u"});
  std::vector<double> h, e;
  for (const int n : {20, 40, 80}) {
    auto par = tests::periodic_layer(H, H, 0.0, 2, n);
    par.box.lid = experiment::Lid{.speed = lid_speed, .pressure = lid_pressure};
    par.box.base_speed = base_speed;
    const layer::Layer system(par);
    auto y = tests::state_at_rest(system);
    kinsol::Kinsol steady(system);
    core::Observer nobody;
    steady.start(0.0, y, std::vector<double>(y.size(), 0.0));
    steady.advance(1.0, nobody);
    const ShearCell exact(par);
    const auto errors = tests::errors(
        system,
        [&](double, double z, double) {
          return tests::PointFlow{exact.speed(z), 0.0, exact.pressure(z)};
        },
        1.0, steady.current().y);
    h.push_back(1.0 / n);
    e.push_back(errors.u.l2);
    table.row({double(n), errors.u.l2, errors.u.linf, errors.p.linf,
               e.size() == 1 ? tests::Table::Cell("") : diagnostics::observed_orders(h, e).back()});
    EXPECT_LT(errors.p.linf, 1e-6 * lid_pressure);
  }
  EXPECT_NEAR(diagnostics::observed_orders(h, e).back(), 2.0, 0.15);
  EXPECT_LT(e.back(), 1e-3 * lid_speed);
}

}  // namespace
