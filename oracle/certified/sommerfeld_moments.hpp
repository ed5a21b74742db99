/// Integrals over a part of the film in closed form, by Sommerfeld's angle.
#pragma once

#include "oracle/certified/ball.hpp"

namespace lubjoint::certified {

/// J_lm = ∫ sin^l θ cos^m θ / H³ dθ, H = 1 + ε cosθ, between two places, l + m ≤ 2:
///   J_lm = q^{(1+l)/2 − 3} ∫ sin^l ψ (cosψ − ε)^m (1 − ε cosψ)^{2−l−m} dψ,
///   sinψ = √q sinθ/H, cosψ = (ε + cosθ)/H.
struct SommerfeldMoments {
  Ball j00, j01, j02, j10, j11, j20;

  /// A place is given by sinθ and cosθ; only the difference of the two angles ψ is needed beside them.
  SommerfeldMoments(const Ball& epsilon, const Ball& sin_0, const Ball& cos_0, const Ball& sin_1, const Ball& cos_1,
                    const Ball& angle) {
    const Ball q = (Ball(1) - epsilon) * (Ball(1) + epsilon);
    const Ball root = sqrt(q);
    const Ball h_0 = Ball(1) + epsilon * cos_0;
    const Ball h_1 = Ball(1) + epsilon * cos_1;
    const Ball s_0 = root * sin_0 / h_0;
    const Ball s_1 = root * sin_1 / h_1;
    const Ball c_0 = (epsilon + cos_0) / h_0;
    const Ball c_1 = (epsilon + cos_1) / h_1;
    // ∫ c, ∫ c², ∫ s, ∫ s c, ∫ s² dψ
    const Ball c = s_1 - s_0;
    const Ball products = s_1 * c_1 - s_0 * c_0;
    const Ball cc = (angle + products) / 2;
    const Ball s = c_0 - c_1;
    const Ball sc = (s_1 - s_0) * (s_1 + s_0) / 2;
    const Ball ss = (angle - products) / 2;
    const Ball q_32 = q * root;
    const Ball q_2 = q * q;
    const Ball q_52 = q_2 * root;
    const Ball square = epsilon * epsilon;
    j00 = (angle - 2 * epsilon * c + square * cc) / q_52;
    j01 = ((Ball(1) + square) * c - epsilon * (angle + cc)) / q_52;
    j02 = (cc - 2 * epsilon * c + square * angle) / q_52;
    j10 = (s - epsilon * sc) / q_2;
    j11 = (sc - epsilon * s) / q_2;
    j20 = ss / q_32;
  }
};

}  // namespace lubjoint::certified
