#include "output/run_file.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <vector>

#include "output/nc_file.hpp"
#include "output/record_stream.hpp"

namespace talus::output {

struct RunFile::State {
  State(const std::filesystem::path& path, const RunFileOptions& o) : file(path, o.replace), options(o) {}

  NcFile file;
  RunFileOptions options;
  std::vector<RecordStream> streams;
};

namespace {

using core::ExitCode;

/// Bytes by which the file may still grow: the disk's free room or the process's limit on file sizes.
std::uint64_t room_left(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const auto disk = std::filesystem::space(folder, error);
  std::uint64_t room = error ? UINT64_MAX : disk.available;
  rlimit limit{};
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error) room = std::min<std::uint64_t>(room, limit.rlim_cur > size ? limit.rlim_cur - size : 0);
  }
  return room;
}

}  // namespace

RunFile::RunFile(const std::filesystem::path& path, core::FieldSource& fields, const Attributes& attributes,
                 const RunFileOptions& options)
    : state_(std::make_unique<State>(path, options)) {
  const int file = state_->file.id();
  Attributes all = attributes;
  all.try_emplace("Conventions", "CF-1.8");
  for (const auto& [name, value] : all) put_attribute(file, NC_GLOBAL, name, value);
  add_stream("time", fields);
}

RunFile::~RunFile() = default;

std::size_t RunFile::add_stream(const std::string& time_name, core::FieldSource& source) {
  const int file = state_->file.id();
  state_->streams.emplace_back(file, time_name, source);
  check(nc_sync(file), ExitCode::io_setup, "setting up " + state_->file.path().string());
  return state_->streams.size() - 1;
}

void RunFile::append(const core::Snapshot& snapshot, std::size_t stream) {
  RecordStream& records = state_->streams.at(stream);
  const std::string name = state_->file.path().string();
  if (!state_->file.is_open())
    throw core::OutputError(ExitCode::output_failed, name + " is closed after an earlier failure");
  const std::uint64_t reserve = state_->options.reserve;
  if (reserve > 0 && room_left(state_->file.path()) < reserve + records.bytes_per_record()) {
    close();
    throw core::OutputError(ExitCode::output_failed, "no room for the next record of " + name + " (it holds " +
                                                         std::to_string(records.n_records()) +
                                                         " complete ones): disk full");
  }
  try {
    records.append(snapshot);
    check(nc_sync(state_->file.id()), ExitCode::output_failed, "writing to disk");
  } catch (const core::OutputError& error) {
    state_->file.close();
    throw core::OutputError(ExitCode::output_failed,
                            name + " at t = " + std::to_string(snapshot.t) + " s: " + error.what());
  }
}

std::size_t RunFile::n_records(std::size_t stream) const { return state_->streams.at(stream).n_records(); }

void RunFile::close() {
  check(state_->file.close(), ExitCode::output_failed, "closing " + state_->file.path().string());
}

}  // namespace talus::output
