#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/problem.hpp"
#include "steady/answer.hpp"

namespace talus::fit {

/// A variable of the optimisation: an unknown parameter, or the surface offset [m] of a profile.
struct Variable {
  std::string name, unit;
  double start, low, high;
};

/// (model - measured)/sigma of every slope, then every speed, then (value - prior)/sigma of every prior.
struct Evaluation {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  ///< by each variable
  Eigen::VectorXd
      conditions;  ///< C, or q - 1, at the surface of each slope point, then of each profile; at most 0 if well-posed
  Eigen::MatrixXd conditions_jacobian;
};

/// What a problem's data look like for given values of its variables: the forward model of `models/steady` beside data.
class Model {
 public:
  /// Keeps a copy of the problem. An error of a flow counts as dzeta/dQ times it, with the slope set by `weigh`.
  explicit Model(Problem problem);

  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const std::vector<Variable>& variables() const { return variables_; }
  [[nodiscard]] int n_data() const { return n_data_; }
  [[nodiscard]] int n_residuals() const;
  [[nodiscard]] int n_conditions() const;

  /// The channel at x, one number a variable. Throws std::invalid_argument where its law refuses them.
  [[nodiscard]] steady::VariedChannel channel(const Eigen::VectorXd& x) const;
  /// None, with the reason, where some flow measured has no steady state.
  [[nodiscard]] steady::Answer<Evaluation> at(const Eigen::VectorXd& x) const;
  /// Of slope [rad] and surface speed [m/s] at a flow, by each variable.
  struct Prediction {
    double zeta, speed, I;
    Eigen::VectorXd zeta_by, speed_by;
  };
  [[nodiscard]] steady::Answer<Prediction> predict(const Eigen::VectorXd& x, double Q) const;

  /// Sets the standard deviation of each slope from those of slope and flow, at the dzeta/dQ that x gives; returns the
  /// largest relative change. None, with the reason and nothing set, where some flow has no steady state at x.
  steady::Answer<double> weigh(const Eigen::VectorXd& x);
  [[nodiscard]] const std::vector<double>& slope_sigma() const { return slope_sigma_; }

  /// Slopes from which the next searches start, one a flow measured: at the end of a law a flow may be found only from nearby.
  using Guesses = std::vector<std::optional<double>>;
  [[nodiscard]] const Guesses& guesses() const { return tangents_; }
  void guess(Guesses guesses) const { tangents_ = std::move(guesses); }

 private:
  [[nodiscard]] Eigen::RowVectorXd by_variables(const steady::Sensitivity& s, double factor) const;

  Problem problem_;
  std::vector<Variable> variables_;
  std::vector<int> offset_of_;  ///< variable of each profile, -1: none
  std::vector<double> slope_sigma_;
  /// tan zeta found last at each slope point, then each profile, from which the next search starts: not for two threads.
  mutable Guesses tangents_;
  int n_data_ = 0;
};

}  // namespace talus::fit
