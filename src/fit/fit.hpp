#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/evaluation.hpp"
#include "fit/identifiability.hpp"
#include "fit/lumps.hpp"

namespace talus::fit {

/// The best value of a variable, and how well it is known.
struct Estimate {
  Variable variable;
  double value;
  std::optional<double> error;  ///< one standard deviation
  std::string why_no_error;     ///< where there is none
  bool from_prior = false;      ///< the data alone would not fix it
  /// chi2 less its minimum with this variable held at `at`, all others free; empty where there is no error.
  std::vector<double> profile_at, profile_rise;
};

/// A lump of which the data fix the product but not each factor.
struct LumpEstimate {
  Lump lump;
  double value, error;
  std::vector<std::string> of;  ///< unknowns in it
};

/// Slope and surface speed at a flow.
struct FlowPrediction {
  double Q, zeta, speed, I;
  std::optional<double> zeta_error, speed_error;  ///< none where they hang on what the data do not see
};

/// How far the surface of a measured flow is from ill-posedness.
struct Margin {
  std::string place;
  double I, C, q;
  std::optional<double> C_margin, q_margin;  ///< in I; none where the law has no such bound
};

/// A local minimum reached from one start.
struct Start {
  Eigen::VectorXd from, to;
  double chi2;
  bool converged;
};

struct Fit {
  steady::VariedChannel best;
  Eigen::VectorXd x;
  std::vector<Estimate> estimates;
  Eigen::VectorXd residuals;        ///< (model - measured)/sigma, data then priors
  std::vector<double> slope_sigma;  ///< [rad]
  double chi2;                      ///< of data and priors, without the loss
  int freedom;                      ///< data and priors less directions seen
  double chance;                    ///< of a larger chi2 if the model and the errors are right; 1 without freedom
  Identifiability data, all;        ///< from the data alone, and with the priors
  std::vector<LumpEstimate> lumps;
  std::vector<Margin> margins;
  double worst_condition = 0.0;  ///< largest C, or q - 1, where that was asked to stay below zero
  std::vector<FlowPrediction> predictions;
  std::vector<Start> starts;
  int infeasible_draws = 0;  ///< parameter sets drawn for which some flow measured had no steady state
};

/// Fits by bounded least squares from several starts. None, with the reason, where no parameters within the bounds let all
/// flows measured be steady: the data reject the law. Throws core::Error(solver) where no start converges.
[[nodiscard]] steady::Answer<Fit> fit(const Problem& problem);

}  // namespace talus::fit
