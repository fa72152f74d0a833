#include "rheology/neutral_points.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/polynomial.hpp"
#include "rheology/well_posedness.hpp"

namespace talus::rheology {

namespace {

using core::Polynomial;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The rational branch in x = I/I_0: mu = n/d, nu = (n d - b)/(n d), q = a/(2 d^2), with m = mu_inf I_0.
struct Rational {
  Polynomial n, d{1.0L, 1.0L}, a, b, log_slope;
  double I_0;

  Rational(long double mu_s, long double mu_d, long double mu_inf, double scale)
      : n{mu_s, mu_d, mu_inf * scale},
        a{2.0L * mu_s, 3.0L * mu_s + mu_d, 2.0L * mu_d, mu_inf * scale},
        b{mu_s, 2.0L * mu_s, mu_d - mu_inf * scale},
        log_slope{0.0L, mu_d - mu_s, 2.0L * mu_inf * scale, mu_inf * scale},
        I_0(scale) {}

  /// 4 n^2 d^4 C.
  [[nodiscard]] Polynomial condition() const { return n * n * a * a - Polynomial{16.0L} * d * d * log_slope * b; }
  /// 2 d^2 (q - 1).
  [[nodiscard]] Polynomial ellipticity() const { return a - Polynomial{2.0L} * d * d; }
};

/// The creep branch in y = 1/ln(A/I): nu = y/2, mu = sqrt(alpha y), q = mu (1 - y/4).
struct Creep {
  long double alpha;

  /// 2 C/y.
  [[nodiscard]] Polynomial condition() const { return {2.0L * alpha - 4.0L, 2.0L - alpha, 0.125L * alpha}; }
  /// In sqrt(y): q - sign.
  [[nodiscard]] Polynomial ellipticity(long double sign) const {
    const long double root = std::sqrt(alpha);
    return {-sign, root, 0.0L, -0.25L * root};
  }
};

void add_rational(std::vector<BranchPoint>& points, const Rational& branch, const Polynomial& p, double from) {
  for (const double x : core::positive_roots(p)) {
    const double I = x * branch.I_0;
    points.push_back({I, Branch::rational, I > from});
  }
}

/// Points of creep from y; those beyond doubles are left out.
void add_creep(std::vector<BranchPoint>& points, const PartiallyRegularised& law, const std::vector<double>& ys) {
  for (const double y : ys) {
    const double I = law.I_N * std::exp(law.folds_N - 1.0 / y);
    if (I > PartiallyRegularised::tiny_I && I < infinity) points.push_back({I, Branch::creep, I <= law.I_N});
  }
}

std::vector<BranchPoint> ascending(std::vector<BranchPoint> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.I < b.I; });
  return points;
}

Rational rational_of(const Classical& law) { return {law.mu_s, law.mu_d, 0.0L, law.I_0}; }
Rational rational_of(const PartiallyRegularised& law) { return {law.mu_s, law.mu_d, law.mu_inf, law.I_0}; }

using Condition = std::function<bool(const Response&)>;

bool is_outside_condition(const Response& r) { return condition_C(r) > 0.0; }
bool is_not_elliptic(const Response& r) { return std::abs(r.q) > 1.0; }
bool is_ill_posed(const Response& r) { return well_posedness(r) == WellPosedness::ill_posed; }

/// Pieces of I >= 0 on which a property of the law cannot change, in ascending order, with that property.
struct Piece {
  Range range;
  bool property;
};
std::vector<Piece> pieces(const Law& law, const Condition& property) {
  std::vector<double> ends;
  for (const auto& points : {branch_neutral_points(law), branch_ellipticity_bounds(law)})
    for (const auto& point : points)
      if (point.relevant) ends.push_back(point.I);
  if (const auto* partial = std::get_if<PartiallyRegularised>(&law)) ends.push_back(partial->I_N);
  std::sort(ends.begin(), ends.end());
  ends.push_back(infinity);
  std::vector<Piece> found;
  double from = 0.0;
  for (const double to : ends) {
    if (!(to > from)) continue;
    const double inside = from == 0.0 ? (to == infinity ? 1.0 : 0.5 * to)
                                      : (to == infinity ? 2.0 * from : std::sqrt(from) * std::sqrt(to));
    const bool now = property(response(law, inside));
    if (!found.empty() && found.back().property == now) found.back().range.to = to;
    else found.push_back({{from, to}, now});
    from = to;
  }
  return found;
}

std::vector<double> changes(const Law& law, const Condition& property) {
  std::vector<double> points;
  for (const auto& piece : pieces(law, property))
    if (piece.range.from > 0.0) points.push_back(piece.range.from);
  return points;
}

std::vector<Range> without(const Law& law, const Condition& property) {
  std::vector<Range> ranges;
  for (const auto& piece : pieces(law, property))
    if (!piece.property) ranges.push_back(piece.range);
  return ranges;
}

}  // namespace

std::vector<BranchPoint> branch_neutral_points(const Law& law) {
  std::vector<BranchPoint> points;
  if (const auto* classical = std::get_if<Classical>(&law)) {
    const Rational branch = rational_of(*classical);
    add_rational(points, branch, branch.condition(), 0.0);
  } else if (const auto* partial = std::get_if<PartiallyRegularised>(&law)) {
    const Rational branch = rational_of(*partial);
    add_rational(points, branch, branch.condition(), partial->I_N);
    add_creep(points, *partial, core::positive_roots(Creep{partial->alpha}.condition()));
  }
  return ascending(std::move(points));
}

std::vector<BranchPoint> branch_ellipticity_bounds(const Law& law) {
  std::vector<BranchPoint> points;
  if (const auto* classical = std::get_if<Classical>(&law)) {
    const Rational branch = rational_of(*classical);
    add_rational(points, branch, branch.ellipticity(), 0.0);
  } else if (const auto* partial = std::get_if<PartiallyRegularised>(&law)) {
    const Rational branch = rational_of(*partial);
    add_rational(points, branch, branch.ellipticity(), partial->I_N);
    for (const long double sign : {1.0L, -1.0L}) {
      auto ys = core::positive_roots(Creep{partial->alpha}.ellipticity(sign));
      for (double& y : ys) y *= y;
      add_creep(points, *partial, ys);
    }
  }
  return ascending(std::move(points));
}

std::vector<double> neutral_points(const Law& law) { return changes(law, is_outside_condition); }
std::vector<double> ellipticity_bounds(const Law& law) { return changes(law, is_not_elliptic); }
std::vector<Range> ranges_of_condition(const Law& law) { return without(law, is_outside_condition); }
std::vector<Range> ranges_of_damping(const Law& law) { return without(law, is_ill_posed); }

}  // namespace talus::rheology
