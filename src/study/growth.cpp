#include "study/growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace talus::study {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_points = 4;
constexpr double least_exponent = 0.5;

struct Line {
  double slope, error;
};

Line line(std::span<const double> t, std::span<const double> y) {
  const auto n = static_cast<double>(t.size());
  double t_mean = 0.0, y_mean = 0.0, tt = 0.0, ty = 0.0, left = 0.0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    t_mean += t[i] / n;
    y_mean += y[i] / n;
  }
  for (std::size_t i = 0; i < t.size(); ++i) {
    tt += (t[i] - t_mean) * (t[i] - t_mean);
    ty += (t[i] - t_mean) * (y[i] - y_mean);
  }
  if (!(tt > 0.0)) return {none, none};
  const double slope = ty / tt;
  for (std::size_t i = 0; i < t.size(); ++i) left += std::pow(y[i] - y_mean - slope * (t[i] - t_mean), 2);
  return {slope, t.size() > 2 ? std::sqrt(left / (n - 2.0) / tt) : none};
}

}  // namespace

GrowthFit fit_growth(std::span<const double> times, std::span<const double> amplitudes, double from, double to) {
  if (times.size() != amplitudes.size())
    throw std::invalid_argument("fit_growth: times and amplitudes differ in number");
  if (!std::ranges::is_sorted(times)) throw std::invalid_argument("fit_growth: times must ascend");
  std::vector<double> t, y;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < from || times[i] > to || !(amplitudes[i] > 0.0)) continue;
    t.push_back(times[i]);
    y.push_back(std::log(amplitudes[i]));
  }
  GrowthFit fit{none, none, from, to, t.size()};
  if (t.size() < fewest_points) return fit;
  const auto all = line(t, y);
  const std::size_t half = t.size() / 2;
  const auto first = line(std::span(t).first(half), std::span(y).first(half));
  const auto last = line(std::span(t).last(t.size() - half), std::span(y).last(t.size() - half));
  fit.rate = all.slope;
  fit.uncertainty = std::max(all.error, 0.5 * std::abs(first.slope - last.slope));
  return fit;
}

std::string_view word_of(GrowthTendency tendency) {
  constexpr std::array<std::string_view, 4> words{"decays", "converges", "blows up", "cannot tell"};
  return words.at(static_cast<std::size_t>(tendency));
}

GrowthVerdict growth_verdict(std::span<const GrowthFit> rates, double ratio) {
  GrowthVerdict verdict{GrowthTendency::cannot_tell, none};
  const std::size_t n = rates.size();
  if (n < 3 || std::ranges::any_of(rates, [](const GrowthFit& fit) { return !std::isfinite(fit.rate); }))
    return verdict;
  const auto last = rates.last(3);
  if (std::ranges::all_of(last, [](const GrowthFit& fit) { return fit.rate > fit.uncertainty; })) {
    const std::array<double, 3> k{0.0, std::log(ratio), 2.0 * std::log(ratio)};
    const std::array<double, 3> y{std::log(last[0].rate), std::log(last[1].rate), std::log(last[2].rate)};
    verdict.exponent = line(k, y).slope;
    if (std::min(y[1] - y[0], y[2] - y[1]) >= least_exponent * std::log(ratio)) {
      verdict.tendency = GrowthTendency::blows_up;
      return verdict;
    }
  }
  if (std::ranges::all_of(rates, [](const GrowthFit& fit) { return fit.rate <= fit.uncertainty; }))
    verdict.tendency = GrowthTendency::decays;
  else if (std::abs(rates[n - 1].rate - rates[n - 2].rate) <= rates[n - 1].uncertainty + rates[n - 2].uncertainty)
    verdict.tendency = GrowthTendency::converges;
  return verdict;
}

}  // namespace talus::study
