#include "output/table_file.hpp"

#include <unistd.h>

#include <array>
#include <limits>
#include <map>
#include <system_error>

#include "output/nc_file.hpp"
#include "output/record_stream.hpp"

namespace talus::output {
namespace {

using core::ExitCode;

void good(int status, const std::string& what) { check(status, ExitCode::output_failed, what); }

class TableWriter {
 public:
  TableWriter(int file, const Table& table) : file_(file), table_(table) {}

  void write() {
    for (const auto& [name, value] : table_.attributes) put_attribute(file_, NC_GLOBAL, name, value);
    for (const auto& [name, length] : table_.dimensions) {
      good(nc_def_dim(file_, name.c_str(), length, &dimensions_[name].id), "dimension '" + name + "'");
      dimensions_[name].length = length;
    }
    std::vector<int> ids;
    for (const auto& variable : table_.variables) ids.push_back(define(variable));
    for (std::size_t i = 0; i < ids.size(); ++i) put(ids[i], table_.variables[i]);
  }

 private:
  struct Dimension {
    int id = -1;
    std::size_t length = 0;
  };

  int define(const TableVariable& variable) {
    const std::string what = "variable '" + variable.name + "'";
    std::vector<int> dimensions;
    std::size_t size = 1;
    for (const auto& name : variable.dimensions) {
      dimensions.push_back(dimensions_.at(name).id);
      size *= dimensions_.at(name).length;
    }
    if (std::visit([](const auto& values) { return values.size(); }, variable.values) != size)
      throw core::Error(ExitCode::internal, what + " does not fill its dimensions");
    constexpr std::array<nc_type, 3> types{NC_DOUBLE, NC_INT64, NC_STRING};
    int id = -1;
    good(nc_def_var(file_, variable.name.c_str(), types.at(variable.values.index()),
                    static_cast<int>(dimensions.size()), dimensions.data(), &id),
         what);
    if (variable.values.index() == 0) {
      const double none = std::numeric_limits<double>::quiet_NaN();
      good(nc_def_var_fill(file_, id, NC_FILL, &none), what);
    }
    if (!variable.unit.empty()) put_attribute(file_, id, "units", variable.unit);
    put_attribute(file_, id, "long_name", variable.long_name);
    for (const auto& [name, value] : variable.attributes) put_attribute(file_, id, name, value);
    if (!variable.flags.empty()) put_flags(file_, id, NC_INT64, variable.flags);
    return id;
  }

  void put(int id, const TableVariable& variable) {
    const std::string what = "writing '" + variable.name + "'";
    if (const auto* numbers = std::get_if<std::vector<double>>(&variable.values)) {
      good(nc_put_var_double(file_, id, numbers->data()), what);
    } else if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&variable.values)) {
      const std::vector<long long> wide(integers->begin(), integers->end());
      good(nc_put_var_longlong(file_, id, wide.data()), what);
    } else {
      std::vector<const char*> texts;
      for (const auto& text : std::get<std::vector<std::string>>(variable.values)) texts.push_back(text.c_str());
      good(nc_put_var_string(file_, id, texts.data()), what);
    }
  }

  int file_;
  const Table& table_;
  std::map<std::string, Dimension> dimensions_;
};

}  // namespace

void write_table(const std::filesystem::path& path, const Table& table) {
  const std::filesystem::path aside = path.string() + ".part-" + std::to_string(getpid());
  std::error_code error;
  try {
    NcFile file(aside, Access::replace);
    TableWriter(file.id(), table).write();
    good(file.close(), "closing " + aside.string());
    std::filesystem::rename(aside, path, error);
    if (error) throw core::OutputError(ExitCode::output_failed, error.message());
  } catch (const core::Error& failure) {
    std::filesystem::remove(aside, error);
    if (failure.code() == ExitCode::internal) throw;
    throw core::OutputError(ExitCode::output_failed, "cannot write " + path.string() + ": " + failure.what());
  }
}

}  // namespace talus::output
