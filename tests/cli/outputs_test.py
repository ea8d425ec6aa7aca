#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where outputs may go, and which format their names mean."""
import os

from command import BAD_ACCESS, BAD_USAGE, KEYS, CommandTest, main

COMMANDS = ("sample {} --rate 2", "convert {}", "plot {}", "tune {} --method timed-c2", "retime {} --max-rate 1deg/s",
            "smooth {} --smoothing-time 1", "reduce {} --tolerance 1deg")
WRITERS = tuple(command for command in COMMANDS if not command.startswith(("plot", "tune")))


class Places(CommandTest):
    def assert_refused(self, arguments, message):
        done = self.run_command(arguments)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (BAD_USAGE, "", f"orispline: {message}\n"))
        self.assertEqual(self.read("keys.csv"), KEYS)

    def test_no_command_writes_into_its_input(self):
        os.symlink("keys.csv", self.folder / "link.csv")
        os.link(self.folder / "keys.csv", self.folder / "twin.csv")
        (self.folder / "inner").mkdir()
        for command in COMMANDS:
            for output in ("keys.csv", "./inner/../keys.csv", "link.csv", "twin.csv"):
                for given in ("keys.csv", "link.csv"):
                    with self.subTest(command=command, output=output):
                        self.assert_refused(f"{command.format(given)} -o {output}",
                                            f"-o: found '{output}', wanted another file than INPUT, which would be lost")

    def test_no_command_writes_into_what_else_it_reads(self):
        self.write("times.csv", "0.5\n")
        for command, option in (("sample other.csv", "--times times.csv"), ("sample other.csv --rate 1", "--truth keys.csv"),
                                ("tune other.csv --method timed-c2 --objective fit", "--reference keys.csv")):
            name, path = option.split()
            self.assert_refused(f"{command} {option} -o {path}",
                                f"-o: found '{path}', wanted another file than that of {name}, which would be lost")
        self.assertEqual(self.read("times.csv"), "0.5\n")

    def test_a_link_stays_and_the_file_that_it_leads_to_is_written(self):
        whole = self.output_of("convert keys.csv")
        (self.folder / "other").mkdir()
        links = {"far.csv": "other/there.csv", "near.csv": "far.csv", "gone.csv": "other/no/there.csv", "circle.csv": "round.csv",
                 "round.csv": "circle.csv", "folder": "other/new"}
        for link, target in links.items():
            os.symlink(target, self.folder / link)
        for link in ("far.csv", "near.csv"):  # to nothing at first
            self.output_of(f"convert keys.csv -o {link} --quiet")
            self.assertEqual(self.read("other/there.csv"), whole)
            (self.folder / "other/there.csv").unlink()
        self.output_of("sample keys.csv --rate 2 --output-folder folder --quiet")
        self.assertEqual(os.listdir(self.folder / "other/new"), ["keys.csv"])
        self.assert_fails("convert keys.csv -o gone.csv", BAD_ACCESS, "gone.csv: cannot write: No such file or directory")
        self.assert_fails("convert keys.csv -o circle.csv", BAD_ACCESS, "circle.csv: cannot write: Too many levels of symbolic links")
        self.assertEqual({link: os.readlink(self.folder / link) for link in links}, links)

    def test_no_two_outputs_go_into_one_file_that_is_not_there(self):
        os.symlink("there.html", self.folder / "link.csv")
        self.assert_refused("smooth keys.csv --smoothing-time 1 -o link.csv --report there.html",
                            "--report: found 'there.html', wanted another file than that of -o")

    def test_a_folder_of_outputs_is_not_that_of_the_inputs(self):
        self.assert_refused("reduce keys.csv --tolerance 1deg --output-folder .",
                            "--output-folder: found ., wanted a folder without the inputs")

    def test_streams_may_be_what_they_are(self):
        self.assertEqual(self.output_of("convert - -o -", input=KEYS), KEYS)
        self.output_of("convert keys.csv -o /dev/null --quiet")


class Names(CommandTest):
    def test_a_name_of_another_kind_of_file_is_refused_with_those_that_are_written(self):
        of_scenes = {"convert": ", or for a skeleton in .bvh, .glb, .gltf, .vrm or .vrma", "sample": ", or for a skeleton in .glb, .gltf, .vrm or .vrma"}
        of_scenes |= {"smooth": of_scenes["convert"], "retime": of_scenes["convert"], "reduce": of_scenes["sample"]}
        for name in ("x.png", "x.c3d", "x.json", "keys.csv.old", "x.PNG"):
            for command in WRITERS:
                done = self.run_command(f"{command.format('keys.csv')} -o {name}")
                self.assertEqual((done.returncode, done.stderr.splitlines()[0]), (
                    BAD_USAGE, f"orispline: -o: found '{name}', wanted a name that ends in .csv, .tum, .npy or .txt{of_scenes[command.split()[0]]}; "
                               "--output-format writes any name"))
                self.assertFalse((self.folder / name).exists())
        for name in ("x.png", "x.csv", "x.html"):
            self.assert_fails(f"plot keys.csv -o {name}", BAD_USAGE, f"-o: found '{name}', wanted a name that ends in .svg")
        self.assert_fails("tune keys.csv --method timed-c2 -o x.tum", BAD_USAGE,
                          "-o: found 'x.tum', wanted a name that ends in .csv or .txt")

    def test_a_format_that_is_named_goes_into_any_file(self):
        self.output_of("convert keys.csv -o keys.old --output-format csv --quiet")
        self.assertEqual(self.read("keys.old"), KEYS)

    def test_names_without_an_extension_and_in_capitals_are_as_before(self):
        for name in ("out", "OUT.CSV", "out.txt", "OUT.TXT"):
            self.output_of(f"convert keys.csv -o {name} --quiet")
            self.assertEqual(self.read(name), KEYS)

    def test_a_text_file_is_of_the_format_of_the_input(self):
        self.output_of("convert keys.csv -o keys.tum --quiet")
        tum = self.read("keys.tum")
        self.write("poses.txt", tum)
        for source in ("keys.tum", "poses.txt"):
            self.output_of(f"convert {source} -o again.txt --quiet")
            self.assertEqual(self.read("again.txt"), tum)
            for command in WRITERS:
                self.output_of(f"{command.format(source)} -o out.txt --quiet")
                rows = [line for line in self.read("out.txt").splitlines() if line[0] != "#"]
                self.assertEqual({line.count(" ") for line in rows}, {7}, command)
        self.output_of("sample keys.tum --rate 1 --derivatives 1 -o out.txt --quiet")
        self.assertTrue(self.read("out.txt").startswith("t,qw,qx,qy,qz,px,py,pz,wx"))
        self.output_of("sample keys.tum --rate 1 -o out.txt --output-format csv --quiet")
        self.assertTrue(self.read("out.txt").startswith("t,qw,qx,qy,qz,px,py,pz,wx"))


if __name__ == "__main__":
    main()
