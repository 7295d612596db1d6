"""Tests of recorded loads; kinds of run_case.py."""

import bisect
import glob
import math
import os
import re

import numpy

import samples as numbers
from case import (check_bound, overrides, read_columns, read_summary,
                  read_text, require)
from summaries import values_of

ENTRY = "Loads/Smallest overpressure"


def read_gauges(output):
    """Times, and overpressures of all gauges at each."""
    times, *gauges = read_columns(output, "load_gauges.csv").values()
    return times, list(map(list, zip(*gauges)))


def integrals(times, samples):
    """Time integrals of means since the time before, the first since 0."""
    steps = [end - begin for begin, end in zip([0.] + times, times)]
    return [sum(step * sample[gauge] for step, sample in zip(steps, samples))
            for gauge in range(len(samples[0]))]


def arrival(case):
    """Samples begin when the wave arrives, and none of their impulse is lost:
    bounds of "first_sample" [s], "samples_at_rest", of the part of the largest
    "first_overpressure" and of the "impulse_difference" from a run that keeps
    less."""
    outputs = [case.straight(), case.folder("later")]
    case.run(outputs[1], extra=["--set", ENTRY + "=0.01"])
    runs = [read_gauges(output) for output in outputs]
    impulses = [integrals(*run) for run in runs]
    largest = max(map(abs, impulses[0]))
    for times, samples in runs:
        highest = max(max(map(abs, sample)) for sample in samples)
        at_rest = [sample for sample in samples
                   if max(map(abs, sample)) < 1e-9 * highest]
        found = {"first_sample": times[0],
                 "samples_at_rest": len(at_rest),
                 "first_overpressure": max(map(abs, samples[0])) / highest,
                 "impulse_difference": max(
                     abs(one - other) / largest
                     for one, other in zip(*impulses))}
        for bound in case.options.bound:
            check_bound(found, bound)


def largest_mean(times, samples, gauge, duration, last=False):
    """Largest mean of a gauge over this time, as one that responds slowly
    would show it, or the last one; samples are means since the time before."""
    begins = [0.] + times
    sums = [0.]
    for begin, end, sample in zip(begins, times, samples):
        sums.append(sums[-1] + (end - begin) * sample[gauge])

    def integral(time):
        i = max(1, bisect.bisect_left(begins, time))
        part = (time - begins[i - 1]) / (begins[i] - begins[i - 1])
        return sums[i - 1] + part * (sums[i] - sums[i - 1])

    return max((integral(time) - integral(time - duration)) / duration
               for time in (times[-1:] if last else times)
               if time >= duration)


def gauge_order(case):
    """The largest means of gauges over some time converge, or with "last" after
    SECONDS those at the end: for --vary as in convergence, and --error "NUMBER
    SECONDS EXACT|..." of the gauges, bounds of "order_NUMBER" and
    "error_NUMBER", a part of the exact one, of the last runs, and of
    "peak_NUMBER" in the last, without a mean."""
    entry, values = case.options.vary.split("=", 1)
    runs = []
    for value in values.split("|"):
        output = case.folder(value)
        case.run(output, extra=["--set", f"{entry}={value}"])
        runs.append((value, *read_gauges(output)))
    found = {}
    for text in case.options.error.split("|"):
        number, duration, *words, exact = text.split()
        gauge, last = int(number) - 1, None
        for value, times, samples in runs:
            peak = max(sample[gauge] for sample in samples)
            mean = largest_mean(times, samples, gauge, float(duration),
                                words == ["last"])
            error = abs(mean / float(exact) - 1.)
            order = math.log2(last / error) if last else math.nan
            last = error
            print(f"gauge {number}, {entry} = {value}: peak {peak:.4f}, mean "
                  f"{mean:.5f}, error {error:.5f}, order {order:.2f}")
        found.update({"order_" + number: order, "error_" + number: error,
                      "peak_" + number: peak})
    for bound in case.options.bound:
        check_bound(found, bound)


def read_domain(output):
    """Corners of the domain that the run used, and its coarse leaves."""
    text = read_text(output, "parameters.prm")
    return [list(map(float, re.search(
        rf"^ *set {entry} *= (.*)$", text, re.MULTILINE)[1].split(",")))
            for entry in ("Lower corner", "Upper corner", "Coarse leaves")]


def entries_of(domain_values):
    """Entries of the domain, from lists of numbers by name."""
    return [f"Domain/{name}=" + ", ".join(f"{value:.15g}" for value in values)
            for name, values in domain_values.items()]


def farther(output, number):
    """Entries that move the open sides of a run's domain, all but those at y
    and z = 0, out by a number of coarse leaves."""
    lower, upper, leaves = read_domain(output)
    for d in range(3):
        edge = (upper[d] - lower[d]) / leaves[d]
        sides = 2 if lower[d] < 0. else 1
        lower[d] -= number * edge * (sides - 1)
        upper[d] += number * edge
        leaves[d] += number * sides
    return overrides(entries_of({"Lower corner": lower, "Upper corner": upper,
                                 "Coarse leaves": leaves}))


def largest_difference(output, other):
    """Difference of gauges' peaks and impulses, over the largest of a kind."""
    one, two = (values_of(read_summary(run), "results")
                for run in (output, other))
    largest = 0.
    for kind in ("_peak", "_impulse"):
        names = [name for name in one
                 if name.startswith("loads_") and name.endswith(kind)]
        assert names, "the run has no gauges"
        scale = max(abs(two[name]) for name in names)
        largest = max([largest] + [abs(one[name] - two[name]) / scale
                                   for name in names])
    return largest


def domain(case):
    """Domain/Size = by time makes a domain large enough for the loads: bounds
    of the "difference" of peaks and impulses from those in a larger domain, and
    of the "short_difference" that the domain of the file itself has."""
    sized, larger, short = (case.folder(name)
                            for name in ("sized", "larger", "short"))
    case.run(sized, extra=["--set", "Domain/Size=by time"])
    case.run(larger, extra=farther(sized, 3))
    case.run(short)
    found = {"difference": largest_difference(sized, larger),
             "short_difference": largest_difference(short, larger)}
    for bound in case.options.bound:
        check_bound(found, bound)


def facet_loads(case):
    """The samples in loads.h5 push the body as hard as the summary says: bounds
    of the relative "file_difference" of their impulse, taken with the areas,
    normals and factors of the file, and of what the summary has. The skin in
    fields/ has the same measures, which are unknown before the blast comes."""
    import h5py
    output = case.folder("run")
    case.run(output, extra=["--set", "Output/Fields=true"])
    summary = read_summary(output)
    with h5py.File(os.path.join(output, "loads.h5")) as file:
        times, samples = list(file["time"]), file["overpressure"][:]
        areas, normals = file["area"][:], file["normal"][:]
        words = file.attrs["factors_to_whole_body"].decode()
        skins = [numbers.read(path) for path in sorted(glob.glob(
            os.path.join(output, "fields", "skin_*.vtp")))]
        for name in ("peak", "impulse", "arrival"):
            require(numpy.isnan(skins[0][name]).all()
                    and numpy.array_equal(skins[-1][name], numpy.float32(
                        file[name][:]), equal_nan=True),
                    f"{name} of the skin is not that of loads.h5")
        require(not skins[0]["overpressure"].any(), "the skin begins loaded")
    steps = [end - begin for begin, end in zip([0.] + times, times)]
    found = -(samples @ steps * areas) @ normals * [
        float(word) for word in words.split(",")]
    told = [values_of(summary, "results").get("loads_impulse_" + axis, 0.)
            for axis in "xyz"]
    summary["file_difference"] = math.dist(found, told) / math.hypot(*told)
    for bound in case.options.bound:
        check_bound(summary, bound)


def whole_body(case):
    """Impulses of a body that a plane of symmetry y = 0 halves are those of the
    whole one: bounds of the relative "difference" from a run without the
    plane, of the impulse "across" the plane, and of the fractions of the gas
    in "part" and "whole"."""
    halves = case.folder("half")
    case.run(halves)
    lower, upper, leaves = read_domain(halves)
    whole = case.folder("whole")
    lower[1], leaves[1] = -upper[1], 2. * leaves[1]
    case.run(whole, extra=overrides(
        [*entries_of({"Lower corner": lower, "Coarse leaves": leaves}),
         "Boundaries/y low=open"]))
    one, two = (read_summary(output) for output in (halves, whole))
    impulses = [[values_of(summary, "results").get("loads_impulse_" + axis, 0.)
                 for axis in "xyz"] for summary in (one, two)]
    found = {"difference": math.dist(*impulses) / math.hypot(*impulses[1]),
             "across": abs(impulses[0][1]),
             "part": one["assumptions"]["modelled_part"]["measured"],
             "whole": one["conservation"]["mass_first"]
             / two["conservation"]["mass_first"]}
    for bound in case.options.bound:
        check_bound(found, bound)


KINDS = {kind.__name__: kind
         for kind in (arrival, gauge_order, domain, facet_loads, whole_body)}
