#include "app/convergence_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "app/refinement.hpp"
#include "experiment/inflow.hpp"
#include "output/run_reader.hpp"
#include "output/text_file.hpp"
#include "sweep/member_results.hpp"
#include "sweep/sweep_folder.hpp"

namespace talus::app {
namespace {

using output::RunReader;
using study::Tendency;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Fields are stored in single precision.
constexpr double single_precision = 1e-6;

using Numbers = std::map<std::string, double>;

/// "mass_stored@56": of a record at an output time.
std::string record_name(const std::string& name, double time) { return name + "@" + sweep::plain(time); }

Numbers numbers_of(const sweep::MemberResults& member, const std::vector<double>& left_out) {
  Numbers all = member.last;
  for (const auto& [name, values] : member.records.numbers) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double time = member.records.times[i];
      if (std::ranges::find(left_out, time) == left_out.end()) all[record_name(name, time)] = values[i];
    }
  }
  return all;
}

class Reader {
 public:
  Reader(const std::filesystem::path& folder, const sweep::Manifest& manifest) : folder_(folder), manifest_(manifest) {}

  ConvergenceStudy read(const Scene& scene, const std::vector<double>& rtols) {
    study_.same_as_end = times_like_the_end(scene);
    const sweep::SweepFolder place(folder_, manifest_.design.size());
    for (std::size_t i = 0; i < manifest_.design.size(); ++i) {
      const auto run_folder = folder_ / place.member(i);
      const auto member = sweep::read_member(run_folder, output::contents(folder_ / place.scene(i)), {});
      study_.levels.push_back({manifest_.design.describe(i), member.state, member.costs, rtols.at(i)});
      numbers_.push_back(numbers_of(member, study_.same_as_end));
      files_.push_back(run_folder / "run.nc");
    }
    count();
    read_numbers();
    read_fields();
    return std::move(study_);
  }

 private:
  [[nodiscard]] bool finished(std::size_t level) const {
    return study_.levels[level].state.status == sweep::Status::finished;
  }

  /// The longest row of finished neighbours, of two equal ones the finer.
  void count() {
    for (std::size_t first = 0; first < study_.levels.size(); ++first) {
      std::size_t n = 0;
      while (first + n < study_.levels.size() && finished(first + n)) ++n;
      if (n > 0 && n >= study_.n_counted) {
        study_.first = first;
        study_.n_counted = n;
      }
    }
  }

  [[nodiscard]] std::size_t finest() const { return study_.first + study_.n_counted - 1; }
  [[nodiscard]] double rtol() const { return study_.levels[finest()].rtol; }

  void read_numbers() {
    if (study_.n_counted == 0) return;
    const RunReader run(files_[finest()]);
    for (const auto& [name, value] : numbers_[finest()]) {
      StudiedNumber number{name, "", name, {}, {}};
      if (const auto known = run.describe(name.substr(0, name.find('@')))) {
        number.unit = known->unit;
        number.long_name = known->long_name;
      }
      for (const auto& level : numbers_) {
        const auto found = level.find(name);
        number.values.push_back(found == level.end() ? none : found->second);
      }
      const auto counted = counted_part(number.values);
      if (std::ranges::none_of(counted, [](double v) { return std::isfinite(v); })) {
        study_.without_value.push_back(name);
        continue;
      }
      for (const double v : counted)
        if (std::isfinite(v)) scale_[number.unit] = std::max(scale_[number.unit], std::abs(v));
      study_.numbers.push_back(std::move(number));
    }
    for (auto& number : study_.numbers)
      number.limit = study::convergence(counted_part(number.values), refinement_ratio, rtol() * scale_.at(number.unit));
  }

  [[nodiscard]] std::span<const double> counted_part(const std::vector<double>& values) const {
    return std::span(values).subspan(study_.first, study_.n_counted);
  }

  void read_fields() {
    if (study_.n_counted < 2) return;
    const RunReader finest_run(files_[finest()]);
    std::map<std::string, double> scale;
    std::vector<std::vector<double>> norms;
    for (const auto& name : finest_run.fields()) {
      StudiedField field{name, "", name, {}, {}};
      if (const auto known = finest_run.describe(name)) {
        field.unit = known->unit;
        field.long_name = known->long_name;
      }
      std::vector<double> L2;
      double largest = 0.0;
      RunReader::Cells coarse;
      for (std::size_t level = study_.first; level <= finest(); ++level) {
        auto fine = RunReader(files_[level]).last_record(name);
        for (const double v : fine.values)
          if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
        if (level > study_.first) {
          field.differences.push_back(study::difference({coarse.n_layers, coarse.n_columns, coarse.values},
                                                        {fine.n_layers, fine.n_columns, fine.values}));
          L2.push_back(field.differences.back().L2);
        }
        coarse = std::move(fine);
      }
      norms.push_back(L2);
      scale[field.unit] = std::max(scale[field.unit], largest);
      study_.fields.push_back(std::move(field));
    }
    for (std::size_t i = 0; i < norms.size(); ++i) {
      auto& field = study_.fields[i];
      field.limit = study::convergence_of_differences(norms[i], refinement_ratio,
                                                      std::max(rtol(), single_precision) * scale.at(field.unit));
    }
  }

  const std::filesystem::path& folder_;
  const sweep::Manifest& manifest_;
  ConvergenceStudy study_;
  std::vector<Numbers> numbers_;
  std::vector<std::filesystem::path> files_;
  std::map<std::string, double> scale_;  ///< the largest number of each unit
};

}  // namespace

std::vector<double> times_like_the_end(const Scene& scene) {
  std::vector<double> times;
  if (scene.integration.method != Integration::Method::steady) return times;
  const auto box = experiment::box_at(scene.box, scene.motion, scene.end);
  for (const double t : scene.recording.listed_times) {
    const auto then = experiment::box_at(scene.box, scene.motion, t);
    if (then.tilt == box.tilt && then.gap == box.gap &&
        experiment::inflow_rate(scene.inflow, t) == experiment::inflow_rate(scene.inflow, scene.end))
      times.push_back(t);
  }
  return times;
}

ConvergenceStudy read_convergence_study(const std::filesystem::path& folder, const sweep::Manifest& manifest,
                                        const Scene& scene, const std::vector<double>& rtols) {
  return Reader(folder, manifest).read(scene, rtols);
}

ConvergenceVerdict verdict_of(const ConvergenceStudy& study) {
  if (study.n_counted < 3) return ConvergenceVerdict::cannot_tell;
  bool all = true, any_divergent = false;
  const auto look = [&](Tendency tendency) {
    all = all && (tendency == Tendency::settled || tendency == Tendency::convergent);
    any_divergent = any_divergent || tendency == Tendency::divergent;
  };
  for (const auto& number : study.numbers) look(number.limit.tendency);
  for (const auto& field : study.fields) look(field.limit.tendency);
  if (any_divergent) return ConvergenceVerdict::not_convergent;
  return all ? ConvergenceVerdict::convergent : ConvergenceVerdict::partly;
}

std::string_view word_of(ConvergenceVerdict verdict) {
  constexpr std::array<std::string_view, 4> words{"convergent", "partly convergent", "not convergent", "cannot tell"};
  return words.at(static_cast<std::size_t>(verdict));
}

}  // namespace talus::app
