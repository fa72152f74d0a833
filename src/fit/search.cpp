#include "fit/search.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "fit/minimise.hpp"

namespace talus::fit {

namespace {

/// Tries for each start wanted before it is given up.
constexpr int draws_per_start = 50;
/// How far C or q - 1 may end above zero.
constexpr double condition_tolerance = 1e-6;
constexpr int most_rounds = 20;

/// Augmented Lagrangian of the inequalities condition <= 0: rows sqrt(weight) max(0, condition + multiplier/weight).
struct Penalty {
  double weight = 1.0;
  Eigen::VectorXd multiplier;

  void append(const Evaluation& e, Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) const {
    const Eigen::Index n = e.residuals.size(), m = e.conditions.size();
    residuals.conservativeResize(n + m);
    jacobian.conservativeResize(n + m, Eigen::NoChange);
    for (Eigen::Index i = 0; i < m; ++i) {
      const double over = e.conditions[i] + multiplier[i] / weight;
      residuals[n + i] = over > 0.0 ? std::sqrt(weight) * over : 0.0;
      jacobian.row(n + i) = (over > 0.0 ? std::sqrt(weight) : 0.0) * e.conditions_jacobian.row(i);
    }
  }
};

LeastSquares least_squares(const Model& model, const std::vector<bool>& held, const Penalty& penalty) {
  const auto n = static_cast<Eigen::Index>(model.variables().size());
  LeastSquares out{Eigen::VectorXd(n),
                   Eigen::VectorXd(n),
                   held,
                   {},
                   model.n_residuals() + model.n_conditions(),
                   model.n_data(),
                   model.problem().loss,
                   model.problem().loss_scale};
  for (Eigen::Index i = 0; i < n; ++i) {
    out.low[i] = model.variables()[static_cast<std::size_t>(i)].low;
    out.high[i] = model.variables()[static_cast<std::size_t>(i)].high;
  }
  out.evaluate = [&](const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) {
    const auto at = model.at(x);
    if (!at) return false;
    residuals = at->residuals, jacobian = at->jacobian;
    penalty.append(*at, residuals, jacobian);
    return true;
  };
  return out;
}

}  // namespace

std::optional<LocalMinimum> descend(const Model& model, const Eigen::VectorXd& start, const std::vector<bool>& held) {
  Penalty penalty;
  penalty.multiplier = Eigen::VectorXd::Zero(model.n_conditions());
  const auto at_start = model.at(start);
  if (!at_start) return std::nullopt;
  // Stiff enough that the condition is ten times nearer after each round, not so stiff that Newton's steps suffer.
  if (model.n_conditions() > 0)
    penalty.weight = 10.0 * at_start->jacobian.squaredNorm() / at_start->conditions_jacobian.squaredNorm();
  const LeastSquares problem = least_squares(model, held, penalty);
  auto found = minimise(problem, start);
  const bool asked = model.n_conditions() > 0;
  bool kept = !asked;
  for (int round = 0; found && asked; ++round) {
    const auto at = model.at(found->x);
    if (!at) return std::nullopt;
    kept = at->conditions.maxCoeff() <= condition_tolerance;
    if (kept || round == most_rounds) break;
    penalty.multiplier = (penalty.multiplier + penalty.weight * at->conditions).cwiseMax(0.0);
    if (round % 4 == 3) penalty.weight *= 10.0;
    found = minimise(problem, found->x);
  }
  if (!found) return std::nullopt;
  if (!asked) return LocalMinimum{found->x, found->cost, found->converged, true};
  // What the penalty adds to the cost is not the data's: it is taken off.
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  if (!problem.evaluate(found->x, residuals, jacobian)) return std::nullopt;
  return LocalMinimum{found->x, found->cost - 0.5 * residuals.tail(model.n_conditions()).squaredNorm(),
                      found->converged, kept};
}

Starts starting_points(const Model& model) {
  const auto n = static_cast<Eigen::Index>(model.variables().size());
  const int wanted = model.problem().starts;
  Starts out;
  std::mt19937_64 engine(20261126);
  for (int draw = 0; draw < draws_per_start * wanted && static_cast<int>(out.points.size()) < wanted; ++draw) {
    Eigen::VectorXd x(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto& v = model.variables()[static_cast<std::size_t>(i)];
      const double share = static_cast<double>(engine() >> 11) * 0x1p-53;
      x[i] = draw == 0 ? v.start : v.low + share * (v.high - v.low);
    }
    if (const auto at = model.at(x)) {
      out.points.push_back(x);
    } else {
      if (out.infeasible == 0) out.reason = at.reason();
      ++out.infeasible;
    }
  }
  return out;
}

}  // namespace talus::fit
