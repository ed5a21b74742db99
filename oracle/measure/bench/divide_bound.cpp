#include "oracle/measure/bench/divide_bound.hpp"

#include <cmath>

namespace lubjoint::reports {

namespace {

[[gnu::always_inline]] inline void run(std::size_t n, const double* a, const double* b, const double* c,
                                       const double* d, double* out) {
  for (std::size_t i = 0; i < n; ++i) out[i] = std::sqrt(a[i]) + std::sqrt(b[i]) + c[i] / d[i];
}

#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("avx2,fma"), gnu::flatten]] void run_avx2(std::size_t n, const double* a, const double* b,
                                                        const double* c, const double* d, double* out) {
  run(n, a, b, c, d, out);
}
#ifndef __clang__
[[gnu::target("avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512"), gnu::flatten]] void run_avx512(
    std::size_t n, const double* a, const double* b, const double* c, const double* d, double* out) {
  run(n, a, b, c, d, out);
}
#endif
#endif

}  // namespace

void two_roots_and_a_quotient(std::size_t n, const double* a, const double* b, const double* c, const double* d,
                              double* out, [[maybe_unused]] InstructionSet set) {
#if defined(__x86_64__) && defined(__GNUC__)
#ifndef __clang__
  if (set == InstructionSet::avx512) return run_avx512(n, a, b, c, d, out);
#endif
  if (set == InstructionSet::avx2) return run_avx2(n, a, b, c, d, out);
#endif
  run(n, a, b, c, d, out);
}

}  // namespace lubjoint::reports
