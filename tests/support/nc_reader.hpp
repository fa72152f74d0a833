#pragma once

#include <netcdf.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace talus::support {

/// Reads a netCDF file through the C API; each call throws std::runtime_error with netCDF's words where it fails.
class NcReader {
 public:
  explicit NcReader(const std::filesystem::path& path) { good(nc_open(path.c_str(), NC_NOWRITE, &file_)); }
  NcReader(const NcReader&) = delete;
  NcReader& operator=(const NcReader&) = delete;
  ~NcReader() { nc_close(file_); }

  [[nodiscard]] int file() const { return file_; }

  [[nodiscard]] int variable(const std::string& name) const {
    if (name.empty()) return NC_GLOBAL;
    int id = -1;
    good(nc_inq_varid(file_, name.c_str(), &id));
    return id;
  }

  [[nodiscard]] std::size_t length(const std::string& dimension) const {
    int id = -1;
    std::size_t n = 0;
    good(nc_inq_dimid(file_, dimension.c_str(), &id));
    good(nc_inq_dimlen(file_, id, &n));
    return n;
  }

  [[nodiscard]] std::vector<std::string> dimensions(const std::string& name) const {
    int n = 0;
    good(nc_inq_varndims(file_, variable(name), &n));
    std::vector<int> ids(static_cast<std::size_t>(n));
    good(nc_inq_vardimid(file_, variable(name), ids.data()));
    std::vector<std::string> names;
    for (const int id : ids) {
      char text[NC_MAX_NAME + 1];
      good(nc_inq_dimname(file_, id, text));
      names.emplace_back(text);
    }
    return names;
  }

  /// All values, row-major.
  [[nodiscard]] std::vector<double> values(const std::string& name) const {
    std::size_t n = 1;
    for (const std::string& dimension : dimensions(name)) n *= length(dimension);
    std::vector<double> all(n);
    good(nc_get_var_double(file_, variable(name), all.data()));
    return all;
  }

  /// All texts, row-major.
  [[nodiscard]] std::vector<std::string> texts(const std::string& name) const {
    std::size_t n = 1;
    for (const std::string& dimension : dimensions(name)) n *= length(dimension);
    std::vector<char*> raw(n);
    good(nc_get_var_string(file_, variable(name), raw.data()));
    std::vector<std::string> all(raw.begin(), raw.end());
    good(nc_free_string(n, raw.data()));
    return all;
  }

  [[nodiscard]] nc_type type(const std::string& name) const {
    nc_type t = NC_NAT;
    good(nc_inq_vartype(file_, variable(name), &t));
    return t;
  }

  /// An attribute of a variable, or of the file where `name` is empty.
  [[nodiscard]] std::string text(const std::string& name, const std::string& attribute) const {
    std::size_t n = 0;
    good(nc_inq_attlen(file_, variable(name), attribute.c_str(), &n));
    std::string all(n, '\0');
    good(nc_get_att_text(file_, variable(name), attribute.c_str(), all.data()));
    return all;
  }
  [[nodiscard]] double number(const std::string& name, const std::string& attribute) const {
    double x = 0.0;
    good(nc_get_att_double(file_, variable(name), attribute.c_str(), &x));
    return x;
  }
  [[nodiscard]] nc_type attribute_type(const std::string& name, const std::string& attribute) const {
    nc_type t = NC_NAT;
    good(nc_inq_atttype(file_, variable(name), attribute.c_str(), &t));
    return t;
  }

 private:
  static void good(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
  }
  int file_ = -1;
};

}  // namespace talus::support
