"""What tests of recorded loads prove; kinds of run_case.py."""

import csv
import os

ENTRY = "Loads/Smallest overpressure"


def read_gauges(output):
    """Times, and overpressures of all gauges at each."""
    with open(os.path.join(output, "load_gauges.csv"), newline="") as file:
        rows = [list(map(float, row)) for row in list(csv.reader(file))[1:]]
    return [row[0] for row in rows], [row[1:] for row in rows]


def integrals(times, samples):
    """Time integrals of means since the time before, the first since 0."""
    steps = [end - begin for begin, end in zip([0.] + times, times)]
    return [sum(step * sample[gauge] for step, sample in zip(steps, samples))
            for gauge in range(len(samples[0]))]


def arrival(case, check_bound, read_summary):
    """Samples begin when the wave arrives, and none of their impulse is lost:
    bounds of "first_sample" [s], "samples_at_rest", of the part of the largest
    "first_overpressure" and of the "impulse_difference" from a run that keeps
    less."""
    outputs = [case.folder("default"), case.folder("later")]
    case.run(outputs[0])
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


KINDS = {kind.__name__: kind for kind in (arrival,)}
