#!/usr/bin/env python3
"""What mutants.py changes and what it leaves alone, on sources made for it; and that the tables in data agree."""

import csv
import importlib.machinery
import importlib.util
import sys
import unittest
from pathlib import Path

import embed
import mutants

SOURCE = """\
#pragma once
#if 1 + 2 > 3
#endif
// a + b, 17
/* a - b, 18 */
template <class T, int N = 3, class = std::enable_if_t<(N > 2)>>
struct Thing {
  static_assert(N < 40, "19 + 20");
  std::array<double, 21> values{};
  double factor = 22;
};
template <class T>
  requires Ring<T> && (sizeof(T) > 23)
T value(const T& x, T* y, T&& z) {
  if (x < 0) throw std::domain_error("24 is > 25: " + text(x + 26));
  const auto f = [=, &y](int k) { return x - k; };
  y->z = -x * 1e-9;
  message << "27 && 28" << '9';
  call(x, y);
  return std::min<T>(x, 0.5);
}
bool holds(int k) { return check(k); }
"""


def changed(text):
    return {(kind, old): new for _, kind, old, new in mutants.changes(text)}


class Places(unittest.TestCase):
    def test_only_code_is_changed(self):
        numbers = {old for kind, old in changed(SOURCE) if kind == "constant"}
        self.assertEqual(numbers, {"22", "0", "1e-9", "0.5"})

    def test_brackets_pointers_and_references_are_no_operators(self):
        operators = sorted(old for _, kind, old, _ in mutants.changes(SOURCE) if kind == "operator")
        self.assertEqual(operators, ["*", "-", "<"])

    def test_each_change_stands_where_it_says(self):
        for position, _, old, new in mutants.changes(SOURCE):
            self.assertTrue(SOURCE.startswith(old, position))
            self.assertTrue(all(n != old for n in new))

    def test_signs_returns_names_and_statements(self):
        found = changed(SOURCE)
        self.assertEqual(found["sign", "-"], [""])
        self.assertEqual(found["name", "min"], ["max"])
        self.assertEqual(found["return sign", "return std::min<T>(x, 0.5)"], ["return -(std::min<T>(x, 0.5))"])
        self.assertEqual(found["dropped", "call(x, y);"], [";"])
        self.assertEqual(found["dropped", "y->z = -x * 1e-9;"], [";"])
        self.assertNotIn(("return sign", "return check(k)"), found)

    def test_a_declaration_is_no_statement_to_drop(self):
        self.assertFalse([old for kind, old in changed("void f() { ; double x = 1; T y(2); }") if kind == "dropped"])

    def test_other_numbers(self):
        self.assertEqual(mutants.other_numbers("3"), ["6", "4", "0"])
        self.assertEqual(mutants.other_numbers("0"), ["1"])
        self.assertEqual(mutants.other_numbers("1"), ["2", "0"])
        self.assertEqual(mutants.other_numbers("0.5"), ["1.0", "1.5", "0.0"])
        self.assertEqual(mutants.other_numbers("1e-6"), ["0.001", "1.000001", "0.0"])
        self.assertEqual(mutants.other_numbers("2.5f"), ["5.0f", "3.5f", "0.0f"])

    def test_identifiers_and_order_survive_lines_put_in_elsewhere(self):
        import pathlib
        import tempfile

        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.hpp"
            file.write_text(SOURCE)
            before = {m.ident: m.new for m in mutants.mutants_of(folder, "a.hpp", "film", 1)}
            file.write_text("\n// one more\n" + SOURCE)
            after = {m.ident: m.new for m in mutants.mutants_of(folder, "a.hpp", "film", 1)}
        self.assertEqual(before, after)
        self.assertEqual(len(before), len([c for c in mutants.changes(SOURCE) if c[3]]))

    def test_shares_add_up_and_leave_no_folder_out(self):
        share = mutants.shares({"film": [0] * 800, "joint": [0] * 100, "multibody": [0] * 700, "motion": [0] * 2000}, 250)
        self.assertEqual(sum(share.values()), 250)
        self.assertGreaterEqual(min(share.values()), 31)


def embedded(text, wanted):
    """The text with a switch, number 7, for the first change of `wanted`; and whether it is in."""
    position, kind, old, new = next(c for c in mutants.changes(text) if c[2] == wanted)
    mutant = mutants.Mutant("id", "film", "a.hpp", position, 1, 1, kind, old, new[0])
    result, inside = embed.embed(text, [(7, mutant)])
    return result, bool(inside)


class Switches(unittest.TestCase):
    def check(self, statement, wanted, switched):
        text, inside = embedded("double f(double x) {\n  " + statement + "\n}\n", wanted)
        self.assertTrue(inside)
        self.assertEqual(text, "double f(double x) {\n  " + switched + "\n}\n")

    def test_statements(self):
        on = "lubjoint_mutation::on(7)"
        self.check("return x + 1;", "+", f"{{ if ({on}) return x - 1; return x + 1; }}")
        self.check("y = x * z;", "*", f"{{ if ({on}) {{ y = x / z; }} else {{ y = x * z; }} }}")
        self.check("call(x);", "call(x);", f"{{ if ({on}) {{ ; }} else {{ call(x); }} }}")
        self.check("const T y = x * z;", "*", f"const T y = [&]() -> T {{ if ({on}) return x / z; return x * z; }}();")
        self.check("const V<T> y(x * z);", "*",
                   f"const V<T> y = [&]() -> V<T> {{ if ({on}) return V<T>(x / z); return V<T>(x * z); }}();")  # fmt: skip

    def test_conditions(self):
        on = "lubjoint_mutation::on(7)"
        switched = f"({on} ? static_cast<bool>(x <= z) : static_cast<bool>(x < z))"
        self.check("if (x < z) return y;", "<", f"if ({switched}) return y;")
        self.check("while (x < z) y();", "<", f"while ({switched}) y();")
        self.check("for (int i = 5; x < z; ++i) y();", "<", f"for (int i = 5; {switched}; ++i) y();")
        self.check("for (int i = 5; x < z; ++i) y();", "5", f"for (int i = ({on} ? 10 : 5); x < z; ++i) y();")

    def test_what_the_compiler_evaluates_stays_out(self):
        for text in ("struct A {\n  static constexpr int n = 5;\n};", "void f() {\n  constexpr int n = 5;\n}"):
            self.assertEqual(embedded(text, "5"), (text, False))

    def test_lines_keep_their_numbers(self):
        source = "T f(T x) {\n  return x +  // one\n         g(x,\n           2);\n}\n"
        text, inside = embedded(source, "+")
        self.assertTrue(inside)
        self.assertEqual(text.count("\n"), source.count("\n"))
        self.assertIn("return x - g(x, 2);", text)


class Tables(unittest.TestCase):
    """The tables of the last campaign, in data/mutation."""

    def setUp(self):
        here = Path(__file__).resolve().parent
        sys.dont_write_bytecode = True
        loader = importlib.machinery.SourceFileLoader("run", str(here / "run"))
        self.run_script = importlib.util.module_from_spec(importlib.util.spec_from_loader("run", loader))
        loader.exec_module(self.run_script)
        self.data = here.parents[1] / "data/mutation"
        with open(self.data / "results.csv", newline="") as file:
            self.results = list(csv.DictReader(file))

    def test_totals_are_those_of_the_results(self):
        with open(self.data / "totals.csv", newline="") as file:
            written = [{k: v for k, v in row.items() if k != "seed"} for row in csv.DictReader(file)]
        expected = [{k: str(v) for k, v in row.items()} for row in self.run_script.totals(self.results)]
        self.assertEqual(written, expected)
        self.assertGreaterEqual(int(written[-1]["mutants"]), 250)

    def test_what_is_equivalent_is_argued(self):
        argued = self.run_script.equivalents(self.data / "equivalent.md")
        for row in self.results:
            if row["verdict"] == self.run_script.EQUIVALENT:
                self.assertIn(row["id"], argued)


if __name__ == "__main__":
    unittest.main()
