#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace talus::app {

/// Keeps in `kept`, an object or null, the largest shares of the flow that `now`, the numbers of one record, has of what matters for
/// well-posedness, each with its time. Nothing where the model has no such numbers.
void note_well_posedness(nlohmann::ordered_json& kept, const nlohmann::ordered_json& now);

/// How close a run came to ill-posedness, in a sentence or two for people; empty where the model does not say. `kept`: by
/// note_well_posedness; `last`: the numbers of the last record.
[[nodiscard]] std::string well_posedness_words(const nlohmann::ordered_json& kept, const nlohmann::ordered_json& last);

}  // namespace talus::app
