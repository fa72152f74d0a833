#include "output/combined_fields.hpp"

#include <algorithm>
#include <utility>

namespace talus::output {

CombinedFields::CombinedFields(std::vector<std::reference_wrapper<core::FieldSource>> sources)
    : sources_(std::move(sources)), values_(sources_.size()) {
  for (const core::FieldSource& source : sources_) n_variables_.push_back(source.variables().size());
}

std::vector<std::pair<std::string, std::size_t>> CombinedFields::dimensions() const {
  std::vector<std::pair<std::string, std::size_t>> all;
  for (const core::FieldSource& source : sources_) {
    // A name with two different lengths stays in twice: the writer names it.
    for (auto& dimension : source.dimensions())
      if (std::find(all.begin(), all.end(), dimension) == all.end()) all.push_back(std::move(dimension));
  }
  return all;
}

std::vector<core::Variable> CombinedFields::variables() const {
  std::vector<core::Variable> all;
  for (const core::FieldSource& source : sources_)
    for (auto& variable : source.variables()) all.push_back(std::move(variable));
  return all;
}

void CombinedFields::evaluate(const core::Snapshot& snapshot, std::vector<std::vector<double>>& values) {
  values.clear();
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    values_[i].resize(n_variables_[i]);
    sources_[i].get().evaluate(snapshot, values_[i]);
    values.insert(values.end(), values_[i].begin(), values_[i].end());
  }
}

}  // namespace talus::output
