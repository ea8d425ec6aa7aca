#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Completion scripts: what a shell that read them offers."""
import re
import shlex
import shutil
import subprocess

from command import CommandTest, main

ASK_BASH = """
COMP_WORDS=({words}); COMP_LINE={line}; COMP_POINT=${{#COMP_LINE}}; COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
_orispline; printf '%s\\n' "${{COMPREPLY[@]}}"
"""


class Bash(CommandTest):
    def offered(self, words, line=None):
        """Completions of the last word; bash takes `=` for a word of its own, so that the line may differ."""
        line = shlex.quote(words.replace("''", "") if line is None else line)
        script = self.output_of("completion bash") + ASK_BASH.format(words=words, line=line)
        done = subprocess.run(["bash", "-c", script], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_commands(self):
        self.assertEqual(self.offered("orispline in"), ["inspect"])

    def test_options_of_the_command(self):
        self.assertEqual(self.offered("orispline sample keys.csv --deriv"), ["--derivatives"])
        self.assertEqual(self.offered("orispline inspect keys.csv --deriv"), [])

    def test_words_that_an_option_takes(self):
        self.assertEqual(self.offered("orispline sample --frame ''"), ["body", "world"])
        self.assertEqual(self.offered("orispline sample --method timed-c"), ["timed-c1", "timed-c2", "timed-c3"])
        self.assertEqual(self.offered("orispline completion z"), ["zsh"])

    def test_a_method_can_be_followed_by_another(self):
        given = "orispline inspect keys.csv --method quintic:tension=1,2"
        self.assertEqual(self.offered(f"{given} --meth"), ["--method"])
        self.assertEqual(self.offered(f"{given} --method timed-c"), ["timed-c1", "timed-c2", "timed-c3"])

    def test_settings_and_their_words(self):
        start = "orispline sample keys.csv --set"
        self.assertIn("tension=", self.offered(f"{start} tensi"))
        self.assertEqual(self.offered(f"{start} hol"), ["hold="])
        self.assertEqual(self.offered(f"{start} vari"), ["variant=boyle", "variant=geier"])
        self.assertEqual(self.offered(f"{start} variant = b", f"{start} variant=b"), ["boyle"])
        self.assertEqual(self.offered(f"{start} variant =", f"{start} variant="), ["boyle", "geier"])
        self.assertEqual(self.offered(f"{start} variant = boyle ''", f"{start} variant=boyle "),
                         self.offered("orispline sample keys.csv ''"))

    def test_end_rules(self):
        self.assertEqual(self.offered("orispline sample keys.csv --ends qu"), ["quadratic"])
        self.assertEqual(self.offered("orispline sample keys.csv --ends h"), ["handle"])

    def test_files(self):
        self.assertEqual(self.offered("orispline sample ke"), ["keys.csv"])
        self.assertEqual(self.offered("orispline sample keys.csv -o ke"), ["keys.csv"])

    def test_nothing_where_only_the_user_knows(self):
        self.assertEqual(self.offered("orispline sample keys.csv --rate ''"), [])


class EveryShell(CommandTest):
    def test_every_option_of_the_help_is_offered(self):
        for command in ("sample", "convert", "inspect", "methods"):
            options = set(re.findall(r"^ +(?:-\w,)?--([\w-]+)", self.output_of(f"help {command} --all"), re.M))
            self.assertIn("json", options)
            for shell, pattern in (("bash", "--{}"), ("zsh", "*--{}["), ("fish", " -l {}")):
                script = self.output_of(f"completion {shell}")
                for option in options:
                    self.assertIn(pattern.format(option), script)

    def test_scripts_are_well_formed(self):
        for shell in ("bash", "zsh", "fish"):
            if not shutil.which(shell):
                continue
            done = subprocess.run([shell, "-n"], input=self.output_of(f"completion {shell}"), capture_output=True,
                                  text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""), shell)


if __name__ == "__main__":
    main()
