#include "output/run_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "output/atomic_file.hpp"
#include "output/nc_file.hpp"
#include "output/record_stream.hpp"

namespace talus::output {

namespace {

using core::ExitCode;

/// Which file a path leads to: device and number; {0, 0} for none.
using Identity = std::pair<dev_t, ino_t>;

Identity identity_of(const std::filesystem::path& path) {
  struct stat info {};
  return stat(path.c_str(), &info) == 0 ? Identity(info.st_dev, info.st_ino) : Identity(0, 0);
}

}  // namespace

struct RunFile::State {
  State(const std::filesystem::path& path, const RunFileOptions& o)
      : file(path, o.replace ? Access::replace : Access::create), options(o), identity(identity_of(path)) {}

  NcFile file;
  RunFileOptions options;
  Identity identity;
  std::vector<RecordStream> streams;
};

namespace {

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

/// Makes the history of `to` go on from that of `from`.
void continue_history(int from, int to) {
  std::string all;
  for (const int file : {from, to}) {
    std::size_t length = 0;
    if (nc_inq_attlen(file, NC_GLOBAL, "history", &length) != NC_NOERR) continue;
    std::string lines(length, '\0');
    check(nc_get_att_text(file, NC_GLOBAL, "history", lines.data()), ExitCode::bad_restart, "history");
    all += (all.empty() ? "" : "\n") + lines;
  }
  if (!all.empty()) put_attribute(to, NC_GLOBAL, "history", all);
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
  if (identity_of(state_->file.path()) != state_->identity) {
    state_->file.close();
    throw core::OutputError(ExitCode::output_failed, name + " was removed or replaced during the run; its " +
                                                         std::to_string(records.n_records()) + " records went with it");
  }
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

void RunFile::take_place_of(const std::filesystem::path& earlier, const std::vector<std::size_t>& n_records) {
  NcFile& file = state_->file;
  const std::filesystem::path aside = file.path();
  try {
    if (n_records.size() != state_->streams.size())
      throw core::OutputError(ExitCode::bad_restart, "the checkpoint speaks of another number of streams");
    NcFile old(earlier, Access::read);
    for (std::size_t i = 0; i < state_->streams.size(); ++i) state_->streams[i].take_over(old.id(), n_records[i]);
    continue_history(old.id(), file.id());
    bring_to_disk();
    std::filesystem::rename(aside, earlier);
  } catch (const std::exception& error) {
    file.close();
    std::error_code ignored;
    std::filesystem::remove(aside, ignored);
    const auto* known = dynamic_cast<const core::Error*>(&error);
    const bool writing = known == nullptr || known->code() == ExitCode::output_failed;
    throw core::OutputError(writing ? ExitCode::output_failed : ExitCode::bad_restart,
                            earlier.string() + " cannot be continued: " + error.what());
  }
  file.renamed(earlier);
}

void RunFile::bring_to_disk() {
  check(nc_sync(state_->file.id()), ExitCode::output_failed, "writing " + state_->file.path().string());
  output::bring_to_disk(state_->file.path());
}

std::size_t RunFile::n_streams() const { return state_->streams.size(); }

double RunFile::last_time(std::size_t stream) const { return state_->streams.at(stream).last_time(); }

std::size_t RunFile::n_records(std::size_t stream) const { return state_->streams.at(stream).n_records(); }

void RunFile::close() {
  check(state_->file.close(), ExitCode::output_failed, "closing " + state_->file.path().string());
}

}  // namespace talus::output
