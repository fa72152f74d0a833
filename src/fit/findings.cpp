#include "fit/findings.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

#include "core/errors.hpp"
#include "steady/ill_posed_depths.hpp"
#include "steady/slope.hpp"

namespace talus::fit {

namespace {

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
  Report(const Model& model, const Reached& reached)
      : model_(model), reached_(reached), x_(reached.x), at_(reached.at) {}

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
    out.freedom = static_cast<int>(at_.residuals.size()) - out.all.rank;
    if (out.freedom > 0) out.chance = Eigen::numext::igammac(0.5 * out.freedom, 0.5 * out.chi2);
    lump(out);
    for (Eigen::Index i = 0; i < n(); ++i) out.estimates.push_back(estimate(out, i));
    if (at_.conditions.size() > 0) out.worst_condition = at_.conditions.maxCoeff();
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
    return reached_.variables[static_cast<std::size_t>(i)];
  }

  void find_what_is_seen(Fit& out) {
    Eigen::VectorXd scale(n());
    for (Eigen::Index i = 0; i < n(); ++i) {
      const double range = variable(i).high - variable(i).low;
      held_.push_back(std::min(x_[i] - variable(i).low, variable(i).high - x_[i]) < at_bound * range);
      scale[i] = std::abs(x_[i]) > 1e-3 * range ? std::abs(x_[i]) : range;
    }
    Eigen::MatrixXd jacobian = at_.jacobian;
    for (int row = 0; row < reached_.n_data; ++row) jacobian.row(row) *= weight(model_.problem(), at_.residuals[row]);
    out.data = identifiability(jacobian.topRows(reached_.n_data), scale, held_, reached_.noise);
    out.all = identifiability(jacobian, scale, held_, reached_.noise);
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
    const auto error = [&](Eigen::VectorXd gradient) {
      gradient.conservativeResizeLike(Eigen::VectorXd::Zero(n()));  // by what only the layer knows: nil
      return out.all.sees(gradient) ? std::optional(out.all.error(gradient)) : std::nullopt;
    };
    out.predictions.push_back({Q, p->zeta, p->speed, p->I, error(p->zeta_by), error(p->speed_by)});
  }

  const Model& model_;
  const Reached& reached_;
  const Eigen::VectorXd& x_;
  const Evaluation& at_;
  std::vector<bool> held_;
};

}  // namespace

Fit findings(const Model& model, const Reached& reached) { return Report(model, reached).write(); }

}  // namespace talus::fit
