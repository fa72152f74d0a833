#include "output/checkpoint_folder.hpp"

#include <nettle/sha2.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>

#include "output/atomic_file.hpp"

namespace talus::output {
namespace {

constexpr std::size_t n_kept = 2;

std::filesystem::path sum_of(const std::filesystem::path& file) { return file.string() + ".sha256"; }

std::string sha256(std::string_view bytes) {
  sha256_ctx context{};
  sha256_init(&context);
  sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string hexadecimal;
  for (const auto byte : digest) {
    std::array<char, 3> two{};
    std::snprintf(two.data(), two.size(), "%02x", byte);
    hexadecimal += two.data();
  }
  return hexadecimal;
}

/// A line that `sha256sum -c` understands.
std::string sum_line(std::string_view bytes, const std::filesystem::path& file) {
  return sha256(bytes) + "  " + file.filename().string() + "\n";
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

std::string CheckpointFolder::write(const Checkpoint& checkpoint) {
  const std::string bytes = to_bytes(checkpoint);
  auto present = numbers();
  const int number = present.empty() ? 1 : present.back() + 1;
  write_atomically(file(number), bytes);
  write_atomically(sum_of(file(number)), sum_line(bytes, file(number)));
  present.push_back(number);
  for (std::size_t i = 0; i + n_kept < present.size(); ++i) remove(present[i]);
  return file(number).filename().string();
}

CheckpointFolder::Found CheckpointFolder::newest() const {
  Found found;
  auto present = numbers();
  for (auto number = present.rbegin(); number != present.rend(); ++number) {
    const auto path = file(*number);
    const std::string bytes = contents(path), sum = contents(sum_of(path));
    found.file = path.filename().string();
    if (sum.empty()) {
      found.damaged.push_back(found.file + " has no checksum beside it");
    } else if (sum != sum_line(bytes, path)) {
      found.damaged.push_back(found.file + " does not agree with its checksum");
    } else {
      found.checkpoint = checkpoint_from(bytes);
      return found;
    }
  }
  found.file.clear();
  return found;
}

void CheckpointFolder::remove_damaged(const Found& found) {
  for (const int number : numbers()) {
    const std::string name = file(number).filename().string();
    if (std::ranges::any_of(found.damaged, [&](const auto& words) { return words.starts_with(name); })) remove(number);
  }
}

void CheckpointFolder::clear() {
  for (const int number : numbers()) {
    std::filesystem::remove(file(number));
    std::filesystem::remove(sum_of(file(number)));
  }
}

std::vector<int> CheckpointFolder::numbers() const {
  static const std::regex pattern(R"(checkpoint_(\d{6})\.nc)");
  std::vector<int> all;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    std::smatch match;
    if (entry.is_regular_file(error) && std::regex_match(name, match, pattern)) all.push_back(std::stoi(match[1]));
  }
  std::ranges::sort(all);
  return all;
}

std::filesystem::path CheckpointFolder::file(int number) const {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "checkpoint_%06d.nc", number);
  return folder_ / name.data();
}

/// The sum goes first: what is left of a removal that is cut short has no sum, and does not count as whole.
void CheckpointFolder::remove(int number) {
  std::error_code ignored;
  std::filesystem::remove(sum_of(file(number)), ignored);
  std::filesystem::remove(file(number), ignored);
}

}  // namespace talus::output
