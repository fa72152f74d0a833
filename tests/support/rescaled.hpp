#pragma once

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

#include "app/models.hpp"
#include "app/scene.hpp"

/// The same scene in other units: every number that has a dimension is multiplied by a power of two, which costs no bit.
namespace talus::tests {

/// Exponents of two by which the numbers of lengths, times and masses grow.
struct Units {
  int length, time, mass;

  [[nodiscard]] double factor(int lengths, int times, int masses) const {
    return std::ldexp(1.0, lengths * length + times * time + masses * mass);
  }
  /// Of a unit as fields declare it: "m s-1". Throws std::invalid_argument for one that is not made of m, s, kg, Pa and 1.
  [[nodiscard]] double factor(const std::string& unit) const {
    std::istringstream words(unit);
    double product = 1.0;
    for (std::string word; words >> word;) {
      const auto end = word.find_first_of("-0123456789");
      const std::string name = word.substr(0, end);
      const int power = end == std::string::npos ? 1 : std::atoi(word.c_str() + end);
      if (name == "m") product *= factor(power, 0, 0);
      else if (name == "s") product *= factor(0, power, 0);
      else if (name == "kg") product *= factor(0, 0, power);
      else if (name == "Pa") product *= factor(-power, -2 * power, power);
      else if (word != "1") throw std::invalid_argument("no unit: " + unit);
    }
    return product;
  }
};

inline app::Scene rescaled(app::Scene scene, const Units& units) {
  const double L = units.factor(1, 0, 0), T = units.factor(0, 1, 0), M = units.factor(0, 0, 1);
  const auto grow = [](double factor, auto&... numbers) { ((numbers *= factor), ...); };
  const auto grow_all = [](double factor, std::vector<double>& numbers) {
    for (double& number : numbers) number *= factor;
  };
  auto& reg = scene.regularisation;
  auto& in = scene.inflow;
  auto& by = scene.integration;
  grow(L, scene.box.length, scene.box.height, scene.box.gap, scene.box.base_slip_length, scene.grains.d, in.position,
       in.width, scene.numerics.film, scene.initial.thickness, scene.cells.cluster_depth, by.atol_height);
  auto& two = scene.two_fluid;
  grow(L, two.jet_margin, two.jet_clearance, two.reach.margin);
  grow(L / T, two.segregation_speed, two.upwind_speed, two.return_speed);
  grow(M / (L * L * L), two.air.rho);
  grow(M / (L * T), two.air.eta, two.air.drag_viscosity);
  grow(T, in.start, in.stop, in.ramp, by.max_step, scene.end);
  if (scene.box.lid) {
    grow(L / T, scene.box.lid->speed);
    grow(M / (L * T * T), scene.box.lid->pressure);
  }
  grow(L / T, scene.box.base_speed, reg.rate_speed, scene.wall.u_c, scene.numerics.film_speed, by.atol_velocity);
  grow(M / (L * T * T), reg.p_0, by.atol_pressure);
  grow(L / (T * T), scene.box.gravity);
  grow(M / (L * L * L), scene.grains.rho_star);
  grow(M / (L * T), reg.eta_max);
  grow(M / T, in.rate);
  grow(1.0 / T, reg.rate_floor);
  grow_all(T, scene.motion.tilt.at);
  grow_all(T, scene.motion.gap.at);
  grow_all(L, scene.motion.gap.values);
  grow_all(L, scene.initial.profile.at);
  grow_all(L / T, scene.initial.profile.values);
  return scene;
}

/// The system that a model builds from a rescaled scene, with every tolerance in the new units, also those that no scene states.
class RescaledSystem final : public core::DaeSystem {
 public:
  RescaledSystem(const app::Scene& scene, const Units& units)
      : built_(app::model(scene.model).build(rescaled(scene, units))), layout_(system().layout()) {
    const auto original = app::model(scene.model).build(scene);
    for (std::size_t i = 0; i < layout_.fields.size(); ++i) {
      const auto& field = original.system->layout().fields[i];
      layout_.fields[i].absolute_tolerance = field.absolute_tolerance * units.factor(field.unit);
    }
  }
  [[nodiscard]] const core::Layout& layout() const override { return layout_; }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return system().pattern(); }
  void initial_state(double t, std::span<double> y, std::span<double> yp) const override {
    system().initial_state(t, y, yp);
  }
  void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override {
    system().residual(t, y, yp, r);
  }
  void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override {
    system().jacobian(t, y, yp, c_j, values);
  }
  [[nodiscard]] std::string describe(core::Index row) const override { return system().describe(row); }
  [[nodiscard]] std::vector<double> breakpoints() const override { return system().breakpoints(); }

 private:
  [[nodiscard]] const core::DaeSystem& system() const { return *built_.system; }
  app::Simulation built_;
  core::Layout layout_;
};

}  // namespace talus::tests
