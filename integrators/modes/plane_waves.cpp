#include "modes/plane_waves.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modes/jacobians.hpp"

namespace talus::modes {
namespace {

using Matrix = Eigen::MatrixXcd;

/// So many of the fastest growing are refined: next to a rate far from the shift, digits of a slow one are lost.
constexpr std::size_t n_refined = 3;
/// Directions that shrink below this share of the largest are those of constraints, or decay beyond interest.
constexpr double smallest_direction = 1e-8;
/// What leaves more than this share of its equation is no mode, but a constraint's zero, rounded and inverted: before it is refined, and
/// after.
constexpr double largest_residual = 1e-3, largest_refined_residual = 1e-7;
/// Unknowns that have a rate somewhere: the columns of M that are not empty.
std::vector<Eigen::Index> differential(const Matrix& M) {
  std::vector<Eigen::Index> all;
  for (Eigen::Index c = 0; c < M.cols(); ++c)
    if (M.col(c).cwiseAbs().maxCoeff() > 0.0) all.push_back(c);
  return all;
}

/// The stiffest rate that the unknowns with a rate show among each other [1/s].
double stiffest(const Matrix& A, const Matrix& M) {
  const auto unknowns = differential(M);
  double rate = 0.0;
  for (Eigen::Index r = 0; r < M.rows(); ++r) {
    const double inertia = M.row(r).cwiseAbs().sum();
    if (inertia > 0.0) rate = std::max(rate, A(r, unknowns).cwiseAbs().sum() / inertia);
  }
  return rate > 0.0 ? rate : 1.0;
}

double residual(const Matrix& A, const Matrix& M, Complex rate, const Eigen::VectorXcd& v) {
  const double terms = (A.cwiseAbs() * v.cwiseAbs() + std::abs(rate) * (M.cwiseAbs() * v.cwiseAbs())).norm();
  return (A * v + rate * (M * v)).norm() / terms;
}

/// By B = (A + s M)^-1 M, whose eigenvalues are 1/(s - rate), with s the stiffest rate: on the differential unknowns alone, where the zeros
/// of constraints are no defective ones, and there on B's range, which has none.
std::vector<Mode> by_shift(const Matrix& A, const Matrix& M) {
  const double shift = stiffest(A, M);
  const auto unknowns = differential(M);
  const Matrix all = (A + shift * M).partialPivLu().solve(Matrix(M(Eigen::all, unknowns)));
  const Matrix inverted = all(unknowns, Eigen::all);
  Eigen::ColPivHouseholderQR<Matrix> range(inverted);
  range.setThreshold(smallest_direction);
  const Matrix basis = range.householderQ() * Matrix::Identity(inverted.rows(), range.rank());
  const Eigen::ComplexEigenSolver<Matrix> solver(basis.adjoint() * inverted * basis);
  if (solver.info() != Eigen::Success) throw std::runtime_error("plane waves: the eigenvalues were not found");
  std::vector<Mode> modes;
  for (Eigen::Index i = 0; i < range.rank(); ++i) {
    const Complex inverse = solver.eigenvalues()[i];
    const Complex rate = shift - 1.0 / inverse;
    const Eigen::VectorXcd v = (all * (basis * solver.eigenvectors().col(i)) / inverse).normalized();
    const double left = residual(A, M, rate, v);
    if (left < largest_residual) modes.push_back({rate, std::vector<Complex>(v.begin(), v.end()), left});
  }
  return modes;
}

/// Two steps of inverse iteration from beside its rate.
Mode refined(const Matrix& A, const Matrix& M, const Mode& mode) {
  constexpr double beside = 1e-5;
  Eigen::VectorXcd v = Eigen::Map<const Eigen::VectorXcd>(mode.shape.data(), A.rows());
  const Complex shift = mode.rate + beside * (std::abs(mode.rate) + 1e-6 * stiffest(A, M));
  const Eigen::PartialPivLU<Matrix> factors(A + shift * M);
  Complex rate = mode.rate;
  for (int step = 0; step < 2; ++step) {
    const Eigen::VectorXcd next = factors.solve(M * v);
    rate = shift - v.dot(v) / v.dot(next);
    v = next.normalized();
  }
  const double left = residual(A, M, rate, v);
  return left < mode.residual ? Mode{rate, std::vector<Complex>(v.begin(), v.end()), left} : mode;
}

void sort(std::vector<Mode>& modes) {
  std::ranges::sort(modes, [](const Mode& a, const Mode& b) { return a.rate.real() > b.rate.real(); });
}

}  // namespace

PlaneWaves::PlaneWaves(const core::DaeSystem& system, double t, std::span<const double> y, core::Index n_blocks)
    : size_(n_blocks > 0 ? system.layout().size() / n_blocks : 0) {
  const core::Index n = system.layout().size();
  if (n_blocks < 1 || n % n_blocks != 0)
    throw std::invalid_argument("plane waves: the unknowns are not so many blocks");
  const auto [stiffness, mass] = jacobians(system, t, y);
  const auto& pattern = system.pattern();
  const core::Index block = n_blocks / 2;
  const auto add = [&](std::map<int, Eigen::MatrixXd>& parts, int distance, core::Index r, core::Index c,
                       double value) {
    if (value == 0.0) return;
    auto& part = parts[distance];
    if (part.size() == 0) part.setZero(size_, size_);
    part(r, c) += value;
  };
  for (core::Index column = 0; column < n; ++column) {
    for (core::Index e = pattern.column_starts()[column]; e < pattern.column_starts()[column + 1]; ++e) {
      const core::Index row = pattern.rows()[e];
      if (row / size_ != block) continue;
      const int distance = static_cast<int>(column / size_ - block);
      if (2 * std::abs(distance) >= n_blocks - 1)
        throw std::invalid_argument("plane waves: a row reaches halfway round the ring; more blocks are needed");
      add(stiffness_, distance, row % size_, column % size_, stiffness[e]);
      add(mass_, distance, row % size_, column % size_, mass[e]);
    }
  }
}

PlaneWaves::Matrix PlaneWaves::wave(const std::map<int, Eigen::MatrixXd>& parts, double phase) const {
  Matrix sum = Matrix::Zero(size_, size_);
  for (const auto& [distance, part] : parts) sum += std::polar(1.0, phase * distance) * part.cast<Complex>();
  return sum;
}

std::vector<Mode> PlaneWaves::modes(double phase) const {
  const Matrix A = wave(stiffness_, phase), M = wave(mass_, phase);
  auto modes = by_shift(A, M);
  sort(modes);
  for (std::size_t i = 0; i < std::min(n_refined, modes.size());) {
    modes[i] = refined(A, M, modes[i]);
    if (modes[i].residual < largest_refined_residual) ++i;
    else modes.erase(modes.begin() + static_cast<std::ptrdiff_t>(i));
  }
  sort(modes);
  return modes;
}

}  // namespace talus::modes
