# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Reads what a report.html says: its tables, its answer, its numbers."""

import html.parser
import math
import re

PREFIXES = {"G": 1e9, "M": 1e6, "k": 1e3, "": 1., "m": 1e-3, "µ": 1e-6,
            "n": 1e-9, "Gi": 2.**30, "Mi": 2.**20, "Ki": 2.**10}
UNITS = ("Pa s", "Pa", "m/s", "m", "kg", "s", "J", "N s", "N", "W", "B")
POWERS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
NUMBER = r"−?\d[\d\u202f]*(?:\.\d+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?"


class Table:
    """Cells as text, lines of a cell apart by newlines."""

    def __init__(self, section, heading):
        self.section, self.heading = section, heading
        self.header, self.rows = [], []

    def records(self):
        """Rows as dictionaries by the header."""
        for row in self.rows:
            if len(row) != len(self.header):
                raise AssertionError(f"a row of {self.section} has {len(row)}"
                                     f" cells below {len(self.header)}: {row}")
        return [dict(zip(self.header, row)) for row in self.rows]


class Page(html.parser.HTMLParser):
    """A report."""

    def __init__(self, text):
        super().__init__()
        self.tables, self.answer, self.paragraphs = [], "", []
        self._section = self._heading = ""
        self._text, self._open = "", []
        self._depth_of_answer = None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if tag == "br":
            self._text += "\n"
        if tag in ("br", "img", "col", "meta"):
            return
        self._open.append(tag)
        if tag == "div" and dict(attributes).get("class") in ("answer",
                                                              "doubts"):
            self._depth_of_answer = len(self._open)
        elif tag == "table":
            self.tables.append(Table(self._section, self._heading))
        elif tag == "tr":
            self._row = []
        elif tag in ("h2", "h3", "td", "th", "p", "li", "caption"):
            self._text = ""

    def handle_endtag(self, tag):
        depth = len(self._open)
        self._open.pop()
        text = self._text.replace("\u00a0", " ").strip()
        if tag == "h2":
            self._section, self._heading = re.sub(r"^\d+\s+", "", text), ""
        elif tag == "h3":
            self._heading = text
        elif tag in ("td", "th"):
            self._row.append(text)
        elif tag == "tr":
            if self._open[-1] == "thead":
                self.tables[-1].header = self._row
            else:
                self.tables[-1].rows.append(self._row)
        elif tag in ("p", "li") and self._depth_of_answer:
            self.answer += text + "\n"
        elif tag in ("p", "li"):
            self.paragraphs.append((self._section, text))
        elif depth == self._depth_of_answer:
            self._depth_of_answer = None

    def handle_data(self, data):
        self._text += data

    def table(self, section, heading=None, column=None):
        """The first table of a section, below a heading or with a column."""
        for table in self.tables:
            if table.section == section \
                    and heading in (None, table.heading) \
                    and (column is None or column in table.header):
                return table
        raise AssertionError(f"the report has no table in {section}")


def read(path):
    with open(path, encoding="utf-8") as file:
        return Page(file.read())


def quantity(text):
    """The first number of a text in SI units, and half a unit of the last
    digit that is shown. "37 %" is 0.37."""
    match = re.search(NUMBER, text)
    if not match:
        raise AssertionError(f"no number in '{text}'")
    digits, _, power = match[0].replace("−", "-").replace("\u202f", "") \
        .partition("·10")
    scale = 10. ** int(power.translate(POWERS) or 0)
    half = 0.5 * 10. ** -len(digits.partition(".")[2])
    scale *= _unit(text[match.end():])
    return float(digits) * scale, half * scale


def _unit(rest):
    rest = rest.lstrip()
    if rest.startswith("%"):
        return 0.01
    for unit in UNITS:
        for prefix, size in PREFIXES.items():
            # Kilograms are a unit as they are.
            if re.match(re.escape(prefix + unit) + r"(?![\w/])", rest):
                return size
    return 1.


def require_same(shown, value, what):
    """A shown number is @p value, to the digits that it has."""
    read_value, half = quantity(shown)
    if not math.isfinite(value) \
            or abs(read_value - value) > half * 1.0001 + 1e-9 * abs(value):
        raise AssertionError(f"{what}: the report shows '{shown}', the files "
                             f"have {value!r}")
