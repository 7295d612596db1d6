# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The page of a report: sections, tables and pictures in one HTML file that
needs nothing besides itself. Each table has a link to itself as a CSV file,
which is in the page as well, with units in its header and all digits of numbers
that the table rounds."""

import base64
import csv
import html
import io
import math
import os
import re
import struct
import textwrap

import jinja2
import matplotlib.pyplot as plt
from markupsafe import Markup, escape

from plot.figures import style

TEMPLATES = jinja2.Environment(
    loader=jinja2.FileSystemLoader(
        os.path.join(os.path.dirname(os.path.abspath(__file__)), "templates")),
    autoescape=True, trim_blocks=True, lstrip_blocks=True,
    undefined=jinja2.StrictUndefined)
LONGEST_ANSWER = 10  # lines on the screen
# Resolution of all pictures of a page.
DOTS_PER_INCH = 150
NO_CHANCE = 5e-4  # below, a bound of a chance is shown as 0 %
WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight",
         "nine", "ten", "eleven", "twelve")
NARROW = 400.  # px, width of pictures that narrow windows show whole
NAMELESS = "table.csv"  # until the section is known


class Rounded(str):
    """A number as a page shows it, with the number itself and its unit, None
    where the heading of its column has it."""

    def __new__(cls, text, value, unit=None):
        made = super().__new__(cls, text)
        made.value, made.unit = value, unit
        return made


def filled(template, **values):
    """A file of templates/ with these values, which are escaped unless they are
    HTML already."""
    return Markup(TEMPLATES.get_template(template).render(values))


def tag(name, *parts, **attributes):
    """An element; attribute "kind" is its class."""
    kinds = Markup().join(
        Markup(' {}="{}"').format("class" if key == "kind" else key, value)
        for key, value in attributes.items() if value)
    return Markup(f"<{name}{kinds}>{Markup().join(parts)}</{name}>")


def paragraph(*parts, kind=None):
    return tag("p", *parts, kind=kind)


def missing(what):
    """The one line of a section that has nothing to show."""
    return paragraph(f"Missing: {what}.", kind="missing")


def bullets(items):
    return tag("ul", *(tag("li", item) for item in items))


def number(value, digits=3):
    """A number with some digits that count; thin spaces between thousands."""
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return "–"
    return Rounded(_digits(value, digits), value)


def _digits(value, digits):
    if value == 0:
        return "0"
    size = abs(value)
    if size >= 1e7 or size < 1e-3:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        power = str(int(exponent)).translate(
            str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        return f"{mantissa.replace('-', '−')}·10{power}"
    after = max(0, digits - 1 - math.floor(math.log10(size) + 1e-9))
    # A number that rounds up to the next decade loses a digit.
    text = f"{value:.{after}f}"
    if after and abs(float(text)) >= 10. ** (digits - after):
        text = f"{value:.{after - 1}f}"
    whole, dot, rest = text.partition(".")
    if len(whole.lstrip("-")) > 4:
        whole = f"{int(whole):,}".replace(",", "\u202f")
    return (whole + dot + rest).replace("-", "−")


def limit(shown, is_lower_limit=True):
    """A number as a page shows it, whose magnitude may be a lower limit."""
    return shown if not is_lower_limit or not isinstance(shown, Rounded) \
        else Rounded(("≤ " if shown.value < 0. else "≥ ") + shown,
                     shown.value, shown.unit)


def count(value):
    """A whole number, thousands apart."""
    text = f"{int(value):,}" if abs(value) >= 10000 else f"{int(value)}"
    return Rounded(text.replace(",", "\u202f"), int(value))


def percent(part, digits=2):
    """A part in per cent."""
    return Rounded(f"{number(100. * part, digits)}\u00a0%", 100. * part, "%")


def digits_beside(limits, value, digits):
    """As many digits, or some more, with which a value is not taken for one of
    the limits that it is next to."""
    while digits < 6 and any(value != limit == float(f"{value:.{digits}g}")
                             for limit in limits):
        digits += 1
    return digits


def chance(part, limits=()):
    """A chance between 0 and 1 in per cent, without digits that mean nothing,
    and not rounded to one of the limits."""
    if 0. < part < 0.001:
        return Rounded("less than 0.1\u00a0%", 100. * part, "%")
    return Rounded("more than 99\u00a0%", 100. * part, "%") \
        if 0.99 < part < 1. else percent(part, digits_beside(limits, part, 2))


def least_chance(part):
    """The same of a lower limit."""
    return limit(percent(part)) if part <= 0.99 else chance(part)


def interval(low, high, limits=()):
    """Bounds of what lies between 0 and 1, not rounded to one of the limits:
    "17 to 100 %"."""
    if high < 0.001 or low > 0.99:
        return chance(high if high < 0.001 else low)
    low, high = ("0" if part < NO_CHANCE else "100" if part >= 0.995 else
                 number(100. * part, digits_beside(limits, part, 2))
                 for part in (low, high))
    return f"{low} to {high}\u00a0%" if low != high else f"{low}\u00a0%"


def error(part):
    """An estimated error; one as large as the value has no digits."""
    return Rounded("±\u00a0" + ("more than 100\u00a0%" if part > 1.
                                else percent(part)), 100. * part, "%")


def joined(words, last="and"):
    """Words as a list in a sentence."""
    words = list(words)
    return f" {last} ".join(filter(None, (", ".join(words[:-1]), *words[-1:])))


def count_in_words(value):
    """A small number in words."""
    return WORDS[value] if value < len(WORDS) else str(value)


def counted(value, noun):
    """A small number in words with its noun: "one verdict", "two verdicts"."""
    return f"{count_in_words(value)} {noun}" + ("" if value == 1 else "s")


def given(value, unit, digits=4):
    """A value as its entry has it: without zeros at the end that nobody wrote,
    in its own unit."""
    mantissa, times, power = number(value, digits).partition("·")
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return Rounded(f"{mantissa}{times}{power}\u00a0{unit}", value, unit)


def height(place):
    """Height of a place [m] above z = 0."""
    return given(round(place[2], 2), "m")


def plain(value, unit):
    """A round number, as a limit, with its unit: 3.6 m/s, 173 kPa."""
    factor, shown = style.scale_unit(unit, abs(value))
    text = f"{value * factor:.4g}".replace("-", "−")
    return Rounded(f"{text}\u00a0{shown}" if shown else text, value, unit)


def quantity(value, unit, digits=3):
    """A value with its unit and a prefix that makes it easy to read."""
    if value is None or not math.isfinite(value):
        return "–"
    # A value that rounds to 1 m is not 1000 mm.
    factor, shown = style.scale_unit(unit, float(f"{abs(value):.{digits}g}"))
    text = number(value * factor, digits)
    return Rounded(f"{text}\u00a0{shown}" if shown else text, value, unit)


def milliseconds(seconds, digits=3):
    return Rounded(f"{number(1e3 * seconds, digits)}\u00a0ms", seconds, "s")


def point(coordinates, digits=4):
    """Coordinates as a page shows them, without brackets and unit."""
    words = ", ".join(f"{x:.{digits}g}" for x in coordinates).replace("-", "−")
    return Rounded(words, "; ".join(repr(float(x)) for x in coordinates))


def table(header, rows, caption=None, numbers=(), widths=(), data=None):
    """A table and a link to it as a CSV file; @p numbers are the columns that
    are aligned to the right, @p widths those of all columns in per cent, @p
    data header and rows of the file where those of the table do not fit. Each
    cell knows its heading, which stands before it where the window is too
    narrow for columns."""
    content = csv_text(*(data or (header, rows))).encode("utf-8")
    return filled("table.html.j2", header=header, rows=rows, caption=caption,
                  numbers=numbers, widths=widths, file=NAMELESS,
                  content=base64.b64encode(content).decode())


def csv_text(header, rows):
    """A table as CSV: numbers with all digits, below their unit in columns of
    one, else next to it, and next to their sign where some are lower or upper
    limits."""
    titles, columns = [], []
    for title, cells in zip(header, zip(*rows) if rows else [()] * len(header)):
        units = {getattr(cell, "unit", None) for cell in cells
                 if isinstance(cell, Rounded) or _plain(cell)}
        titles.append(title)
        columns.append([_plain(cell) for cell in cells])
        if len(units) > 1:
            titles.append(f"unit of {title}")
            columns.append([getattr(cell, "unit", None) or ""
                            for cell in cells])
        elif any(units):
            titles[-1] += f" [{units.pop()}]"
        signs = [cell[0] if isinstance(cell, Rounded)
                 and cell[:1] in ("≥", "≤") else "" for cell in cells]
        if any(signs):
            titles.append(f"limit of {title}")
            columns.append(signs)
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([titles, *zip(*columns)])
    return stream.getvalue()


def _plain(cell):
    """A cell as text without HTML."""
    if isinstance(cell, Rounded):
        return str(cell.value)
    if isinstance(cell, Markup):
        cell = _text_of(str(cell).replace("<br>", "; "))
    return "" if cell == "–" else str(cell).replace("\u00a0", " ")


def _text_of(markup):
    return html.unescape(re.sub("<[^>]*>", "", markup))


def folded_table(title, content):
    """A table under its title, folded on the screen, open on paper."""
    return tag("details", tag("summary", title), content, kind="table")


def folded_file(title, text):
    """The text of a file under its name, folded; paper names it alone."""
    return tag("details", tag("summary", title,
                              tag("span", " (in the folder of this report; "
                                  "not printed)", kind="paper")),
               tag("pre", text))


def moments(times, digits=3):
    """Times [s] in words: "1.8, 2.1 and 2.5 ms"."""
    return joined(number(1e3 * time, digits) for time in times) + "\u00a0ms"


def figure(picture, description, caption, kind="png"):
    """A matplotlib figure, or the bytes of a PNG picture, with its caption.
    @p description says what is to be seen to those who cannot see it. Lines
    are best as "svg", pictures with many colours as "png"."""
    content = picture if isinstance(picture, bytes) else render(picture, kind)
    form = "image/svg+xml" if kind == "svg" else "image/png"
    # At which points of a PNG's fonts are points [px]; others have their own.
    width = 96. * struct.unpack(">I", content[16:20])[0] / DOTS_PER_INCH \
        if content.startswith(b"\x89PNG") else 0.
    return filled("figure.html.j2", form=form, description=description,
                  content=base64.b64encode(content).decode("ascii"),
                  width=width, caption=caption,
                  is_large=not 0. < width <= NARROW)


def render(picture, kind):
    """The bytes of a matplotlib figure, which is closed."""
    stream = io.BytesIO()
    options = {"pil_kwargs": {"optimize": True}} if kind == "png" else {}
    picture.savefig(stream, format=kind, bbox_inches="tight",
                    dpi=DOTS_PER_INCH, **options)
    plt.close(picture)
    return stream.getvalue()


def drawn(draw, *arguments, **options):
    """The PNG of a function that saves its picture to its last argument."""
    stream = io.BytesIO()
    draw(*arguments, stream, **options)
    return stream.getvalue()


class Page:
    """Sections in order, with a list of them at the top."""

    def __init__(self, title, subtitle):
        self.title, self.subtitle = title, subtitle
        self.lead = []
        self.sections = []

    def open_with(self, *parts):
        """Adds parts before the list of sections."""
        self.lead += parts

    def section(self, name, *parts):
        self.sections.append((name, parts))

    def figures(self):
        """Section, description and caption of each figure, in order."""
        return [{"section": name, "description": _text_of(description),
                 "caption": _text_of(caption)}
                for name, parts in [("", self.lead), *self.sections]
                for description, caption in re.findall(
                    'alt="([^"]*)".*?<figcaption>(.*?)</figcaption>',
                    "".join(map(str, parts)), re.S)]

    def render(self):
        sections = [(name, _name_files(name, Markup().join(parts)))
                    for name, parts in self.sections]
        return filled("page.html.j2", title=self.title, subtitle=self.subtitle,
                      lead=self.lead, sections=sections)


def _name_files(section, content):
    """Names the CSV files of a section after it."""
    name = re.sub(r"[^a-z0-9]+", "_", section.lower()).strip("_")
    parts = str(content).split(f'download="{NAMELESS}"')
    names = [name] if len(parts) == 2 else [
        f"{name}_{number}" for number in range(1, len(parts))]
    return Markup(parts[0] + "".join(
        f'download="{file}.csv"{part}' for file, part in zip(names,
                                                             parts[1:])))


def write_page(folder, text):
    """Writes report.html; the old one stays until the new one is whole.
    Prints its path."""
    path = os.path.join(folder, "report.html")
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".new", path)
    print(path)


def print_answer(text):
    """Prints the answer of a page, indented by two spaces: as many whole
    sentences as the screen has lines for."""
    answer = re.search('<div class="answer">(.*?)</div>', text, re.S)[1]
    sentences = re.split(r"(?<=\.) (?=[A-Z0-9])",
                         Markup(answer.replace("</p>", " ")).striptags())
    while len(lines := textwrap.wrap(" ".join(sentences), 78)) \
            > LONGEST_ANSWER:
        sentences.pop()
    for line in lines:
        print("  " + line)
