#include "output/run_reader.hpp"

#include <algorithm>
#include <array>

#include "output/nc_file.hpp"

namespace talus::output {
namespace {

/// Names of a variable's dimensions.
std::vector<std::string> dimensions_of(int file, int id) {
  int n = 0;
  std::array<int, NC_MAX_VAR_DIMS> ids{};
  if (nc_inq_var(file, id, nullptr, nullptr, &n, ids.data(), nullptr) != NC_NOERR) return {};
  std::vector<std::string> names;
  for (int i = 0; i < n; ++i) {
    std::array<char, NC_MAX_NAME + 1> name{};
    nc_inq_dimname(file, ids.at(i), name.data());
    names.emplace_back(name.data());
  }
  return names;
}

void good(int status, const std::string& what) { check(status, core::ExitCode::io_setup, what); }

}  // namespace

RunReader::RunReader(const std::filesystem::path& path) : path_(path) {
  good(nc_open(path.c_str(), NC_NOWRITE, &file_), "cannot read " + path.string());
  int series_time = -1, n_variables = 0;
  if (nc_inq_dimid(file_, "series_time", &series_time) != NC_NOERR) series_time = -1;
  good(nc_inq_nvars(file_, &n_variables), path.string());
  for (int id = 0; id < n_variables; ++id) {
    char name[NC_MAX_NAME + 1];
    int n_dimensions = 0, dimension = -1;
    good(nc_inq_var(file_, id, name, nullptr, &n_dimensions, nullptr, nullptr), path.string());
    if (is_field(id)) fields_.emplace_back(name);
    if (n_dimensions != 1 || std::string(name) == "series_time") continue;
    good(nc_inq_vardimid(file_, id, &dimension), path.string());
    if (series_time >= 0 && dimension == series_time) series_.emplace_back(name);
  }
}

RunReader::~RunReader() { nc_close(file_); }

std::optional<RunReader::Description> RunReader::describe(const std::string& name) const {
  int id = -1;
  if (nc_inq_varid(file_, name.c_str(), &id) != NC_NOERR) return std::nullopt;
  return Description{text(id, "units"), text(id, "long_name")};
}

std::vector<double> RunReader::values(const std::string& name) const {
  const std::string what = path_.string() + ": " + name;
  int id = -1, dimension = -1;
  std::size_t n = 0;
  good(nc_inq_varid(file_, name.c_str(), &id), what);
  good(nc_inq_dimid(file_, "series_time", &dimension), what);
  good(nc_inq_dimlen(file_, dimension, &n), what);
  std::vector<double> values(n);
  if (n > 0) good(nc_get_var_double(file_, id, values.data()), what);
  return values;
}

RunReader::Cells RunReader::last_record(const std::string& name) const {
  const std::string what = path_.string() + ": " + name;
  int id = -1;
  good(nc_inq_varid(file_, name.c_str(), &id), what);
  Cells cells;
  std::vector<std::size_t> start, count;
  for (const auto& dimension : dimensions_of(file_, id)) {
    int number = -1;
    std::size_t n = 0;
    good(nc_inq_dimid(file_, dimension.c_str(), &number), what);
    good(nc_inq_dimlen(file_, number, &n), what);
    if (dimension == "layer") cells.n_layers = n;
    if (dimension == "column") cells.n_columns = n;
    const bool is_time = dimension == "time";
    if (is_time && n == 0) throw core::OutputError(core::ExitCode::io_setup, what + ": no record");
    start.push_back(is_time ? n - 1 : 0);
    count.push_back(is_time ? 1 : n);
  }
  cells.values.resize(cells.n_layers * cells.n_columns);
  good(nc_get_vara_double(file_, id, start.data(), count.data(), cells.values.data()), what);
  return cells;
}

bool RunReader::is_field(int id) const {
  const auto dimensions = dimensions_of(file_, id);
  const bool recorded = dimensions.size() > 1 && dimensions.front() == "time";
  const bool has_cells = std::all_of(dimensions.begin() + (recorded ? 1 : 0), dimensions.end(),
                                     [](const std::string& name) { return name == "layer" || name == "column"; });
  return recorded && has_cells && text(id, "axis").empty() && text(id, "flag_meanings").empty();
}

std::string RunReader::text(int variable, const char* attribute) const {
  std::size_t n = 0;
  if (nc_inq_attlen(file_, variable, attribute, &n) != NC_NOERR) return "";
  std::string text(n, '\0');
  good(nc_get_att_text(file_, variable, attribute, text.data()), path_.string());
  return text;
}

}  // namespace talus::output
