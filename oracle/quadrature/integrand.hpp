/// A view of a callable, so that the rules are compiled once and not per integrand.
#pragma once

#include <concepts>
#include <memory>
#include <type_traits>

namespace lubjoint::oracle {

/// Non-owning reference to a function double -> double; the callable must outlive it.
class Integrand {
 public:
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, Integrand>) &&
      std::is_invocable_r_v<double, const F&, double> Integrand(
          const F& function)  // NOLINT(google-explicit-constructor): a lambda is an integrand
      : object_(std::addressof(function)),
  call_([](const void* object, double x) { return static_cast<double>((*static_cast<const F*>(object))(x)); }) {}

  double operator()(double x) const { return call_(object_, x); }

 private:
  const void* object_;
  double (*call_)(const void*, double);
};

}  // namespace lubjoint::oracle
