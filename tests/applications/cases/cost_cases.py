"""Tests of promised costs; kinds of run_case.py."""

import os
import re

from case import read_summary, read_text, require
from summaries import values_of


PROMISE = re.compile(r"peaks ([\d.]+) %, impulses ([\d.]+) %[^;]*; "
                     r"updates (\d+(?:\.\d+)?) times")
GAUGE = re.compile(r"^# +(\d) +([\d.]+) +([\d.]+)$", re.MULTILINE)


def presets(case):
    """Each preset has the errors that its first lines state, within a
    twentieth and a twentieth of a per cent, and makes as many updates relative
    to the first one as they state, within 3 %; --compare names them, the file has the true peaks and impulses."""
    folder = os.path.dirname(os.path.abspath(case.options.file))
    scene = read_text(case.options.file)
    truth = [tuple(map(float, row)) for row in GAUGE.findall(scene)]
    require(truth and "include " in scene, "the file has no figures or preset")
    unit_cost, wrong = None, []
    for name in case.options.compare:
        preset = os.path.join(folder, name + ".prm")
        text = " ".join(read_text(preset).replace("#", " ").split())
        promised = PROMISE.search(text)
        require(promised, f"{preset} does not say what it costs")
        with open(case.folder(name + ".prm"), "w") as file:
            file.write(re.sub(r"^include .*$", "include " + preset, scene,
                              flags=re.MULTILINE))
        output = case.folder(name)
        case.run(output, file=case.folder(name + ".prm"))
        summary = read_summary(output)
        found = values_of(summary, "results")
        errors = [max(100. * abs(found[f"probe_{gauge:.0f}_{quantity}"] / scale
                                 / row[column] - 1.)
                      for gauge, *row in truth)
                  for column, (quantity, scale) in enumerate(
                      (("peak_overpressure", 1e3), ("impulse", 1.)))]
        updates = summary["performance"]["updates"]
        unit_cost = unit_cost or updates
        peak, impulse, cost = map(float, promised.groups())
        print(f"{name}: peaks {errors[0]:.2f} %, impulses {errors[1]:.2f} %, "
              f"{updates / unit_cost:.2f} times the updates; promised {peak}, "
              f"{impulse}, {cost}")
        for stated, measured in ((peak, errors[0]), (impulse, errors[1])):
            if not abs(measured - stated) < 0.05 * stated + 0.05:
                wrong.append(f"{name}: the error is {measured:.2f} %, not "
                             f"{stated} %")
        if not 0.97 < updates / unit_cost / cost < 1.03:
            wrong.append(f"{name} makes {updates / unit_cost:.2f} times as "
                         "many updates")
    require(not wrong, "; ".join(wrong))


KINDS = {"presets": presets}
