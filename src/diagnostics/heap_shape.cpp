#include "diagnostics/heap_shape.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "diagnostics/line_fit.hpp"

namespace talus::diagnostics {

Apex apex(const Surface& surface) {
  const auto& H = surface.H;
  if (H.size() < 3) throw std::invalid_argument("apex: needs three or more columns");
  if (!std::all_of(H.begin(), H.end(), [](double h) { return std::isfinite(h); }))
    throw std::invalid_argument("apex: a height is not finite");
  if (!surface.x.empty() && surface.x.size() != H.size())
    throw std::invalid_argument("apex: heights and centres differ in number");
  const auto top = std::max_element(H.begin(), H.end());
  const auto i = static_cast<std::size_t>(top - H.begin());
  Apex a{static_cast<int>(i), surface.centre(i), *top};
  if (i == 0 || i + 1 == H.size()) return a;
  const double left = a.x - surface.centre(i - 1), right = surface.centre(i + 1) - a.x;
  const double before = (H[i] - H[i - 1]) / left, after = (H[i + 1] - H[i]) / right;
  const double slope = (right * before + left * after) / (left + right), bend = 2.0 * (after - before) / (left + right);
  if (bend < 0.0) {
    a.x -= slope / bend;
    a.H -= 0.5 * slope * slope / bend;
  }
  return a;
}

std::optional<Face> right_face(const Surface& surface, const FaceRule& rule) {
  const Apex top = apex(surface);
  const int n = static_cast<int>(surface.H.size());
  int toe = top.column;
  while (toe < n && surface.H[toe] >= rule.toe * top.H) ++toe;
  const double run = toe - top.column;
  const int first = top.column + static_cast<int>(std::ceil(rule.from * run));
  const int last = std::min(top.column + static_cast<int>(std::floor(rule.to * run)), n - 1);
  if (last - first < 4) return std::nullopt;
  std::vector<double> x;
  for (int i = first; i <= last; ++i) x.push_back(surface.centre(i));
  const LineFit line = fit_line(x, surface.H.subspan(first, last - first + 1));
  return Face{surface.tilt - std::atan(line.slope), line.rms, first, last};
}

Sawtooth sawtooth(const Surface& surface, std::span<const double> top_layer, const SawtoothRule& rule) {
  const auto& H = surface.H;
  if (top_layer.size() != H.size()) throw std::invalid_argument("sawtooth: heights and top layers differ in size");
  const double x_apex = apex(surface).x;
  Sawtooth worst{0.0, -1};
  for (std::size_t i = 1; i + 1 < H.size(); ++i) {
    const bool near_apex = std::abs(surface.centre(i) - x_apex) <= rule.apex_margin;
    if (near_apex || std::min({H[i - 1], H[i], H[i + 1]}) <= rule.film) continue;
    const double share = std::abs(H[i - 1] - 2.0 * H[i] + H[i + 1]) / top_layer[i];
    if (worst.column < 0 || share > worst.share) worst = {share, static_cast<int>(i)};
  }
  return worst;
}

}  // namespace talus::diagnostics
