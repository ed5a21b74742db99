#include "oracle/proofs/spatial.hpp"

namespace lubjoint::proofs {

Spatial operator+(const Spatial& v, const Spatial& w) { return {v.x + w.x, v.y + w.y, v.z + w.z}; }
Spatial operator-(const Spatial& v, const Spatial& w) { return {v.x - w.x, v.y - w.y, v.z - w.z}; }
Spatial operator-(const Spatial& v) { return {-v.x, -v.y, -v.z}; }
Spatial operator*(const ex& factor, const Spatial& v) { return {factor * v.x, factor * v.y, factor * v.z}; }
ex dot(const Spatial& v, const Spatial& w) { return v.x * w.x + v.y * w.y + v.z * w.z; }
Spatial cross(const Spatial& v, const Spatial& w) {
  return {v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
}

void equal(Proof& proof, const Algebra& algebra, const Spatial& v, const Spatial& w) {
  proof.equal(algebra, v.x, w.x);
  proof.equal(algebra, v.y, w.y);
  proof.equal(algebra, v.z, w.z);
}

Spatial turned(const Parameters& p, const Spatial& v) {
  const auto& [e0, e] = p;
  return (2 * pow(e0, 2) - 1) * v + 2 * dot(e, v) * e + 2 * e0 * cross(e, v);
}

Spatial turned_back(const Parameters& p, const Spatial& v) { return turned({p.first, -p.rest}, v); }

Spatial times_l(const Parameters& p, const Parameters& w) {
  const auto& [e0, e] = p;
  return ex(-1) * (w.first * e) - cross(e, w.rest) + e0 * w.rest;
}

Parameters times_l_transposed(const Parameters& p, const Spatial& v) {
  const auto& [e0, e] = p;
  return {-dot(e, v), cross(e, v) + e0 * v};  // ẽᵀ = −ẽ
}

MovingBody::MovingBody(const std::string& name)
    : r("r_" + name),
      v("v_" + name),
      a("a_" + name),
      e0("e0_" + name),
      e("e_" + name),
      w("w_" + name),
      alpha("alpha_" + name) {}

ex MovingBody::rate(const ex& f) const {
  ex sum = 0;
  const auto along = [&](const SpatialSymbol& at, const Spatial& by) {
    sum += f.diff(at.x) * by.x + f.diff(at.y) * by.y + f.diff(at.z) * by.z;
  };
  along(r, v);
  along(v, a);
  along(w, alpha);
  const Parameters p_rate = times_l_transposed(p(), frac(1, 2) * Spatial(w));
  sum += f.diff(e0) * p_rate.first;
  along(e, p_rate.rest);
  return sum.expand();
}

Algebra& MovingBody::add_relation(Algebra& algebra) const { return algebra.root(e0, 1 - dot(e, e)); }

}  // namespace lubjoint::proofs
