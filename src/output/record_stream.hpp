#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "core/field_source.hpp"
#include "output/attributes.hpp"

/// Inside this room only, see nc_file.hpp.
namespace talus::output {

/// Writes one attribute of `variable` (or NC_GLOBAL) in file `file`. Throws OutputError(io_setup).
void put_attribute(int file, int variable, const std::string& name, const Attribute& value);
/// CF's flag_values 0, 1, ... of netCDF type `type`, as the variable is, and flag_meanings.
void put_flags(int file, int variable, int type, const std::vector<std::string>& flags);

/// One unlimited time dimension of an open file and the variables of one FieldSource along it.
class RecordStream {
 public:
  /// Defines the time dimension, those of the source that the file does not have yet, and the variables. Throws
  /// OutputError(io_setup); Error(internal) for a dimension with two lengths or a variable of unknown dimensions.
  RecordStream(int file, const std::string& time_name, core::FieldSource& source);

  /// Writes the next record; the first one writes the fixed variables too. Throws OutputError(output_failed);
  /// Error(internal) where the source's values do not have the shape that it declared.
  void append(const core::Snapshot& snapshot);

  /// Takes over the first n records of the same stream in another open file, fixed variables too, before the first
  /// append(). Throws OutputError(bad_restart) where that file does not hold them as this stream would write them,
  /// OutputError(output_failed) where they cannot be written.
  void take_over(int from, std::size_t n);

  [[nodiscard]] std::size_t n_records() const { return n_records_; }
  /// Time of the last record [s]; -infinity without one.
  [[nodiscard]] double last_time() const { return last_time_; }
  /// Uncompressed size of a record [byte].
  [[nodiscard]] std::size_t bytes_per_record() const { return bytes_per_record_; }

 private:
  struct Slot {
    core::Variable variable;
    int id;
    bool container;                  ///< a scalar that only carries attributes, for example an SGRID topology
    std::vector<std::size_t> start;  ///< of a record, time first unless the variable is fixed
    std::vector<std::size_t> count;
    std::size_t size;  ///< values in a record
  };

  void define_time();
  void define_dimensions();
  void define(const core::Variable& variable);
  void write(const Slot& slot, const std::vector<double>& values);
  void copy(const Slot& slot, int from, std::size_t n);

  int file_;
  std::string time_name_;
  core::FieldSource& source_;
  int time_dimension_ = -1;
  int time_variable_ = -1;
  std::vector<Slot> slots_;
  std::vector<std::vector<double>> values_;
  std::vector<float> single_;
  std::vector<double> double_;
  std::size_t n_records_ = 0;
  double last_time_ = -std::numeric_limits<double>::infinity();
  std::size_t bytes_per_record_ = sizeof(double);
};

}  // namespace talus::output
