# SPDX-License-Identifier: Apache-2.0
"""The command under test, run in a folder of its own with the input files that the tests name."""
import fcntl
import math
import os
import pathlib
import pty
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import unittest

from page_data import data_of

COMMAND = pathlib.Path(os.environ["ORISPLINE_COMMAND"]).resolve()
EXPECTED = pathlib.Path(__file__).resolve().parent / "expected"
SUCCESS, BAD_DATA, BAD_USAGE, BAD_ACCESS = 0, 1, 2, 3

HALF = math.sqrt(0.5)
with_pages = unittest.skipIf(os.environ.get("ORISPLINE_PAGE") == "OFF", "the command was built without pages")
without_pages = unittest.skipUnless(os.environ.get("ORISPLINE_PAGE") == "OFF", "the command was built with pages")
KEYS = f"t,qw,qx,qy,qz\n0,1,0,0,0\n1,{math.cos(math.pi / 8)},0,0,{math.sin(math.pi / 8)}\n3,{HALF},0,0,{HALF}\n"


def read_or_nothing(terminal):
    """Linux fails where the other side of a terminal is closed."""
    try:
        return os.read(terminal, 65536)
    except OSError:
        return b""


class CommandTest(unittest.TestCase):
    """Every test starts in an empty folder that holds keys.csv: 45° about z in 1 s, then 45° in 2 s."""

    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("keys.csv", KEYS)

    def write(self, name, text):
        (self.folder / name).write_text(text, "utf-8")

    def read(self, name):
        return (self.folder / name).read_text("utf-8")

    def run_command(self, arguments, **options):
        """`arguments` as one line of words, or as a list where a word holds blanks."""
        words = arguments.split() if isinstance(arguments, str) else arguments
        return subprocess.run([COMMAND, *words], cwd=self.folder, capture_output=True, text=True, encoding="utf-8",
                              check=False, **options)

    def output_of(self, arguments, **options):
        """Standard output of a run that has to succeed."""
        done = self.run_command(arguments, **options)
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        return done.stdout

    def assert_fails(self, arguments, code, message, **options):
        """Nothing on standard output, and on standard error exactly the message, in one line."""
        done = self.run_command(arguments, **options)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (code, "", f"orispline: {message}\n"))

    def on_terminal(self, columns, arguments):
        """The lines that a run writes to a terminal of so many columns."""
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 25, columns, 0, 0))
        with subprocess.Popen([COMMAND, *arguments], cwd=self.folder, stdout=theirs, stderr=subprocess.DEVNULL) as run:
            os.close(theirs)
            text = b""
            while piece := read_or_nothing(ours):
                text += piece
        os.close(ours)
        self.assertEqual(run.returncode, SUCCESS)
        return text.decode("utf-8").replace("\r\n", "\n").splitlines()

    def page(self, name):
        """The data of a report, which has to be whole and to need no network."""
        text = self.read(name)
        self.assertNotRegex(text, r'(src|href)="https?://')
        self.assertFalse((self.folder / f"{name}.part").exists())
        return data_of(text)

    def assert_writes_reports_as_compare(self, arguments, bad_arguments):
        """Of a command with --report: what is refused, and that a failure leaves the old report."""
        self.assert_fails(f"{arguments} --report -", BAD_USAGE, "--report: found '-', wanted the name of a file")
        for other in ("out.csv", "./out.csv"):
            self.assert_fails(f"{arguments} -o out.csv --report {other}", BAD_USAGE,
                              f"--report: found '{other}', wanted another file than that of -o")
        source = arguments.split()[1]
        self.assert_fails(f"{arguments} -o out.csv --report ./{source}", BAD_USAGE,
                          f"--report: found './{source}', wanted another file than INPUT")
        done = self.run_command(f"{arguments} -o out.csv --report nowhere/out.html")
        self.assertEqual(done.returncode, BAD_ACCESS)
        self.assertIn("nowhere/out.html", done.stderr)
        self.write("old.html", "old")
        self.assertEqual(self.run_command(f"{bad_arguments} -o out.csv --report old.html").returncode, BAD_DATA)
        done = self.run_command(f"{arguments} -o nowhere/out.csv --report old.html")
        self.assertEqual(done.returncode, BAD_ACCESS)
        self.assertEqual(self.read("old.html"), "old")
        self.assertEqual({path.name for path in self.folder.iterdir() if "out" in path.name or "part" in path.name}, set())

    def assert_same_table(self, text, expected, separator=","):
        """Times are the same text; other numbers agree to 1e-12, for sines differ in the last digit."""
        rows, wanted = text.splitlines(), expected.splitlines()
        self.assertEqual(len(rows), len(wanted), text)
        for row, want in zip(rows, wanted):
            cells, want_cells = row.split(separator), want.split(separator)
            self.assertEqual(len(cells), len(want_cells), row)
            self.assertEqual(cells[0], want_cells[0])
            for cell, want_cell in zip(cells[1:], want_cells[1:]):
                if want_cell[0].isalpha():
                    self.assertEqual(cell, want_cell)
                else:
                    self.assertAlmostEqual(float(cell), float(want_cell), delta=1e-12, msg=row)


def rows_of(text):
    """The rows of a CSV below its header, as numbers."""
    return [[float(cell) for cell in line.split(",")] for line in table_of(text)[1:]]


def table_of(text):
    """The lines of a CSV without the comments above it."""
    return [line for line in text.splitlines() if not line.startswith("#")]


def main():
    # Shells let programs in the background ignore Ctrl-C, and children inherit that; here the command is to hear it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    result = unittest.main(exit=False).result
    for test, reason in result.skipped:
        print(f"skipped: {test.id().partition('.')[2]}: {reason}")
    sys.exit(not result.wasSuccessful())
