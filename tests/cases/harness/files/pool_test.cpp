// Work on several threads: all of it, once, and its first failure.
#include "cases/harness/files/pool.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <string>

namespace plumbline::pool_test {
namespace {

TEST(Pool, DoesEveryPieceOnceForAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 8, 100}) {
    std::vector<std::atomic<int>> done(37);
    for_all(done.size(), threads, [&](std::size_t k) { ++done[k]; });
    for (const auto& times : done) EXPECT_EQ(times, 1) << threads;
  }
}

TEST(Pool, NothingToDoIsDone) {
  for_all(0, 4, [](std::size_t) { FAIL(); });
}

TEST(Pool, ResultsDoNotDependOnTheNumberOfThreads) {
  const auto results = [](int threads) {
    std::vector<double> values(200);
    for_all(values.size(), threads, [&](std::size_t k) { values[k] = 1.0 / (1.0 + static_cast<double>(k)); });
    return values;
  };
  EXPECT_EQ(results(1), results(2));
  EXPECT_EQ(results(1), results(7));
}

TEST(Pool, AnExceptionArrivesAndEndsTheWork) {
  for (const int threads : {1, 4}) {
    std::atomic<int> begun{0};
    try {
      for_all(100000, threads, [&](std::size_t k) {
        ++begun;
        if (k == 3) throw std::runtime_error("piece 3");
        std::this_thread::sleep_for(std::chrono::microseconds(10));
      });
      FAIL() << "the exception was lost";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "piece 3");
    }
    EXPECT_LT(begun, 100000) << "work went on after a failure";
  }
}

TEST(Pool, UsesTheThreadsItIsGiven) {
  std::atomic<int> waiting{0};
  std::atomic<bool> met{false};
  // Two pieces that can end only together; a pool of one would run into the limit.
  for_all(2, 2, [&](std::size_t) {
    ++waiting;
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (waiting < 2 && std::chrono::steady_clock::now() < limit) std::this_thread::yield();
    if (waiting == 2) met = true;
  });
  EXPECT_TRUE(met);
}

}  // namespace
}  // namespace plumbline::pool_test
