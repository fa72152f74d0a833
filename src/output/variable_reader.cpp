#include "output/variable_reader.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "output/nc_file.hpp"

namespace talus::output {
namespace {

void good(int status, const std::string& what) { check(status, core::ExitCode::io_setup, what); }

bool has_attribute(int file, int id, const char* name) {
  return nc_inq_att(file, id, name, nullptr, nullptr) == NC_NOERR;
}

std::string text(int file, int id, const char* attribute) {
  std::size_t n = 0;
  nc_type type = NC_NAT;
  if (nc_inq_att(file, id, attribute, &type, &n) != NC_NOERR || type != NC_CHAR) return "";
  std::string out(n, '\0');
  good(nc_get_att_text(file, id, attribute, out.data()), attribute);
  return out;
}

bool is_number(nc_type type) { return type != NC_CHAR && type != NC_STRING && type <= NC_MAX_ATOMIC_TYPE; }

/// What marks a missing number: the variable's own word, or netCDF's.
double fill_of(int file, int id, nc_type type) {
  double fill = std::numeric_limits<double>::quiet_NaN();
  if (nc_get_att_double(file, id, "_FillValue", &fill) == NC_NOERR) return fill;
  if (type == NC_DOUBLE) return NC_FILL_DOUBLE;
  return type == NC_FLOAT ? static_cast<double>(NC_FILL_FLOAT) : fill;
}

}  // namespace

VariableReader::VariableReader(const std::filesystem::path& path) : path_(path) {
  prepare_hdf5();
  good(nc_open(path.c_str(), NC_NOWRITE, &file_), path.string() + ": cannot be read as netCDF");
  int n = 0;
  good(nc_inq_nvars(file_, &n), path.string());
  for (int id = 0; id < n; ++id) {
    std::array<char, NC_MAX_NAME + 1> name{};
    nc_type type = NC_NAT;
    good(nc_inq_var(file_, id, name.data(), &type, nullptr, nullptr, nullptr), path.string());
    if (is_number(type)) names_.emplace_back(name.data());
  }
}

VariableReader::~VariableReader() { nc_close(file_); }

std::optional<StoredVariable> VariableReader::read(const std::string& name) const {
  if (std::ranges::find(names_, name) == names_.end()) return std::nullopt;
  const std::string what = path_.string() + ": " + name;
  int id = -1, n_dimensions = 0;
  nc_type type = NC_NAT;
  std::array<int, NC_MAX_VAR_DIMS> ids{};
  good(nc_inq_varid(file_, name.c_str(), &id), what);
  good(nc_inq_var(file_, id, nullptr, &type, &n_dimensions, ids.data(), nullptr), what);
  if (has_attribute(file_, id, "scale_factor") || has_attribute(file_, id, "add_offset"))
    throw core::OutputError(core::ExitCode::io_setup,
                            what + ": is packed (scale_factor, add_offset); expected plain numbers");
  StoredVariable out{text(file_, id, "units"), {}, {}, {}};
  std::size_t size = 1;
  for (int i = 0; i < n_dimensions; ++i) {
    std::array<char, NC_MAX_NAME + 1> dimension{};
    std::size_t length = 0;
    good(nc_inq_dim(file_, ids.at(static_cast<std::size_t>(i)), dimension.data(), &length), what);
    out.dimensions.emplace_back(dimension.data());
    out.lengths.push_back(length);
    size *= length;
  }
  out.values.resize(size);
  if (size > 0) good(nc_get_var_double(file_, id, out.values.data()), what);
  std::ranges::replace(out.values, fill_of(file_, id, type), std::numeric_limits<double>::quiet_NaN());
  return out;
}

}  // namespace talus::output
