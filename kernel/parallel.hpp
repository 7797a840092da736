// Loops that threads share. What a loop computes never depends on how many there are: work is split into pieces that the
// problem fixes, and pieces that could write the same place are never under way together.
#pragma once

namespace plumbline {

// One copy of the code, whoever runs it: where a product and a sum become one rounding is the compiler's choice.
template <class Work>
[[gnu::noinline]] void run_piece(Work& work, int k) {
  work(k);
}

// Calls work(k) for k in [0, count). Calls must not write the same places.
template <class Work>
void for_each_piece(int count, [[maybe_unused]] int threads, Work&& work) {
#ifdef _OPENMP
  if (threads > 1 && count > 1) {
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int k = 0; k < count; ++k) run_piece(work, k);
    return;
  }
#endif
  for (int k = 0; k < count; ++k) run_piece(work, k);
}

// The same for many cheap calls, in long stretches.
template <class Work>
void for_each_index(int count, int threads, Work&& work) {
  constexpr int stretch = 4096;
  for_each_piece((count + stretch - 1) / stretch, threads, [&](int piece) {
    const int first = piece * stretch, last = first + stretch < count ? first + stretch : count;
    for (int k = first; k < last; ++k) work(k);
  });
}

}  // namespace plumbline
