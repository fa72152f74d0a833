#include "app/sweep_progress.hpp"

#include <unistd.h>

#include "app/progress.hpp"

namespace talus::app {
namespace {

constexpr int bar_width = 30;

}  // namespace

SweepProgress::SweepProgress(const sweep::Design& design, std::size_t n_skipped, std::FILE* stream)
    : design_(design), n_skipped_(n_skipped), stream_(stream), terminal_(isatty(fileno(stream)) != 0) {}

void SweepProgress::ended(std::size_t member, const sweep::MemberState& state, bool again) {
  using sweep::Status;
  if (!again) ++n_ended_;
  if (state.status == Status::failed && !again) ++n_failed_;
  if (terminal_ && state.status != Status::failed) return;
  std::string line = "member " + std::to_string(member) + " " + std::string(word_of(state.status));
  if (state.status != Status::finished) line += " (" + state.reason.substr(0, state.reason.find('\n')) + ")";
  if (again) line += ", will be tried once more";
  std::fprintf(stream_, "%s%s: %s; %zu of %zu done\n", terminal_ ? "\r\033[K" : "", line.c_str(),
               design_.describe(member).c_str(), n_skipped_ + n_ended_, design_.size());
  std::fflush(stream_);
}

void SweepProgress::idle(std::size_t running, std::size_t left) {
  if (!terminal_) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  const std::string rest =
      n_ended_ > 0 ? duration(seconds * static_cast<double>(left) / static_cast<double>(n_ended_)) : "unknown";
  const std::size_t done = n_skipped_ + n_ended_;
  std::fprintf(stream_, "\r%s %zu of %zu members done, %zu failed, %zu running, left about %s\033[K",
               bar(static_cast<double>(done) / static_cast<double>(design_.size()), bar_width).c_str(), done,
               design_.size(), n_failed_, running, rest.c_str());
  std::fflush(stream_);
}

void SweepProgress::finish() {
  if (terminal_) std::fputc('\n', stream_);
}

}  // namespace talus::app
