#include "modes/leading_modes.hpp"

#include <Spectra/GenEigsSolver.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modes/jacobians.hpp"

namespace talus::modes {
namespace {

using Vector = Eigen::VectorXd;
using ComplexVector = Eigen::VectorXcd;

/// A sparse matrix in the order of a pattern.
class Sparse {
 public:
  Sparse(const core::SparsePattern& pattern, const std::vector<double>& values) : pattern_(pattern), values_(values) {}

  template <class V>
  [[nodiscard]] V times(const V& x) const {
    V y = V::Zero(x.size());
    for_each([&](core::Index r, core::Index c, double a) { y[r] += a * x[c]; });
    return y;
  }
  /// |A| |x|.
  [[nodiscard]] Vector sizes(const ComplexVector& x) const {
    Vector y = Vector::Zero(x.size());
    for_each([&](core::Index r, core::Index c, double a) { y[r] += std::abs(a) * std::abs(x[c]); });
    return y;
  }

 private:
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (core::Index c = 0; c < pattern_.n(); ++c)
      for (core::Index e = pattern_.column_starts()[c]; e < pattern_.column_starts()[c + 1]; ++e)
        visit(pattern_.rows()[e], c, values_[e]);
  }
  const core::SparsePattern& pattern_;
  const std::vector<double>& values_;
};

/// What Spectra iterates.
class Inverted {
 public:
  using Scalar = double;
  Inverted(const core::DaeSystem& system, const Jacobians& matrices, double shift, const linear::Settings& settings)
      : n_(system.pattern().n()), mass_(system.pattern(), matrices.mass) {
    std::vector<double> values(matrices.stiffness);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += shift * matrices.mass[i];
    solver_ = linear::make_solver(system.pattern(), settings);
    solver_->factor(values);
  }
  [[nodiscard]] Eigen::Index rows() const { return n_; }
  [[nodiscard]] Eigen::Index cols() const { return n_; }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<Vector> y(out, n_);
    y = mass_.times(Vector(Eigen::Map<const Vector>(in, n_)));
    solver_->solve({out, static_cast<std::size_t>(n_)});
  }

 private:
  Eigen::Index n_;
  Sparse mass_;
  std::unique_ptr<linear::DirectSolver> solver_;
};

/// A vector in which no rate is missing, rid of what belongs to infinite ones by two applications.
Vector start(const Inverted& inverted) {
  Vector x(inverted.rows()), y(inverted.rows());
  std::uint64_t state = 1;
  for (double& value : x) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    value = static_cast<double>(state >> 11U) / 9007199254740992.0 - 0.5;
  }
  inverted.perform_op(x.data(), y.data());
  inverted.perform_op(y.data(), x.data());
  return x.normalized();
}

class Search {
 public:
  Search(const core::DaeSystem& system, double t, std::span<const double> y, const LeadingOptions& options)
      : system_(system),
        options_(options),
        matrices_(jacobians(system, t, y)),
        stiffness_(system.pattern(), matrices_.stiffness),
        mass_(system.pattern(), matrices_.mass) {}

  LeadingModes run() {
    for (const double shift : options_.shifts) about(shift);
    std::ranges::sort(found_.modes, [](const Mode& a, const Mode& b) { return a.rate.real() > b.rate.real(); });
    return std::move(found_);
  }

 private:
  void about(double shift) {
    const auto n = static_cast<int>(system_.pattern().n());
    const int n_modes = std::min(options_.n_modes, n - 2), n_vectors = std::min(options_.n_vectors, n);
    Inverted inverted(system_, matrices_, shift, options_.linear);
    Spectra::GenEigsSolver<Inverted> solver(inverted, n_modes, std::max(n_vectors, std::min(n_modes + 3, n)));
    const Vector first = start(inverted);
    solver.init(first.data());
    const auto n_found =
        static_cast<int>(solver.compute(Spectra::SortRule::LargestMagn, options_.max_restarts, options_.tolerance));
    double radius = 0.0;
    met_.assign(n_known_, false);
    const ComplexVector inverses = solver.eigenvalues();
    const Eigen::MatrixXcd shapes = solver.eigenvectors();
    for (int i = 0; i < n_found; ++i) {
      const Complex rate = shift - 1.0 / inverses[i];
      radius = std::max(radius, std::abs(rate - shift));
      keep(rate, shapes.col(i), std::abs(rate - shift));
    }
    n_known_ = found_.modes.size();
    const bool complete = solver.info() == Spectra::CompInfo::Successful;
    found_.searched.push_back({shift, complete ? radius : 0.0, n_found});
    options_.progress(found_.searched.back());
  }

  /// Of a mode found from two shifts the one that fits its equation better; modes of one rate about one shift are several. `distance`: of the
  /// rate from the shift, whose digits it has.
  void keep(Complex rate, const ComplexVector& v, double distance) {
    constexpr double alike = 1e-6;
    const ComplexVector left = stiffness_.times(v) + rate * mass_.times(v);
    const Vector terms = stiffness_.sizes(v) + std::abs(rate) * mass_.sizes(v);
    Mode mode{rate, std::vector<Complex>(v.begin(), v.end()), left.norm() / terms.norm()};
    for (std::size_t i = 0; i < n_known_; ++i) {
      auto& other = found_.modes[i];
      if (met_[i] || std::abs(other.rate - rate) > alike * distance) continue;
      met_[i] = true;
      if (mode.residual < other.residual) other = std::move(mode);
      return;
    }
    found_.modes.push_back(std::move(mode));
  }

  const core::DaeSystem& system_;
  const LeadingOptions& options_;
  Jacobians matrices_;
  Sparse stiffness_, mass_;
  LeadingModes found_;
  std::size_t n_known_ = 0;  ///< modes found about earlier shifts
  std::vector<bool> met_;    ///< of these, those found again
};

}  // namespace

LeadingModes leading_modes(const core::DaeSystem& system, double t, std::span<const double> y,
                           const LeadingOptions& options) {
  if (options.shifts.empty() || options.n_modes < 1 || options.n_vectors < options.n_modes + 3)
    throw std::invalid_argument("leading modes: expected a shift, a mode and three vectors more than modes");
  return Search(system, t, y, options).run();
}

}  // namespace talus::modes
