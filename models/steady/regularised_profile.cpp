#include "steady/regularised_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/bracketed_root.hpp"
#include "rheology/checks.hpp"
#include "steady/slope.hpp"

namespace talus::steady {

RegularisedProfile::RegularisedProfile(const ProfileProblem& problem) : problem_(problem) {
  for (const double s : problem.depths()) z_.push_back(-s);
}

Answer<RegularisedProfile> RegularisedProfile::at(const RegularisedLayer& layer, double zeta, int cells) {
  check_layer(layer.channel, zeta, layer.thickness);
  rheology::check(layer.regularisation);
  if (!std::isfinite(layer.thickness)) throw std::invalid_argument("thickness of a regularised layer must be finite");
  if (!(layer.u_c > 0.0 && std::isfinite(layer.u_c)))
    throw std::invalid_argument("u_c = " + std::to_string(layer.u_c) + " must be finite and above 0 m/s");
  if (cells < 4) throw std::invalid_argument("cells = " + std::to_string(cells) + " must be at least 4");

  const ProfileProblem problem(layer, zeta, cells);
  if (!problem.solvable())
    return Answer<RegularisedProfile>::none("no steady state at tan zeta = " + std::to_string(std::tan(zeta)) +
                                            ": the " + std::string(rheology::name(layer.channel.law)) +
                                            " law cannot carry the stress that full wall friction leaves");
  RegularisedProfile profile(problem);
  std::vector<double> jump;
  profile.iterations_ = problem.solve(jump);
  if (profile.iterations_ < 0) return Answer<RegularisedProfile>::none("Newton's method did not converge");
  profile.u_ = problem.speeds(jump);
  profile.flux_ = problem.flux(profile.u_);
  profile.u_.push_back(0.0);
  return profile;
}

double RegularisedProfile::speed(double z) const {
  if (!(z <= 0.0 && z >= z_.back()))
    throw std::invalid_argument("speed: z = " + std::to_string(z) + " lies outside the layer");
  const double x = problem_.position(-z);
  const int first = std::clamp(static_cast<int>(x) - 1, 0, problem_.size() - 3);
  double u = 0.0;
  for (int i = first; i < first + 4; ++i) {
    double weight = 1.0;
    for (int j = first; j < first + 4; ++j)
      if (j != i) weight *= (x - j) / (i - j);
    u += weight * u_[i];
  }
  return u;
}

Answer<double> slope_of_flux(const RegularisedLayer& layer, double Q, int cells) {
  if (!(Q > 0.0 && std::isfinite(Q)))
    throw std::invalid_argument("slope_of_flux: Q = " + rheology::checks::text(Q) + " must be above 0 kg/s");
  constexpr double flattest = 1e-3, steepest = 0.4999 * std::numbers::pi;
  std::string reason;
  // Above the steepest steady slope the flux counts as twice Q: the sign is what the search needs.
  const auto excess = [&](double zeta) {
    const auto profile = RegularisedProfile::at(layer, zeta, cells);
    if (!profile) {
      reason = profile.reason();
      return 1.0;
    }
    return std::pow(profile->flux() / Q, 0.3) - 1.0;
  };
  const auto exact = slope_of_flux(layer.channel, Q, layer.thickness);
  double low = exact ? *exact : 0.25 * std::numbers::pi, high = low;
  for (double step = 0.005; low > flattest && excess(low) > 0.0; step *= 3.0) low = std::max(flattest, low - step);
  for (double step = 0.005; high < steepest && excess(high) < 0.0; step *= 3.0) high = std::min(steepest, high + step);
  if ((low <= flattest && excess(low) > 0.0) || (high >= steepest && excess(high) < 0.0))
    return Answer<double>::none("no slope between 0.057 and 89.98 degrees carries Q = " + rheology::checks::text(Q) +
                                " kg/s");
  const double zeta = core::bracketed_root(excess, low, high, 1e-10);
  if (std::abs(excess(zeta)) > 1e-6)
    return Answer<double>::none("no steady slope carries Q = " + rheology::checks::text(Q) + " kg/s: " + reason);
  return zeta;
}

}  // namespace talus::steady
