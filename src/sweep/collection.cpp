#include "sweep/collection.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "config/spelling.hpp"
#include "core/errors.hpp"
#include "output/csv.hpp"
#include "output/run_reader.hpp"
#include "output/text_file.hpp"
#include "sweep/member_results.hpp"
#include "sweep/sweep_folder.hpp"

namespace talus::sweep {
namespace {

using output::TableVariable;
using Description = output::RunReader::Description;
using Names = std::set<std::string>;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// What summary.json adds to run.nc.
const std::map<std::string, Description>& own_descriptions() {
  static const std::map<std::string, Description> all{
      {"simulated_seconds", {"s", "simulated time that was reached"}},
      {"wall_seconds", {"s", "wall time of the run"}},
      {"cpu_seconds", {"s", "CPU time of the run"}},
      {"peak_memory_bytes", {"byte", "largest resident memory of the run"}}};
  return all;
}

double value_of(const std::map<std::string, double>& numbers, const std::string& name) {
  const auto found = numbers.find(name);
  return found == numbers.end() ? missing : found->second;
}

class Collector {
 public:
  Collector(const std::filesystem::path& folder, const Manifest& manifest, const std::vector<std::string>& series)
      : folder_(folder), manifest_(manifest), design_(manifest.design), place_(folder, design_.size()) {
    for (std::size_t i = 0; i < design_.size(); ++i) {
      const std::string scene = output::contents(folder / place_.scene(i));
      results_.push_back(read_member(folder / place_.member(i), scene, series));
    }
    for (const auto& member : results_) {
      for (const auto& [name, value] : member.last) last_.insert(name);
      for (const auto& [name, value] : member.costs) costs_.insert(name);
    }
    check(series);
    for (const auto& dimension : design_.dimensions()) dimensions_.push_back(dimension.name);
  }

  Collection collect(const std::vector<std::string>& series) {
    Collection out;
    table_ = &out.table;
    for (const auto& dimension : design_.dimensions()) add_dimension(dimension);
    add_states();
    for (const auto& name : last_)
      add(variable("final_" + name, describe(name), [&](const MemberResults& m) { return value_of(m.last, name); }));
    for (const auto& name : costs_)
      add(variable(name, describe(name), [&](const MemberResults& m) { return value_of(m.costs, name); }));
    add_times("record", "output.times", &MemberResults::records, last_);
    add_times("series", "output.series_interval", &MemberResults::series, Names(series.begin(), series.end()));
    out.table.attributes = {{"Conventions", "CF-1.8"},
                            {"title", manifest_.title.empty() ? manifest_.name : manifest_.title},
                            {"sweep", manifest_.name}};
    out.csv = csv();
    for (const auto& member : results_) out.members.push_back(member.state);
    return out;
  }

 private:
  void add(TableVariable variable) { table_->variables.push_back(std::move(variable)); }

  void add_dimension(const Dimension& dimension) {
    table_->dimensions.emplace_back(dimension.name, dimension.size());
    for (const auto& axis : dimension.axes) {
      const std::string name =
          dimension.axes.size() == 1 && dimension.name != "member" ? dimension.name : netcdf_name(axis.key);
      TableVariable coordinate{name, {dimension.name}, axis.unit, axis.doc, {}, {{"scene_key", axis.key}}};
      const auto& values = axis.values;
      if (std::ranges::all_of(values, [](const auto& v) { return std::holds_alternative<std::string>(v); })) {
        auto& texts = coordinate.values.emplace<std::vector<std::string>>();
        for (const auto& value : values) texts.push_back(std::get<std::string>(value));
      } else if (std::ranges::all_of(values, [](const auto& v) { return std::holds_alternative<double>(v); })) {
        auto& numbers = coordinate.values.emplace<std::vector<double>>();
        for (const auto& value : values) numbers.push_back(std::get<double>(value));
      } else {
        auto& integers = coordinate.values.emplace<std::vector<std::int64_t>>();
        for (const auto& value : values) {
          const auto* truth = std::get_if<bool>(&value);
          integers.push_back(truth != nullptr ? static_cast<std::int64_t>(*truth) : std::get<std::int64_t>(value));
        }
      }
      add(std::move(coordinate));
    }
  }

  void add_states() {
    std::vector<std::int64_t> number, status, code;
    for (const auto& member : results_) {
      number.push_back(static_cast<std::int64_t>(number.size()));
      status.push_back(static_cast<std::int64_t>(member.state.status));
      code.push_back(member.state.exit_code);
    }
    add({"member", dimensions_, "", "number of the member", std::move(number)});
    TableVariable state{"status", dimensions_, "", "what became of the member", std::move(status)};
    for (const auto each : {Status::planned, Status::unfinished, Status::stopped, Status::failed, Status::finished})
      state.flags.emplace_back(word_of(each));
    add(std::move(state));
    add({"exit_code", dimensions_, "", "exit code of the member; -1 where there is none", std::move(code)});
  }

  template <class Value>
  TableVariable variable(const std::string& name, const Description& description, const Value& value) {
    std::vector<double> values;
    for (const auto& member : results_) values.push_back(value(member));
    return {name, dimensions_, description.unit, description.long_name, std::move(values)};
  }

  /// `what`_time and, along it, `what`_NAME of each name; times are those of all members.
  void add_times(const std::string& what, const std::string& key, TimeSeries MemberResults::*part, const Names& names) {
    std::set<double> united;
    for (const auto& member : results_) united.insert((member.*part).times.begin(), (member.*part).times.end());
    if (united.empty() || names.empty()) return;
    const std::vector<double> times(united.begin(), united.end());
    const std::string dimension = what + "_time";
    table_->dimensions.emplace_back(dimension, times.size());
    auto dimensions = dimensions_;
    dimensions.push_back(dimension);
    add({dimension, {dimension}, "s", "simulated time, from " + key, times});
    for (const auto& name : names) {
      std::vector<double> values(results_.size() * times.size(), missing);
      for (std::size_t i = 0; i < results_.size(); ++i) {
        const TimeSeries& of_member = results_[i].*part;
        const auto found = of_member.numbers.find(name);
        if (found == of_member.numbers.end()) continue;
        for (std::size_t k = 0; k < of_member.times.size(); ++k) {
          const auto at = std::ranges::lower_bound(times, of_member.times[k]) - times.begin();
          values[i * times.size() + static_cast<std::size_t>(at)] = found->second.at(k);
        }
      }
      const auto description = describe(name);
      add({what + "_" + name, dimensions, description.unit, description.long_name, std::move(values)});
    }
  }

  /// Unit and long name, from the first member whose run.nc knows the name.
  const Description& describe(const std::string& name) {
    if (const auto own = own_descriptions().find(name); own != own_descriptions().end()) return own->second;
    if (const auto known = descriptions_.find(name); known != descriptions_.end()) return known->second;
    for (std::size_t i = 0; i < design_.size(); ++i) {
      const auto file = folder_ / place_.member(i) / "run.nc";
      if (!std::filesystem::exists(file)) continue;
      if (const auto found = output::RunReader(file).describe(name)) return descriptions_[name] = *found;
    }
    return descriptions_[name] = {"", name};
  }

  void check(const std::vector<std::string>& series) {
    for (const auto& name : series) {
      if (std::ranges::any_of(results_, [&](const auto& member) { return member.series.numbers.contains(name); }))
        continue;
      std::vector<std::string> known;
      for (std::size_t i = 0; i < design_.size() && known.empty(); ++i) {
        const auto file = folder_ / place_.member(i) / "run.nc";
        if (std::filesystem::exists(file)) known = output::RunReader(file).series();
      }
      std::string list;
      for (const auto& each : known) list += (list.empty() ? "" : ", ") + each;
      const auto meant = config::nearest(name, known);
      throw core::ConfigError("--series " + name + ": no member has it" +
                              (meant ? " (did you mean " + *meant + "?)" : "") + "; there are " +
                              (list.empty() ? "none" : list));
    }
  }

  std::string csv() {
    std::vector<std::string> line{"member", "folder"};
    const auto head = [&](const std::string& prefix, const std::string& name) {
      const auto& unit = describe(name).unit;
      line.push_back(prefix + name + (unit.empty() ? "" : " [" + unit + "]"));
    };
    for (const auto& [axis, value] : design_.settings(0)) line.push_back(heading(axis));
    line.insert(line.end(), {"status", "exit_code"});
    for (const auto& name : last_) head("final_", name);
    for (const auto& name : costs_) head("", name);
    std::string out = output::csv_line(line);
    const auto number = [&](double x) { line.push_back(x == x ? plain(x) : ""); };
    for (std::size_t i = 0; i < results_.size(); ++i) {
      const auto& member = results_[i];
      line = {std::to_string(i), place_.member(i)};
      for (const auto& [axis, value] : design_.settings(i)) line.push_back(plain(value));
      line.emplace_back(word_of(member.state.status));
      line.push_back(member.state.exit_code < 0 ? "" : std::to_string(member.state.exit_code));
      for (const auto& name : last_) number(value_of(member.last, name));
      for (const auto& name : costs_) number(value_of(member.costs, name));
      out += output::csv_line(line);
    }
    return out;
  }

  const std::filesystem::path& folder_;
  const Manifest& manifest_;
  const Design& design_;
  SweepFolder place_;
  std::vector<MemberResults> results_;
  Names last_, costs_;
  std::vector<std::string> dimensions_;
  std::map<std::string, Description> descriptions_;
  output::Table* table_ = nullptr;
};

}  // namespace

Collection collect(const std::filesystem::path& folder, const Manifest& manifest,
                   const std::vector<std::string>& series) {
  return Collector(folder, manifest, series).collect(series);
}

}  // namespace talus::sweep
