#include "output/checkpoint.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "output/nc_file.hpp"
#include "output/record_stream.hpp"

namespace talus::output {
namespace {

using core::ExitCode;

constexpr const char* counter_prefix = "statistics_";

/// A netCDF file in memory, given up by the destructor unless it was closed.
class Image {
 public:
  Image() {
    prepare_hdf5();
    must(nc_create_mem("checkpoint", NC_NETCDF4, 0, &id_), ExitCode::internal);
  }
  explicit Image(std::string_view bytes) {
    prepare_hdf5();
    must(nc_open_mem("checkpoint", NC_NOWRITE, bytes.size(), const_cast<char*>(bytes.data()), &id_),
         ExitCode::bad_restart);
  }
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  ~Image() {
    if (open_) nc_close(id_);
  }
  [[nodiscard]] int id() const { return id_; }
  static void must(int status, ExitCode code) { check(status, code, "checkpoint"); }

  std::string close() {
    NC_memio memory{};
    open_ = false;
    must(nc_close_memio(id_, &memory), ExitCode::internal);
    std::string bytes(static_cast<const char*>(memory.memory), memory.size);
    std::free(memory.memory);
    return bytes;
  }

 private:
  int id_ = -1;
  bool open_ = true;
};

class Writer {
 public:
  void attribute(const std::string& name, const Attribute& value) {
    put_attribute(image_.id(), NC_GLOBAL, name, value);
  }
  int dimension(const char* name, std::size_t length) {
    int id = -1;
    good(nc_def_dim(image_.id(), name, length, &id));
    return id;
  }
  void text(const std::string& name, const std::string& value) {
    int id = -1;
    const int length = dimension((name + "_length").c_str(), value.size());
    good(nc_def_var(image_.id(), name.c_str(), NC_CHAR, 1, &length, &id));
    good(nc_put_var_text(image_.id(), id, value.c_str()));
  }
  void variable(const char* name, int dimension, const std::string& meaning, const std::vector<double>& values) {
    int id = -1;
    good(nc_def_var(image_.id(), name, NC_DOUBLE, 1, &dimension, &id));
    put_attribute(image_.id(), id, "long_name", meaning);
    good(nc_put_var_double(image_.id(), id, values.data()));
  }
  std::string close() { return image_.close(); }

 private:
  static void good(int status) { Image::must(status, ExitCode::internal); }
  Image image_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : image_(bytes) {}
  [[nodiscard]] std::string attribute(const std::string& name) const {
    std::size_t length = 0;
    good(nc_inq_attlen(image_.id(), NC_GLOBAL, name.c_str(), &length));
    std::string value(length, '\0');
    good(nc_get_att_text(image_.id(), NC_GLOBAL, name.c_str(), value.data()));
    return value;
  }
  [[nodiscard]] double number(const std::string& name) const {
    double value = 0.0;
    good(nc_get_att_double(image_.id(), NC_GLOBAL, name.c_str(), &value));
    return value;
  }
  [[nodiscard]] std::string text(const char* name) const {
    const auto [id, length] = find(name);
    std::string value(length, '\0');
    good(nc_get_var_text(image_.id(), id, value.data()));
    return value;
  }
  [[nodiscard]] std::vector<double> variable(const char* name) const {
    const auto [id, length] = find(name);
    std::vector<double> values(length);
    good(nc_get_var_double(image_.id(), id, values.data()));
    return values;
  }

 private:
  [[nodiscard]] std::pair<int, std::size_t> find(const char* name) const {
    int id = -1, dimension = -1;
    std::size_t length = 0;
    good(nc_inq_varid(image_.id(), name, &id));
    good(nc_inq_vardimid(image_.id(), id, &dimension));
    good(nc_inq_dimlen(image_.id(), dimension, &length));
    return {id, length};
  }
  static void good(int status) { Image::must(status, ExitCode::bad_restart); }
  Image image_;
};

void must_be_finite(const std::vector<double>& values, const std::string& what) {
  const auto bad = std::ranges::find_if(values, [](double x) { return !std::isfinite(x); });
  if (bad != values.end())
    throw core::IntegrationError("no checkpoint is written of a state that is not finite: " + what + " of unknown " +
                                 std::to_string(bad - values.begin()));
}

template <class To, class From>
std::vector<To> converted(const std::vector<From>& values) {
  std::vector<To> out;
  for (const auto& value : values) out.push_back(static_cast<To>(value));
  return out;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const auto& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::vector<std::string> parted(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ' ') words.emplace_back();
    else words.back() += c;
  }
  return words;
}

}  // namespace

void Checkpoint::set_layout(const core::Layout& layout) {
  fields.clear();
  for (const auto& field : layout.fields) fields.push_back(field.name);
  field_of = layout.field_of;
}

bool Checkpoint::fits(const core::Layout& layout) const {
  return field_of == layout.field_of && std::ranges::equal(fields, layout.fields, {}, {}, &core::Field::name);
}

std::string to_bytes(const Checkpoint& c) {
  must_be_finite({c.t}, "time");
  must_be_finite(c.y, "value");
  must_be_finite(c.yp, "rate");
  Writer file;
  file.attribute("title", "Talus checkpoint; go on with `talus restart` on its folder");
  file.attribute("time", c.t);
  file.attribute("talus_version", c.talus_version);
  file.attribute("git_revision", c.revision);
  file.attribute("fields", joined(c.fields));
  file.attribute("linear_solver", c.linear_solver);
  file.text("scene", c.scene);
  file.text("summary", c.summary);
  core::for_each_counter(c.statistics, [&](const char* name, auto value) {
    file.attribute(counter_prefix + std::string(name), static_cast<double>(value));
  });
  const int unknown = file.dimension("unknown", c.y.size()), stream = file.dimension("stream", c.n_records.size());
  file.variable("y", unknown, "unknowns, each in the unit of its field", c.y);
  file.variable("y_prime", unknown, "their rates, per second", c.yp);
  file.variable("field", unknown, "number in the list of fields", converted<double>(c.field_of));
  file.variable("n_records", stream, "records of each stream of run.nc", converted<double>(c.n_records));
  return file.close();
}

Checkpoint checkpoint_from(std::string_view bytes) {
  const Reader file(bytes);
  Checkpoint c;
  c.t = file.number("time");
  c.talus_version = file.attribute("talus_version");
  c.revision = file.attribute("git_revision");
  c.fields = parted(file.attribute("fields"));
  c.linear_solver = file.attribute("linear_solver");
  c.scene = file.text("scene");
  c.summary = file.text("summary");
  core::for_each_counter(c.statistics, [&](const char* name, auto& value) {
    value = static_cast<std::remove_reference_t<decltype(value)>>(file.number(counter_prefix + std::string(name)));
  });
  c.y = file.variable("y");
  c.yp = file.variable("y_prime");
  c.field_of = converted<std::uint8_t>(file.variable("field"));
  c.n_records = converted<std::size_t>(file.variable("n_records"));
  if (c.yp.size() != c.y.size() || c.field_of.size() != c.y.size())
    throw core::OutputError(ExitCode::bad_restart, "checkpoint: y, y_prime and field differ in length");
  return c;
}

}  // namespace talus::output
