#include "study/convergence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace talus::study {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double factor_of_agreement = 1.25, factor_of_doubt = 3.0, orders_agree_within = 0.3;

/// NaN where the differences change their sign or either is nothing.
double order(double before, double now, double ratio) {
  const double share = before / now;
  return share > 0.0 && std::isfinite(share) ? std::log(share) / std::log(ratio) : none;
}

/// Two neighbouring orders that agree, both worth extrapolating by.
bool agree(std::span<const double> orders) {
  if (orders.size() < 2) return false;
  const double last = orders.back(), before = orders[orders.size() - 2];
  return std::abs(last - before) <= orders_agree_within && std::min(last, before) >= least_order;
}

double safety(std::span<const double> orders) { return agree(orders) ? factor_of_agreement : factor_of_doubt; }

/// By how much the last difference is multiplied to reach the limit.
double rest(double p, double ratio) { return 1.0 / (std::pow(ratio, std::min(p, highest_order)) - 1.0); }

Tendency tendency_of(double before, double now, double p, double resolution) {
  if (std::max(std::abs(before), std::abs(now)) <= resolution) return Tendency::settled;
  if (std::abs(now) >= std::abs(before)) return Tendency::divergent;
  if (std::isnan(p)) return Tendency::oscillating;
  return p < least_order ? Tendency::slow : Tendency::convergent;
}

void check(double ratio) {
  if (!(ratio > 1.0)) throw std::invalid_argument("convergence: expected a ratio above 1");
}

}  // namespace

std::string_view word_of(Tendency tendency) {
  constexpr std::array<std::string_view, 6> words{"settled",     "convergent", "slow",
                                                  "oscillating", "divergent",  "unknown"};
  return words.at(static_cast<std::size_t>(tendency));
}

const std::vector<Tendency>& tendencies() {
  static const std::vector<Tendency> all{Tendency::settled,     Tendency::convergent, Tendency::slow,
                                         Tendency::oscillating, Tendency::divergent,  Tendency::unknown};
  return all;
}

Convergence convergence(std::span<const double> values, double ratio, double resolution) {
  check(ratio);
  Convergence result{Tendency::unknown, {}, values.empty() ? none : values.back(), none, none};
  std::vector<double> e;
  for (std::size_t i = 1; i < values.size(); ++i) e.push_back(values[i] - values[i - 1]);
  for (std::size_t i = 1; i < e.size(); ++i) result.orders.push_back(order(e[i - 1], e[i], ratio));
  const bool known = std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
  if (!known || e.size() < 2) return result;

  const double before = e[e.size() - 2], now = e.back(), p = result.orders.back();
  const double larger = std::max(std::abs(before), std::abs(now));
  result.tendency = tendency_of(before, now, p, resolution);
  switch (result.tendency) {
    case Tendency::convergent:
    case Tendency::slow:
      result.value = values.back() + now * rest(p, ratio);
      result.error = std::abs(now) * rest(p, ratio);
      result.uncertainty = safety(result.orders) * result.error;
      break;
    case Tendency::oscillating: result.uncertainty = factor_of_doubt * larger; break;
    case Tendency::settled: result.uncertainty = larger; break;
    case Tendency::divergent:
    case Tendency::unknown: break;
  }
  return result;
}

Convergence convergence_of_differences(std::span<const double> norms, double ratio, double resolution) {
  check(ratio);
  Convergence result{Tendency::unknown, {}, none, none, none};
  for (std::size_t i = 1; i < norms.size(); ++i) result.orders.push_back(order(norms[i - 1], norms[i], ratio));
  const bool known = std::ranges::all_of(norms, [](double v) { return std::isfinite(v); });
  if (!known || norms.size() < 2) return result;
  const double before = norms[norms.size() - 2], now = norms.back(), p = result.orders.back();
  result.tendency = tendency_of(before, now, p, resolution);
  if (result.tendency == Tendency::settled) result.uncertainty = std::max(before, now);
  if (result.tendency != Tendency::convergent && result.tendency != Tendency::slow) return result;
  result.error = now * rest(p, ratio);
  result.uncertainty = safety(result.orders) * result.error;
  return result;
}

}  // namespace talus::study
