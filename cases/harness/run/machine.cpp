#include "cases/harness/run/machine.hpp"

#include <malloc.h>

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <cstring>
#include <thread>
#include <vector>

namespace plumbline {
namespace {

constexpr double shortest = 0.003;  // s that a measurement lasts: less than a slice of time on a busy machine
constexpr int repetitions = 15;     // of which the fastest counts: a limit is what the machine can do undisturbed

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Seconds that `rounds` calls of work(thread) take on each of some threads, from the first start to the last end.
template <class Work>
double seconds_of_rounds(int threads, long rounds, const Work& work) {
  std::vector<double> start(static_cast<std::size_t>(threads)), end(start);
  std::barrier together(threads);
  const auto run = [&](std::size_t t) {
    together.arrive_and_wait();
    start[t] = now();
    for (long k = 0; k < rounds; ++k) work(t);
    end[t] = now();
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < start.size(); ++t) others.emplace_back(run, t);
  run(0);
  for (std::thread& other : others) other.join();
  return *std::max_element(end.begin(), end.end()) - *std::min_element(start.begin(), start.end());
}

// Rounds of work per second on each of some threads.
template <class Work>
double rounds_per_second(int threads, const Work& work) {
  long rounds = 1;
  double time = seconds_of_rounds(threads, rounds, work);
  while (time < shortest) {
    rounds = std::max(2 * rounds,
                      static_cast<long>(1.2 * shortest / std::max(time, 1e-9) * static_cast<double>(rounds)));
    time = seconds_of_rounds(threads, rounds, work);
  }
  for (int k = 1; k < repetitions; ++k) time = std::min(time, seconds_of_rounds(threads, rounds, work));
  return static_cast<double>(rounds) / time;
}

}  // namespace

double copy_rate(std::size_t bytes, int threads) {
  const std::size_t values = std::max<std::size_t>(bytes / (16 * static_cast<std::size_t>(threads)), 1);
  std::vector<std::vector<double>> from(static_cast<std::size_t>(threads), std::vector<double>(values, 1.0)), to = from;
  const double rounds = rounds_per_second(threads, [&](std::size_t t) {
    std::memcpy(to[t].data(), from[t].data(), 8 * values);
    from[t][0] += to[t][values - 1];
  });
  return rounds * 16.0 * static_cast<double>(values) * threads;
}

double fma_rate(int threads) {
  // More sums than are under way at once where two units take four steps each, and few enough for the registers.
  constexpr int sums = 12, products = 1000;
  using Eigen::internal::padd, Eigen::internal::pmadd, Eigen::internal::predux, Eigen::internal::pset1;
  using Packet = Eigen::internal::packet_traits<double>::type;
  std::vector<double> kept(static_cast<std::size_t>(threads));
  const double rounds = rounds_per_second(threads, [&](std::size_t t) {
    const Packet factor = pset1<Packet>(1.0 - 1e-9), added = pset1<Packet>(1e-9 + 1e-20 * kept[t]);
    Packet sum[sums];
    for (Packet& s : sum) s = factor;
    for (int k = 0; k < products; ++k) {  // unrolled, or the sums stay in memory
#pragma GCC unroll 12
      for (Packet& s : sum) s = pmadd(s, factor, added);  // Eigen's own product and sum, fused on every instruction set
    }
    for (int k = 1; k < sums; ++k) sum[0] = padd(sum[0], sum[k]);
    kept[t] = predux(sum[0]);
  });
  constexpr int lanes = Eigen::internal::packet_traits<double>::size;
  return rounds * 2.0 * products * sums * lanes * threads;
}

std::optional<double> allocated_bytes() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
  const struct mallinfo2 all = ::mallinfo2();
  return static_cast<double>(all.uordblks) + static_cast<double>(all.hblkhd);
#else
  return {};
#endif
}

}  // namespace plumbline
