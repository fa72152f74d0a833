#include "app/selected_fields.hpp"

#include <algorithm>

namespace talus::app {
namespace {

/// Dimensions of the model's fields: 2 over columns and layers, 1 over layers alone.
std::size_t rank(const std::vector<core::Variable>& all) {
  std::size_t most = 1;
  for (const auto& v : all) most = std::max(most, v.dimensions.size());
  return most;
}

bool wanted(const core::Variable& v, std::size_t rank, Selection selection) {
  const bool number_in_time = v.dimensions.empty() && !v.fixed;
  const bool below_rank = v.dimensions.size() < rank;
  switch (selection) {
    case Selection::fields: return !number_in_time;
    case Selection::surface: return !number_in_time && (below_rank || (v.fixed && v.dimensions.size() == 1));
    case Selection::series: return !v.fixed && below_rank;
    case Selection::numbers: return number_in_time;
  }
  return false;
}

}  // namespace

const std::vector<std::vector<double>>& EvaluatedFields::at(const core::Snapshot& snapshot) {
  if (empty_ || snapshot.t != t_) source_.evaluate(snapshot, values_);
  empty_ = false;
  t_ = snapshot.t;
  return values_;
}

SelectedFields::SelectedFields(EvaluatedFields& evaluated, Selection selection) : evaluated_(evaluated) {
  const auto all = evaluated.source().variables();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!wanted(all[i], rank(all), selection)) continue;
    variables_.push_back(all[i]);
    if (selection == Selection::series && !all[i].dimensions.empty()) variables_.back().name += "_series";
    chosen_.push_back(i);
  }
}

std::vector<std::pair<std::string, std::size_t>> SelectedFields::dimensions() const {
  auto used = evaluated_.source().dimensions();
  std::erase_if(used, [&](const auto& dimension) {
    return std::ranges::none_of(variables_, [&](const auto& v) {
      return std::ranges::find(v.dimensions, dimension.first) != v.dimensions.end();
    });
  });
  return used;
}

void SelectedFields::evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) {
  const auto& all = evaluated_.at(snapshot);
  values.resize(chosen_.size());
  for (std::size_t i = 0; i < chosen_.size(); ++i) values[i] = all[chosen_[i]];
}

}  // namespace talus::app
