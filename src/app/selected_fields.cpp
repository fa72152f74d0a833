#include "app/selected_fields.hpp"

#include <algorithm>

namespace talus::app {
namespace {

bool wanted(const core::Variable& v, Selection selection) {
  const bool number_in_time = v.dimensions.empty() && !v.fixed;
  switch (selection) {
    case Selection::fields: return !number_in_time;
    case Selection::surface: return !number_in_time && v.dimensions.size() < 2;
    case Selection::series: return !v.fixed && v.dimensions.size() < 2;
    case Selection::numbers: return number_in_time;
  }
  return false;
}

}  // namespace

SelectedFields::SelectedFields(core::FieldSource& source, Selection selection) : source_(source) {
  const auto all = source.variables();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!wanted(all[i], selection)) continue;
    variables_.push_back(all[i]);
    if (selection == Selection::series && !all[i].dimensions.empty()) variables_.back().name += "_series";
    chosen_.push_back(i);
  }
}

std::vector<std::pair<std::string, std::size_t>> SelectedFields::dimensions() const {
  auto used = source_.dimensions();
  std::erase_if(used, [&](const auto& dimension) {
    return std::ranges::none_of(variables_, [&](const auto& v) {
      return std::ranges::find(v.dimensions, dimension.first) != v.dimensions.end();
    });
  });
  return used;
}

void SelectedFields::evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) {
  source_.evaluate(snapshot, all_);
  values.resize(chosen_.size());
  for (std::size_t i = 0; i < chosen_.size(); ++i) values[i].swap(all_[chosen_[i]]);
}

}  // namespace talus::app
