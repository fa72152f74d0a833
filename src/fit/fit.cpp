#include "fit/fit.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

#include "core/errors.hpp"
#include "fit/search.hpp"
#include "steady/ill_posed_depths.hpp"
#include "steady/slope.hpp"

namespace talus::fit {

namespace {

using steady::Answer;

/// Closer to a bound than this share of its range a variable counts as being there.
constexpr double at_bound = 1e-7;

Eigen::VectorXd unit(Eigen::Index n, Eigen::Index i) { return Eigen::VectorXd::Unit(n, i); }

/// What a row counts under the loss: the square root of d rho/d r^2.
double weight(const Problem& problem, double residual) {
  const double r = std::abs(residual) / problem.loss_scale;
  if (problem.loss == Loss::huber) return r > 1.0 ? std::sqrt(1.0 / r) : 1.0;
  return problem.loss == Loss::cauchy ? std::sqrt(1.0 / (1.0 + r * r)) : 1.0;
}

class Report {
 public:
  Report(const Model& model, const LocalMinimum& best) : model_(model), x_(best.x), at_(model.at(best.x).value()) {}

  Fit write() {
    const auto& problem = model_.problem();
    Fit out{.best = model_.channel(x_),
            .x = x_,
            .estimates = {},
            .residuals = at_.residuals,
            .slope_sigma = model_.slope_sigma(),
            .chi2 = at_.residuals.squaredNorm(),
            .freedom = 0,
            .chance = 1.0,
            .data = {},
            .all = {},
            .lumps = {},
            .margins = {},
            .predictions = {},
            .starts = {}};
    find_what_is_seen(out);
    out.freedom = model_.n_residuals() - out.all.rank;
    if (out.freedom > 0) out.chance = Eigen::numext::igammac(0.5 * out.freedom, 0.5 * out.chi2);
    lump(out);
    for (Eigen::Index i = 0; i < n(); ++i) out.estimates.push_back(estimate(out, i));
    if (model_.n_conditions() > 0) out.worst_condition = at_.conditions.maxCoeff();
    const auto bounds = steady::posedness_bounds(out.best.channel.law);
    for (const auto& point : problem.slopes)
      out.margins.push_back(margin(point.place, *steady::flow_of_flux(out.best.channel, point.Q), bounds));
    for (const auto& profile : problem.profiles) {
      const auto flow = profile.Q ? steady::flow_of_flux(out.best.channel, *profile.Q)
                                  : steady::UniformFlow::at(out.best.channel, *profile.zeta);
      out.margins.push_back(margin(profile.name, *flow, bounds));
    }
    for (const double Q : problem.predict) predict(out, Q);
    return out;
  }

 private:
  [[nodiscard]] Eigen::Index n() const { return x_.size(); }
  [[nodiscard]] const Variable& variable(Eigen::Index i) const {
    return model_.variables()[static_cast<std::size_t>(i)];
  }

  void find_what_is_seen(Fit& out) {
    Eigen::VectorXd scale(n());
    for (Eigen::Index i = 0; i < n(); ++i) {
      const double range = variable(i).high - variable(i).low;
      held_.push_back(std::min(x_[i] - variable(i).low, variable(i).high - x_[i]) < at_bound * range);
      scale[i] = std::abs(x_[i]) > 1e-3 * range ? std::abs(x_[i]) : range;
    }
    Eigen::MatrixXd jacobian = at_.jacobian;
    for (int row = 0; row < model_.n_data(); ++row) jacobian.row(row) *= weight(model_.problem(), at_.residuals[row]);
    out.data = identifiability(jacobian.topRows(model_.n_data()), scale, held_);
    out.all = identifiability(jacobian, scale, held_);
  }

  /// Lumps that the data fix, where not all of their factors are fixed and no simpler lumps explain it.
  void lump(Fit& out) const {
    const auto& unknowns = model_.problem().unknowns;
    std::vector<Eigen::VectorXd> explained;
    const auto rest_of = [&](Eigen::VectorXd power) {
      for (const auto& e : explained) power -= e.dot(power) * e;
      return power;
    };
    for (Eigen::Index i = 0; i < n(); ++i)
      if (held_[static_cast<std::size_t>(i)] || out.data.sees(unit(n(), i))) explained.push_back(unit(n(), i));
    const auto parameters = out.best.values();
    for (const auto& candidate : lumps(out.best)) {
      Eigen::VectorXd power = Eigen::VectorXd::Zero(n()), gradient = Eigen::VectorXd::Zero(n());
      const double value = value_of(candidate, parameters);
      LumpEstimate found{candidate, value, 0.0, {}};
      for (std::size_t k = 0; k < unknowns.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        power[i] = candidate.power[static_cast<std::size_t>(unknowns[k].parameter)];
        if (power[i] == 0.0 || x_[i] == 0.0 || held_[k]) continue;
        gradient[i] = value * power[i] / x_[i];
        found.of.push_back(variable(i).name);
      }
      const Eigen::VectorXd rest = rest_of(power);
      if (rest.norm() < 1e-6 || !out.data.sees(gradient)) continue;
      explained.push_back(rest.normalized());
      found.error = out.all.error(gradient);
      out.lumps.push_back(found);
    }
  }

  [[nodiscard]] Estimate estimate(const Fit& out, Eigen::Index i) const {
    const Variable& v = variable(i);
    Estimate e{v, x_[i], {}, "", false, {}, {}};
    if (held_[static_cast<std::size_t>(i)]) {
      e.why_no_error = x_[i] - v.low < v.high - x_[i] ? "at its lower bound" : "at its upper bound";
    } else if (!out.all.sees(unit(n(), i))) {
      e.why_no_error = "the data do not fix it";
      for (const auto& lump : out.lumps)
        if (std::ranges::find(lump.of, v.name) != lump.of.end()) {
          e.why_no_error += ", only " + lump.lump.name + " = " + lump.lump.formula;
          break;
        }
    } else if (const double error = out.all.error(unit(n(), i)); error > 0.5 * (v.high - v.low)) {
      e.why_no_error = "the data leave it anywhere between its bounds";
    } else {
      e.error = error;
      e.from_prior = !out.data.sees(unit(n(), i));
    }
    return e;
  }

  static Margin margin(const std::string& place, const steady::UniformFlow& flow,
                       const steady::PosednessBounds& bounds) {
    const auto depths = steady::ill_posed_depths(flow, bounds);
    return {place, flow.inertial_number(0.0), depths.C_surface, depths.q_surface, depths.C_margin, depths.q_margin};
  }

  void predict(Fit& out, double Q) const {
    const auto p = model_.predict(x_, Q);
    if (!p) throw core::Error(core::ExitCode::solver, "fit: nothing to predict at this flow: " + p.reason());
    const auto error = [&](const Eigen::VectorXd& gradient) {
      return out.all.sees(gradient) ? std::optional(out.all.error(gradient)) : std::nullopt;
    };
    out.predictions.push_back({Q, p->zeta, p->speed, p->I, error(p->zeta_by), error(p->speed_by)});
  }

  const Model& model_;
  Eigen::VectorXd x_;
  Evaluation at_;
  std::vector<bool> held_;
};

/// How the sum of squares rises when one variable is held to either side of its best value.
void add_profile(const Model& model, const LocalMinimum& best, Estimate& estimate, Eigen::Index i) {
  if (!estimate.error) return;
  std::vector<bool> held(model.variables().size(), false);
  held[static_cast<std::size_t>(i)] = true;
  std::vector<std::pair<double, double>> points{{estimate.value, 0.0}};
  for (const double side : {-1.0, 1.0}) {
    Eigen::VectorXd from = best.x;
    for (int step = 1; step <= 4; ++step) {
      from[i] = estimate.value + side * 0.75 * step * *estimate.error;
      if (from[i] < estimate.variable.low || from[i] > estimate.variable.high) break;
      const auto found = descend(model, from, held);
      if (!found) break;
      from = found->x;
      points.emplace_back(from[i], 2.0 * (found->cost - best.cost));
    }
  }
  std::ranges::sort(points);
  for (const auto& [at, rise] : points) estimate.profile_at.push_back(at), estimate.profile_rise.push_back(rise);
}

}  // namespace

Answer<Fit> fit(const Problem& problem) {
  Model model(problem);
  const std::vector<bool> none_held(model.variables().size(), false);
  const Starts starts = starting_points(model);
  if (starts.points.empty())
    return Answer<Fit>::none(
        "the data reject the " + std::string(rheology::name(problem.varied.channel.law)) + " law: in none of " +
        std::to_string(starts.infeasible) +
        " parameter sets between the bounds has it a steady state at every flow measured; the first: " + starts.reason);
  const bool flows_uncertain = std::ranges::any_of(problem.slopes, [](const auto& p) { return p.Q_error > 0.0; });
  if (flows_uncertain) model.weigh(starts.points.front());
  std::optional<LocalMinimum> best;
  std::vector<Start> reached;
  bool all_ill_posed = true;
  for (const auto& point : starts.points) {
    const auto found = descend(model, point, none_held);
    if (!found) continue;
    reached.push_back({point, found->x, 2.0 * found->cost, found->converged});
    all_ill_posed = all_ill_posed && !found->well_posed;
    if (found->converged && found->well_posed && (!best || found->cost < best->cost)) best = found;
  }
  if (!best && all_ill_posed)
    return Answer<Fit>::none(
        "none of " + std::to_string(reached.size()) + " starts came to parameters between the bounds that keep " +
        (problem.condition == Condition::C ? "C <= 0" : "q <= 1") + " at the surface of every flow measured");
  if (!best)
    throw core::Error(core::ExitCode::solver, "fit: none of " + std::to_string(reached.size()) +
                                                  " starts converged; expected fewer unknowns, or closer bounds");
  for (int round = 0; flows_uncertain && round < 20 && model.weigh(best->x) > 1e-6; ++round)
    best = descend(model, best->x, none_held);
  Fit out = Report(model, *best).write();
  for (std::size_t i = 0; problem.likelihoods && i < out.estimates.size(); ++i)
    add_profile(model, *best, out.estimates[i], static_cast<Eigen::Index>(i));
  out.starts = std::move(reached);
  out.infeasible_draws = starts.infeasible;
  return out;
}

}  // namespace talus::fit
