#include "sweep/sweep_folder.hpp"

#include <algorithm>

namespace talus::sweep {

SweepFolder::SweepFolder(std::filesystem::path path, std::size_t n_members)
    : path_(std::move(path)), width_(std::max<std::size_t>(4, std::to_string(n_members - 1).size())) {}

std::string SweepFolder::number(std::size_t member) const {
  const std::string digits = std::to_string(member);
  return std::string(width_ - digits.size(), '0') + digits;
}

}  // namespace talus::sweep
