#include "app/trade_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/theory.hpp"
#include "config/spelling.hpp"
#include "core/errors.hpp"
#include "experiment/inflow.hpp"
#include "output/run_reader.hpp"
#include "output/text_file.hpp"
#include "study/convergence.hpp"
#include "sweep/member_results.hpp"
#include "sweep/sweep_folder.hpp"

namespace talus::app {
namespace {

using sweep::MemberResults;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t reference_row = 1;
/// A heap counts as steady where its outflow is the inflow to this share.
constexpr double steady_within = 0.02;
const std::array<std::string, 3> usual_judges{"heap_angle", "mass_flow", "mass_stored"};

/// A number at the recorded times and at the end, by time; a time that is the end counts once.
std::map<double, double> course(const MemberResults& member, const std::string& name, double end) {
  std::map<double, double> out;
  if (const auto found = member.records.numbers.find(name); found != member.records.numbers.end()) {
    for (std::size_t i = 0; i < found->second.size(); ++i) out[member.records.times[i]] = found->second[i];
  }
  if (const auto found = member.last.find(name); found != member.last.end()) out[end] = found->second;
  std::erase_if(out, [](const auto& entry) { return !std::isfinite(entry.second); });
  return out;
}

class Reader {
 public:
  Reader(const std::filesystem::path& folder, const sweep::Manifest& manifest, const Scene& scene,
         const TradeChoices& choices)
      : scene_(scene) {
    const sweep::SweepFolder place(folder, manifest.design.size());
    for (std::size_t i = 0; i < manifest.design.size(); ++i) {
      members_.push_back(sweep::read_member(folder / place.member(i), output::contents(folder / place.scene(i)), {}));
      study_.rows.push_back({choices.all[i], members_[i].state, members_[i].costs, {}, std::nullopt});
    }
    study_.left_out = choices.left_out;
    study_.exact = exact_slope_of(scene);
    reference_file_ = folder / place.member(reference_row) / "run.nc";
  }

  TradeStudy read(const std::optional<std::string>& by) {
    if (members_[reference_row].state.status != sweep::Status::finished)
      throw core::ConfigError("study trade: the reference did not finish (" + members_[reference_row].state.reason +
                              "): there is nothing to measure errors by; a coarser scene, --set grid..., may do");
    if (study_.exact && !steady()) study_.exact.reset();
    read_numbers();
    choose_judge(by);
    for (std::size_t i = 0; i < study_.rows.size(); ++i) read_errors(i);
    study_.growth = growth();
    return std::move(study_);
  }

 private:
  [[nodiscard]] std::map<double, double> course_of(std::size_t row, const std::string& name) const {
    return course(members_[row], name, scene_.end);
  }
  [[nodiscard]] bool finished(std::size_t row) const { return members_[row].state.status == sweep::Status::finished; }

  /// Whether as much leaves the reference at that time as is poured in.
  [[nodiscard]] bool steady() const {
    const auto out = course_of(reference_row, "outflow_rate_right");
    const auto found = out.find(study_.exact->time);
    return found != out.end() && std::abs(found->second - scene_.inflow.rate) < steady_within * scene_.inflow.rate;
  }

  void read_numbers() {
    const output::RunReader run(reference_file_);
    for (const auto& [name, value] : members_[reference_row].last) {
      const auto reference = course_of(reference_row, name);
      double scale = 0.0;
      for (const auto& [time, v] : reference) scale = std::max(scale, std::abs(v));
      if (!(scale > 0.0)) continue;
      const auto known = run.describe(name);
      study_.numbers.push_back(
          {name, known ? known->unit : "", known ? known->long_name : name, scale, uncertainty(name, reference)});
    }
  }

  /// By the grids of the scene's ladder, the reference the finest; the worst over the times.
  [[nodiscard]] double uncertainty(const std::string& name, const std::map<double, double>& reference) const {
    std::vector<std::size_t> ladder;
    for (const double ratio : {0.25, 0.5, 1.0}) {
      for (std::size_t i = 0; i < study_.rows.size(); ++i)
        if (study_.rows[i].choice.cells_ratio == ratio && finished(i)) ladder.push_back(i);
    }
    ladder.push_back(reference_row);
    if (ladder.size() < 3) return none;
    double worst = none;
    for (const auto& [time, value] : reference) {
      std::vector<double> values;
      for (const std::size_t row : ladder) {
        const auto its = course_of(row, name);
        const auto found = its.find(time);
        values.push_back(found == its.end() ? none : found->second);
      }
      const auto limit = study::convergence(values, reference_refinement, scene_.integration.rtol * std::abs(value));
      if (std::isfinite(limit.uncertainty))
        worst = std::isnan(worst) ? limit.uncertainty : std::max(worst, limit.uncertainty);
    }
    return worst;
  }

  void choose_judge(const std::optional<std::string>& by) {
    const auto has = [&](const std::string& name) {
      return std::ranges::any_of(study_.numbers, [&](const auto& n) { return n.name == name; });
    };
    if (by) {
      if (has(*by)) {
        study_.judge = *by;
        return;
      }
      std::vector<std::string> known;
      std::string list;
      for (const auto& number : study_.numbers) {
        known.push_back(number.name);
        list += (list.empty() ? "" : ", ") + number.name;
      }
      const auto meant = config::nearest(*by, known);
      throw core::ConfigError("study trade --by " + *by + ": the scene has no such number" +
                              (meant ? " (did you mean " + *meant + "?)" : "") + "; there are " + list);
    }
    const auto usual = std::ranges::find_if(usual_judges, has);
    if (usual == usual_judges.end())
      throw core::ConfigError(
          "study trade: the scene has none of heap_angle, mass_flow, mass_stored; --by NAME says what counts");
    study_.judge = *usual;
  }

  void read_errors(std::size_t row) {
    if (!finished(row)) return;
    auto& out = study_.rows[row];
    if (row != reference_row) {
      for (const auto& number : study_.numbers) {
        const auto reference = course_of(reference_row, number.name);
        double worst = none;
        for (const auto& [time, value] : course_of(row, number.name)) {
          const auto found = reference.find(time);
          if (found == reference.end()) continue;
          const double error = std::abs(value - found->second);
          worst = std::isnan(worst) ? error : std::max(worst, error);
        }
        if (std::isfinite(worst)) out.errors[number.name] = worst;
      }
    }
    if (!study_.exact) return;
    const auto angles = course_of(row, "heap_angle");
    if (const auto found = angles.find(study_.exact->time); found != angles.end())
      out.exact_error = std::abs(found->second - study_.exact->degrees);
  }

  [[nodiscard]] std::optional<double> growth() const {
    std::vector<double> cells, costs;
    for (const auto& row : study_.rows) {
      if (!(row.choice.cells_ratio > 0.0) || row.state.status != sweep::Status::finished) continue;
      const bool both = scene_.cells.columns > 0 && row.choice.settings.contains("grid.columns");
      const double power = both || row.choice.settings.empty() ? (scene_.cells.columns > 0 ? 2.0 : 1.0) : 1.0;
      cells.push_back(std::pow(row.choice.cells_ratio, power));
      costs.push_back(row.cost());
    }
    return study::growth_exponent(cells, costs);
  }

  const Scene& scene_;
  TradeStudy study_;
  std::vector<MemberResults> members_;
  std::filesystem::path reference_file_;
};

}  // namespace

double TradeRow::cost() const {
  const auto found = costs.find("cpu_seconds");
  return found == costs.end() ? none : found->second;
}

const TradeNumber& TradeStudy::judged() const { return *std::ranges::find(numbers, judge, &TradeNumber::name); }

std::vector<study::Priced> TradeStudy::priced() const {
  std::vector<study::Priced> out;
  for (const auto& row : rows) {
    const auto found = row.errors.find(judge);
    out.push_back({row.cost(), found == row.errors.end() ? none : found->second / judged().scale});
  }
  return out;
}

std::vector<study::Priced> TradeStudy::priced_by_slope() const {
  std::vector<study::Priced> out;
  for (const auto& row : rows) out.push_back({row.cost(), row.exact_error.value_or(none)});
  return out;
}

TradeStudy read_trade_study(const std::filesystem::path& folder, const sweep::Manifest& manifest, const Scene& scene,
                            const TradeChoices& choices, const std::optional<std::string>& by) {
  return Reader(folder, manifest, scene, choices).read(by);
}

std::optional<ExactSlope> exact_slope_of(const Scene& scene) {
  const auto theory = theory_of(scene);
  if (!theory.steady || !theory.steady->heap) return std::nullopt;
  std::optional<double> time;
  const double rate = experiment::open_rate(scene.inflow, scene.end);
  for (const double t : scene.recording.listed_times) {
    if (experiment::inflow_rate(scene.inflow, t) == rate) time = t;
  }
  if (experiment::inflow_rate(scene.inflow, scene.end) == rate) time = scene.end;
  if (!time) return std::nullopt;
  return ExactSlope{*time, theory.steady->flow.zeta() * 180.0 / std::numbers::pi};
}

}  // namespace talus::app
