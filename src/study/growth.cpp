#include "study/growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "study/convergence.hpp"

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
  constexpr std::array<std::string_view, 5> words{"decays", "converges", "blows up", "not convergent", "cannot tell"};
  return words.at(static_cast<std::size_t>(tendency));
}

const std::vector<GrowthTendency>& growth_tendencies() {
  using enum GrowthTendency;
  static const std::vector<GrowthTendency> all{decays, converges, blows_up, not_convergent, cannot_tell};
  return all;
}

GrowthVerdict growth_verdict(std::span<const GrowthFit> rates, double ratio) {
  constexpr std::size_t fewest_grids = 3;
  const std::size_t n = rates.size();
  if (n < fewest_grids) return {GrowthTendency::cannot_tell, none, static_cast<int>(fewest_grids - n)};
  if (std::ranges::any_of(rates, [](const GrowthFit& fit) { return !std::isfinite(fit.rate); }))
    return {GrowthTendency::cannot_tell, none, 1};
  const auto grows = [](const GrowthFit& fit) { return fit.rate > fit.uncertainty; };
  if (std::ranges::none_of(rates, grows)) return {GrowthTendency::decays, none};
  const auto last = rates.last(fewest_grids);
  const double before = last[1].rate - last[0].rate, now = last[2].rate - last[1].rate;
  const bool agree = std::abs(now) <= last[1].uncertainty + last[2].uncertainty;
  const bool all_grow = std::ranges::all_of(last, grows);
  GrowthVerdict verdict{GrowthTendency::cannot_tell, none};
  if (all_grow) {
    const std::array<double, 3> k{0.0, std::log(ratio), 2.0 * std::log(ratio)};
    const std::array<double, 3> y{std::log(last[0].rate), std::log(last[1].rate), std::log(last[2].rate)};
    verdict.exponent = line(k, y).slope;
    if (std::min(y[1] - y[0], y[2] - y[1]) >= least_exponent * std::log(ratio)) {
      verdict.tendency = GrowthTendency::blows_up;
      return verdict;
    }
  }
  if (agree || std::abs(now) <= std::abs(before) * std::pow(ratio, -least_order)) {
    verdict.tendency = GrowthTendency::converges;
  } else if (all_grow && std::abs(now) >= std::abs(before)) {
    verdict.tendency = GrowthTendency::not_convergent;
  } else {
    const auto growing = std::ranges::find_if_not(rates.rbegin(), rates.rend(), grows) - rates.rbegin();
    verdict.finer = growing == 0 ? 1 : std::max(1, static_cast<int>(fewest_grids) - static_cast<int>(growing));
  }
  return verdict;
}

}  // namespace talus::study
