"""Translation units: how each is compiled, what it includes, which lines of the library's source it holds code of, what its
fast tests are, and what all that takes. Measured once, kept in the build folder until one of the files changes."""

import hashlib
import json
import os
import re
import resource
import shlex
import shutil
import subprocess
import xml.sax.saxutils
from dataclasses import asdict, dataclass, field
from pathlib import Path

import embed
import mutants

#: Bounds are checked, so that a loop that runs too far is seen.
OPTIONS = ["-O1", "-w", "-DNDEBUG", "-D_GLIBCXX_ASSERTIONS"]

#: What nearly every test includes; boost/numeric/odeint.hpp as a whole is no C++20.
PRECOMPILED = """\
#include <Eigen/Dense>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <unsupported/Eigen/AutoDiff>
#include <variant>
"""

#: Sources of the library that read scenes and compute nothing.
READERS = ("journal_scene", "scene_changes", "scene_file", "scene_parts", "simulate", "start_check", "table_reader")

#: Tests of the oracle, the page and the program, none of which is built again.
OF_OTHERS = re.compile(
    r"accuracy|bench|certified|command|cost|finite_length|fuzz|golden_integrity|include_rules|leave_out|literature|options"
    r"|page|pinkus_sternlicht_difference|proofs|quadrature_test|stress|sweep|unfinished|verify|version"
)


class Failed(Exception):
    """A program that had to succeed did not."""


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(command, seconds=None, **options):
    """Runs a command with a limit of processor time, which says the same on a busy machine; (status, output, seconds)."""
    began = cpu_seconds()

    def limit():
        whole = int(seconds) + 1
        resource.setrlimit(resource.RLIMIT_CPU, (whole, whole + 1))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    with subprocess.Popen(
        [str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
        preexec_fn=limit if seconds else None, start_new_session=True, **options) as process:  # fmt: skip
        try:
            # One that sleeps takes no processor time.
            output, _ = process.communicate(timeout=20 * seconds + 60 if seconds else None)
            status = process.returncode
        except subprocess.TimeoutExpired:
            process.kill()
            output, _ = process.communicate()
            status = -24
    return status, output.decode(errors="replace"), cpu_seconds() - began


@dataclass
class Unit:
    """A source file that is compiled: a test, or one of the library's."""

    source: str
    flags: list
    is_test: bool
    group: str  # executable or archive it belongs to
    state: str = ""  # digest of all that it depends on
    seconds: float = 0  # to compile
    code: dict = field(default_factory=dict)  # file of the repository: lines of which there is code
    cases: list = field(default_factory=list)  # fast tests that pass
    run_seconds: float = 0  # of those
    members: list = field(default_factory=list)  # of the library's sources, those linked in
    reached: list = field(default_factory=list)  # numbers of the embedded mutants that the cases come to

    @property
    def name(self):
        return Path(self.source).stem


class Bench:
    """The build folder: archives by CMake, everything that holds mutated code by hand."""

    def __init__(self, root, folder, report, slow=2.0, source_limit=8.0):
        self.root, self.folder, self.report = Path(root), Path(folder), report
        self.slow, self.source_limit = slow, source_limit
        self.overlay = self.folder / "overlay"
        self.units = {}

    # --- preparation

    def prepare(self, pool):
        """Embeds the mutants of the pool (in its order, which numbers them), and finds out what is compiled already."""
        self.configure()
        self.precompile()
        known = self.folder / "units.json"
        state = json.loads(known.read_text()) if known.exists() else {"units": [], "alone": []}
        old = {u["source"]: Unit(**u) for u in state["units"]}
        self.numbers = {m.ident: k for k, m in enumerate(pool)}
        self.pool = pool
        self.alone = set(state["alone"])  # have to be compiled by themselves
        self.embed_all()
        self.units = {u.source: u for u in self.all_units()}
        self.ready, self.known = set(), known
        for unit in self.units.values():
            before = old.get(unit.source)
            if before and before.state == unit.state and self.object_of(unit).exists():
                self.units[unit.source] = before
                self.ready.add(unit.source)

    def tests(self):
        """The tests, those of headers before those of scenes, which have more of the library behind them."""
        found = [u for u in self.units.values() if u.is_test]
        scenes = {u.source: any("/lubjoint/scene/" in h for h in self.includes(u)) for u in found}
        return sorted(found, key=lambda u: (scenes[u.source], "/property_tests/" in u.source, u.source))

    def make(self, test):
        """Compiles a test and the library's units behind it, and runs it once, where that has not been done."""
        fresh = self.compile_once(test)
        if fresh:
            self.find_members(test)
        for source in test.members:
            fresh = self.compile_once(self.units[source]) or fresh
        if fresh or not self.program_of(test).exists() or not test.reached:
            self.measure_tests(test)
        self.save()

    def compile_once(self, unit):
        if unit.source in self.ready:
            return False
        self.report(f"compiling {unit.source}")
        self.compile_embedded(unit)
        self.ready.add(unit.source)
        return True

    def save(self):
        done = [asdict(self.units[source]) for source in sorted(self.ready)]
        self.known.write_text(json.dumps({"units": done, "alone": sorted(self.alone)}))

    def embed_all(self):
        """Writes lib with the mutants of the pool into a folder that comes before the real one."""
        self.embedded = {}  # identifier: first and last line of the statement that it is in
        target = self.folder / "embedded"
        sources = [p for p in (self.root / "lib").rglob("*") if p.suffix in (".hpp", ".cpp") and p.parts[-2] in
                   (*mutants.FOLDERS, "number", "scene", "src")]  # fmt: skip
        for path in sources:
            self.embed_file(path.relative_to(self.root / "lib").as_posix())
        runtime = self.folder / "runtime.cpp"
        if not runtime.exists() or runtime.read_text() != embed.RUNTIME:
            runtime.write_text(embed.RUNTIME)
            self.must(["c++", "-O1", "-c", runtime, "-o", self.folder / "runtime.o"], "compiling the switches")
        (target / "switch.hpp").write_text(embed.SWITCH)

    def embed_file(self, name):
        mine = [(self.numbers[m.ident], m) for m in self.pool if m.file == f"lib/{name}" and m.ident not in self.alone]
        text, inside = embed.embed((self.root / "lib" / name).read_text(), mine)
        here = {m.ident for m in self.pool if m.file == f"lib/{name}"}
        self.embedded = {i: lines for i, lines in self.embedded.items() if i not in here}
        self.embedded |= inside
        target = self.folder / "embedded" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_text() != text:
            target.write_text(text)

    def compile_embedded(self, unit):
        """Compiles; mutants that the compiler complains of are left out, and tried by themselves later."""
        for _ in range(8):
            status, output = self.compile_and_list(unit)
            if status == 0:
                return
            for pattern in (r"embedded/([\w/.]+):(\d+):\d+: error:", r"embedded/([\w/.]+):(\d+):"):
                places = {(f, int(line)) for f, line in re.findall(pattern, output)}
                blamed = [m for m in self.pool if m.ident in self.embedded and any(
                    m.file == f"lib/{f}" and self.embedded[m.ident][0] <= line <= self.embedded[m.ident][1]
                    for f, line in places)]  # fmt: skip
                if blamed:
                    break
            if not blamed:
                raise Failed(f"compiling {unit.source} failed:\n{output[:3000]}")
            self.report("by themselves: " + ", ".join(f"{m.file}:{m.line} {m.old}" for m in blamed)[:300])
            self.alone |= {m.ident for m in blamed}
            for file in {m.file for m in blamed}:
                self.embed_file(file.removeprefix("lib/"))
        raise Failed(f"compiling {unit.source} failed again and again:\n{output[:3000]}")

    def must(self, command, what):
        status, output, _ = run(command, cwd=self.folder)
        if status:
            raise Failed(f"{what} failed:\n{output[-3000:]}")
        return output

    def configure(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        if not (self.folder / "build.ninja").exists():
            self.must(["cmake", "-S", self.root, "-B", self.folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                       "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON",
                       "-DLUBJOINT_INSTALL=OFF"], "configuring")  # fmt: skip
        self.must(["ninja", "build.ninja"], "configuring")
        self.link = {}
        archives = set()
        for group in ("tests/lubjoint_tests", "property_tests/lubjoint_property_tests"):
            command = shlex.split(self.must(["ninja", "-t", "commands", group], "asking ninja").strip().splitlines()[-1])
            at = command.index("-o")
            rest = command[at + 2 :]
            rest = [w for w in rest[: rest.index("&&")] if not re.search(r"lubjoint_(commands|page|verify\w*)\.a$", w)]
            self.link[group.split("/")[1]] = rest
            archives |= {a for a in rest if a.endswith(".a") and not a.startswith("/")}
        self.report("building the archives")
        self.must(["ninja", "-j1", *sorted(archives)], "building the archives")
        self.linker = ["-fuse-ld=lld"] if shutil.which("ld.lld") else []

    def all_units(self):
        self.compiler = None
        units = {}
        generated = (self.folder / "lib").as_posix()
        for entry in json.loads((self.folder / "compile_commands.json").read_text()):
            source, words = entry["file"], shlex.split(entry["command"])
            words = words[1:] if "ccache" in words[0] else words
            output = words[words.index("-o") + 1]
            m = re.match(r"(?:\w+/)CMakeFiles/(lubjoint_\w+)\.dir/", output)
            path = Path(source)
            is_test = path.parent in (self.root / "tests", self.root / "property_tests")
            is_ours = (path.parent == self.root / "lib/src" or source.startswith(generated)) and path.stem not in READERS
            if not m or not (is_test or is_ours) or source in units or (is_test and OF_OTHERS.search(path.stem)):
                continue
            self.compiler = self.compiler or words[0]
            flags = [w for w in words[1:-4] if not re.match(r"-O|-W|-DNDEBUG|-g", w)]
            unit = Unit(source, flags, is_test, m.group(1))
            headers = self.includes(unit)
            if is_test and not any(re.search(rf"/lib/include/lubjoint/({'|'.join(mutants.FOLDERS)})/", h) for h in headers):
                continue
            text = b"".join(self.embedded_of(h).read_bytes() for h in sorted(headers))
            unit.state = hashlib.sha256(text + repr((flags, OPTIONS, PRECOMPILED)).encode()).hexdigest()
            units[source] = unit
        return sorted(units.values(), key=lambda u: (u.is_test, u.source))

    def embedded_of(self, file):
        """The file with the mutants in it, where it is one of lib's."""
        lib = (self.root / "lib").as_posix() + "/"
        inside = self.folder / "embedded" / file.removeprefix(lib)
        return inside if file.startswith(lib) and inside.exists() else Path(file)

    def includes(self, unit):
        """The unit and all files of the repository that it includes, however deep."""
        folders = [Path(f[2:]) for f in unit.flags if f.startswith("-I")]
        found, left = set(), [Path(unit.source)]
        while left:
            file = left.pop()
            if file.as_posix() in found:
                continue
            found.add(file.as_posix())
            for name in re.findall(r'^\s*#\s*include "([^"]+)"', file.read_text(), re.M):
                for folder in [file.parent, *folders]:
                    if (folder / name).exists():
                        left.append((folder / name).resolve())
                        break
        return found

    def precompile(self):
        header = self.folder / "precompiled" / "common.hpp"
        text = f"// {OPTIONS}\n{PRECOMPILED}"
        if header.exists() and header.read_text() == text and header.with_suffix(".hpp.gch").exists():
            return
        self.report("precompiling the headers of others")
        header.parent.mkdir(exist_ok=True)
        header.write_text(text)
        self.must(["c++", "-std=gnu++20", *OPTIONS, "-ffp-contract=off", "-DBOOST_ALL_NO_LIB", "-isystem", "/usr/include/eigen3",
                   "-x", "c++-header", header, "-o", header.with_suffix(".hpp.gch")], "precompiling")  # fmt: skip

    # --- compiling and running

    def object_of(self, unit, mutated=False):
        return self.folder / ("mutated" if mutated else "objects") / f"{unit.group}.{unit.name}.o"

    def compile_command(self, unit, output, overlay):
        """With the headers and sources of `overlay` before the real ones."""
        source = unit.source
        if Path(source).parent == self.root / "lib/src":
            source = overlay / "src" / Path(source).name
        first = [f"-I{overlay}/include", f"-I{overlay}/src"]
        common = ["-include", self.folder / "precompiled/common.hpp"] if "-std=gnu++20" in unit.flags else []
        common += ["-include", self.folder / "embedded/switch.hpp"]
        return [self.compiler, *first, *unit.flags, "-ffp-contract=off", *OPTIONS, *common, "-o", output, "-c", source]

    def link_command(self, objects, group, output):
        return [self.compiler, *self.linker, "-O1", *objects, self.folder / "runtime.o", "-o", output, *self.link[group]]

    def compile_and_list(self, unit):
        """Compiles with the embedded mutants, and lists the lines that the unit holds code of; (status, messages)."""
        target = self.object_of(unit)
        target.parent.mkdir(exist_ok=True)
        assembly = target.with_suffix(".s")
        command = self.compile_command(unit, assembly, self.folder / "embedded")
        command[command.index("-c")] = "-S"
        status, output, unit.seconds = run([*command, "-g1"], cwd=self.folder)
        if status == 0:
            unit.code = self.lines_with_code(assembly)
            self.must([self.compiler, "-c", assembly, "-o", target], "assembling")
            assembly.unlink()
        return status, output

    def lines_with_code(self, assembly):
        names, lines = {}, {}
        prefix = f"{self.folder}/embedded/"
        with open(assembly, errors="replace") as text:
            for line in text:
                if line.startswith("\t.loc "):
                    words = line.split(None, 3)
                    lines.setdefault(words[1], set()).add(int(words[2]))
                elif line.startswith("\t.file "):
                    words = shlex.split(line)
                    names[words[1]] = "/".join(words[2:])
        return {"lib/" + f[len(prefix) :]: sorted(lines[n]) for n, f in names.items() if f.startswith(prefix) and n in lines}

    def program_of(self, test):
        return self.folder / "programs" / test.name

    def find_members(self, test):
        """Which of the library's sources the linker takes for a test."""
        map_file = self.folder / "link.map"
        command = self.link_command([self.object_of(test)], test.group, self.folder / "program")
        self.must([*command, f"-Wl,-Map={map_file}"], "linking")
        names = set(re.findall(r"/?liblubjoint_(?:scene|batch)\.a\(([\w.]+)\.o\)", map_file.read_text(errors="replace")))
        test.members = sorted(s for s, u in self.units.items() if not u.is_test and Path(s).name in names)

    def measure_tests(self, test):
        """Links the test with the library's units, and runs it: which cases pass and are fast, what they come to."""
        program = self.program_of(test)
        program.parent.mkdir(exist_ok=True)
        objects = [self.object_of(test), *(self.object_of(self.units[source]) for source in test.members)]
        self.must(self.link_command(objects, test.group, program), "linking")
        # What fails here needs the program or a file that is not built.
        status, output, used = run([program, "-r", "xml", "-d", "yes"], seconds=90, cwd=self.folder)
        cases = re.findall(r'<TestCase name="([^"]*)".*?<OverallResult success="(\w+)" durationInSeconds="([^"]+)"', output, re.S)
        wall = sum(float(c[2]) for c in cases) or 1.0
        busy = min(1.0, used / wall)
        times = {xml.sax.saxutils.unescape(n, {"&quot;": '"'}): float(s) * busy for n, ok, s in cases if ok == "true"}
        fast = sorted((n for n in times if times[n] <= self.slow), key=times.get)
        total, test.cases = 0.0, []
        for name in fast:
            if total + times[name] > self.source_limit:
                break
            total += times[name]
            test.cases.append(name)
        test.run_seconds = total
        reached = self.folder / "reached"
        reached.unlink(missing_ok=True)
        if test.cases:
            environment = {**os.environ, "LUBJOINT_REACHED": str(reached)}
            self.run_cases(program, test, seconds=None, environment=environment)
        test.reached = [int(k) for k in reached.read_text().split()] if reached.exists() else []

    def run_cases(self, program, test, seconds, environment):
        cases = self.folder / "cases"
        cases.write_text("".join(name.replace(",", "\\,") + "\n" for name in test.cases))  # a comma would end the name
        command = [program, "-r", "xml", "-a", "-f", cases]
        status, output, used = run(command, seconds=seconds, cwd=self.folder, env=environment)
        last = re.findall(r'<TestCase name="([^"]*)"', output)
        name = xml.sax.saxutils.unescape(last[-1], {"&quot;": '"'}) if last else "(before the first)"
        if status in (-24, -9):
            return "timed out", name, used
        return ("failed", name, used) if status else ("passed", "", used)

    def run_switched(self, test, number):
        """Runs the fast cases with an embedded mutant switched on; as run_tests."""
        environment = {**os.environ, "LUBJOINT_MUTANT": str(number)}
        return self.run_cases(self.program_of(test), test, 4 * test.run_seconds + 3, environment)

    def write_overlay(self, file, text):
        """The mutated file before the real one, for whoever includes or compiles it."""
        shutil.rmtree(self.overlay, ignore_errors=True)
        shutil.rmtree(self.folder / "mutated", ignore_errors=True)
        (self.folder / "mutated").mkdir()
        (self.overlay / "include").mkdir(parents=True)
        if file.startswith("lib/include/"):
            (self.overlay / "src").symlink_to(self.root / "lib/src")
            target = self.overlay / file.removeprefix("lib/")
        else:
            shutil.copytree(self.root / "lib/src", self.overlay / "src")
            target = self.overlay / file.removeprefix("lib/")
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)

    def compile_mutated(self, unit):
        """(Whether it compiled, seconds)."""
        output = self.object_of(unit, mutated=True)
        command = self.compile_command(unit, output, self.overlay)
        status, _, used = run(command, seconds=10 * unit.seconds + 20, cwd=self.folder)
        return status == 0, used

    def run_tests(self, test, mutated):
        """Runs the fast cases of a test source with the mutated units linked before all others.

        Returns ("passed" | "failed" | "timed out", name of the case, seconds).
        """
        # What is linked first gives the functions that several units hold.
        objects = [self.object_of(u, mutated=True) for u in mutated]
        if test not in mutated:
            objects.append(self.object_of(test))
        program = self.folder / "program"
        status, _, linking = run(self.link_command(objects, test.group, program), cwd=self.folder)
        if status:
            return "failed", "(the linker)", linking
        result, name, used = self.run_cases(program, test, 4 * test.run_seconds + 3, None)
        return result, name, linking + used
