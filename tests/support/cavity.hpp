#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnostics/observed_order.hpp"
#include "kinsol/kinsol.hpp"
#include "support/layer_cases.hpp"
#include "support/layer_flow.hpp"
#include "support/reference.hpp"
#include "support/table.hpp"

/// The lid-driven cavity against the tables of Ghia, Ghia and Shin on its centre lines, and the spectral extremes there.
namespace talus::tests {

/// Of values at ascending places: the cubic through the four nearest.
inline double interpolated(const std::vector<double>& at, const std::vector<double>& values, double x) {
  const auto next = std::ranges::lower_bound(at, x) - at.begin();
  const auto first = std::clamp<std::ptrdiff_t>(next - 2, 0, std::ssize(at) - 4);
  double sum = 0.0;
  for (auto i = first; i < first + 4; ++i) {
    double weight = values[i];
    for (auto j = first; j < first + 4; ++j)
      if (j != i) weight *= (x - at[j]) / (at[i] - at[j]);
    sum += weight;
  }
  return sum;
}

/// The steady flow at a Reynolds number on n x n uniform cells, found directly.
class Cavity {
 public:
  Cavity(double Re, int n) : layer_(parameters(Re, n)), y_(state_at_rest(layer_)) {
    kinsol::Options options;
    options.rtol = 1e-6;
    kinsol::Kinsol steady(layer_, options);
    core::Observer nobody;
    steady.start(0.0, y_, std::vector<double>(y_.size(), 0.0));
    steady.advance(1.0, nobody);
    std::ranges::copy(steady.current().y, y_.begin());
  }

  /// u along x = 1/2 and w along z = 1/2.
  [[nodiscard]] double u(double z) const {
    const auto& c = layer_.columns();
    std::vector<double> at{0.0}, values{0.0};
    for (int k = 0; k < c.n_layers; ++k) {
      at.push_back((k + 0.5) / c.n_layers);
      values.push_back(y_[layer_.unknowns().u(c.n_columns / 2, k)]);
    }
    at.push_back(1.0), values.push_back(1.0);
    return interpolated(at, values, z);
  }
  [[nodiscard]] double w(double x) const {
    const auto& c = layer_.columns();
    std::vector<double> at{0.0}, values{0.0};
    for (int i = 0; i < c.n_columns; ++i) {
      at.push_back(c.x_centre(i));
      values.push_back(y_[layer_.unknowns().omega(i, c.n_layers / 2)]);
    }
    at.push_back(1.0), values.push_back(0.0);
    return interpolated(at, values, x);
  }

  /// Of u(z) or w(x), over a thousand places.
  [[nodiscard]] double extreme(double (Cavity::*velocity)(double) const, bool most) const {
    double found = 0.0;
    for (int j = 0; j <= 1000; ++j) {
      const double value = (this->*velocity)(1e-3 * j);
      found = most ? std::max(found, value) : std::min(found, value);
    }
    return found;
  }

 private:
  static layer::Parameters parameters(double Re, int n) {
    auto par = fluid_box(1.0 / Re, n, n);
    par.box.periodic = par.box.left_open = par.box.right_open = false;
    par.box.end_walls = experiment::Contact::no_slip;
    par.box.lid->speed = 1.0;
    return par;
  }

  layer::Layer layer_;
  std::vector<double> y_;
};

/// Departures of a series of grids: `most` [m/s] from the table on the last, and from the extremes, at `order` and at last below
/// `error` [m/s].
inline void expect_cavity(int number, const std::string& name, const std::vector<int>& cells, double most, double order,
                          double error) {
  const auto reference = support::reference("cavity.json");
  const auto& c = reference.at("cases").at(number);
  const auto z = reference.at("z").get<std::vector<double>>(), x = reference.at("x").get<std::vector<double>>();
  Table table("layer_cavity_" + name, {"cells", "most off u of table [m/s]", "most off w of table [m/s]", "u min [m/s]",
                                       "w max [m/s]", "w min [m/s]", "most off extremes [m/s]", "order"});
  table.row({"spectral", "", "", c.at("u_min").get<double>(), c.at("w_max").get<double>(), c.at("w_min").get<double>(),
             "", ""});
  std::vector<double> h, e;
  double off_u = 0.0, off_w = 0.0;
  for (const int n : cells) {
    const Cavity cavity(c.at("Re"), n);
    off_u = off_w = 0.0;
    for (std::size_t j = 0; j < z.size(); ++j) {
      off_u = std::max(off_u, std::abs(cavity.u(z[j]) - c.at("u").at(j).get<double>()));
      off_w = std::max(off_w, std::abs(cavity.w(x[j]) - c.at("w").at(j).get<double>()));
    }
    const double u_min = cavity.extreme(&Cavity::u, false), w_max = cavity.extreme(&Cavity::w, true),
                 w_min = cavity.extreme(&Cavity::w, false);
    h.push_back(1.0 / n);
    e.push_back(std::max({std::abs(u_min - c.at("u_min").get<double>()), std::abs(w_max - c.at("w_max").get<double>()),
                          std::abs(w_min - c.at("w_min").get<double>())}));
    table.row({double(n), off_u, off_w, u_min, w_max, w_min, e.back(),
               e.size() == 1 ? Table::Cell("") : diagnostics::observed_orders(h, e).back()});
  }
  EXPECT_LT(std::max(off_u, off_w), most);
  EXPECT_GT(diagnostics::observed_orders(h, e).back(), order);
  EXPECT_LT(e.back(), error);
}

}  // namespace talus::tests
