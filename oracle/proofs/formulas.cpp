#include "oracle/proofs/formulas.hpp"

namespace lubjoint::proofs {

const Symbols& sym() {
  static const Symbols symbols;
  return symbols;
}

ex q() { return 1 - pow(sym().eps, 2); }
ex d_factor() { return 2 + pow(sym().eps, 2); }
ex film_at(const ex& cos_theta) { return 1 + sym().eps * cos_theta; }

Algebra film_algebra() {
  const Symbols& y = sym();
  return Algebra().root(y.s, q()).root(y.sigma, 1).angle(y.theta).root(y.sin_start, 1 - pow(y.cos_start, 2));
}

Polar operator+(const Polar& x, const Polar& y) { return {x.radial + y.radial, x.tangential + y.tangential}; }
Polar operator-(const Polar& x, const Polar& y) { return {x.radial - y.radial, x.tangential - y.tangential}; }
Polar operator*(const ex& factor, const Polar& x) { return {factor * x.radial, factor * x.tangential}; }

void equal(Proof& proof, const Algebra& algebra, const Polar& x, const Polar& y) {
  proof.equal(algebra, x.radial, y.radial);
  proof.equal(algebra, x.tangential, y.tangential);
}

ex power_of(const Polar& force) { return force.radial * sym().b - force.tangential * sym().a / 2; }

Polar short_full() {
  const auto& [eps, s, a, b] = std::tie(sym().eps, sym().s, sym().a, sym().b);
  return {-Pi * b * (1 + 2 * pow(eps, 2)) / pow(s, 5), Pi * a / (2 * pow(s, 3))};
}

Polar short_half() {
  const auto& [eps, s, a, b] = std::tie(sym().eps, sym().s, sym().a, sym().b);
  const symbol& sigma = sym().sigma;
  return {-frac(1, 2) * (2 * eps * sigma * a / pow(q(), 2) + Pi * b * (1 + 2 * pow(eps, 2)) / pow(s, 5)),
          frac(1, 2) * (Pi * a / (2 * pow(s, 3)) + sigma * 4 * eps * b / pow(q(), 2))};
}

Polar long_full() {
  const auto& [s, a, b] = std::tie(sym().s, sym().a, sym().b);
  return {-12 * Pi * b / pow(s, 3), 12 * Pi * a / (d_factor() * s)};
}

Polar long_half() {
  const auto& [eps, s, a, b] = std::tie(sym().eps, sym().s, sym().a, sym().b);
  const symbol& sigma = sym().sigma;
  const ex dq = d_factor() * q();
  return {-(12 * eps * sigma * a / dq + 6 * b / pow(s, 3) * (Pi - 16 / (Pi * d_factor()))),
          6 * Pi * a / (d_factor() * s) + sigma * 24 * eps * b / dq};
}

Polar long_half_eq5() {
  const auto& [eps, s, a, b] = std::tie(sym().eps, sym().s, sym().a, sym().b);
  const symbol& sigma = sym().sigma;
  return {-(12 * eps * sigma * a / (d_factor() * q()) + 6 * Pi * b / pow(s, 3)),
          6 * Pi * a / (d_factor() * s) + sigma * 24 * b / ((1 + eps) * q())};
}

Polar pinkus_sternlicht(const ex& k_upper, bool closing) {
  const auto& [eps, s, a, b] = std::tie(sym().eps, sym().s, sym().a, sym().b);
  const ex bb = closing ? ex(eps * b) : ex(-eps * b);
  const ex phi = (closing ? ex(k_upper + 3 * bb) : k_upper) / (k_upper + frac(3, 2) * bb);
  const ex d = d_factor();
  return {-6 / (d * pow(s, 3)) * (4 * eps * k_upper + Pi * d * b * phi), 6 * Pi * a / (d * s) * phi};
}

ex reynolds_source(const ex& theta) { return sym().a * sin(theta) - 2 * sym().b * cos(theta); }

ex short_profile() {
  const symbol& theta = sym().theta;
  return reynolds_source(theta) / pow(film_at(cos(theta)), 3);
}

ex long_profile_printed() {
  const auto& [eps, a, b, theta] = std::tie(sym().eps, sym().a, sym().b, sym().theta);
  const ex h = film_at(cos(theta));
  return a * sin(theta) * (2 + eps * cos(theta)) / (d_factor() * pow(h, 2)) +
         b / eps * (1 / pow(h, 2) - 1 / pow(1 + eps, 2));
}

ex long_profile() {
  const auto& [eps, a, b, theta] = std::tie(sym().eps, sym().a, sym().b, sym().theta);
  const ex h = film_at(cos(theta));
  return a * sin(theta) * (2 + eps * cos(theta)) / (d_factor() * pow(h, 2)) +
         b * (1 - cos(theta)) * (2 + eps + eps * cos(theta)) / (pow(h, 2) * pow(1 + eps, 2));
}

Planar operator+(const Planar& v, const Planar& w) { return {v.x + w.x, v.y + w.y}; }
Planar operator-(const Planar& v, const Planar& w) { return {v.x - w.x, v.y - w.y}; }
Planar operator*(const ex& factor, const Planar& v) { return {factor * v.x, factor * v.y}; }
ex dot(const Planar& v, const Planar& w) { return v.x * w.x + v.y * w.y; }
ex cross(const Planar& v, const Planar& w) { return v.x * w.y - v.y * w.x; }
Planar turned_90(const Planar& v) { return {-v.y, v.x}; }
Planar turned(const Planar& v, const ex& cosine, const ex& sine) {
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
}

void equal(Proof& proof, const Algebra& algebra, const Planar& v, const Planar& w) {
  proof.equal(algebra, v.x, w.x);
  proof.equal(algebra, v.y, w.y);
}

FrameMoments frame_moments(const ex& e1, const ex& e2, const ex& root_q, const ex& delta) {
  const ex n2 = 1 - pow(e2, 2);
  const ex qq = n2 - pow(e1, 2);
  FrameMoments moments;
  moments.v = delta + e1 * root_q / n2;
  moments.a = ((2 * qq + 3 * pow(e1, 2)) * delta + e1 * root_q * (4 * qq + 3 * pow(e1, 2)) / n2) / n2;
  moments.e = 3 * e1 * delta + root_q * (2 * qq + 3 * pow(e1, 2)) / n2;
  moments.w = (qq + 3 * pow(e1, 2)) * delta + 3 * e1 * root_q;
  return moments;
}

Resistance short_dynamic(const ex& e1, const ex& e2, const ex& root_q, const ex& delta) {
  const FrameMoments m = frame_moments(e1, e2, root_q, delta);
  const ex factor = 1 / pow(root_q, 5);
  return {factor * m.w, factor * e2 * m.e};
}

Resistance long_dynamic(const ex& e1, const ex& e2, const ex& root_q, const ex& delta) {
  const FrameMoments m = frame_moments(e1, e2, root_q, delta);
  const ex n2 = 1 - pow(e2, 2);
  const ex factor = 12 * m.v / (m.a + pow(root_q, 2) * pow(e2, 2) * m.v / n2) / pow(root_q, 3);
  return {factor * n2 * m.a, factor * e2 * m.e};
}

ex short_dynamic_across(const ex& e1, const ex& e2, const ex& root_q, const ex& delta) {
  const FrameMoments m = frame_moments(e1, e2, root_q, delta);
  const ex n2 = 1 - pow(e2, 2);
  const ex squares = pow(root_q, 2) + 3 * pow(e2, 2);
  return (squares * m.v + 2 * e1 * pow(e2, 2) * pow(root_q, 3) / pow(n2, 2)) / pow(root_q, 5);
}

GiNaC::exmap in_dynamic_motion() {
  const Symbols& y = sym();
  return {{y.a, 2 * y.speed * y.cos_start}, {y.b, y.speed * y.sin_start}};
}

Polar in_polar_components(Resistance (*law)(const ex&, const ex&, const ex&, const ex&)) {
  // û = r sinθs − t cosθs and û⊥ = r cosθs + t sinθs, so that e₁ = ε sinθs and e₂ = ε cosθs.
  const Symbols& y = sym();
  const Resistance f = law(y.eps * y.sin_start, y.eps * y.cos_start, y.s, y.delta);
  return {-y.speed * (f.along * y.sin_start + f.across * y.cos_start),
          -y.speed * (-f.along * y.cos_start + f.across * y.sin_start)};
}

}  // namespace lubjoint::proofs
