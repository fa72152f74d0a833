#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/field_source.hpp"
#include "output/attributes.hpp"

namespace talus::output {

struct RunFileOptions {
  bool replace = false;                ///< overwrite a file that exists; else that is an error
  std::uint64_t reserve = 16u << 20u;  ///< room that must stay free on the disk after a record [byte]; 0: do not look
};

/// The netCDF-4 file of a run (CF-1.8), conventionally `run.nc`. It holds one or more streams of records, each a
/// FieldSource along an unlimited time dimension of its own. Every record is on disk when append() returns, so that a
/// killed run leaves a readable file, and other processes may read along (HDF5's file lock is off unless
/// HDF5_USE_FILE_LOCKING says otherwise).
class RunFile {
 public:
  /// Creates the file with its first stream, `fields` along "time", and global `attributes`. The source must outlive
  /// this object. Throws OutputError(io_setup).
  RunFile(const std::filesystem::path& path, core::FieldSource& fields, const Attributes& attributes,
          const RunFileOptions& options = {});
  /// Closes and never throws; call close() to learn whether that succeeded.
  ~RunFile();
  RunFile(const RunFile&) = delete;
  RunFile& operator=(const RunFile&) = delete;

  /// Adds a stream with times of its own and returns its number for append(). Dimensions of the same name are shared.
  /// Throws OutputError(io_setup).
  std::size_t add_stream(const std::string& time_name, core::FieldSource& source);

  /// Writes one record of a stream; 0 is the first. Throws OutputError(output_failed): before it touches the file if
  /// that is no longer at its path or the disk has too little room, or after having closed it if a write failed. Nothing
  /// can be written after that.
  void append(const core::Snapshot& snapshot, std::size_t stream = 0);

  /// Goes on where an earlier run's file `earlier` is to end: takes over the first n_records[i] records of each stream i
  /// and its history, then takes its place by rename; a reader of the earlier file keeps what it has open. To be called
  /// after the last add_stream() and before the first append(). Throws OutputError(bad_restart) where `earlier` does not
  /// hold those records, OutputError(output_failed) where they cannot be written; `earlier` is then as it was.
  void take_place_of(const std::filesystem::path& earlier, const std::vector<std::size_t>& n_records);

  /// Brings all records to disk (append() alone leaves them to the system): they then survive a loss of power. Throws
  /// OutputError(output_failed).
  void bring_to_disk();

  [[nodiscard]] std::size_t n_streams() const;
  [[nodiscard]] std::size_t n_records(std::size_t stream = 0) const;
  /// Time of a stream's last record [s]; -infinity without one.
  [[nodiscard]] double last_time(std::size_t stream = 0) const;

  /// Throws OutputError(output_failed) if what was written is not all on disk.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus::output
