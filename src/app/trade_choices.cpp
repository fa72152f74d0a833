#include "app/trade_choices.hpp"

#include <cmath>
#include <set>

#include "app/models.hpp"
#include "app/words.hpp"
#include "config/read.hpp"
#include "core/errors.hpp"

namespace talus::app {
namespace {

using config::Scalar;
using Settings = std::map<std::string, Scalar>;

class Builder {
 public:
  explicit Builder(const Scene& scene)
      : scene_(scene), values_(config::read_text(scene_schema(), scene.effective, scene.name)) {}

  TradeChoices build() {
    add({"scene", "as it stands", {}, 1.0});
    auto finest = grid_of(reference_refinement);
    finest["integrator.rtol"] = scene_.integration.rtol / reference_tolerances;
    add({"reference", "cells halved, rtol a tenth", finest, 0.0});
    grids();
    tolerances();
    numbers("max_order", "integrator.max_order",
            {Scalar(std::int64_t{1}), Scalar(std::int64_t{2}), Scalar(std::int64_t{3})});
    if (has_layers()) regularisations();
    words("advection", "model.advection", words::of(words::advections));
    if (has_layers()) words("spacing", "grid.spacing", words::of(words::spacings));
    words("linear solver", "integrator.linear_solver", words::of(words::linear_solvers));
    words("newton", "integrator.newton", words::of(words::newtons));
    words("rung", "model.name", model_names());
    directions();
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool has_layers() const { return model(scene_.model).has_layers; }
  [[nodiscard]] bool has_columns() const { return has_layers() && model(scene_.model).has_columns; }

  /// Columns and layers times `ratio`, as far as the model has them; empty where they would not be whole numbers.
  [[nodiscard]] Settings grid_of(double ratio) const {
    Settings out;
    const auto scaled = [&](const char* key, int cells) {
      const double n = cells * ratio;
      if (n != static_cast<double>(static_cast<std::int64_t>(n))) return false;
      out[key] = static_cast<std::int64_t>(n);
      return true;
    };
    if (has_columns() && !scaled("grid.columns", scene_.cells.columns)) return {};
    if (has_layers() && !scaled("grid.layers", scene_.cells.layers)) return {};
    return out;
  }

  void grids() {
    for (const double ratio : {0.25, 0.5}) {
      const auto settings = grid_of(ratio);
      if (!settings.empty()) add({"grid", grid_words(settings), settings, ratio});
    }
  }

  /// Half the cells in one direction alone.
  void directions() {
    if (!has_columns()) return;
    const auto half = grid_of(0.5);
    for (const auto& [key, words] : {std::pair{"grid.columns", "half along"}, std::pair{"grid.layers", "half across"}})
      if (const auto found = half.find(key); found != half.end())
        add({"cells", words, {{found->first, found->second}}, 0.0});
  }

  static std::string grid_words(const Settings& settings) {
    std::string out;
    for (const auto& [key, value] : settings) out += (out.empty() ? "" : "x") + sweep::plain(value);
    return out;
  }

  void tolerances() {
    for (const double rtol : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
      if (rtol == scene_.integration.rtol) continue;
      add({"rtol", sweep::plain(rtol), {{"integrator.rtol", rtol}}, 0.0});
      if (rtol < scene_.integration.rtol) continue;
      for (const double ratio : {0.25, 0.5}) {
        auto settings = grid_of(ratio);
        if (settings.empty()) continue;
        const std::string words = grid_words(settings) + ", " + sweep::plain(rtol);
        settings["integrator.rtol"] = rtol;
        add({"grid and rtol", words, settings, 0.0});
      }
    }
  }

  void regularisations() {
    scaled("eta_max", "rheology.eta_max", {-2, -1, 1, 2});
    scaled("p_0", "rheology.p_0", {-1, 1});
    if (scene_.wall.mu_w > 0.0) scaled("u_c", "wall.u_c", {-1, 1});
  }

  /// The scene's own number times powers of ten.
  void scaled(const std::string& group, const std::string& key, const std::vector<int>& powers) {
    if (!values_.has(key)) return;
    const double own = values_.number(key);
    if (!(own > 0.0)) return;
    for (const int power : powers) {
      const double value = power < 0 ? own / std::pow(10.0, -power) : own * std::pow(10.0, power);
      add({group, sweep::plain(value), {{key, value}}, 0.0});
    }
  }

  void numbers(const std::string& group, const std::string& key, const std::vector<Scalar>& choices) {
    for (const auto& choice : choices) add({group, sweep::plain(choice), {{key, choice}}, 0.0});
  }

  void words(const std::string& group, const std::string& key, const std::vector<std::string>& choices) {
    if (!values_.has(key)) return;
    for (const auto& word : choices) {
      if (word != values_.text(key)) add({group, word, {{key, word}}, 0.0});
    }
  }

  void add(TradeChoice choice) {
    std::vector<std::string> overrides;
    for (const auto& [key, value] : choice.settings)
      overrides.push_back(key + "=" + config::to_toml(config::value_of(value)));
    try {
      (void)read_scene_text(scene_.effective, scene_.name, overrides);
    } catch (const core::ConfigError& error) {
      const std::string why = error.what();
      out_.left_out.push_back(choice.group + " " + choice.words + ": " + why.substr(0, why.find('\n')));
      return;
    }
    out_.all.push_back(std::move(choice));
  }

  const Scene& scene_;
  config::Values values_;
  TradeChoices out_;
};

/// The scene's own value of a key that has a single one.
Scalar own_value(const config::Values& values, const std::string& key) {
  switch (values.schema().find(key)->type) {
    case config::Type::number: return values.number(key);
    case config::Type::integer: return values.integer(key);
    case config::Type::boolean: return values.boolean(key);
    default: return values.text(key);
  }
}

}  // namespace

TradeChoices trade_choices(const Scene& scene) { return Builder(scene).build(); }

sweep::Dimension dimension_of(const TradeChoices& choices, const Scene& scene) {
  const auto values = config::read_text(scene_schema(), scene.effective, scene.name);
  std::set<std::string> keys;
  for (const auto& choice : choices.all)
    for (const auto& [key, value] : choice.settings) keys.insert(key);
  sweep::Dimension out{"choice", {}};
  for (const auto& choice : choices.all) out.labels.push_back(choice.group + " " + choice.words);
  for (const auto& key : keys) {
    const auto* known = scene_schema().find(key);
    sweep::Axis axis{key, known->unit, known->doc, {}};
    for (const auto& choice : choices.all) {
      const auto found = choice.settings.find(key);
      axis.values.push_back(found == choice.settings.end() ? own_value(values, key) : found->second);
    }
    out.axes.push_back(std::move(axis));
  }
  return out;
}

}  // namespace talus::app
