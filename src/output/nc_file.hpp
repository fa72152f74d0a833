#pragma once

#include <netcdf.h>

#include <filesystem>
#include <string>

#include "core/errors.hpp"

/// Inside this room only: the rest of Talus does not see netCDF.
namespace talus::output {

/// Throws OutputError(code) with `what` and netCDF's own words unless `status` is NC_NOERR.
void check(int status, core::ExitCode code, const std::string& what);

/// To be called before the first use of netCDF, since HDF5 reads its environment once: switches off HDF5's file lock unless
/// the environment says otherwise. It would shut out readers of a running job, and fails on many network drives.
void prepare_hdf5();

enum class Access { create, replace, read };

/// Owns one netCDF-4 file, open for writing unless for `read`.
class NcFile {
 public:
  /// Throws OutputError(io_setup), also where the file to create exists already.
  NcFile(const std::filesystem::path& path, Access access);
  NcFile(const NcFile&) = delete;
  NcFile& operator=(const NcFile&) = delete;
  /// Closes without a word; call close() to learn whether all is on disk.
  ~NcFile() { close(); }

  [[nodiscard]] int id() const { return id_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] bool is_open() const { return open_; }
  /// The file has got another name; it stays open.
  void renamed(const std::filesystem::path& path) { path_ = path; }

  /// Closes, at most once: HDF5 does not survive a second try after a failed one. Returns netCDF's status.
  int close() noexcept;

 private:
  std::filesystem::path path_;
  int id_ = -1;
  bool open_ = false;
};

}  // namespace talus::output
