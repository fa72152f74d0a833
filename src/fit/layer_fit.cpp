#include <algorithm>
#include <cmath>

#include "core/errors.hpp"
#include "fit/fit.hpp"
#include "fit/minimise.hpp"

namespace talus::fit {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using steady::Answer;

/// A descent ends where chi2 changes by less than twice this, about what the noise between runs does to it; the last step is by Newton's method,
/// so that what is left is far less than an error.
constexpr double small_change = 0.025;

/// Where the first stage ended, or the values stated where that had no data.
VectorXd start_of(const Joint& joint, const std::optional<Fit>& first) {
  VectorXd x(static_cast<Index>(joint.variables().size()));
  for (Index i = 0; i < x.size(); ++i)
    x[i] = first && i < first->x.size() ? first->x[i] : joint.variables()[static_cast<std::size_t>(i)].start;
  return x;
}

Minimum descend(Joint& joint, const Problem& problem, const VectorXd& start) {
  LeastSquares sum{VectorXd(start.size()),
                   VectorXd(start.size()),
                   std::vector<bool>(joint.variables().size(), false),
                   [&](const VectorXd& x, VectorXd& residuals, Eigen::MatrixXd& jacobian) {
                     const auto* point = joint.at(x);
                     if (point == nullptr) return false;
                     residuals = point->evaluation.residuals, jacobian = point->evaluation.jacobian;
                     return true;
                   },
                   joint.n_residuals(),
                   joint.n_data(),
                   problem.loss,
                   problem.loss_scale,
                   small_change,
                   [&] { return joint.used_up(); }};
  for (Index i = 0; i < start.size(); ++i) {
    sum.low[i] = joint.variables()[static_cast<std::size_t>(i)].low;
    sum.high[i] = joint.variables()[static_cast<std::size_t>(i)].high;
  }
  return minimise(sum, start).value();
}

std::vector<std::string> newly_seen(const Fit& fit, const std::vector<Estimate>& before) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < fit.estimates.size(); ++i)
    if (fit.estimates[i].error && (i >= before.size() || !before[i].error))
      out.push_back(fit.estimates[i].variable.name);
  return out;
}

}  // namespace

Answer<Fit> fit(const Problem& problem, const LayerStage& stage, LayerRuns& runs) {
  std::optional<Fit> first;
  Model model(problem);
  if (model.n_data() > 0 && !model.variables().empty()) {
    Problem alone = problem;
    alone.likelihoods = false;  // those of both stages would be others
    alone.predict.clear();
    const auto answer = fit(alone);
    if (!answer) return answer;
    first = *answer;
  }
  Joint joint(model, stage, runs);
  const VectorXd start = start_of(joint, first);
  if (const auto weighed = model.weigh(start.head(static_cast<Index>(model.variables().size()))); !weighed)
    return Answer<Fit>::none("no steady state where the layer's part starts: " + weighed.reason());
  const auto* begin = joint.at(start);
  if (begin == nullptr)
    return Answer<Fit>::none(joint.used_up()
                                 ? "stage_2.evaluations = " + std::to_string(stage.evaluations) +
                                       " does not suffice for one derivative by each unknown"
                                 : "the values that the layer starts from have no steady state: " +
                                       model.at(start.head(static_cast<Index>(model.variables().size()))).reason());
  if (begin->model.size() == 0)
    return Answer<Fit>::none("the first run of the layer failed: " + joint.failures().front());
  const auto minimum = descend(joint, problem, start);
  const auto* best = joint.at(minimum.x);
  const double noise = joint.noise(*best);
  Fit out = findings(model, {joint.variables(), best->x, best->evaluation, joint.n_data(), noise / stage.step});
  const auto& before = first ? first->estimates : std::vector<Estimate>{};
  out.layer = LayerFindings{stage,
                            best->model,
                            before,
                            begin->evaluation.residuals.squaredNorm(),
                            joint.n_runs(),
                            joint.failures(),
                            minimum.converged,
                            noise / std::sqrt(static_cast<double>(stage.data.size())),
                            newly_seen(out, before)};
  if (first) out.starts = first->starts, out.infeasible_draws = first->infeasible_draws;
  return out;
}

}  // namespace talus::fit
