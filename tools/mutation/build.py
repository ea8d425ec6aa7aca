# SPDX-License-Identifier: Apache-2.0
"""A copy of the tree with mutants in it, built once; those that do not compile are taken out again."""
import collections
import json
import os
import pathlib
import re
import shutil
import subprocess

from mutation.mutants import mutants_of

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
WITHOUT = {"report", "pages"}
NOT_BUILT = {"scenes/assimp.cpp"}  # without an option that is off
PLACE = re.compile(r"src/orispline/([\w/.]+):(\d+)")
LIBRARY, HOST = "src/orispline", "base/expected.cpp"  # the host has mutation.cpp behind its own text
FLAGS = {"CMAKE_BUILD_TYPE": "Debug", "CMAKE_CXX_FLAGS_DEBUG": "-O1 -D_GLIBCXX_ASSERTIONS", "ORISPLINE_TESTS": "ON",
         "BUILD_SHARED_LIBS": "OFF"}


def put(path, data):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.is_file() or path.read_bytes() != data:
        path.write_bytes(data)


def equivalents():
    """Mutants that no test can find, by file, text of the line, original and mutant; each has its reason there."""
    listed = json.loads((HERE / "equivalent.json").read_text("utf-8"))
    return {(e["file"], e["line"], e["original"], e["mutated"]) for e in listed}


def key_of(mutant, text):
    """As in equivalents()."""
    return mutant.file, text.splitlines()[mutant.line - 1].strip(), mutant.original, mutant.mutated


def is_in(name, folders):
    """Whether a file lies in one of the folders, or fits one such as `reduce/hermite_*`; without folders in any but a few."""
    if len(name.parts) < 2 or name.as_posix() in NOT_BUILT:
        return False
    if not folders:
        return name.parts[0] not in WITHOUT
    return any(chosen == name.parts[0] or "/" in chosen and name.match(chosen) for chosen in folders)


def candidates(folders):
    """All mutants of the library's folders but equivalent ones, in the order of files and lines."""
    folder = ROOT / LIBRARY
    found, without = [], equivalents()
    for path in sorted([*folder.rglob("*.cpp"), *folder.rglob("*.hpp")]):
        name = path.relative_to(folder)
        if is_in(name, folders):
            text = path.read_text("utf-8")
            found += [m for m in mutants_of(name.as_posix(), text) if key_of(m, text) not in without]
    return found


def overlap(a, b):
    return a.file == b.file and a.start < b.end and b.start < a.end


def sampled(found, count, random):
    """So many mutants, evenly over the lines that have any; none lies in another."""
    lines = collections.defaultdict(list)
    for mutant in found:
        lines[mutant.file, mutant.line].append(mutant)
    groups, chosen = list(lines.values()), []
    step, offset = max(1.0, len(groups) / count), random.random()
    for k in range(min(count, len(groups))):
        mutant = random.choice(groups[int((k + offset) * step) % len(groups)])
        if not any(overlap(mutant, other) for other in chosen[-20:]):
            mutant.id = len(chosen)
            chosen.append(mutant)
    return chosen


class MutatedTree:
    def __init__(self, folder, mutants):
        self.tree, self.build, self.original = folder / "tree", folder / "build", folder / "original"
        self.mutants = list(mutants)

    def copy(self):
        """Files that are as they were keep their times, and what was compiled of them."""
        listed = subprocess.run(["git", "ls-files", "-coz", "--exclude-standard"], cwd=ROOT, check=True,
                                capture_output=True)
        names = [name for name in listed.stdout.decode().split("\0") if name and (ROOT / name).is_file()]
        known = set(names)
        for path in [path for path in self.tree.rglob("*") if path.is_file()]:
            if path.relative_to(self.tree).as_posix() not in known:
                path.unlink()
        mutated = {f"{LIBRARY}/{file}" for file in (HOST, *(mutant.file for mutant in self.mutants))}
        for name in names:
            if name in mutated:
                put(self.original / name, (ROOT / name).read_bytes())
            else:
                put(self.tree / name, (ROOT / name).read_bytes())
                shutil.copymode(ROOT / name, self.tree / name)
        shared = self.tree.parent / "shared"
        if (ROOT.parent / "shared").exists() and not shared.exists():
            shared.symlink_to(ROOT.parent / "shared")
        for file in {HOST, *(mutant.file for mutant in self.mutants)}:
            self.write(file)

    def write(self, file):
        """A source with the mutants that are left in it."""
        text = (self.original / LIBRARY / file).read_text("utf-8")
        for mutant in sorted((m for m in self.mutants if m.file == file), key=lambda m: -m.start):
            text = text[:mutant.start] + mutant.replacement() + text[mutant.end:]
        if file == HOST:  # of what every part of the library is linked with
            text += (HERE / "mutation.cpp").read_text("utf-8")
        put(self.tree / LIBRARY / file, text.encode())

    def configure(self):
        choice = self.tree / "tools/mutation/mutation.hpp"
        flags = dict(FLAGS, CMAKE_CXX_FLAGS=f"-ffp-contract=off -w -Wno-narrowing -include {choice}")
        subprocess.run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja",
                        *(f"-D{name}={value}" for name, value in flags.items())],
                       check=True, stdout=subprocess.DEVNULL)

    def compile(self, targets, jobs):
        """Builds the targets; the mutants where the compiler finds errors, which are taken out."""
        dropped = []
        while True:
            done = subprocess.run(["ninja", "-C", self.build, f"-j{jobs}", "-k", "0", *targets], check=False, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=dict(os.environ, LC_ALL="C"))
            if done.returncode == 0:
                return dropped
            faulty = self.faulty(done.stdout)
            if not faulty:
                raise RuntimeError(f"the mutated tree does not build:\n{done.stdout[-4000:]}")
            print(f"{len(faulty)} mutants do not compile", flush=True)
            dropped += faulty
            self.mutants = [mutant for mutant in self.mutants if mutant not in faulty]
            for file in {mutant.file for mutant in faulty}:
                self.write(file)

    def libraries(self):
        listed = subprocess.run(["ninja", "-C", self.build, "-t", "targets", "all"], check=True, capture_output=True,
                                text=True)
        return re.findall(r"^(src/orispline/\S+\.a): ", listed.stdout, re.M)

    def faulty(self, output):
        """The mutants at the places of errors; where an error is elsewhere, those at the places that led to it."""
        faulty = []
        for block in re.split(r"^FAILED: ", output, flags=re.M)[1:]:
            errors = [line for line in block.splitlines() if " error: " in line]
            at_errors = self.at(PLACE.findall("\n".join(errors)))
            faulty += [mutant for mutant in at_errors or self.at(PLACE.findall(block)) if mutant not in faulty]
        return faulty

    def at(self, places):
        wanted = {(file, int(line)) for file, line in places}
        return [m for m in self.mutants
                if any((m.file, m.line + k) in wanted for k in range(m.pattern.count("\n") + 1))]
