#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <catch2/catch.hpp>
#include <string>

#include "lubjoint/film/pressure.hpp"
#include "oracle/laws/accuracy.hpp"
#include "oracle/laws/published_forms.hpp"
#include "support/film_reference.hpp"

namespace film_law_test {

using namespace lubjoint;
using namespace lubjoint::test;

namespace {

struct SpotValue {
  const char* law;
  double epsilon, a, b;
  const char* radial;
  const char* tangential;
};

/// F_r/S and F_t/S in 40 digits. Obtained with mpmath 1.3 at 60 digits, without this library: adaptive quadrature of
/// the pressure of Reynolds' equation over the film in θ (long films with p = 0 at both ends: H³p' = −6(G + C), G = −a
/// cosθ − 2b sinθ, C from ∫p' = 0; long_half_eq5: eq. 5). pinkus_sternlicht: eqs. 14 to 18 multiplied through, in K, B,
/// φ.
const SpotValue spot_values[] = {
    {"short_full", 0.625, 1.5, 0.75, "-14.4785286830386086090584854315716321031",
     "4.953180865250050313625271331853453087904"},
    {"short_half", 0.625, 1.5, 0.75, "-9.763919173866444343976974471209879167922",
     "5.001245264972165196260367421350789660323"},
    {"short_dynamic", 0.625, 1.5, 0.75, "-14.29306290082509783493784853941440991501",
     "3.964748212705590872777071042488264638494"},
    {"long_full", 0.625, 1.5, 0.75, "-59.43817038300060376350325598224143705484",
     "30.30181235211795485982518932427994830247"},
    {"long_half", 0.625, 1.5, 0.75, "-17.28834939965253496475572243618758175181",
     "22.87337978088552343292918591402534368366"},
    {"long_half_eq5", 0.625, 1.5, 0.75, "-37.44155879632684788476821924300608805985",
     "33.3284209689583857139362633011932285891"},
    {"long_dynamic", 0.625, 1.5, 0.75, "-50.40323433798351801563671070650875923498",
     "21.8904809578191524934864094548880327077"},
    {"pinkus_sternlicht", 0.625, 1.5, 0.75, "-54.28814473337753355633192164583288110106",
     "22.1086247742245737008715246314752372224"},
    {"short_full", 0.875, -0.5, -0.25, "74.75611255554561448463697291813161256877",
     "-6.92186227366163097079971971464181597859"},
    {"short_half", 0.875, -0.5, -0.25, "29.41361183332836279787404201462136183994",
     "4.50351330761362895904458458712353645515"},
    {"short_dynamic", 0.875, -0.5, -0.25, "-0.02662492493416981468504895290443646807468",
     "-0.3935764081495687939133825112029848959935"},
    {"long_full", 0.875, -0.5, -0.25, "83.06234728393957164959663657570179174308",
     "-14.07836394643043587281298925011894775306"},
    {"long_half", 0.875, -0.5, -0.25, "9.08722236753546491632023794621977307579",
     "1.060253055033369634214974301494198439852"},
    {"long_half_eq5", 0.875, -0.5, -0.25, "33.43173861372119825417684936129722355516",
     "6.614151360118115396926838708273859456801"},
    {"long_dynamic", 0.875, -0.5, -0.25, "1.46984955457615711293974249755435634712",
     "-3.152995067038611993240035037027693504929"},
    {"pinkus_sternlicht", 0.875, -0.5, -0.25, "2.783160204585766017629081932239749013583",
     "-2.413134079507564538046967784193678771274"},
    {"short_full", 0.25, 0.125, -2, "8.306234728393957164959663657570179174308",
     "0.2163081960519259678374912410825567493309"},
    {"short_half", 0.25, 0.125, -2, "4.117561808641423026924276273229534031598",
     "-1.029623679751814793859032157236499403112"},
    {"short_dynamic", 0.25, 0.125, -2, "1.778374823216549605726135699974055278814",
     "0.0741048768877834004646455846327024864749"},
    {"long_full", 0.25, 0.125, -2, "83.06234728393957164959663657570179174308",
     "2.359725775111919649136268084536982719974"},
    {"long_half", 0.25, 0.125, -2, "8.693451099735885818733013587330375152997",
     "-5.026197718504646236037926563792114700619"},
    {"long_half_eq5", 0.25, 0.125, -2, "41.33723424803039188540437889391150193215",
     "-39.78013711244404017543186595773150864001"},
    {"long_dynamic", 0.25, 0.125, -2, "28.4495800923620895565230256497852607942",
     "1.016091254771512587690071273345659502614"},
    {"pinkus_sternlicht", 0.25, 0.125, -2, "23.73171678091926067633376380297801407346",
     "0.8505911065497475553431793828221181894705"},
};

PolarForce<FiftyDigits> ratio_in_fifty_digits(std::string_view law, double epsilon, double a, double b) {
  const PolarFilmState<FiftyDigits> state{FiftyDigits(epsilon), FiftyDigits(a), FiftyDigits(b)};
  return with_film_law(law, [&]<class Law>() { return polar_force_ratio<Law, FiftyDigits>(state); });
}

FiftyDigits sum(const std::vector<FiftyDigits>& terms) {
  FiftyDigits total = 0;
  for (const FiftyDigits& term : terms) total += term;
  return total;
}

/// ε near 0, in the middle, and near 1 (opening films of the published dynamic forms lose 5 digits at 1 − ε = 0.001).
const double ratios[] = {1e-30, 1e-6, 0.25, 0.5, 0.75, 0.9375, 0.999};
const double motions[][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1.5, 0.75}, {-1.5, 0.75}, {1.5, -0.75}, {-0.5, -2}};

const std::vector<reports::AccuracyRow>& accuracy() {
  static const std::vector<reports::AccuracyRow> rows = reports::measure_accuracy(8, 20090331);
  return rows;
}

constexpr double near_wall = 0.9e-12;  // rows to 1 − ε = 1e-12, which rounds to a double on either side

}  // namespace

TEST_CASE("every law equals its published form, evaluated term by term in 50 digits") {
  for (const std::string_view law : film_law_names) {
    for (const double epsilon : ratios) {
      for (const auto& [a, b] : motions) {
        INFO(law << ", epsilon " << epsilon << ", a " << a << ", b " << b);
        const PolarForce<FiftyDigits> ratio = ratio_in_fifty_digits(law, epsilon, a, b);
        const auto terms =
            reports::published_terms<FiftyDigits>(law, FiftyDigits(epsilon), FiftyDigits(a), FiftyDigits(b));
        const FiftyDigits radial = sum(terms.radial);
        const FiftyDigits tangential = sum(terms.tangential);
        const FiftyDigits size = abs(radial) + abs(tangential);
        // 50 digits, less what the published dynamic forms cancel: at most 16 digits for the film that opens at 0.999
        CHECK(static_cast<double>(abs(ratio.radial - radial) / size) < 1e-33);
        CHECK(static_cast<double>(abs(ratio.tangential - tangential) / size) < 1e-33);  // the same
      }
    }
  }
}

TEST_CASE("every law equals spot values from quadrature in another program: 39 digits, and double to rounding") {
  for (const SpotValue& spot : spot_values) {
    INFO(spot.law << ", epsilon " << spot.epsilon << ", a " << spot.a << ", b " << spot.b);
    const FiftyDigits radial(spot.radial);
    const FiftyDigits tangential(spot.tangential);
    const PolarForce<FiftyDigits> many = ratio_in_fifty_digits(spot.law, spot.epsilon, spot.a, spot.b);
    CHECK(static_cast<double>(abs(many.radial / radial - 1)) < 1e-38);          // 40 digits quoted
    CHECK(static_cast<double>(abs(many.tangential / tangential - 1)) < 1e-38);  // the same
    const PolarFilmState<double> state(spot.epsilon, spot.a, spot.b);
    const auto ratio = with_film_law(spot.law, [&]<class Law>() { return polar_force_ratio<Law>(state); });
    const double size = static_cast<double>(sqrt(FiftyDigits(radial * radial + tangential * tangential)));
    // A dozen roundings of terms that are at most ten times |F| in these states.
    CHECK(std::abs(ratio.radial - static_cast<double>(radial)) < 40 * 0x1p-52 * size);
    CHECK(std::abs(ratio.tangential - static_cast<double>(tangential)) < 40 * 0x1p-52 * size);  // the same
  }
}

TEST_CASE("the five closed forms are right to 4 ulp of the sum of their terms, ε from 1e-300 to 1 - 1e-12") {
  for (const char* law : {"short_full", "short_half", "long_full", "long_half", "long_half_eq5"}) {
    INFO(law);
    CHECK(reports::worst_ulp(accuracy(), law, near_wall) <= 4);  // rounding: a dozen operations, half an ulp each
    CHECK(reports::worst_ulp(accuracy(), law, near_wall) > 0);   // something was measured
  }
}

TEST_CASE("pinkus_sternlicht is right to 8 ulp of the sum of its terms, ε from 1e-300 to 1 - 1e-12") {
  CHECK(reports::worst_ulp(accuracy(), "pinkus_sternlicht", near_wall) <= 8);  // rounding: twenty operations
  CHECK(reports::worst_ulp(accuracy(), "pinkus_sternlicht", near_wall) > 0);   // something was measured
}

TEST_CASE(
    "the dynamic laws are right to 1e-13 of |F| up to ε = 1 - 1e-6 and 1e-10 up to 1 - 1e-9, opening or closing") {
  for (const char* law : {"short_dynamic", "long_dynamic"}) {
    INFO(law);
    CHECK(reports::worst_of_force(accuracy(), law, 0.9e-6) <= 1e-13);  // rounding, conditioned by the angle of u
    CHECK(reports::worst_of_force(accuracy(), law, 0.9e-9) <= 1e-10);  // the same, 1/√(1 − ε) times
    CHECK(reports::worst_of_force(accuracy(), law, 0.9e-9) > 0);       // something was measured
  }
}

TEST_CASE("the force is the integral of the library's own pressure field, wherever the field has a closed form") {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  for_each_film_law([]<class Law>() {
    if constexpr (Law::name != "long_half" && Law::name != "long_dynamic" && Law::name != "pinkus_sternlicht") {
      for (const double epsilon : {0.0, 0.25, 0.75, 0.9375}) {
        for (const auto& [a, b] : motions) {
          INFO(Law::name << ", epsilon " << epsilon << ", a " << a << ", b " << b);
          const PolarFilmState<double> state(epsilon, a, b);
          const FilmBounds<double> film = film_bounds(Law::extent, state);
          // Axially the short pressure is a parabola, its integral 2/3 of the middle's times L; the long one is
          // constant.
          const auto line_pressure = [&](double theta) {
            if (Law::limit == BearingLimit::long_bearing) {
              return bearing.length() * long_bearing_pressure(bearing, oil, state, theta);
            }
            return 2 * bearing.length() / 3 * short_bearing_pressure(bearing, oil, state, theta, 0.0);
          };
          const auto cosine = [&](double theta) { return bearing.radius() * line_pressure(theta) * std::cos(theta); };
          const auto sine = [&](double theta) { return bearing.radius() * line_pressure(theta) * std::sin(theta); };
          const PolarForce<double> force = film_force<Law>(bearing, oil, state);
          const auto terms = reports::published_terms<double>(Law::name, epsilon, a, b);
          double size = 0;
          for (const double term : terms.radial) size += std::abs(term);
          for (const double term : terms.tangential) size += std::abs(term);
          size *= force_scale(Law::limit, bearing, oil);
          // The rule's own tolerance, of integrals whose positive and negative parts exceed the force tenfold.
          CHECK(std::abs(Rule::integrate(cosine, film.start, film.end, 12, 1e-12) - force.radial) < 1e-10 * size);
          CHECK(std::abs(Rule::integrate(sine, film.start, film.end, 12, 1e-12) - force.tangential) < 1e-10 * size);
        }
      }
    }
  });
}

}  // namespace film_law_test
