/// Independent pieces of work on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lubjoint::reports {

/// Cores of this machine, at least one.
inline unsigned available_cores() { return std::max(1u, std::thread::hardware_concurrency()); }

/// Calls work(i) for every i below count, on so many threads, in no order. The first exception ends the others after
/// their piece, and is thrown on.
template <class Work>
void run_parallel(std::size_t count, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto loop = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> pool;
    const std::size_t size = std::min<std::size_t>(std::max(1u, threads), count);
    for (std::size_t i = 0; i < size; ++i) pool.emplace_back(loop);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace lubjoint::reports
