#include "core/both.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

/// Two pieces of work on two threads.
namespace {
using talus::core::both;

TEST(Both, RunsEachOnce) {
  int first = 0, second = 0;
  for (int i = 0; i < 5000; ++i)
    both(
        i % 3 != 0, [&] { ++first; }, [&] { ++second; });
  EXPECT_EQ(first, 5000);
  EXPECT_EQ(second, 5000);
}

TEST(Both, UsesASecondThreadWhereAllowed) {
  std::thread::id there;
  both(
      true, [] {}, [&] { there = std::this_thread::get_id(); });
  EXPECT_NE(there, std::this_thread::get_id());
  both(
      false, [] {}, [&] { there = std::this_thread::get_id(); });
  EXPECT_EQ(there, std::this_thread::get_id());
}

TEST(Both, WakesASleepingCompanion) {
  int done = 0;
  for (int i = 0; i < 3; ++i) {
    both(
        true, [] {}, [&] { ++done; });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    both(
        true, [] {},
        [&] {
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
          ++done;
        });
  }
  EXPECT_EQ(done, 6);
}

TEST(Both, MayBeNested) {
  std::atomic<int> n{0}, m{0};
  both(
      true,
      [&] {
        both(
            true, [&] { ++n; }, [&] { ++n; });
      },
      [&] {
        both(
            true, [&] { ++m; }, [&] { ++m; });
      });
  EXPECT_EQ(n, 2);
  EXPECT_EQ(m, 2);
}

TEST(Both, WaitsForBothAndRethrowsTheFirst) {
  bool ended = false;
  const auto fail = [](const char* what) { throw std::runtime_error(what); };
  const auto what = [](const auto& first, const auto& second) {
    try {
      both(true, first, second);
    } catch (const std::runtime_error& error) { return std::string(error.what()); }
    return std::string("nothing");
  };
  EXPECT_EQ(what([&] { fail("first"); },
                 [&] {
                   std::this_thread::sleep_for(std::chrono::milliseconds(10));
                   ended = true;
                 }),
            "first");
  EXPECT_TRUE(ended);
  EXPECT_EQ(what([] {}, [&] { fail("second"); }), "second");
  EXPECT_EQ(what([&] { fail("first"); }, [&] { fail("second"); }), "first");
  EXPECT_EQ(what([] {}, [] {}), "nothing");
}

}  // namespace
