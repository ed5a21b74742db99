#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "lubjoint/motion/journal_recorder.hpp"
#include "lubjoint/run/largest_value.hpp"
#include "lubjoint/run/step_looks.hpp"
#include "lubjoint/scene/scene_file.hpp"
#include "lubjoint/scene/simulate.hpp"

namespace recorder_test {

using namespace lubjoint;

namespace {

/// ε(t) = 0.8 − (t − 0.6)², |F|(t) = 10 − 40 (t − 0.3)²: each has one peak inside 0…1, in none of the looked-at points.
struct TwoPeaks {
  static double ratio(double t) { return 0.8 - (t - 0.6) * (t - 0.6); }
  JournalState<double> journal(double, const JournalState<double>& y) const { return y; }
  Vector2<double> force(double t, const JournalState<double>&) const { return {0, -(10 - 40 * (t - 0.3) * (t - 0.3))}; }
};

/// The motion of TwoPeaks; keeps the times that it is asked for.
struct Asked {
  std::vector<double>& times;
  JournalState<double> operator()(double t) const {
    times.push_back(t);
    return {0.6 * TwoPeaks::ratio(t), -0.8 * TwoPeaks::ratio(t), 0, 0};
  }
};

RunSettings every(double interval) {
  RunSettings settings;
  settings.duration = 1;
  settings.output_interval = interval;
  return settings;
}

/// Peak that is found of f, looked at four times a step.
template <class F>
LargestValue<double> peak_of(const F& f, const std::vector<double>& steps) {
  LargestValue<double> largest;
  for (std::size_t s = 0; s + 1 < steps.size(); ++s) {
    const auto time_of = [&](std::size_t i) {
      return i == 4 ? steps[s + 1] : steps[s] + (steps[s + 1] - steps[s]) * static_cast<double>(i) / 4;
    };
    std::vector<double> values;
    for (std::size_t i = 0; i <= 4; ++i) values.push_back(f(time_of(i)));
    const auto inside = [&](double t) {
      CHECK(t >= steps[s]);
      CHECK(t <= steps[s + 1]);
      return f(t);
    };
    largest.look(values, time_of, inside, inside);
  }
  return largest;
}

}  // namespace

TEST_CASE("journal recorder: samples at every multiple of the interval and at the end, each once") {
  JournalRecorder recorder(every(0.25));
  std::vector<double> times;
  const Asked motion{times};
  const TwoPeaks mode;
  recorder.start(mode, 0.0, motion(0));
  recorder.step(mode, 0.0, 0.1, motion, 1);
  recorder.step(mode, 0.1, 0.6, motion, 1);
  recorder.step(mode, 0.6, 1.0, motion, 1);
  recorder.finish(mode, 1.0, motion(1));
  recorder.finish(mode, 1.0, motion(1));
  std::vector<double> found;
  for (const JournalSample& sample : recorder.samples()) {
    found.push_back(sample.t);
    CHECK(sample.eccentricity_ratio() == Approx(TwoPeaks::ratio(sample.t)).epsilon(1e-15));  // rounding
    CHECK(sample.force == mode.force(sample.t, sample.state));
  }
  CHECK(found == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
}

TEST_CASE("output times: one within rounding of the end is the end, in either kind of run") {
  REQUIRE(3 * 0.3 < 0.9);  // by rounding: 0.8999999999999999
  Scene scene = load_scene(LUBJOINT_SOURCE_DIR "/data/scenes/journal.toml");
  scene.run.duration = 0.9;
  scene.run.output_interval = 0.3;
  scene.run.relative_tolerance = scene.run.absolute_tolerance = 1e-4;
  const auto times = [](const auto& run) {
    std::vector<double> found;
    for (const auto& sample : run.samples) found.push_back(sample.t);
    return found;
  };
  const std::vector<double> wanted{0, 0.3, 0.6, 0.9};
  CHECK(times(simulate_journal(scene)) == wanted);
  scene.energy_ledger = true;  // no free journal any more
  CHECK(times(simulate_multibody(scene)) == wanted);
}

TEST_CASE("journal recorder: a peak inside a step is found where it is, between the looks beside it") {
  JournalRecorder recorder(every(10));
  std::vector<double> times;
  const Asked motion{times};
  recorder.start(TwoPeaks{}, 0.0, motion(0));
  times.clear();
  recorder.step(TwoPeaks{}, 0.0, 1.0, motion, 4);
  CHECK(recorder.max_eccentricity_ratio() == Approx(0.8).epsilon(1e-14));  // Brent's 26 bits, squared
  CHECK(recorder.max_force() == Approx(10).epsilon(1e-13));
  // Looks at 0, ¼ … 1, then searches around ¼ and ½ for the force, around ½ for ε: nothing beyond ¾ but one look
  // beside 1, where |F| is 9.6 and bends so much that it might have its largest value.
  REQUIRE(times.size() > 5);
  CHECK(times[4] == 1);
  std::size_t beside_end = 0;
  for (std::size_t i = 5; i < times.size(); ++i) {
    CHECK(times[i] >= 0);
    if (times[i] <= 0.75) continue;
    CHECK(times[i] == Approx(1 - 0.25e-3).epsilon(1e-15));  // a thousandth of a quarter
    ++beside_end;
  }
  CHECK(beside_end == 1);
}

TEST_CASE(
    "journal recorder: on the way up or down the largest value is that of the step's end; one look beside it tells") {
  for (const bool up : {true, false}) {
    JournalRecorder recorder(every(10));
    std::vector<double> times;
    const double start = up ? 0.0 : 0.7;  // ε rises until 0.6
    const double end = up ? 0.2 : 1.0;
    const Asked motion{times};
    recorder.start(TwoPeaks{}, start, motion(start));
    times.clear();
    recorder.step(TwoPeaks{}, start, end, motion, 4);
    // Five looks, and one beside an end for each quantity that is largest there (|F| at both): no search.
    CHECK(times.size() <= 8);
    for (std::size_t i = 5; i < times.size(); ++i) {
      CHECK(std::min(std::abs(times[i] - start), std::abs(times[i] - end)) < 1e-3 * (end - start));
    }
    const double highest = TwoPeaks::ratio(up ? end : start);
    CHECK(recorder.max_eccentricity_ratio() == Approx(highest).epsilon(1e-15));  // rounding
  }
}

TEST_CASE("journal recorder: a peak beside the end of a step is found on either side of it, with its time") {
  std::vector<double> times;
  const Asked motion{times};
  for (const double seam : {0.57, 0.599, 0.6, 0.601, 0.63}) {  // ε is largest at 0.6, |F| at 0.3
    INFO("steps meet at " << seam);
    JournalRecorder recorder(every(10));
    recorder.start(TwoPeaks{}, 0.0, motion(0));
    recorder.step(TwoPeaks{}, 0.0, seam - 0.3, motion, 4);
    recorder.step(TwoPeaks{}, seam - 0.3, seam, motion, 4);
    recorder.step(TwoPeaks{}, seam, 1.0, motion, 4);
    CHECK(recorder.max_eccentricity_ratio() == Approx(0.8).epsilon(1e-13));  // Brent's 26 bits, squared
    CHECK(std::abs(recorder.t_max_eccentricity_ratio() - 0.6) < 1e-6);       // Brent's 26 bits
    CHECK(recorder.max_force() == Approx(10).epsilon(1e-13));
    CHECK(std::abs(recorder.t_max_force() - 0.3) < 1e-6);  // Brent's 26 bits
  }
}

TEST_CASE("journal recorder: the state at the start counts") {
  JournalRecorder recorder(every(10));
  std::vector<double> times;
  const Asked motion{times};
  recorder.start(TwoPeaks{}, 0.6, motion(0.6));
  CHECK(recorder.max_eccentricity_ratio() == Approx(0.8).epsilon(1e-15));  // rounding
  CHECK(recorder.max_force() == Approx(10 - 40 * 0.09).epsilon(1e-15));
}

TEST_CASE("peaks: found inside a step, and where two steps meet on either side of them") {
  const auto around = [](double top) { return [top](double t) { return 5 - (t - top) * (t - top); }; };
  for (const double top : {0.31, 0.5, 0.49, 0.51, 0.07, 0.93}) {
    INFO("peak at " << top);
    const LargestValue<double> peak = peak_of(around(top), {0, 0.5, 1});
    CHECK(peak.value() == Approx(5).epsilon(1e-14));  // Brent's 26 bits, squared
    CHECK(std::abs(peak.t() - top) < 1e-6);           // those bits
  }
}

TEST_CASE("peaks: on a rise, the end; on a fall, the start; of a quantity below zero, too") {
  const auto rise = [](double t) { return 2 * t - 7; };
  const auto fall = [](double t) { return -2 * t - 7; };
  CHECK(peak_of(rise, {0, 0.5, 1}).value() == -5);
  CHECK(peak_of(rise, {0, 0.5, 1}).t() == 1);
  CHECK(peak_of(fall, {0, 0.5, 1}).value() == -7);
  CHECK(peak_of(fall, {0, 0.5, 1}).t() == 0);
}

TEST_CASE("peaks: what the interpolant shows and the method does not confirm is none") {
  const auto time_of = [](std::size_t i) { return 0.5 * static_cast<double>(i); };
  const auto shown = [](double) { return 50.0; };
  LargestValue<double> largest;
  CHECK_FALSE(largest.is_known());
  largest.look({1, 100, 3}, time_of, shown, [](double) { return 2.5; });
  CHECK(largest.value() == 3);
  CHECK(largest.t() == 1);
  largest.look({1, 100, 3}, time_of, shown, [](double) { return 7.5; });
  CHECK(largest.value() == 7.5);
}

TEST_CASE("peaks: where the interpolant leaves the film, the places that were looked at stand") {
  const auto time_of = [](std::size_t i) { return 0.5 * static_cast<double>(i); };
  const auto outside = [](double) -> double { throw std::domain_error("outside"); };
  LargestValue<double> largest;
  largest.look({1, 9, 3}, time_of, outside, [](double) { return 8.0; });
  CHECK(largest.value() == 8);
  CHECK(largest.t() == 0.5);
}

TEST_CASE("peaks: one between two looks counts, though the looks are below an earlier one") {
  // 5 at 0.25, a look; then 5.001 at 1.5625, between the looks at 1.5 and 1.75, which are below 5.
  const auto f = [](double t) {
    return t < 1 ? 5 - 16 * (t - 0.25) * (t - 0.25) : 5.001 - 16 * (t - 1.5625) * (t - 1.5625);
  };
  REQUIRE(f(1.5) < 5);
  REQUIRE(f(1.75) < 5);
  const LargestValue<double> peak = peak_of(f, {0, 1, 2});
  CHECK(peak.value() == Approx(5.001).epsilon(1e-14));  // Brent's 26 bits, squared
  CHECK(std::abs(peak.t() - 1.5625) < 1e-6);            // those bits
}

TEST_CASE("peaks: looked for in few places first, they are those of looks in all of them") {
  // Two waves of slowly growing height, of which a step holds a twentieth to a third.
  const auto f = [](std::size_t k, double t) {
    return (1 + 0.01 * t) * (k == 0 ? std::sin(t) : std::cos(3 * t) + 0.2 * std::sin(11 * t));
  };
  for (const double length : {0.05, 0.2, 0.35}) {
    INFO("steps of " << length);
    std::size_t looks = 0;
    StepLooks<double> few(2, 8);
    std::vector<LargestValue<double>> all(2);
    std::size_t steps = 0;
    for (double t0 = 0; t0 < 50; t0 += length, ++steps) {
      const double t1 = t0 + length;
      const auto see = [&](double t, const auto& put) {
        ++looks;
        for (std::size_t k = 0; k < 2; ++k) put(k, f(k, t));
      };
      few.step(t0, t1, false, see, f, f);
      const auto time_of = [&](std::size_t i) { return i == 8 ? t1 : t0 + (t1 - t0) * static_cast<double>(i) / 8; };
      for (std::size_t k = 0; k < 2; ++k) {
        std::vector<double> values;
        for (std::size_t i = 0; i <= 8; ++i) values.push_back(f(k, time_of(i)));
        const auto inside = [&](double t) { return f(k, t); };
        all[k].look(values, time_of, inside, inside);
      }
    }
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(few.largest(k).value() == all[k].value());
      CHECK(few.largest(k).t() == all[k].t());
    }
    CHECK(looks < 6 * steps);  // of 9; at least 4
  }
}

}  // namespace recorder_test
