#include "output/nc_file.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace talus::output {

namespace {

/// HDF5 flushes files that could not be closed once more when the process exits, and crashes there. Handlers run last
/// in, first out: this one ends the process, with the status it was going to have, before HDF5's gets its turn.
void exit_before_hdf5() noexcept {
  static const int registered = on_exit(
      [](int status, void*) {
        std::fflush(nullptr);
        _exit(status);
      },
      nullptr);
  static_cast<void>(registered);
}

}  // namespace

void check(int status, core::ExitCode code, const std::string& what) {
  if (status != NC_NOERR) throw core::OutputError(code, what + ": " + nc_strerror(status));
}

void prepare_hdf5() { setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0); }

NcFile::NcFile(const std::filesystem::path& path, Access access) : path_(path) {
  prepare_hdf5();
  if (access == Access::read) {
    check(nc_open(path.c_str(), NC_NOWRITE, &id_), core::ExitCode::io_setup, "cannot read " + path.string());
  } else {
    if (access == Access::create && std::filesystem::exists(path))
      throw core::OutputError(core::ExitCode::io_setup, path.string() + " exists already and is not replaced");
    const int mode = NC_NETCDF4 | (access == Access::replace ? NC_CLOBBER : NC_NOCLOBBER);
    check(nc_create(path.c_str(), mode, &id_), core::ExitCode::io_setup, "cannot create " + path.string());
  }
  open_ = true;
}

int NcFile::close() noexcept {
  if (!open_) return NC_NOERR;
  open_ = false;
  const int status = nc_close(id_);
  if (status != NC_NOERR) exit_before_hdf5();
  return status;
}

}  // namespace talus::output
