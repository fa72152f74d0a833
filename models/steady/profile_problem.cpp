#include "steady/profile_problem.hpp"

#include <algorithm>
#include <cmath>

namespace talus::steady {

namespace {

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

ProfileProblem::ProfileProblem(const RegularisedLayer& layer, double zeta, int cells) : layer_(layer) {
  const auto& [channel, regularisation, u_c, H] = layer;
  const double flowing = channel.mu_w > 0.0 ? channel.gap * std::tan(zeta) / channel.mu_w : H;
  h0_ = std::min(H, flowing);
  a_ = std::asinh(std::sqrt(H / h0_));
  weight_ = channel.grains.rho() * channel.gravity * std::sin(zeta);
  floor_ = rheology::rate_floor(regularisation, H);
  const auto depth_at = [&](double i) {
    const double y = std::sinh(a_ * i / cells);
    return h0_ * y * y;
  };
  const double lithostatic = channel.grains.rho() * channel.gravity * std::cos(zeta);
  for (int i = 0; i <= cells; ++i) depth_.push_back(depth_at(i));
  for (int i = 0; i < cells; ++i) {
    spacing_.push_back(depth_[i + 1] - depth_[i]);
    volume_.push_back(depth_at(i + 0.5) - (i > 0 ? depth_at(i - 0.5) : 0.0));
    face_pressure_.push_back(lithostatic * depth_at(i + 0.5));
    full_friction_.push_back(2.0 * channel.mu_w / channel.gap *
                             rheology::positive_pressure(lithostatic * depth_[i], regularisation.p_0));
  }
}

double ProfileProblem::position(double depth) const { return std::asinh(std::sqrt(depth / h0_)) / a_ * size(); }

bool ProfileProblem::solvable() const {
  const double mu = rheology::friction_bound(layer_.channel.law);
  double stress = 0.0;
  for (int i = 0; i < size(); ++i) {
    stress += volume_[i] * (weight_ - full_friction_[i]);
    if (stress >= mu * rheology::positive_pressure(face_pressure_[i], layer_.regularisation.p_0)) return false;
  }
  return true;
}

std::vector<double> ProfileProblem::speeds(std::span<const double> jump) const {
  std::vector<double> u(jump.begin(), jump.end());
  for (int i = size() - 2; i >= 0; --i) u[i] += u[i + 1];
  return u;
}

void ProfileProblem::force(std::span<const double> jump, std::vector<double>& on_node, Stiffness* stiffness) const {
  using Rate = core::Dual<1>;
  const int n = size();
  const std::vector<double> u = speeds(jump);
  on_node.assign(n, 0.0);
  if (stiffness) *stiffness = {std::vector<double>(n), std::vector<double>(n)};
  for (int i = 0; i < n; ++i) {
    const double direction = std::tanh(u[i] / layer_.u_c);
    const Rate rate = Rate::input(jump[i] / spacing_[i], 0);
    const Rate eta = rheology::viscosity(layer_.channel.law, layer_.channel.grains, layer_.regularisation,
                                         Rate(0.25 * rate * rate), floor_, Rate(face_pressure_[i]));
    const Rate tau = eta * rate;
    on_node[i] += volume_[i] * (weight_ - full_friction_[i] * direction) - tau.value;
    if (i + 1 < n) on_node[i + 1] += tau.value;
    if (!stiffness) continue;
    // At large I a law that saturates loses its slope to rounding.
    stiffness->face[i] = std::max(tau.slope[0], 1e-12 * eta.value) / spacing_[i];
    stiffness->node[i] = volume_[i] * full_friction_[i] * (1.0 - direction * direction) / layer_.u_c;
  }
}

bool ProfileProblem::step(std::vector<double>& jump) const {
  const int n = size();
  std::vector<double> load, change(n), trial(n);
  Stiffness k;
  force(jump, load, &k);
  const std::vector<double> load_at_start = load;
  // Springs in a row: from the surface down each node's load and stiffness pass to the next. Sums of positive terms
  // only, so the elimination is exact however rigid a face is.
  for (int i = 1; i < n; ++i) {
    const double share = k.face[i - 1] / (k.face[i - 1] + k.node[i - 1]);
    k.node[i] += share * k.node[i - 1];
    load[i] += share * load[i - 1];
  }
  double below = 0.0, most = 0.0, fastest = 0.0;
  for (int i = n - 1; i >= 0; --i) {
    change[i] = (load[i] - k.node[i] * below) / (k.face[i] + k.node[i]);
    below += change[i];
    most = std::max(most, std::abs(below));
  }
  for (const double u : speeds(jump)) fastest = std::max(fastest, std::abs(u));
  double unbalanced = 0.0;
  for (const double f : load_at_start) unbalanced += std::abs(f);
  if (most <= 1e-10 * fastest && unbalanced <= 1e-7 * weight_ * depth_.back()) return true;

  // The slope of the convex function along the step rises from -`start` through zero at its minimum; it is accepted at
  // half of that. No jump may fall below a tenth of itself: the speed grows upwards, and a tangent at fast shear would
  // turn a face that has to come to rest far into reverse.
  const std::vector<double> change_of_speed = speeds(change);
  const double start = dot(load_at_start, change_of_speed);
  const auto slope_at = [&](double t) {
    for (int i = 0; i < n; ++i) trial[i] = std::max(jump[i] + t * change[i], 0.1 * jump[i]);
    force(trial, load, nullptr);
    return -dot(load, change_of_speed);
  };
  double t = 1.0, before = 0.0, beyond = 0.0, slope = slope_at(t);
  for (int tries = 0; tries < 60 && std::abs(slope) > 0.5 * start; ++tries) {
    (slope > 0.0 ? beyond : before) = t;
    if (beyond == 0.0) t *= 4.0;
    else t = before > 0.0 ? 0.5 * (before + beyond) : 0.3 * beyond;
    slope = slope_at(t);
  }
  jump.swap(trial);
  return false;
}

int ProfileProblem::solve(std::vector<double>& jump) const {
  jump.assign(size(), 0.0);
  for (int iteration = 1; iteration <= 200; ++iteration) {
    if (step(jump)) return iteration;
    if (!std::isfinite(jump[0])) return -1;
  }
  return -1;
}

double ProfileProblem::flux(std::span<const double> u) const {
  return layer_.channel.grains.rho() * layer_.channel.gap * dot(u, volume_);
}

}  // namespace talus::steady
