#include "output/run_reader.hpp"

#include "output/nc_file.hpp"

namespace talus::output {
namespace {

void good(int status, const std::string& what) { check(status, core::ExitCode::io_setup, what); }

}  // namespace

RunReader::RunReader(const std::filesystem::path& path) : path_(path) {
  good(nc_open(path.c_str(), NC_NOWRITE, &file_), "cannot read " + path.string());
  int series_time = -1, n_variables = 0;
  if (nc_inq_dimid(file_, "series_time", &series_time) != NC_NOERR) return;
  good(nc_inq_nvars(file_, &n_variables), path.string());
  for (int id = 0; id < n_variables; ++id) {
    char name[NC_MAX_NAME + 1];
    int n_dimensions = 0, dimension = -1;
    good(nc_inq_var(file_, id, name, nullptr, &n_dimensions, nullptr, nullptr), path.string());
    if (n_dimensions != 1 || std::string(name) == "series_time") continue;
    good(nc_inq_vardimid(file_, id, &dimension), path.string());
    if (dimension == series_time) series_.emplace_back(name);
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

std::string RunReader::text(int variable, const char* attribute) const {
  std::size_t n = 0;
  if (nc_inq_attlen(file_, variable, attribute, &n) != NC_NOERR) return "";
  std::string text(n, '\0');
  good(nc_get_att_text(file_, variable, attribute, text.data()), path_.string());
  return text;
}

}  // namespace talus::output
