#include "fit/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.hpp"
#include "fit/search.hpp"

namespace talus::fit {

namespace {

using core::Error;
using core::ExitCode;
using steady::Answer;

/// A minimum, the number of the start that led there, and the slopes of its flows.
struct Candidate {
  std::size_t start;
  LocalMinimum minimum;
  Model::Guesses guesses;
};

std::vector<bool> none_held(const Model& model) { return std::vector<bool>(model.variables().size(), false); }

bool has_uncertain_flows(const Problem& problem) {
  return std::ranges::any_of(problem.slopes, [](const auto& p) { return p.Q_error > 0.0; });
}

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

/// The minimum with the errors of flows at the slopes that it gives. Throws Error(solver) where there is none.
LocalMinimum weighed(Model& model, LocalMinimum at) {
  constexpr int most_rounds = 20;
  for (int round = 0; round < most_rounds; ++round) {
    const auto change = model.weigh(at.x);
    if (!change) throw Error(ExitCode::solver, change.reason());
    if (*change <= 1e-6) break;
    const auto found = descend(model, at.x, none_held(model));
    if (!found) throw Error(ExitCode::solver, "the descent fails once flows have their errors");
    at = *found;
  }
  return at;
}

/// Sets the errors of flows at the first start where that can be done.
void weigh_at_first(Model& model, const std::vector<Eigen::VectorXd>& points) {
  if (has_uncertain_flows(model.problem()))
    std::ranges::any_of(points, [&](const auto& point) { return static_cast<bool>(model.weigh(point)); });
}

/// The minima that may be the answer, the best first; what became of each start goes to `starts`.
std::vector<Candidate> descend_from(Model& model, const std::vector<Eigen::VectorXd>& points,
                                    std::vector<Start>& starts) {
  weigh_at_first(model, points);
  std::vector<Candidate> out;
  for (const auto& point : points) {
    const auto found = descend(model, point, none_held(model));
    if (!found) {
      starts.push_back({point, point, std::numeric_limits<double>::infinity(), false, "no flow where it led"});
      continue;
    }
    starts.push_back({point, found->x, 2.0 * found->cost, found->converged, ""});
    auto& start = starts.back();
    const auto at = model.at(found->x);
    if (!found->converged) start.failure = "did not converge";
    else if (!found->well_posed) start.failure = "not well-posed";
    else if (!at) start.converged = false, start.failure = at.reason();
    else out.push_back({starts.size() - 1, *found, model.guesses()});
  }
  std::ranges::stable_sort(out, {}, [](const Candidate& c) { return c.minimum.cost; });
  return out;
}

std::string reasons_of(const std::vector<Start>& starts) {
  std::string out;
  for (std::size_t i = 0; i < starts.size(); ++i) out += "; start " + std::to_string(i + 1) + ": " + starts[i].failure;
  return out;
}

Fit report(const Model& model, const LocalMinimum& best) {
  const auto at = model.at(best.x);
  if (!at) throw Error(ExitCode::solver, at.reason());
  Fit out = findings(model, {model.variables(), best.x, *at, model.n_data()});
  for (std::size_t i = 0; model.problem().likelihoods && i < out.estimates.size(); ++i)
    add_profile(model, best, out.estimates[i], static_cast<Eigen::Index>(i));
  return out;
}

}  // namespace

Answer<Fit> fit(const Problem& problem) {
  Model model(problem);
  const Starts drawn = starting_points(model);
  if (drawn.points.empty())
    return Answer<Fit>::none(
        "the data reject the " + std::string(rheology::name(problem.varied.channel.law)) + " law: in none of " +
        std::to_string(drawn.infeasible) +
        " parameter sets between the bounds has it a steady state at every flow measured; the first: " + drawn.reason);
  std::vector<Start> starts;
  for (const auto& candidate : descend_from(model, drawn.points, starts)) {
    try {
      model.guess(candidate.guesses);
      Fit out = report(model, weighed(model, candidate.minimum));
      out.starts = std::move(starts);
      out.infeasible_draws = drawn.infeasible;
      return out;
    } catch (const Error& error) {  // a quadrature fails: within rounding of the law's steepest slope
      starts[candidate.start].converged = false;
      starts[candidate.start].failure = error.what();
      weigh_at_first(model, drawn.points);
    }
  }
  const bool all_ill_posed = std::ranges::all_of(starts, [](const Start& s) { return s.failure == "not well-posed"; });
  if (all_ill_posed)
    return Answer<Fit>::none(
        "none of " + std::to_string(starts.size()) + " starts came to parameters between the bounds that keep " +
        (problem.condition == Condition::C ? "C <= 0" : "q <= 1") + " at the surface of every flow measured");
  throw Error(ExitCode::solver, "fit: none of " + std::to_string(starts.size()) +
                                    " starts came to a minimum; expected fewer unknowns, or closer bounds" +
                                    reasons_of(starts));
}

}  // namespace talus::fit
