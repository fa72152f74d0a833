#include "output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/errors.hpp"

namespace talus::output {

namespace {

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool valid() const { return number_ >= 0; }
  bool close() {
    const bool good = number_ < 0 || ::close(number_) == 0;
    number_ = -1;
    return good;
  }

 private:
  int number_;
};

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

void write_atomically(const std::filesystem::path& path, std::string_view text) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const std::filesystem::path beside = aside(path);
  const auto fail = [&] {
    const std::string reason = std::strerror(errno);
    ::unlink(beside.c_str());
    throw core::OutputError(core::ExitCode::output_failed, "cannot write " + path.string() + ": " + reason);
  };
  Descriptor file(::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!file.valid() || !write_all(file.number(), text) || ::fsync(file.number()) != 0 || !file.close()) fail();
  if (::rename(beside.c_str(), path.c_str()) != 0) fail();
  // The new name itself lives in the folder. Some file systems cannot bring a folder to disk: the text is safe
  // regardless.
  const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.valid()) ::fsync(directory.number());
}

std::filesystem::path aside(const std::filesystem::path& path) {
  return path.string() + ".part-" + std::to_string(getpid());
}

void bring_to_disk(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.valid() || ::fsync(file.number()) != 0)
    throw core::OutputError(core::ExitCode::output_failed,
                            "cannot bring " + path.string() + " to disk: " + std::strerror(errno));
}

}  // namespace talus::output
