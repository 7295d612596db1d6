# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Formats of files by their number, as in
include/contrecoup/io/file/file_format.h, and of report.json."""

NUMBERS = {"loads": 1, "profile": 1, "summary": 1, "scene": 1, "study": 1,
           "report": 1}


def require_readable(name, number):
    """Raises ValueError where the number is newer than that of this program."""
    if isinstance(number, int) and number > NUMBERS[name]:
        raise ValueError(f"it has format {number}, this program reads up to "
                         f"{NUMBERS[name]}")
