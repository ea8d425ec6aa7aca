#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orispline tasks: that every option it lists is one of the command's, with the same words."""
import json
import re

from command import CommandTest, main

OTHERWISE = {  # what the command takes in a manner of its own
    "slowing": "--per-interval", "adapt": "--no-adapt", "least_energy": "--no-least-energy", "values": "--refit",
    "spacing": "--jitter", "seed": "--random", "world_turn": "--no-world-turn", "body_turn": "--no-body-turn",
    "runs": "--no-runs", "scale": "--no-scale", "translation": "--no-translation"}


class Tasks(CommandTest):
    def setUp(self):
        super().setUp()
        self.tasks = {task["task"]: task for task in json.loads(self.output_of("tasks --json"))}

    def test_every_option_is_one_of_the_command(self):
        for name, task in self.tasks.items():
            text = self.output_of(f"help {name} --all")
            for option in task["options"]:
                flag = OTHERWISE.get(option["name"], "--" + option["name"].replace("_", "-"))
                self.assertRegex(text, rf"(?m)^ +{flag}\b", name)
                if "words" in option and option["name"] not in OTHERWISE:
                    self.assertIn("|".join(word["word"] for word in option["words"]), text)

    def test_states_units_ranges_and_defaults(self):
        smooth = {option["name"]: option for option in self.tasks["smooth"]["options"]}
        noise = smooth["noise"]
        self.assertEqual((noise["type"], noise["unit"], noise["lowest"], noise["highest"], noise["default"]),
                         ("number", "rad", 1e-7, 0.5, None))
        self.assertEqual((smooth["penalty"]["default"], smooth["loss"]["default"], smooth["gyro"]["default"]), (None, "robust", False))
        self.assertEqual({o["name"] for o in self.tasks["reduce"]["options"] if o["required"]}, {"tolerance"})

    def test_results_are_members_of_the_json(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n2,0.6,0.8,0,0\n4,0,1,0,0\n")
        for name, arguments in (("smooth", ""), ("tune", "--method quintic"), ("reduce", "--tolerance 1deg"),
                                ("retime", "--max-rate 1deg/s"), ("mean", "")):
            found = json.loads(self.output_of(f"{name} keys.csv {arguments} --json -o out.csv"))
            for result in self.tasks[name]["results"]:
                if not result["absent"]:
                    self.assertIn(result["name"], found, name)

    def test_the_page_names_every_field(self):
        page = self.output_of("tasks")
        for task in self.tasks.values():
            for field in task["options"] + task["results"] + task.get("results_of_gyros", []):
                self.assertRegex(page, rf"(?m)^  {re.escape(field['name'])}\b")


if __name__ == "__main__":
    main()
