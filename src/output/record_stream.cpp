#include "output/record_stream.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "output/nc_file.hpp"

namespace talus::output {

namespace {

using core::ExitCode;

/// A chunk of this many values where a record is a single number: one such chunk is 4 kB.
constexpr std::size_t scalar_records_per_chunk = 512;

void check_setup(int status, const std::string& what) { check(status, ExitCode::io_setup, what); }

/// The integer that the whole text states, if it does.
std::optional<int> as_integer(const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

/// Sets the chunks of a variable, and lets netCDF keep one of them in memory: nothing is read back, and by default it keeps
/// 16 MiB of old records a variable.
void set_chunks(int file, int variable, const std::vector<std::size_t>& chunk, std::size_t bytes_a_value,
                const std::string& what) {
  std::size_t bytes = bytes_a_value;
  for (const std::size_t n : chunk) bytes *= n;
  check_setup(nc_def_var_chunking(file, variable, NC_CHUNKED, chunk.data()), what);
  check_setup(nc_set_var_chunk_cache(file, variable, bytes, 1, 0.0F), what);
}

bool is_container(const core::Variable& v) {
  return v.fixed && v.dimensions.empty() &&
         (v.attributes.contains("cf_role") || v.attributes.contains("grid_mapping_name"));
}

}  // namespace

void put_attribute(int file, int variable, const std::string& name, const Attribute& value) {
  int status = NC_NOERR;
  if (const auto* text = std::get_if<std::string>(&value))
    status = nc_put_att_text(file, variable, name.c_str(), text->size(), text->c_str());
  else if (const auto* real = std::get_if<double>(&value))
    status = nc_put_att_double(file, variable, name.c_str(), NC_DOUBLE, 1, real);
  else status = nc_put_att_int(file, variable, name.c_str(), NC_INT, 1, std::get_if<int>(&value));
  check_setup(status, "attribute '" + name + "'");
}

void put_flags(int file, int variable, int type, const std::vector<std::string>& flags) {
  std::vector<long long> values;
  std::string words;
  for (const auto& flag : flags) {
    values.push_back(static_cast<long long>(values.size()));
    words += (words.empty() ? "" : " ") + flag;
  }
  check_setup(nc_put_att_longlong(file, variable, "flag_values", type, values.size(), values.data()),
              "attribute 'flag_values'");
  put_attribute(file, variable, "flag_meanings", words);
}

RecordStream::RecordStream(int file, const std::string& time_name, core::FieldSource& source)
    : file_(file), time_name_(time_name), source_(source) {
  define_time();
  define_dimensions();
  for (const core::Variable& variable : source_.variables()) define(variable);
}

void RecordStream::define_time() {
  check_setup(nc_def_dim(file_, time_name_.c_str(), NC_UNLIMITED, &time_dimension_), "dimension '" + time_name_ + "'");
  check_setup(nc_def_var(file_, time_name_.c_str(), NC_DOUBLE, 1, &time_dimension_, &time_variable_),
              "variable '" + time_name_ + "'");
  set_chunks(file_, time_variable_, {scalar_records_per_chunk}, sizeof(double), "chunks of time");
  const Attributes attributes{{"units", "s"},
                              {"axis", "T"},
                              {"standard_name", "time"},
                              {"long_name", "simulated time since the start of the scene"}};
  for (const auto& [name, value] : attributes) put_attribute(file_, time_variable_, name, value);
}

void RecordStream::define_dimensions() {
  for (const auto& [name, length] : source_.dimensions()) {
    int id = -1;
    if (nc_inq_dimid(file_, name.c_str(), &id) != NC_NOERR) {
      check_setup(nc_def_dim(file_, name.c_str(), length, &id), "dimension '" + name + "'");
      continue;
    }
    std::size_t known = 0;
    check_setup(nc_inq_dimlen(file_, id, &known), "dimension '" + name + "'");
    if (known != length)
      throw core::Error(ExitCode::internal, "output dimension '" + name + "' has two lengths, " +
                                                std::to_string(known) + " and " + std::to_string(length));
  }
}

void RecordStream::define(const core::Variable& variable) {
  Slot slot{variable, -1, is_container(variable), {}, {}, 1};
  std::vector<int> dimensions;
  if (!variable.fixed) {
    dimensions.push_back(time_dimension_);
    slot.count.push_back(1);
  }
  for (const std::string& name : variable.dimensions) {
    int id = -1;
    std::size_t length = 0;
    if (nc_inq_dimid(file_, name.c_str(), &id) != NC_NOERR || nc_inq_dimlen(file_, id, &length) != NC_NOERR)
      throw core::Error(ExitCode::internal,
                        "output variable '" + variable.name + "' names the unknown dimension '" + name + "'");
    dimensions.push_back(id);
    slot.count.push_back(length);
    slot.size *= length;
  }
  slot.start.assign(slot.count.size(), 0);

  const std::string what = "variable '" + variable.name + "'";
  const bool single = variable.storage == core::Storage::single_precision;
  const nc_type type = slot.container ? NC_INT : single ? NC_FLOAT : NC_DOUBLE;
  check_setup(
      nc_def_var(file_, variable.name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(), &slot.id),
      what);
  if (!variable.dimensions.empty()) {
    set_chunks(file_, slot.id, slot.count, single ? sizeof(float) : sizeof(double), what);
    check_setup(nc_def_var_deflate(file_, slot.id, 1, 1, 1), what);
  } else if (!variable.fixed) {
    set_chunks(file_, slot.id, {scalar_records_per_chunk}, single ? sizeof(float) : sizeof(double), what);
  }
  if (!slot.container) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const float none_single = std::numeric_limits<float>::quiet_NaN();
    check_setup(nc_def_var_fill(file_, slot.id, NC_FILL, single ? static_cast<const void*>(&none_single) : &none),
                what);
    put_attribute(file_, slot.id, "units", variable.unit);
  }
  put_attribute(file_, slot.id, "long_name", variable.long_name);
  for (const auto& [name, text] : variable.attributes) {
    const std::optional<int> integer = as_integer(text);
    put_attribute(file_, slot.id, name, integer ? Attribute(*integer) : Attribute(text));
  }
  if (!variable.flags.empty()) put_flags(file_, slot.id, type, variable.flags);
  if (!variable.fixed) bytes_per_record_ += slot.size * (single ? sizeof(float) : sizeof(double));
  slots_.push_back(std::move(slot));
}

void RecordStream::append(const core::Snapshot& snapshot) {
  values_.resize(slots_.size());
  source_.evaluate(snapshot, values_);
  if (values_.size() != slots_.size())
    throw core::Error(ExitCode::internal, "an output source declares " + std::to_string(slots_.size()) +
                                              " variables but gives " + std::to_string(values_.size()));
  // Time comes first: a record that breaks off then reads as a time with missing values, not as values at no time.
  check(nc_put_var1_double(file_, time_variable_, &n_records_, &snapshot.t), ExitCode::output_failed,
        "writing '" + time_name_ + "'");
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (slot.container || (slot.variable.fixed && n_records_ > 0)) continue;
    if (!slot.variable.fixed) slot.start[0] = n_records_;
    write(slot, values_[i]);
  }
  ++n_records_;
  last_time_ = snapshot.t;
}

void RecordStream::take_over(int from, std::size_t n) {
  const auto must = [&](int status, const std::string& what) { check(status, ExitCode::bad_restart, what); };
  int dimension = -1, variable = -1;
  std::size_t there = 0;
  must(nc_inq_dimid(from, time_name_.c_str(), &dimension), "dimension '" + time_name_ + "'");
  must(nc_inq_dimlen(from, dimension, &there), "dimension '" + time_name_ + "'");
  must(nc_inq_varid(from, time_name_.c_str(), &variable), "variable '" + time_name_ + "'");
  if (there < n)
    throw core::OutputError(ExitCode::bad_restart, "it holds " + std::to_string(there) + " records along '" +
                                                       time_name_ + "', the checkpoint speaks of " + std::to_string(n));
  std::vector<double> times(n);
  const std::size_t first = 0;
  if (n > 0) must(nc_get_vara_double(from, variable, &first, &n, times.data()), "reading '" + time_name_ + "'");
  if (n > 0)
    check(nc_put_vara_double(file_, time_variable_, &first, &n, times.data()), ExitCode::output_failed,
          "writing '" + time_name_ + "'");
  for (const Slot& slot : slots_)
    if (!slot.container && n > 0) copy(slot, from, n);
  n_records_ = n;
  if (n > 0) last_time_ = times.back();
}

/// Record by record, as they were written: a value is moved, not converted.
void RecordStream::copy(const Slot& slot, int from, std::size_t n) {
  const std::string what = "variable '" + slot.variable.name + "'";
  const bool single = slot.variable.storage == core::Storage::single_precision;
  int id = -1;
  nc_type type = NC_NAT;
  check(nc_inq_varid(from, slot.variable.name.c_str(), &id), ExitCode::bad_restart, what);
  check(nc_inq_vartype(from, id, &type), ExitCode::bad_restart, what);
  if (type != (single ? NC_FLOAT : NC_DOUBLE))
    throw core::OutputError(ExitCode::bad_restart, what + " is of another type");
  auto start = slot.start, count = slot.count;
  const bool numbers = !slot.variable.fixed && slot.variable.dimensions.empty();  // all at once
  const std::size_t n_pieces = slot.variable.fixed || numbers ? 1 : n;
  if (numbers) count[0] = n;
  single_.resize(numbers ? n : slot.size);
  double_.resize(single_.size());
  for (std::size_t k = 0; k < n_pieces; ++k) {
    if (!slot.variable.fixed) start[0] = k;
    check(single ? nc_get_vara_float(from, id, start.data(), count.data(), single_.data())
                 : nc_get_vara_double(from, id, start.data(), count.data(), double_.data()),
          ExitCode::bad_restart, "reading " + what);
    check(single ? nc_put_vara_float(file_, slot.id, start.data(), count.data(), single_.data())
                 : nc_put_vara_double(file_, slot.id, start.data(), count.data(), double_.data()),
          ExitCode::output_failed, "writing " + what);
  }
}

void RecordStream::write(const Slot& slot, const std::vector<double>& values) {
  if (values.size() != slot.size)
    throw core::Error(ExitCode::internal, "output variable '" + slot.variable.name + "' has " +
                                              std::to_string(values.size()) + " values instead of " +
                                              std::to_string(slot.size));
  int status = NC_NOERR;
  if (slot.variable.storage == core::Storage::single_precision) {
    // Narrowed here, not by netCDF: it takes a value beyond float for an error, and an uncapped viscosity may be one.
    single_.resize(values.size());
    std::transform(values.begin(), values.end(), single_.begin(), [](double x) { return static_cast<float>(x); });
    status = nc_put_vara_float(file_, slot.id, slot.start.data(), slot.count.data(), single_.data());
  } else {
    status = nc_put_vara_double(file_, slot.id, slot.start.data(), slot.count.data(), values.data());
  }
  check(status, ExitCode::output_failed, "writing '" + slot.variable.name + "'");
}

}  // namespace talus::output
