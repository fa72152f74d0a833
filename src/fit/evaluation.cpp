#include "fit/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/errors.hpp"
#include "steady/slope.hpp"

namespace talus::fit {

namespace {

using steady::Answer;
using steady::Sensitivity;
using steady::UniformFlow;

/// A flow measured, and how its flux depends on everything.
struct State {
  UniformFlow flow;
  std::optional<Sensitivity> flux;  ///< where the flux is what is known of it

  [[nodiscard]] Sensitivity total(const Sensitivity& s) const { return flux ? steady::at_fixed_flux(s, *flux) : s; }
};

/// `tangent`: a guess of tan zeta, replaced by what was found.
Answer<State> state_of(const steady::VariedChannel& varied, std::optional<double> Q, std::optional<double> zeta,
                       std::optional<double>& tangent) {
  if (!Q) {
    const auto flow = UniformFlow::at(varied.channel, *zeta);
    return flow ? Answer<State>(State{*flow, {}}) : Answer<State>::none(flow.reason());
  }
  const auto found = steady::flow_near(varied, *Q, tangent);
  if (!found) return Answer<State>::none(found.reason());
  tangent = found->flow.tan_zeta();
  return State{found->flow, found->flux};
}

Sensitivity tan_zeta(const UniformFlow& flow) { return {flow.tan_zeta(), {}, 1.0}; }

/// dzeta/dtan zeta.
double to_angle(const UniformFlow& flow) { return 1.0 / (1.0 + flow.tan_zeta() * flow.tan_zeta()); }

}  // namespace

Model::Model(Problem problem) : problem_(std::move(problem)) {
  for (const auto& u : problem_.unknowns) {
    const auto i = static_cast<std::size_t>(u.parameter);
    variables_.push_back(
        {std::string(steady::parameter_names[i]), std::string(steady::parameter_units[i]), u.start, u.low, u.high});
  }
  for (const auto& profile : problem_.profiles) {
    offset_of_.push_back(profile.offset_limit > 0.0 ? static_cast<int>(variables_.size()) : -1);
    if (profile.offset_limit > 0.0)
      variables_.push_back({"offset of " + profile.name, "m", 0.0, -profile.offset_limit, profile.offset_limit});
  }
  for (const auto& point : problem_.slopes) slope_sigma_.push_back(point.zeta_error);
  tangents_.resize(problem_.slopes.size() + problem_.profiles.size());
  n_data_ = static_cast<int>(problem_.slopes.size());
  for (const auto& profile : problem_.profiles) n_data_ += static_cast<int>(profile.depth.size());
}

int Model::n_residuals() const {
  return n_data_ +
         static_cast<int>(std::ranges::count_if(problem_.unknowns, [](auto& u) { return u.prior.has_value(); }));
}

int Model::n_conditions() const {
  return problem_.condition == Condition::report ? 0
                                                 : static_cast<int>(problem_.slopes.size() + problem_.profiles.size());
}

steady::VariedChannel Model::channel(const Eigen::VectorXd& x) const {
  auto values = problem_.varied.values();
  for (std::size_t i = 0; i < problem_.unknowns.size(); ++i)
    values[static_cast<std::size_t>(problem_.unknowns[i].parameter)] = x[static_cast<Eigen::Index>(i)];
  return problem_.varied.with(values);
}

Eigen::RowVectorXd Model::by_variables(const Sensitivity& s, double factor) const {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(variables_.size()));
  for (std::size_t i = 0; i < problem_.unknowns.size(); ++i)
    row[static_cast<Eigen::Index>(i)] = factor * s.by[static_cast<std::size_t>(problem_.unknowns[i].parameter)];
  return row;
}

Answer<Evaluation> Model::at(const Eigen::VectorXd& x) const {
  const auto n = static_cast<Eigen::Index>(variables_.size());
  Evaluation out{Eigen::VectorXd(n_residuals()), Eigen::MatrixXd::Zero(n_residuals(), n),
                 Eigen::VectorXd(n_conditions()), Eigen::MatrixXd::Zero(n_conditions(), n)};
  Eigen::Index row = 0, condition = 0;
  const auto put = [&](double residual, const Eigen::RowVectorXd& by) {
    out.residuals[row] = residual;
    out.jacobian.row(row++) = by;
  };
  try {
    const auto varied = channel(x);
    const auto put_condition = [&](const State& state) {
      if (problem_.condition == Condition::report) return;
      const bool C = problem_.condition == Condition::C;
      const auto s = state.total(C ? steady::surface_C(varied, state.flow) : steady::surface_q(varied, state.flow));
      out.conditions[condition] = C ? s.value : s.value - 1.0;
      out.conditions_jacobian.row(condition++) = by_variables(s, 1.0);
    };
    for (std::size_t i = 0; i < problem_.slopes.size(); ++i) {
      const auto& point = problem_.slopes[i];
      const auto state = state_of(varied, point.Q, {}, tangents_[i]);
      if (!state) return Answer<Evaluation>::none(point.place + ": " + state.reason());
      const auto s = state->total(tan_zeta(state->flow));
      put((state->flow.zeta() - point.zeta) / slope_sigma_[i],
          by_variables(s, to_angle(state->flow) / slope_sigma_[i]));
      put_condition(*state);
    }
    for (std::size_t k = 0; k < problem_.profiles.size(); ++k) {
      const auto& profile = problem_.profiles[k];
      const auto state = state_of(varied, profile.Q, profile.zeta, tangents_[problem_.slopes.size() + k]);
      if (!state) return Answer<Evaluation>::none(profile.name + ": " + state.reason());
      const double offset = offset_of_[k] < 0 ? 0.0 : x[offset_of_[k]];
      for (std::size_t i = 0; i < profile.depth.size(); ++i) {
        const double depth = std::max(profile.depth[i] + offset, 0.0);
        const auto s = state->total(steady::speed_sensitivity(varied, state->flow, depth));
        auto by = by_variables(s, 1.0 / profile.error[i]);
        if (offset_of_[k] >= 0) by[offset_of_[k]] = s.by_depth / profile.error[i];
        put((s.value - profile.speed[i]) / profile.error[i], by);
      }
      put_condition(*state);
    }
  } catch (const std::invalid_argument& error) {
    return Answer<Evaluation>::none(error.what());
  } catch (const core::Error& error) {  // within rounding of the law's steepest slope
    return Answer<Evaluation>::none(error.what());
  } catch (const std::domain_error& error) {  // of a search for a root
    return Answer<Evaluation>::none(error.what());
  }
  for (std::size_t i = 0; i < problem_.unknowns.size(); ++i) {
    const auto& prior = problem_.unknowns[i].prior;
    if (!prior) continue;
    Eigen::RowVectorXd by = Eigen::RowVectorXd::Zero(n);
    by[static_cast<Eigen::Index>(i)] = 1.0 / prior->error;
    put((x[static_cast<Eigen::Index>(i)] - prior->value) / prior->error, by);
  }
  return out;
}

Answer<Model::Prediction> Model::predict(const Eigen::VectorXd& x, double Q) const {
  const auto varied = channel(x);
  std::optional<double> no_guess;
  const auto state = state_of(varied, Q, {}, no_guess);
  if (!state) return Answer<Prediction>::none(state.reason());
  const auto speed = state->total(steady::speed_sensitivity(varied, state->flow, 0.0));
  return Prediction{state->flow.zeta(), speed.value, state->flow.inertial_number(0.0),
                    by_variables(state->total(tan_zeta(state->flow)), to_angle(state->flow)), by_variables(speed, 1.0)};
}

Answer<double> Model::weigh(const Eigen::VectorXd& x) {
  auto sigma = slope_sigma_;
  double change = 0.0;
  try {
    const auto varied = channel(x);
    for (std::size_t i = 0; i < problem_.slopes.size(); ++i) {
      const auto& point = problem_.slopes[i];
      const auto state = state_of(varied, point.Q, {}, tangents_[i]);
      if (!state) return Answer<double>::none(point.place + ": " + state.reason());
      sigma[i] = std::hypot(point.zeta_error, to_angle(state->flow) / state->flux->by_slope * point.Q_error);
      change = std::max(change, std::abs(sigma[i] / slope_sigma_[i] - 1.0));
    }
  } catch (const core::Error& error) {  // within rounding of the law's steepest slope
    return Answer<double>::none(error.what());
  }
  slope_sigma_ = std::move(sigma);
  return change;
}

}  // namespace talus::fit
