#include "app/fit_runs.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <thread>

#include "app/measured_columns.hpp"
#include "app/scene.hpp"
#include "app/sweep_work.hpp"
#include "app/table.hpp"

namespace talus::app {
namespace {

using core::ExitCode;
using Eigen::VectorXd;
using sweep::Status;
using Answer = steady::Answer<VectorXd>;

/// A fit tells of batches, not of runs.
class Silence : public sweep::RunnerWatch {
 public:
  void ended(std::size_t, const sweep::MemberState&, bool) override {}
  void idle(std::size_t, std::size_t) override {}
};

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// What is wrong, after which member has it.
std::string last_line(const std::string& text) { return text.substr(text.rfind('\n') + 1); }

/// What says nothing of the parameters ends the fit: the same command goes on once it is mended.
void end_if_not_of_the_scene(const sweep::MemberState& state) {
  for (const auto code : {ExitCode::io_setup, ExitCode::output_failed, ExitCode::memory, ExitCode::configuration})
    if (state.exit_code == static_cast<int>(code))
      throw core::Error(code, "a run of stage 2 failed: " + state.reason + "; the same command goes on");
}

/// Runs all that are not run; waits for those that a fit that was killed left running.
void run(SweepWork& work, int jobs) {
  Silence watch;
  while (true) {
    if (work.run_once(jobs, watch) != 0)
      throw core::Error(ExitCode::restartable, "stopped; the same command goes on, with the runs that are made");
    if (std::ranges::none_of(work.manifest().members, [](const auto& m) { return m.status == Status::unfinished; }))
      return;
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
}

/// Linear between the middles of columns, constant beyond the outermost.
double height_at(const std::vector<double>& x, const double* heights, double at) {
  const auto right = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin());
  if (right == 0) return heights[0];
  if (right == x.size()) return heights[x.size() - 1];
  const double share = (at - x[right - 1]) / (x[right] - x[right - 1]);
  return (1.0 - share) * heights[right - 1] + share * heights[right];
}

}  // namespace

FitRuns::FitRuns(const FitFile& file, std::filesystem::path folder, int jobs, bool force)
    : file_(file), layer_(*file.layer), folder_(std::move(folder)), jobs_(jobs), force_(force) {}

/// Records at the times of the data, and no checkpoints in between: a run that is stopped begins anew with the same bits.
std::vector<std::string> FitRuns::settings() const {
  std::set<double> times;
  for (const auto& datum : layer_.stage.data) times.insert(datum.time);
  const Scene scene = read_scene(layer_.scene, layer_.settings);
  std::vector<std::string> own{"output.times=" + config::to_toml(std::vector<double>(times.begin(), times.end())),
                               "output.fields=false", "output.series_interval=" + shortest(scene.end),
                               "output.interval=" + shortest(scene.end)};
  if (!scene.checkpointing.by_interval) own.push_back("checkpoint.interval=" + shortest(2.0 * scene.end));
  return overridden(layer_.settings, own);
}

sweep::SweepFile FitRuns::sweep_of(const std::vector<VectorXd>& points) const {
  sweep::Dimension dimension{"evaluation", {}};
  for (std::size_t i = 0; i < layer_.keys.size(); ++i) {
    const auto* key = scene_schema().find(layer_.keys[i]);
    sweep::Axis axis{key->name, key->unit, key->doc, {}};
    for (const auto& point : points) axis.values.emplace_back(point[static_cast<Eigen::Index>(i)]);
    dimension.axes.push_back(std::move(axis));
  }
  return {file_.name + "_stage_2", file_.title, layer_.scene, settings(), sweep::Design({dimension})};
}

std::vector<Answer> FitRuns::at(const std::vector<VectorXd>& points) {
  std::vector<Answer> out(points.size(), Answer::none(""));
  std::vector<std::size_t> accepted;
  std::vector<VectorXd> to_run;
  SweepPlan plan{sweep_of(points), {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    try {
      plan.scenes.push_back(member_scenes(sweep_of({points[i]}), layer_.scene).front());
      accepted.push_back(i), to_run.push_back(points[i]);
    } catch (const core::ConfigError& error) { out[i] = Answer::none("refused: " + last_line(error.what())); }
  }
  const std::string number = std::to_string(++n_batches_);
  const std::string name = "batch_" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number;
  if (to_run.empty()) return out;
  plan.file = sweep_of(to_run);
  SweepWork work(plan, file_.name, folder_ / name, force_);
  run(work, jobs_);
  for (std::size_t k = 0; k < accepted.size(); ++k) {
    const auto& state = work.manifest().members[k];
    if (state.status == Status::finished) out[accepted[k]] = read(work.folder().path() / work.folder().member(k));
    else {
      end_if_not_of_the_scene(state);
      out[accepted[k]] = Answer::none(first_line(state.reason));
    }
  }
  return out;
}

Answer FitRuns::read(const std::filesystem::path& run_folder) const {
  const auto path = run_folder / "run.nc";
  const auto run = open_netcdf(path);
  std::map<std::string, output::StoredVariable> known;
  const auto variable = [&](const std::string& name) -> const output::StoredVariable& {
    if (const auto found = known.find(name); found != known.end()) return found->second;
    auto stored = run.read(name);
    if (!stored)
      throw core::ConfigError(layer_.scene.string() + ": its model records no " + name +
                              "; expected model.name = \"layer\"");
    return known[name] = std::move(*stored);
  };
  const auto& times = variable("series_time").values;
  VectorXd out(static_cast<Eigen::Index>(layer_.stage.data.size()));
  for (std::size_t i = 0; i < layer_.stage.data.size(); ++i) {
    const auto& datum = layer_.stage.data[i];
    const auto at = std::ranges::lower_bound(times, datum.time * (1.0 - 1e-12)) - times.begin();
    const auto k = static_cast<std::size_t>(at);
    if (k == times.size()) return Answer::none("nothing is recorded at " + shortest(datum.time) + " s");
    double value = 0.0;
    if (datum.kind == "height") {
      const auto& x = variable("x").values;
      value = height_at(x, variable("height_series").values.data() + k * x.size(), datum.x);
    } else {
      value = variable(datum.kind).values[k];
    }
    if (!std::isfinite(value)) return Answer::none("has no " + datum.kind + " at " + shortest(datum.time) + " s");
    out[static_cast<Eigen::Index>(i)] = value;
  }
  return out;
}

void FitRuns::told(int n_runs, const VectorXd& first, double chi2) {
  std::string at;
  for (std::size_t i = 0; i < layer_.keys.size(); ++i) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", first[static_cast<Eigen::Index>(i)]);
    at += (i > 0 ? ", " : "") + layer_.keys[i] + " = " + text;
  }
  char sum[48] = "failed";
  if (std::isfinite(chi2)) std::snprintf(sum, sizeof sum, "chi2 %.5g", chi2);
  std::fprintf(stderr, "stage 2: %d of at most %d runs; %s at %s\n", n_runs, layer_.stage.evaluations, sum, at.c_str());
}

}  // namespace talus::app
