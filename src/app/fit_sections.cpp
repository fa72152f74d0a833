#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "app/fit_report.hpp"

namespace talus::app {
namespace {

constexpr double degree = std::numbers::pi / 180.0, none = std::numeric_limits<double>::quiet_NaN();
/// A residual from here on is called an outlier.
constexpr double outlier = 4.0;

using Numbers = std::vector<double>;
using Words = std::vector<std::string>;

double number(const std::optional<double>& value) { return value.value_or(none); }

std::string short_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", value);
  return text.data();
}

FitSection unknowns(const fit::Fit& fit) {
  Words name, unit, note;
  Numbers value, error, low, high;
  for (const auto& e : fit.estimates) {
    name.push_back(e.variable.name), unit.push_back(e.variable.unit);
    value.push_back(e.value), error.push_back(number(e.error));
    low.push_back(e.variable.low), high.push_back(e.variable.high);
    note.push_back(e.from_prior ? "fixed by its prior, not by the data" : e.why_no_error);
  }
  return {"unknown",
          "Parameters",
          {{"name", "", "parameter, or surface offset of a profile", name},
           {"value", "", "best value", value},
           {"error", "", "one standard deviation; none where the data do not fix the parameter", error},
           {"unit", "", "of value, error and bounds", unit},
           {"low", "", "lower bound", low},
           {"high", "", "upper bound", high},
           {"note", "", "why there is no error, or where it comes from", note}}};
}

FitSection lumps(const fit::Fit& fit) {
  Words name, formula, unit, of;
  Numbers value, error;
  for (const auto& lump : fit.lumps) {
    name.push_back(lump.lump.name), formula.push_back(lump.lump.formula), unit.push_back(lump.lump.unit);
    value.push_back(lump.value), error.push_back(lump.error);
    std::string all;
    for (const auto& each : lump.of) all += (all.empty() ? "" : ", ") + each;
    of.push_back(all);
  }
  return {"lump",
          "What the data fix only as a product",
          {{"name", "", "name of the lump", name},
           {"value", "", "best value", value},
           {"error", "", "one standard deviation", error},
           {"unit", "", "of value and error", unit},
           {"formula", "", "the lump", formula},
           {"of", "", "unknowns in it", of}}};
}

FitSection directions(const fit::Fit& fit) {
  Numbers singular, change;
  Words seen, parts;
  const auto& data = fit.data;
  for (Eigen::Index k = 0; k < data.singular_values.size(); ++k) {
    const bool is_seen = k < data.rank;
    singular.push_back(data.singular_values[k]);
    change.push_back(is_seen ? 1.0 / data.singular_values[k] : none);
    seen.push_back(is_seen ? "yes" : "no");
    std::string text;
    for (Eigen::Index i = 0; i < data.directions.rows(); ++i)
      if (const double part = data.directions(i, k); std::abs(part) >= 0.05)
        text += (text.empty() ? "" : " ") + std::string(part < 0.0 ? "-" : "+") + short_text(std::abs(part)) + " " +
                fit.estimates[static_cast<std::size_t>(i)].variable.name;
    parts.push_back(text);
  }
  return {"direction",
          "Directions of relative changes, the best seen by the data first",
          {{"singular_value", "1", "of the data's Jacobian by relative changes", singular},
           {"standard_deviation", "1", "relative change along it; none where the data do not see it", change},
           {"seen", "", "whether the data see it", seen},
           {"parts", "", "share of each parameter, if above 0.05", parts}}};
}

FitSection data(const FitFile& file, const fit::Fit& fit) {
  Words place, kind, note;
  Numbers flow, depth, time, x, measured, error, model, residual;
  Eigen::Index row = 0;
  const auto add = [&](const std::string& where, const std::string& what, double Q, double h, double value,
                       double sigma, double t = none, double down = none) {
    const double r = fit.residuals[row++];
    place.push_back(where), kind.push_back(what), flow.push_back(Q), depth.push_back(h), time.push_back(t);
    x.push_back(down);
    measured.push_back(value), error.push_back(sigma), model.push_back(value + r * sigma), residual.push_back(-r);
    note.push_back(std::abs(r) >= outlier ? "outlier" : "");
  };
  for (std::size_t i = 0; i < file.problem.slopes.size(); ++i) {
    const auto& point = file.problem.slopes[i];
    add(point.place, "slope [degree]", point.Q, none, point.zeta / degree, fit.slope_sigma[i] / degree);
  }
  for (const auto& profile : file.problem.profiles)
    for (std::size_t i = 0; i < profile.depth.size(); ++i)
      add(profile.name, "speed [m/s]", number(profile.Q), profile.depth[i], profile.speed[i], profile.error[i]);
  if (fit.layer)
    for (const auto& d : fit.layer->stage.data)
      add(d.place, d.kind + " [" + d.unit + "]", none, none, d.value, d.error, d.time, d.x);
  return {"data",
          "Data",
          {{"place", "", "file, and row", place},
           {"kind", "", "what was measured, and its unit", kind},
           {"Q_kg_s", "kg s-1", "mass flow", flow},
           {"depth_m", "m", "below what was taken for the surface", depth},
           {"time_s", "s", "since the start of the layer's scene", time},
           {"x_m", "m", "down the base", x},
           {"measured", "", "measured value", measured},
           {"error", "", "its standard deviation, that of the flow in it", error},
           {"model", "", "best model", model},
           {"residual", "1", "(measured - model)/error", residual},
           {"note", "", "outlier: beyond four standard deviations", note}}};
}

FitSection predictions(const FitFile& file, const fit::Fit& fit) {
  Numbers flow, zeta, zeta_error, measured, off, speed, speed_error, I;
  for (const auto& p : fit.predictions) {
    const fit::SlopePoint* point = nullptr;
    for (const auto& each : file.held_back)
      if (std::abs(each.Q - p.Q) <= 1e-9 * p.Q) point = &each;
    flow.push_back(p.Q), zeta.push_back(p.zeta / degree), zeta_error.push_back(number(p.zeta_error) / degree);
    speed.push_back(p.speed), speed_error.push_back(number(p.speed_error)), I.push_back(p.I);
    measured.push_back(point ? point->zeta / degree : none);
    off.push_back(point && p.zeta_error ? (point->zeta - p.zeta) / std::hypot(*p.zeta_error, point->zeta_error) : none);
  }
  return {"prediction",
          "Flows held back",
          {{"Q_kg_s", "kg s-1", "mass flow", flow},
           {"zeta_deg", "degree", "predicted slope", zeta},
           {"zeta_error_deg", "degree", "its standard deviation", zeta_error},
           {"measured_deg", "degree", "measured slope, the last one at that flow", measured},
           {"off", "1", "(measured - predicted) over the standard deviation of both", off},
           {"speed_m_s", "m s-1", "predicted surface speed", speed},
           {"speed_error_m_s", "m s-1", "its standard deviation; none where it hangs on what the data do not see",
            speed_error},
           {"I", "1", "predicted I at the surface", I}}};
}

FitSection margins(const fit::Fit& fit) {
  Words place;
  Numbers I, C, q, C_margin, q_margin;
  for (const auto& m : fit.margins) {
    place.push_back(m.place);
    I.push_back(m.I), C.push_back(m.C), q.push_back(m.q);
    C_margin.push_back(number(m.C_margin)), q_margin.push_back(number(m.q_margin));
  }
  return {"margin",
          "Well-posedness at the surface of each flow measured (C <= 0 and q < 1 are inside)",
          {{"place", "", "data", place},
           {"I", "1", "inertial number at the surface", I},
           {"C", "1", "C (3.18)", C},
           {"q", "1", "mu - I mu'/2", q},
           {"C_margin", "1", "I of the highest neutral point less I; negative: ill-posed by (3.18)", C_margin},
           {"q_margin", "1", "I of q = 1 less I; negative: short waves grow", q_margin}}};
}

FitSection starts(const fit::Fit& fit) {
  Numbers chi2;
  Words converged, note;
  for (const auto& s : fit.starts) {
    chi2.push_back(s.chi2), converged.push_back(s.converged ? "yes" : "no");
    note.push_back(s.failure);
  }
  return {"start",
          "Starts",
          {{"chi2", "1", "reached from each start, with the loss", chi2},
           {"converged", "", "", converged},
           {"note", "", "why it failed", note}}};
}

/// What the layer's data change against the steady flow's alone.
FitSection stages(const fit::Fit& fit) {
  Words name, note;
  Numbers before, before_error, value, error;
  if (fit.layer)
    for (std::size_t i = 0; i < fit.estimates.size(); ++i) {
      const auto& e = fit.estimates[i];
      const auto* first = i < fit.layer->before.size() ? &fit.layer->before[i] : nullptr;
      name.push_back(e.variable.name), value.push_back(e.value), error.push_back(number(e.error));
      before.push_back(first ? first->value : none), before_error.push_back(first ? number(first->error) : none);
      const bool is_new =
          std::ranges::find(fit.layer->seen_by_layer_only, e.variable.name) != fit.layer->seen_by_layer_only.end();
      note.push_back(is_new ? "fixed by the layer's data only" : e.error ? "" : e.why_no_error);
    }
  return {"stage",
          "Stage 1, by the steady flow alone, and stage 2, by all data",
          {{"name", "", "parameter", name},
           {"before", "", "best value by stage 1; none where it does not know the parameter", before},
           {"before_error", "", "its standard deviation", before_error},
           {"value", "", "best value by both", value},
           {"error", "", "its standard deviation", error},
           {"note", "", "which data fix it", note}}};
}

FitSection likelihoods(const fit::Fit& fit) {
  Words name;
  Numbers at, rise;
  for (const auto& e : fit.estimates)
    for (std::size_t i = 0; i < e.profile_at.size(); ++i)
      name.push_back(e.variable.name), at.push_back(e.profile_at[i]), rise.push_back(e.profile_rise[i]);
  return {"likelihood",
          "Profile likelihoods",
          {{"name", "", "parameter held", name},
           {"at", "", "there, in its unit", at},
           {"rise", "1", "of chi2 over its minimum, all others free", rise}}};
}

}  // namespace

std::vector<FitSection> fit_sections(const FitFile& file, const fit::Fit& fit) {
  return {unknowns(fit),          stages(fit),  lumps(fit),  directions(fit),  data(file, fit),
          predictions(file, fit), margins(fit), starts(fit), likelihoods(fit), slope_curve(file, fit),
          speed_curves(file, fit)};
}

}  // namespace talus::app
