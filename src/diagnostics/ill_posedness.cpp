#include "diagnostics/ill_posedness.hpp"

#include <stdexcept>

#include "rheology/well_posedness.hpp"

namespace talus::diagnostics {

IllPosedness ill_posedness(const rheology::Law& law, std::span<const double> I, std::span<const double> area) {
  if (I.size() != area.size()) throw std::invalid_argument("ill_posedness: inertial numbers and areas differ in size");
  IllPosedness sum{0.0, 0.0, 0.0};
  double total = 0.0;
  for (std::size_t i = 0; i < I.size(); ++i) {
    if (!(area[i] > 0.0)) continue;
    if (!(I[i] >= 0.0)) throw std::invalid_argument("ill_posedness: an inertial number is negative or not a number");
    const auto r = rheology::response(law, I[i]);
    total += area[i];
    if (rheology::condition_C(r) > 0.0) sum.C_positive += area[i];
    if (rheology::max_growth(r) > 0.0) sum.growing += area[i];
    if (r.q >= 1.0) sum.not_elliptic += area[i];
  }
  if (total == 0.0) return sum;
  return {sum.C_positive / total, sum.growing / total, sum.not_elliptic / total};
}

}  // namespace talus::diagnostics
