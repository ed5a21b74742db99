/// Vectors and rigid bodies in space for the proofs: written anew from their definitions, with Euler parameters as
/// symbols.
#pragma once

#include <array>
#include <string>

#include "oracle/proofs/formulas.hpp"

namespace lubjoint::proofs {

// Vectors in space.
struct Spatial {
  ex x;
  ex y;
  ex z;
};
Spatial operator+(const Spatial& v, const Spatial& w);
Spatial operator-(const Spatial& v, const Spatial& w);
Spatial operator-(const Spatial& v);
Spatial operator*(const ex& factor, const Spatial& v);
ex dot(const Spatial& v, const Spatial& w);
Spatial cross(const Spatial& v, const Spatial& w);
void equal(Proof& proof, const Algebra& algebra, const Spatial& v, const Spatial& w);

/// A vector whose components NAME_x, NAME_y, NAME_z are symbols.
struct SpatialSymbol {
  symbol x;
  symbol y;
  symbol z;

  explicit SpatialSymbol(const std::string& name) : x(name + "_x"), y(name + "_y"), z(name + "_z") {}
  operator Spatial() const { return {x, y, z}; }  // NOLINT(google-explicit-constructor)
  std::array<symbol, 3> components() const { return {x, y, z}; }
};

/// Euler parameters (e₀, e).
struct Parameters {
  ex first;
  Spatial rest;
};

/// A(p) v of a body-fixed v, A = (2e₀² − 1)I + 2(e eᵀ + e₀ẽ).
Spatial turned(const Parameters& p, const Spatial& v);
/// A(p)ᵀ v.
Spatial turned_back(const Parameters& p, const Spatial& v);
/// L w of a w with four components, L = [−e, −ẽ + e₀I].
Spatial times_l(const Parameters& p, const Parameters& w);
/// Lᵀ v.
Parameters times_l_transposed(const Parameters& p, const Spatial& v);

/// A body in motion: r, ṙ, r̈ and p, ω′, ω̇′, all symbols; |p| = 1 is a relation of its algebra.
struct MovingBody {
  SpatialSymbol r, v, a;
  symbol e0;
  SpatialSymbol e;
  SpatialSymbol w;      ///< ω′
  SpatialSymbol alpha;  ///< ω̇′

  explicit MovingBody(const std::string& name);

  Parameters p() const { return {e0, e}; }
  /// A v′.
  Spatial turned(const Spatial& fixed) const { return proofs::turned(p(), fixed); }
  /// ω × A v′, and ω × (ω × A v′).
  Spatial turning(const Spatial& fixed) const { return turned(cross(w, fixed)); }
  Spatial turning_twice(const Spatial& fixed) const { return turned(cross(w, cross(w, fixed))); }
  /// ω and ω̇: A ω′ and A ω̇′ (as ω × ω = 0).
  Spatial spin() const { return turned(w); }
  Spatial spin_rate() const { return turned(alpha); }
  Spatial point(const Spatial& fixed) const { return Spatial(r) + turned(fixed); }

  /// The share of the body's motion in ḟ: ṙ, r̈, ṗ = ½Lᵀω′ and ω̇′.
  ex rate(const ex& f) const;
  Algebra& add_relation(Algebra& algebra) const;
};

}  // namespace lubjoint::proofs
