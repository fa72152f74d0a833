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

/// A local minimum reached from one start, or why there is none.
struct Start {
  Eigen::VectorXd from, to;
  double chi2;
  bool converged;
  std::string failure;  ///< "" where it came to a minimum
};

/// What the layer model adds, where it was asked.
struct LayerFindings {
  LayerStage stage;
  Eigen::VectorXd model;              ///< of each datum at the best values, in its unit
  std::vector<Estimate> before;       ///< by the steady flow alone; empty where that had no data
  double chi2_before;                 ///< of all data and priors where the descent began
  int n_runs;                         ///< of the scene, failed ones among them
  std::vector<std::string> failures;  ///< runs that failed: where, and why
  bool converged;                     ///< false: the runs allowed were used up
  double
      noise;  ///< root of the mean square by which two runs of nearly equal parameters differ, in standard deviations
  std::vector<std::string> seen_by_layer_only;  ///< unknowns with an error that the steady flow gives none
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
  int infeasible_draws = 0;              ///< parameter sets drawn for which some flow measured had no steady state
  std::optional<LayerFindings> layer{};  ///< residuals are then of slopes, speeds, the layer's data, priors
};

/// A minimum of a sum of squares: residuals of data, then of priors, with their Jacobian.
struct Reached {
  std::vector<Variable> variables;  ///< those of the model first
  Eigen::VectorXd x;
  const Evaluation& at;
  int n_data;
  double noise = 0.0;  ///< as `identifiability` has it
};

/// What it says: all of Fit but starts, profile likelihoods and the layer's findings. Throws core::Error(solver) where a flow to
/// be predicted has no steady state, or a quadrature fails.
[[nodiscard]] Fit findings(const Model& model, const Reached& reached);

}  // namespace talus::fit
