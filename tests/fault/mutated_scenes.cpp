#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <random>

#include "support/program.hpp"
#include "support/scene_reading.hpp"

/// The example scenes, spoilt at random: read or refused in words, never a crash. A short form of `make fuzz`.
namespace {
using namespace talus;

class Mutator {
 public:
  std::string operator()(std::string text) {
    for (int changes = 1 + below(4); changes > 0; --changes) change(text);
    return text;
  }
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

 private:
  void change(std::string& text) {
    static constexpr std::array values{"nan",
                                       "-inf",
                                       "1e308",
                                       "-1",
                                       "0",
                                       "5e-324",
                                       "9223372036854775807",
                                       "true",
                                       "[]",
                                       "[1,1]",
                                       "{}",
                                       "\"\"",
                                       R"('a\b"c')",
                                       "'''",
                                       "1979-05-27",
                                       "0xffffffffffffffff",
                                       "1_0",
                                       "\"\\",
                                       "#",
                                       "\n",
                                       "[a.b.c]",
                                       "\xff\xfe",
                                       "\x01"
                                       "box.gap=1e-3",
                                       "\x01"
                                       "time.end="};
    const std::size_t at = below(text.size() + 1), length = below(40);
    switch (below(6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(at, text.substr(below(text.size() + 1), length)); break;
      case 3: text.insert(at, values[below(values.size())]); break;
      case 4: text.insert(at, std::string(1 + 20 * length, "[{\"(=.\n"[below(7)])); break;
      default: {  // the value of a key
        const auto equals = text.find('=', at), end = text.find('\n', equals);
        if (end != std::string::npos) text.replace(equals + 1, end - equals - 1, values[below(values.size())]);
      }
    }
  }
  std::mt19937 random_{1};
};

TEST(MutatedScenes, AreReadOrRefusedInWords) {
  Mutator mutate;
  int accepted = 0, refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TALUS_SOURCE_DIR "/runs/examples")) {
    if (entry.path().extension() != ".toml") continue;
    const std::string scene = support::contents(entry.path());
    ASSERT_TRUE(support::read_as_scene(scene));
    for (int i = 0; i < 500; ++i) ++(support::read_as_scene(mutate(scene)) ? accepted : refused);
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GT(refused, 1000);
}
}  // namespace
