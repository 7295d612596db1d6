#!/usr/bin/python3
"""A stand-in for the application study, and for the blast that it starts: eight
runs of 0.1 s (or two, of which the second writes more), a table and a recommended
file; or with "Writes=distances" the scenes of three distances. Entry "Flaw" makes it misbehave in one way, see self_test.py."""

import csv
import json
import os
import signal
import subprocess
import sys


def path(*names):
    return os.path.join(output, *names)


def write(text, *names):
    os.makedirs(os.path.dirname(path(*names)), exist_ok=True)
    with open(path(*names), "w", encoding="utf-8") as file:
        file.write(text)


def summarise(status):
    write(json.dumps({"status": status, "errors": {"density_L1": 0.003},
                      "outcomes": {"stable": n_runs}}), "summary.json")


def run_variant(number):
    """Lasts a while, and leaves its outcome."""
    subprocess.run([sys.executable, "-c", "import sys, time; time.sleep(0.1)",
                    path("variants", str(number))], check=True)
    if n_runs == 2:
        write("x" * (number << 18), "variants", str(number), "fields.bin")
    write("{}", "variants", str(number), "outcome.json")
    if n_runs != 2:
        write("x" * (32 << 10), "variants", str(number), "fields.bin")


def fail(error):
    """As an application whose disk takes no more."""
    print(f"error: cannot write standard output: {error.strerror}",
          file=sys.stderr)
    sys.exit(0 if flaw == "careless" else 3)


def finish():
    rows = [["error", "core [s]", "pareto front", "outcome"]]
    rows += [[0.003 + 0.001 * number, 1 + number, "yes" if number == 0 else
              "no", "stable"] for number in range(8)]
    with open(path("study.csv"), "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows(rows)
    write("Fields = true\n" + ("wrong" if flaw == "wrong" else ""),
          "recommended.prm")
    write(" " * (1 if flaw == "blank" else 20000), "pictures", "a.png")
    summarise("finished")


def write_distances():
    """Three scenes with results that fall, their table and its curves."""
    rows = [["folder", "blast/results.probe_1_peak_overpressure",
             "blast/results.loads_chest_peak",
             "biomechanics/results.injury_intracranial_pressure_peak",
             "blast/probe_injury.csv:lung_lethality probe 1:value"]]
    for number, death in enumerate((0.99, 0.1, 0.)):
        folder = path("variants", str(number), "run")
        values = [1e5 * (number if flaw == "rising" else 3 - number)] * 3
        row = [folder, *values, 0. if flaw == "deathless" else death]
        # Either stage has the results of both.
        results = {name.split("/results.")[1]: {"value": value, "unit": "Pa"}
                   for name, value in zip(rows[0][1:], values)}
        for stage in ("blast", "biomechanics"):
            write(json.dumps({"results": results}), "variants", str(number),
                  "run", stage, "summary.json")
        row[2] += flaw == "wrong"
        rows.append(row)
    with open(path("study.csv"), "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows(rows)
    write(" " * (1 if flaw == "blank" else 20000), "pictures", "curves.png")


def main():
    stopped = []
    for asked in (signal.SIGINT, signal.SIGTERM):
        signal.signal(asked, lambda found, _: stopped.append(found))
    write(json.dumps({"status": "finished" if flaw == "boastful" else
                      "started"}), "manifest.json")
    for number in range(n_runs):
        done = path("variants", str(number), "outcome.json")
        if os.path.exists(done) and flaw != "restless":
            continue
        if stopped:
            summarise("stopped")
            sys.exit(143 if flaw == "confused" else 128 + stopped[0])
        run_variant(number)
    return finish()


def stand_in_for_blast():
    with open(sys.argv[1], encoding="utf-8") as file:
        error = 0.5 if "wrong" in file.read() else 0.003
    write(json.dumps({"errors": {"density_L1": error}}), "summary.json")


if __name__ == "__main__":
    output = sys.argv[sys.argv.index("--output") + 1]
    flaw = next((word[len("Flaw="):] for word in sys.argv
                 if word.startswith("Flaw=")), "none")
    n_runs = 2 if "Vary leaves/Values=10; 100" in sys.argv else 8
    if os.path.basename(sys.argv[0]) == "blast":
        stand_in_for_blast()
    else:
        try:
            write_distances() if "Writes=distances" in sys.argv else main()
        except OSError as error:
            fail(error)
