"""What tests of predicted and promised costs prove; kinds of run_case.py."""

import glob
import json
import os
import re


def require(holds, reason):
    if not holds:
        raise AssertionError(reason)


def bytes_in(folder):
    return sum(os.path.getsize(os.path.join(root, name))
               for root, _, names in os.walk(folder) for name in names)


def predicted_and_found(case, read_summary, attempt):
    """What --check predicts, in all of its answers, and what a run needs."""
    cache = os.path.abspath(case.folder(f"cache_{attempt}"))
    os.environ["XDG_CACHE_HOME"] = cache
    os.environ.pop("CONTRECOUP_CHECK_SECONDS", None)
    _, first, _ = case.run(None, extra=["--check"])
    print(first)
    require("Calibrating" in first, "the first --check says nothing of trials")
    _, second, _ = case.run(None, extra=["--check"])
    require("Calibrating" not in second and "kept in" in second,
            f"the second --check forgot the first: {second}")
    files = glob.glob(os.path.join(cache, "contrecoup", "*.json"))
    require(len(files) == 1, f"the cache holds {files}")
    with open(files[0]) as file:
        predicted = json.load(file)

    output = case.folder(f"run_{attempt}")
    case.run(output)
    summary = read_summary(output)
    performance = summary["performance"]
    found = {"seconds": performance["core_seconds"] / case.options.ranks,
             "memory": performance["peak_memory_bytes"],
             "output": bytes_in(output),
             "steps": summary["steps"]}
    if "cells" in case.options.compare:
        found["cells"] = summary["cells"]
    # Trials of 4 s are mostly start-up there, which costs no time per cell.
    if "ASAN_OPTIONS" in os.environ:
        del found["seconds"]
    return predicted, found


def forecast(case, check_bound, read_summary):
    """--check predicts processor time, memory and output of the run within
    the factor of --tolerance, and remembers that the next time; cells too if
    --compare names them, as they are in the end. A machine that others use may
    slow down between prediction and run: time has three attempts."""
    factor = float(case.options.tolerance)
    for attempt in range(3):
        predicted, found = predicted_and_found(case, read_summary, attempt)
        wrong = []
        for name, value in found.items():
            ratio = predicted[name] / value
            print(f"{name}: predicted {predicted[name]:.4g}, "
                  f"found {value:.4g}, ratio {ratio:.3f}")
            if not 1. / factor < ratio < factor:
                wrong.append(name)
        if wrong != ["seconds"]:
            break
    require(not wrong, f"the prediction of {', '.join(wrong)} is off by more "
            f"than {factor}")


PROMISE = re.compile(r"peaks ([\d.]+) %, impulses ([\d.]+) %[^;]*; "
                     r"relative cost (\d+(?:\.\d+)?)")
GAUGE = re.compile(r"^# +(\d) +([\d.]+) +([\d.]+)$", re.MULTILINE)


def presets(case, check_bound, read_summary):
    """Each preset has the errors that its first lines state, within a third
    and half a per cent, and the cost relative to the first one within a factor
    of 2; --compare names them, the file has the true peaks and impulses."""
    folder = os.path.dirname(os.path.abspath(case.options.file))
    with open(case.options.file) as file:
        scene = file.read()
    truth = [tuple(map(float, row)) for row in GAUGE.findall(scene)]
    require(truth and "include " in scene, "the file has no figures or preset")
    unit_cost = None
    for name in case.options.compare:
        preset = os.path.join(folder, name + ".prm")
        with open(preset) as file:
            text = " ".join(file.read().replace("#", " ").split())
        promised = PROMISE.search(text)
        require(promised, f"{preset} does not say what it costs")
        with open(case.folder(name + ".prm"), "w") as file:
            file.write(re.sub(r"^include .*$", "include " + preset, scene,
                              flags=re.MULTILINE))
        output = case.folder(name)
        case.run(output, file=case.folder(name + ".prm"))
        summary = read_summary(output)
        found = summary["assumptions"]
        errors = [max(100. * abs(found[f"probe_{gauge:.0f}_{quantity}"] / scale
                                 / row[column] - 1.)
                      for gauge, *row in truth)
                  for column, (quantity, scale) in enumerate(
                      (("peak_overpressure", 1e3), ("impulse", 1.)))]
        seconds = summary["performance"]["core_seconds"]
        unit_cost = unit_cost or seconds
        peak, impulse, cost = map(float, promised.groups())
        print(f"{name}: peaks {errors[0]:.2f} %, impulses {errors[1]:.2f} %, "
              f"relative cost {seconds / unit_cost:.2f}; promised {peak}, "
              f"{impulse}, {cost}")
        for stated, measured in ((peak, errors[0]), (impulse, errors[1])):
            require(abs(measured - stated) < stated / 3. + 0.5,
                    f"{name}: the error is {measured:.2f} %, not {stated} %")
        require(0.5 < seconds / unit_cost / cost < 2.,
                f"{name} costs {seconds / unit_cost:.2f} times as much")


KINDS = {kind.__name__: kind for kind in (forecast, presets)}
