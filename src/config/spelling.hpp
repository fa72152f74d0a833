#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus::config {

/// Number of single-letter insertions, deletions, replacements and swaps of neighbours between two words, upper and
/// lower case being equal (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, unless even that one differs in more than a third of its letters (two letters in a
/// short word), or in all of them.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace talus::config
