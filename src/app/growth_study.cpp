#include "app/growth_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/refinement.hpp"
#include "app/steady_layer.hpp"
#include "app/study_members.hpp"
#include "app/sweep_work.hpp"
#include "column/layer_state.hpp"
#include "core/errors.hpp"
#include "output/run_reader.hpp"
#include "output/text_file.hpp"
#include "sweep/member_results.hpp"
#include "symbol/growth_map.hpp"
#include "symbol/sheared_layer.hpp"

namespace talus::app {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double fitted_share = 0.5;  // the last part of what is fitted
constexpr double most_others = 0.1;   // of the disturbed waves' amplitude
constexpr double most_speed = 0.1;    // of the fastest speed
constexpr double least_window = 1.0;  // in times of the mode: a shorter one sees what goes before it
const std::vector<std::string> series{"disturbance_speed", "other_waves_speed"};

SweepPlan plan_of(const GrowthRequest& request, const sweep::Dimension& runs) {
  const auto settings = overridden(request.overrides, {"output.times=[]"});
  return plan_of({"wellposed", "Growth of disturbances of", request.scene_file, settings, runs}, request.scene);
}

/// A run that the solver gave up has nothing more to say.
bool is_over(const sweep::MemberState& state) {
  return state.same_scene &&
         (state.status == sweep::Status::finished ||
          (state.status == sweep::Status::failed && state.exit_code == static_cast<int>(core::ExitCode::solver)));
}

/// The strongest wave along x, and where the departure from the mean is largest.
void look_at_the_end(const std::filesystem::path& file, GrowthRun& run) {
  const output::RunReader reader(file);
  const auto u = reader.last_record("u_centre"), z = reader.last_record("z"), x = reader.last_record("x");
  const std::size_t n = u.n_columns;
  std::vector<double> energy(n / 2 + 1, 0.0);
  double largest = 0.0;
  for (std::size_t k = 0; k < u.n_layers; ++k) {
    const auto row = std::span(u.values).subspan(k * n, n);
    double mean = 0.0;
    for (const double each : row) mean += each / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) {
      if (!(std::abs(row[i] - mean) > largest)) continue;
      largest = std::abs(row[i] - mean);
      run.x = x.values[i];
      run.z = z.values[k * n + i];
    }
    for (std::size_t m = 1; m < energy.size(); ++m) {
      std::complex<double> sum = 0.0;
      for (std::size_t i = 0; i < n; ++i)
        sum += (row[i] - mean) * std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>(m * i % n) / n);
      energy[m] += std::norm(sum);
    }
  }
  if (largest > 0.0) run.wave = static_cast<int>(std::ranges::max_element(energy) - energy.begin());
}

GrowthRun run_of(const GrowthMember& member, const std::filesystem::path& folder, const std::string& scene,
                 double fastest) {
  const auto results = sweep::read_member(folder, scene, series);
  GrowthRun run{member, results.series.times, {}, {}, none, {}, "", 0.0, 0, none, none};
  if (results.state.status == sweep::Status::failed)
    run.end = results.state.reason.substr(0, results.state.reason.find('\n'));
  const auto part = [&](const std::string& name) {
    const auto found = results.series.numbers.find(name);
    return found == results.series.numbers.end() ? std::vector<double>(run.times.size(), none) : found->second;
  };
  run.amplitudes = part(series.front());
  run.others = part(series.back());
  std::size_t n = 0;
  while (n < run.times.size() && run.others[n] <= most_others * run.amplitudes[n] &&
         run.amplitudes[n] <= most_speed * fastest)
    ++n;
  if (n < run.times.size()) run.taken_over = run.times[n];
  const double to = n > 0 ? run.times[n - 1] : 0.0;
  run.fit = study::fit_growth(run.times, run.amplitudes, (1.0 - fitted_share) * to, to);
  if (std::abs(member.predicted) * (run.fit.to - run.fit.from) < least_window)
    run.fit.rate = run.fit.uncertainty = none;
  if (run.times.empty()) return run;
  run.reached = run.times.back();
  look_at_the_end(folder / "run.nc", run);
  return run;
}

/// Where the layer's own inertial numbers are ill-posed, what the symbol's grids say of them.
std::optional<HiddenGrowth> hidden_growth(const Scene& finest) {
  constexpr int fewest = 16, most = 1024;
  constexpr std::size_t n_looked_at = 5;
  const SteadyLayer steady(finest, 9);
  const auto states = column::layer_states(steady.column(), 0.0, steady.speeds());
  std::vector<double> I;
  double share = 0.0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (states[k].flow_class != diagnostics::FlowClass::ill_posed) continue;
    share += steady.column().heights().thickness(static_cast<int>(k)) / steady.thickness();
    I.push_back(states[k].I);
  }
  if (I.empty()) return std::nullopt;
  std::vector<int> sizes;
  for (int n = fewest; n <= most; n *= 2) sizes.push_back(n);
  HiddenGrowth hidden{share, 0, most};
  std::ranges::sort(I);
  for (std::size_t j = 0; j < n_looked_at; ++j) {
    const symbol::ShearedLayer flow(finest.grains, finest.law, I[j * (I.size() - 1) / (n_looked_at - 1)], 1.0);
    const auto waves = symbol::fastest_waves([&](double x, double z) { return flow.growth(x, z).real(); }, sizes);
    for (std::size_t s = 0; s < sizes.size(); ++s)
      if (waves[s].growth > 0.0 && (hidden.cells == 0 || sizes[s] < hidden.cells)) hidden.cells = sizes[s];
  }
  return hidden;
}

GrowthStudy gathered(const GrowthRequest& request, const std::vector<GrowthMember>& members, const SweepWork& work,
                     const SweepPlan& plan) {
  GrowthStudy study;
  const double fastest = std::ranges::max(SteadyLayer(request.scene, 9).speeds());
  for (std::size_t i = 0; i < members.size(); ++i) {
    auto row = std::ranges::find(study.rows, members[i].name, &GrowthRow::name);
    if (row == study.rows.end()) row = study.rows.insert(row, {members[i].name, {}, {}});
    row->runs.push_back(run_of(members[i], work.folder().path() / work.folder().member(i), plan.scenes[i], fastest));
  }
  for (auto& row : study.rows) {
    std::vector<study::GrowthFit> fits;
    for (const auto& run : row.runs) fits.push_back(run.fit);
    row.verdict = study::growth_verdict(fits, refinement_ratio);
    if (row.name == "grid noise") study.verdict = row.verdict;
  }
  study.hidden = hidden_growth(refined(request.scene, request.levels - 1));
  if (study.hidden && study.verdict.tendency == study::GrowthTendency::decays) {
    study.verdict.tendency = study::GrowthTendency::cannot_tell;
    const int layers = study.rows.front().runs.back().member.layers;
    study.verdict.finer = study.hidden->cells > layers
                              ? std::max(1, int(std::lround(std::log2(double(study.hidden->cells) / layers))))
                              : 1;
  }
  return study;
}

}  // namespace

std::optional<GrowthStudy> growth_study(const GrowthRequest& request) {
  std::filesystem::create_directories(request.folder);
  const auto members = growth_members(request);
  const auto plan = plan_of(request, dimension_of(members, request.scene));
  SweepWork work(plan, request.scene_file.string(), request.folder, request.force);
  if (!std::ranges::all_of(work.manifest().members, is_over) &&
      work.run(request.jobs, 1) == core::ExitCode::restartable)
    return std::nullopt;
  return gathered(request, members, work, plan);
}

}  // namespace talus::app
