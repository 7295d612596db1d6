# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Notes of a report on stages that have not come to their end, and on a blast
that has not come to the body."""

from plot.readers import files
from plot.readers.scene import STAGES
from plot.report import page

WHOLE = (None, "finished", "reused")
NOT_REACHED = "The blast does not reach the body before the run ends."


def words(scene, name):
    """How far an unfinished stage has come; "" of any other one."""
    stage = getattr(scene, name)
    told = [row.get("status") for row in scene.list_of("stages")
            if row.get("name") == name] + [stage.summary.get("status")]
    status = next((one for one in told if one not in WHOLE), None)
    if not stage.exists or status is None:
        return ""
    history = stage.table("history.csv")
    time = files.as_number(stage.summary.get("time"))
    if time is None and history is not None and "time" in history:
        time = float(history["time"][-1])
    end = stage.parameter("Time/End time") or [scene.fact("end_time")]
    return f"{name} is unfinished ({status})" + (
        "" if time is None else f", at {page.milliseconds(time)}"
        + ("" if end[0] is None else f" of {page.milliseconds(end[0])}")) \
        + ": extremes and impulses are those until then"


def note(scene, *names):
    """Above a section with figures of stages: a paragraph in a list, or []."""
    told = [text for text in (words(scene, name) for name in names) if text]
    return [page.paragraph("The stage " + "; the stage ".join(told) + ".",
                           kind="note")] if told else []


def reservations(scene):
    """Reservations on all stages, a sentence each."""
    return [f"The stage {text}." for text in
            (words(scene, name) for name in STAGES) if text]
