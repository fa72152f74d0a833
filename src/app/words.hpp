#pragma once

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/scene.hpp"
#include "ida/options.hpp"
#include "layer/parameters.hpp"
#include "linear/direct_solver.hpp"
#include "two_fluid/parameters.hpp"

/// The words of a scene file that stand for a case of the code, each pair once.
namespace talus::app::words {

template <class T, std::size_t N>
using Table = std::array<std::pair<std::string_view, T>, N>;

inline constexpr Table<rheology::Cap, 3> caps{
    {{"none", rheology::Cap::none}, {"hard", rheology::Cap::hard}, {"smooth", rheology::Cap::smooth}}};
inline constexpr Table<layer::Advection, 3> advections{
    {{"none", layer::Advection::none}, {"upwind", layer::Advection::upwind}, {"central", layer::Advection::central}}};
inline constexpr Table<two_fluid::Sharpening, 3> sharpenings{
    {{"none", two_fluid::Sharpening::none},
     {"segregation", two_fluid::Sharpening::segregation},
     {"counter_gradient", two_fluid::Sharpening::counter_gradient}}};
inline constexpr Table<two_fluid::Jet, 2> jets{
    {{"resolved", two_fluid::Jet::resolved}, {"free_fall", two_fluid::Jet::free_fall}}};
inline constexpr Table<two_fluid::Direction, 3> directions{{{"gravity", two_fluid::Direction::gravity},
                                                            {"base_normal", two_fluid::Direction::base_normal},
                                                            {"settling", two_fluid::Direction::settling}}};
inline constexpr Table<two_fluid::Transport, 3> transports{{{"limited", two_fluid::Transport::limited},
                                                            {"upwind", two_fluid::Transport::upwind},
                                                            {"jet", two_fluid::Transport::jet}}};
inline constexpr Table<two_fluid::Averaging, 2> averagings{
    {{"arithmetic", two_fluid::Averaging::arithmetic}, {"harmonic", two_fluid::Averaging::harmonic}}};
/// Whether two_fluid::Reach is limited.
inline constexpr Table<bool, 2> extents{{{"box", false}, {"reachable", true}}};
inline constexpr Table<linear::Choice, 7> linear_solvers{{{"automatic", linear::Choice::automatic},
                                                          {"klu", linear::Choice::klu},
                                                          {"umfpack", linear::Choice::umfpack},
                                                          {"dissected", linear::Choice::dissected},
                                                          {"mumps", linear::Choice::mumps},
                                                          {"banded", linear::Choice::banded},
                                                          {"condensed", linear::Choice::condensed}}};
inline constexpr Table<Integration::Method, 2> methods{
    {{"bdf", Integration::Method::bdf}, {"steady", Integration::Method::steady}}};
inline constexpr Table<ida::Newton, 2> newtons{{{"damped", ida::Newton::damped}, {"stock", ida::Newton::stock}}};
inline constexpr Table<grid::Spacing, 2> spacings{
    {{"clustered", grid::Spacing::clustered}, {"uniform", grid::Spacing::uniform}}};
inline constexpr Table<Initial::State, 3> initial_states{
    {{"rest", Initial::State::rest}, {"profile", Initial::State::profile}, {"steady", Initial::State::steady}}};
inline constexpr Table<bool, 2> ends{{{"open", true}, {"wall", false}}};
inline constexpr Table<bool, 2> surfaces{{{"free", false}, {"lid", true}}};
inline constexpr Table<experiment::Contact, 2> contacts{
    {{"no_slip", experiment::Contact::no_slip}, {"free_slip", experiment::Contact::free_slip}}};

/// The laws by their place in rheology::Law.
inline constexpr Table<std::size_t, 3> laws{{{"classical", 0}, {"partially_regularised", 1}, {"constant", 2}}};

template <class T, std::size_t N>
std::vector<std::string> of(const Table<T, N>& table) {
  std::vector<std::string> out;
  for (const auto& [word, value] : table) out.emplace_back(word);
  return out;
}

/// Precondition: `word` is in the table, as the schema has checked.
template <class T, std::size_t N>
T meaning(const Table<T, N>& table, std::string_view word) {
  for (const auto& [known, value] : table) {
    if (known == word) return value;
  }
  throw std::logic_error("no meaning for the word " + std::string(word));
}

/// A length for messages.
inline std::string in_metres(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g m", x);
  return text.data();
}

}  // namespace talus::app::words
