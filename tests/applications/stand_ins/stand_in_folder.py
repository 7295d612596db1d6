#!/usr/bin/python3
"""A stand-in for an application in its output folder: a lock, a manifest, what
--resume and --overwrite do, signals. Entry "Flaw" makes it misbehave in one
way, see self_test.py."""

import glob
import json
import os
import re
import shutil
import signal
import sys
import time

NAMES = ("history.csv", "fields/fields_0000.vtu", "checkpoint/1/complete.json")


def refuse(message):
    print("error: " + message, file=sys.stderr)
    sys.exit(1)


def path(*names):
    return os.path.join(output, *names)


def read(name):
    with open(path(name), encoding="utf-8") as file:
        return file.read()


def write(name, text):
    os.makedirs(os.path.dirname(path(name)), exist_ok=True)
    with open(path(name), "w", encoding="utf-8") as file:
        file.write(text)


def write_manifest(status):
    write("manifest.json", json.dumps({"status": status, "entries": entries,
                                       "application": application}))


def manifest():
    """That of the run before; none if there is none."""
    if not os.path.exists(path("manifest.json")):
        return None
    try:
        return {"status": "", "entries": {}, **json.loads(read("manifest.json"))}
    except json.JSONDecodeError:
        return refuse("manifest.json is not one")


def require_folder():
    for other, name in (("/", "root"), (os.environ.get("HOME"), "home")):
        if os.path.exists(output) and os.path.samefile(output, other):
            refuse(f"the {name} folder")


def lock():
    if os.path.exists(output) and not os.access(output, os.W_OK):
        refuse(f"{output} is not writable")
    if os.path.exists(path("lock")) and flaw != "shares":
        holder = read("lock")
        if "process" not in holder:
            refuse("lock is not one")
        number = holder.split("process ")[1].split(" ")[0]
        if os.path.exists(f"/proc/{number}"):
            refuse(f"in use by process {number} on here")
    if flaw == "greedy":
        shutil.rmtree(output, ignore_errors=True)
    write("lock", f"process {os.getpid()} on here")


def unlock():
    """A run that shares its folder may find the lock gone."""
    if os.path.exists(path("lock")) or flaw != "shares":
        os.remove(path("lock"))


def admit(before):
    """Whether the run may begin."""
    has_checkpoint = bool(glob.glob(path(NAMES[2])))
    others = [name for name in os.listdir(output) if name != "lock"]
    is_finished = (before or {}).get("status") == "finished"
    if "--resume" in sys.argv and not has_checkpoint and flaw != "rash" and (
            is_finished or before is None and others):
        leave("--resume: there is no checkpoint")
    if "--resume" in sys.argv and not has_checkpoint and flaw != "silent":
        print("it holds nothing to go on with yet; the run begins")
    if before is None:
        for name in NAMES:
            if os.path.exists(path(name)) and flaw != "ruthless":
                leave(f"{name} is foreign")
        return True
    if "--overwrite" in sys.argv or flaw == "forgetful":
        if flaw != "silent":
            print("removing what it wrote")
        return True
    changed = [name for name in entries
               if before["entries"].get(name) != entries[name]]
    if changed and "--resume" in sys.argv and before["status"] == "finished":
        if flaw == "rewinds":
            return True
        leave("it is at 3 s already")
    if changed and (before["status"] == "finished" or "--resume" in sys.argv
                    and changed[0] == "Precision"):
        leave(f"{changed[0]} differs")
    if before["status"] == "finished":
        print("finished before; --overwrite computes all anew" + (
            ", --resume goes on to a later end"
            if glob.glob(path(NAMES[2])) else ""))
        return False
    if "--resume" not in sys.argv and glob.glob(path(NAMES[2])):
        leave("--resume goes on with it")
    return True


def leave(message):
    unlock()
    if os.path.isdir(output) and not os.listdir(output):
        os.rmdir(output)
    refuse(message)


def run():
    asked = []
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1):
        signal.signal(number, lambda found, _: asked.append(found))
    write_manifest("started")
    for name in NAMES[:2] if "Brief" in entries else NAMES:
        write(name, str(entries))
    first, step = 0, -1
    resumes = "--resume" in sys.argv and os.path.exists(path("summary.json"))
    if resumes and flaw != "repeats":
        first = json.loads(read("summary.json"))["steps"]
    last = int(entries.get("Steps", "3"))
    stop = first + int(entries.get("Time/Steps in this run", last))
    for step in range(first, min(last, stop)):
        time.sleep(0.01)
        write(NAMES[0], str(entries))
        if asked:
            break
    is_stopped = asked or stop < last
    write("summary.json", json.dumps(
        {"status": "stopped" if is_stopped else "finished", "steps": step + 1,
         "resumed_from_step": first if resumes else None}))
    write("checkpoint/1/run.json", json.dumps({"state": {"step": step + 1}}))
    write_manifest("stopped" if is_stopped else "finished")
    print("results in " + output)
    if flaw == "homesick" and not os.path.isdir(os.environ["HOME"]):
        print("there is no home", file=sys.stderr)
    draw_report()
    unlock()
    sys.exit(128 + asked[0] if asked and flaw != "content" else 0)


def draw_report():
    """As a scene does at its end, by a library that may be broken."""
    library = os.path.join(os.environ.get("PYTHONPATH", ""), "matplotlib.py")
    if not os.path.exists(library):
        write("report.html", "")
        return
    why = "WARNING: no report: plot.py failed"
    with open(library, encoding="utf-8") as file:
        killed = re.search(r"killpg\(0, (\d+)", file.read())
    if killed:
        asked = signal.Signals(int(killed[1]))
        if flaw != "mute":
            why += f": asked to stop by {asked.name}"
        print(why + "\n--resume makes it")
        write("log.txt", why)
        write_manifest("stopped" if "scene" in application else "finished")
        unlock()
        sys.exit(3 if flaw == "content" else 128 + asked)
    if flaw != "mute":
        why += ": ValueError: no pictures today"
    print(why)
    write("log.txt", why)
    write_manifest("failed")
    if flaw != "content":
        unlock()
        print("error: all stages are finished, but there is no report",
              file=sys.stderr)
        sys.exit(3)


def check():
    place = os.environ.get("XDG_CACHE_HOME", "")
    if flaw == "cached" and not os.path.isdir(place):
        refuse(f"no cache in {place}")
    print("The parameters are valid.")
    sys.exit(0)


entries = dict(sys.argv[at + 1].split("=", 1)
               for at, word in enumerate(sys.argv) if word == "--set")
flaw = entries.pop("Flaw", "none")
application = os.path.basename(sys.argv[0])
output = os.path.join("output", "" if flaw == "shared" else application,
                      os.path.splitext(os.path.basename(sys.argv[1]))[0])
if "--output" in sys.argv:
    output = sys.argv[sys.argv.index("--output") + 1]
if "--check" in sys.argv:
    check()
if os.environ.get("OMPI_COMM_WORLD_RANK", "0") != "0":
    sys.exit(0)
require_folder()
try:
    lock()
except (FileExistsError, NotADirectoryError):
    refuse("cannot make the output folder")
if not admit(manifest()):
    unlock()
    sys.exit(0)
try:
    run()
except OSError as error:
    print(f"cannot write: {error.strerror}", file=sys.stderr)
    sys.exit({"careless": 0, "confused": 1}.get(flaw, 3))
