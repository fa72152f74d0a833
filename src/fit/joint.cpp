#include "fit/joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace talus::fit {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What each datum of the layer counts [standard deviations] where its run failed: far more than where it did not.
constexpr double penalty = 1000.0;
/// A change of all parameters by this share moves no datum; what moves is noise.
constexpr double nudge = 1e-6;

std::string in_words(const std::vector<Variable>& variables, const std::vector<Index>& varied, const VectorXd& x) {
  std::ostringstream out;
  for (const Index i : varied)
    out << (out.tellp() > 0 ? ", " : "") << variables[static_cast<std::size_t>(i)].name << " = " << x[i];
  return out.str();
}

}  // namespace

Joint::Joint(const Model& steady, const LayerStage& stage, LayerRuns& runs)
    : steady_(steady), stage_(stage), runs_(runs), variables_(steady.variables()) {
  for (std::size_t i = 0; i < steady.problem().unknowns.size(); ++i) varied_.push_back(static_cast<Index>(i));
  for (const auto& u : stage.unknowns) {
    varied_.push_back(static_cast<Index>(variables_.size()));
    variables_.push_back({u.key, u.unit, u.start, u.low, u.high});
  }
}

int Joint::n_residuals() const {
  return steady_.n_residuals() + n_layer() +
         static_cast<int>(std::ranges::count_if(stage_.unknowns, [](const auto& u) { return u.prior.has_value(); }));
}

VectorXd Joint::residuals(const VectorXd& model) const {
  VectorXd out(n_layer());
  for (Index i = 0; i < out.size(); ++i) {
    const auto& datum = stage_.data[static_cast<std::size_t>(i)];
    out[i] = (model[i] - datum.value) / datum.error;
  }
  return out;
}

/// Away from the nearer bound where the step would cross it.
double Joint::shift(const VectorXd& x, Index variable) const {
  const auto& v = variables_[static_cast<std::size_t>(variable)];
  const double step = std::min(stage_.step * std::abs(x[variable]), 0.5 * (v.high - v.low));
  return x[variable] + step <= v.high ? step : -step;
}

Joint::Answers Joint::run(const std::vector<VectorXd>& all_x) {
  std::vector<VectorXd> points;
  for (const auto& x : all_x) points.push_back(x(varied_));
  auto answers = runs_.at(points);
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (!answers[i])
      failures_.push_back("run " + std::to_string(n_runs_ + static_cast<int>(i) + 1) + ", " +
                          in_words(variables_, varied_, all_x[i]) + ": " + answers[i].reason());
  n_runs_ += static_cast<int>(answers.size());
  return answers;
}

/// All but the layer's own rows.
Evaluation Joint::around(const Evaluation& steady, const VectorXd& x) const {
  const auto n = static_cast<Index>(variables_.size());
  const Index n_steady = steady_.n_data(), n_steady_variables = steady.jacobian.cols();
  Evaluation out{VectorXd::Zero(n_residuals()), Eigen::MatrixXd::Zero(n_residuals(), n), steady.conditions,
                 steady.conditions_jacobian};
  const Index n_priors = steady.residuals.size() - n_steady;
  out.residuals.head(n_steady) = steady.residuals.head(n_steady);
  out.residuals.segment(n_data(), n_priors) = steady.residuals.tail(n_priors);
  out.jacobian.topLeftCorner(n_steady, n_steady_variables) = steady.jacobian.topRows(n_steady);
  out.jacobian.block(n_data(), 0, n_priors, n_steady_variables) = steady.jacobian.bottomRows(n_priors);
  Index row = n_data() + n_priors;
  for (std::size_t i = 0; i < stage_.unknowns.size(); ++i) {
    const auto& prior = stage_.unknowns[i].prior;
    if (!prior) continue;
    const Index column = n_steady_variables + static_cast<Index>(i);
    out.residuals[row] = (x[column] - prior->value) / prior->error;
    out.jacobian(row++, column) = 1.0 / prior->error;
  }
  return out;
}

/// `answers` are of the point, and of one shifted point a variable. One that failed is tried on the other side; a variable with
/// none on either is left where it is, its derivatives zero.
void Joint::put_layer(Point& point, const Answers& answers, const std::vector<VectorXd>& all_x) {
  const Index first = steady_.n_data();
  auto& [x, evaluation, model] = point;
  if (!answers.front()) {
    evaluation.residuals.segment(first, n_layer()).setConstant(penalty);
    return;
  }
  model = *answers.front();
  const VectorXd base = residuals(model);
  evaluation.residuals.segment(first, n_layer()) = base;
  std::vector<Index> again;
  const auto put = [&](Index column, const VectorXd& shifted, double by) {
    evaluation.jacobian.col(column).segment(first, n_layer()) = (residuals(shifted) - base) / by;
  };
  for (std::size_t k = 0; k < varied_.size(); ++k) {
    const Index column = varied_[k];
    if (answers[k + 1]) put(column, *answers[k + 1], all_x[k + 1][column] - x[column]);
    else again.push_back(column);
  }
  std::vector<VectorXd> other_side;
  for (const Index column : again) {
    other_side.push_back(x);
    other_side.back()[column] -= shift(x, column);
  }
  if (again.empty() || n_runs_ + static_cast<int>(again.size()) >= stage_.evaluations) return;
  const auto others = run(other_side);
  for (std::size_t k = 0; k < again.size(); ++k)
    if (others[k]) put(again[k], *others[k], other_side[k][again[k]] - x[again[k]]);
}

/// Fractions of the way between bounds round where they are taken and put back.
bool Joint::is_same(const VectorXd& a, const VectorXd& b) const {
  for (Index i = 0; i < a.size(); ++i) {
    const auto& v = variables_[static_cast<std::size_t>(i)];
    if (std::abs(a[i] - b[i]) > 1e-12 * (v.high - v.low)) return false;
  }
  return true;
}

const Joint::Point* Joint::at(const VectorXd& x) {
  const auto known = std::ranges::find_if(known_, [&](const Point& p) { return is_same(p.x, x); });
  if (known != known_.end()) return &*known;
  const auto steady = steady_.at(x.head(static_cast<Index>(steady_.variables().size())));
  if (!steady) return nullptr;
  std::vector<VectorXd> all_x(varied_.size() + 1, x);
  for (std::size_t k = 0; k < varied_.size(); ++k) all_x[k + 1][varied_[k]] += shift(x, varied_[k]);
  // One run is kept for the noise.
  if (n_runs_ + static_cast<int>(all_x.size()) >= stage_.evaluations) {
    used_up_ = true;
    return nullptr;
  }
  const auto answers = run(all_x);
  Point point{x, around(*steady, x), {}};
  put_layer(point, answers, all_x);
  runs_.told(n_runs_, all_x.front()(varied_),
             answers.front() ? point.evaluation.residuals.squaredNorm() : std::numeric_limits<double>::infinity());
  known_.push_back(std::move(point));
  return &known_.back();
}

double Joint::noise(const Point& point) {
  VectorXd x = point.x;
  for (const Index i : varied_) x[i] += nudge * shift(x, i) / stage_.step;
  const auto answers = run({x});
  if (!answers.front()) return std::numeric_limits<double>::infinity();
  return (residuals(*answers.front()) - residuals(point.model)).norm();
}

}  // namespace talus::fit
