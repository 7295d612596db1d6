# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""The page of a report: sections, tables and pictures in one HTML file that
needs nothing besides itself."""

import base64
import html
import io
import math
import os

import matplotlib.pyplot as plt

from plot.figures import style

STYLE = """
:root { --ink: #1d2329; --soft: #5b6570; --line: #d9dee3; --pale: #f4f6f8;
        --accent: #0b5c8f; --bad: #a12a1c; --mid: #8a5a00; --good: #1f6b3a; }
* { box-sizing: border-box; }
body { font: 16px/1.5 "Segoe UI", "DejaVu Sans", Arial, sans-serif;
       color: var(--ink); background: #fff; margin: 0 auto; max-width: 1060px;
       padding: 24px 28px 60px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 4px; }
h2 { font-size: 21px; margin: 44px 0 10px; padding-bottom: 4px;
     border-bottom: 2px solid var(--accent); }
h3 { font-size: 16px; margin: 22px 0 6px; }
p, li { max-width: 78ch; }
.sub { color: var(--soft); margin: 0 0 18px; }
.answer { background: var(--pale); border-left: 5px solid var(--accent);
          padding: 12px 20px; margin: 16px 0; font-size: 18px; }
.answer p { margin: 8px 0; }
.missing, .note { color: var(--soft); }
nav { columns: 3 220px; font-size: 14px; margin: 12px 0 0; }
nav a { display: block; color: var(--accent); text-decoration: none; }
table { border-collapse: collapse; width: 100%; margin: 10px 0 6px;
        font-size: 14px; line-height: 1.35; }
th { text-align: left; background: var(--pale); font-weight: 600; }
th, td { border-bottom: 1px solid var(--line); padding: 6px 9px;
         vertical-align: top; }
td.number, th.number { text-align: right; }
td.number { white-space: nowrap; }
td small { color: var(--soft); font-size: 12.5px; }
caption { caption-side: bottom; text-align: left; color: var(--soft);
          font-size: 13.5px; padding: 6px 0; }
figure { margin: 16px 0 20px; }
figure img { max-width: 100%; height: auto; display: block; }
figcaption { color: var(--soft); font-size: 13.5px; max-width: 95ch;
             padding-top: 5px; }
code, pre { font-family: "DejaVu Sans Mono", Consolas, monospace;
            font-size: 13px; overflow-wrap: anywhere; }
pre { background: var(--pale); padding: 10px 14px; white-space: pre-wrap; }
.bad { color: var(--bad); font-weight: 600; }
.mid { color: var(--mid); font-weight: 600; }
.good { color: var(--good); font-weight: 600; }
details summary { cursor: pointer; color: var(--accent); }
.paper { display: none; }
/* On a narrow window a row stands as a card, each cell after its heading. */
@media screen and (max-width: 900px) {
  body { padding: 16px 14px 40px; overflow-wrap: break-word; }
  h1 { font-size: 25px; }
  .answer { padding: 8px 14px; font-size: 16px; }
  td, td.number { white-space: normal; overflow-wrap: anywhere; }
  .wide { display: flex; flex-direction: column; }
  .wide caption { order: 1; }
  .wide col, .wide thead { display: none; }
  .wide tbody, .wide tr, .wide td { display: block; width: auto; }
  .wide tr { border-bottom: 2px solid var(--line); padding: 6px 0; }
  .wide td { border: 0; padding: 2px 0 2px 14px; text-align: left; }
  .wide td:first-child { padding-left: 0; font-weight: 600; }
  .wide td:not(:first-child)::before {
    content: attr(data-label); display: block; color: var(--soft);
    font-size: 12.5px; }
  .wide td.number:not(:first-child)::before {
    content: attr(data-label) ": "; display: inline; }
}
@page { margin: 12mm; }
@media print {
  body { max-width: none; padding: 0; font-size: 9.5pt; line-height: 1.4; }
  h1 { font-size: 19pt; }
  h2 { font-size: 13.5pt; margin: 18px 0 6px; }
  h3 { font-size: 11pt; margin: 12px 0 4px; }
  h2, h3 { break-after: avoid; }
  p, li { max-width: none; orphans: 3; widows: 3; margin-block: 5px; }
  .answer { font-size: 10.5pt; padding: 6px 14px; }
  table { font-size: 8pt; }
  th, td { padding: 3px 5px; }
  td small { font-size: 7pt; }
  caption, figcaption { font-size: 8pt; max-width: none; }
  figure { margin: 8px 0 10px; }
  figure img { width: auto !important; max-height: 80mm; }
  figure, tr { break-inside: avoid; }
  nav, .screen { display: none; }
  .paper { display: inline; }
  /* Paper cannot be unfolded. */
  details.table::details-content { content-visibility: visible; }
  details summary { list-style: none; color: var(--ink); }
}
"""


class Html(str):
    """Text that is HTML already."""


def escape(text):
    return text if isinstance(text, Html) else Html(html.escape(str(text)))


def tag(name, *parts, **attributes):
    """An element; attribute "kind" is its class."""
    kinds = "".join(
        f' {"class" if key == "kind" else key}="{html.escape(str(value))}"'
        for key, value in attributes.items() if value)
    return Html(f"<{name}{kinds}>{''.join(escape(part) for part in parts)}"
                f"</{name}>")


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


def count(value):
    """A whole number, thousands apart."""
    text = f"{int(value):,}".replace(",", "\u202f")
    return text if abs(value) >= 10000 else text.replace("\u202f", "")


def percent(part):
    """An estimated error; what is as large as the value has no digits."""
    return "more than 100\u00a0%" if part > 1. \
        else f"{number(100. * part, 2)}\u00a0%"


def plain(value, unit):
    """A round number, as a limit, with its unit: 3.6 m/s, 173 kPa."""
    factor, shown = style.scale_unit(unit, abs(value))
    text = f"{value * factor:.4g}".replace("-", "−")
    return f"{text}\u00a0{shown}" if shown else text


def quantity(value, unit, digits=3):
    """A value with its unit and a prefix that makes it easy to read."""
    if value is None or not math.isfinite(value):
        return "–"
    factor, shown = style.scale_unit(unit, abs(value))
    text = number(value * factor, digits)
    return f"{text}\u00a0{shown}" if shown else text


def milliseconds(seconds, digits=3):
    return f"{number(1e3 * seconds, digits)}\u00a0ms"


def table(header, rows, caption=None, numbers=(), widths=()):
    """A table; @p numbers are the columns that are aligned to the right,
    @p widths those of all columns in per cent. Each cell knows its heading,
    which stands before it where the window is too narrow for columns."""
    def cells(kind, row):
        return tag("tr", *(
            tag(kind, cell, kind="number" if column in numbers else None,
                **({"data-label": header[column]} if kind == "td" else {}))
            for column, cell in enumerate(row)))
    parts = [tag("caption", caption)] if caption else []
    parts += [Html(f'<col style="width:{width}%">') for width in widths]
    parts += [tag("thead", cells("th", header)),
              tag("tbody", *(cells("td", row) for row in rows))]
    return tag("table", *parts, kind="wide" if len(header) > 2 else None)


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
    words = [number(1e3 * time, digits) for time in times]
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1]))) \
        + "\u00a0ms"


def figure(picture, description, caption, kind="png", width=None):
    """A matplotlib figure, or the bytes of a PNG picture, with its caption.
    @p description says what is to be seen to those who cannot see it. Lines
    are best as "svg", pictures with many colours as "png"."""
    content = picture if isinstance(picture, bytes) else render(picture, kind)
    form = "image/svg+xml" if kind == "svg" else "image/png"
    data = base64.b64encode(content).decode("ascii")
    image = Html(f'<img src="data:{form};base64,{data}" '
                 f'alt="{html.escape(description, quote=True)}"'
                 + (f' style="width:{width}"' if width else "") + ">")
    return tag("figure", image, tag("figcaption", caption))


def render(picture, kind):
    """The bytes of a matplotlib figure, which is closed."""
    stream = io.BytesIO()
    options = {"pil_kwargs": {"optimize": True}} if kind == "png" else {}
    picture.savefig(stream, format=kind, bbox_inches="tight",
                    dpi=120, **options)
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
        """What stands before the list of sections."""
        self.lead += parts

    def section(self, name, *parts):
        self.sections.append((name, parts))

    def render(self):
        links, body = [], []
        for index, (name, parts) in enumerate(self.sections, 1):
            anchor = f"section-{index}"
            links.append(tag("a", f"{index}  {name}", href=f"#{anchor}"))
            body.append(tag("section", tag("h2", f"{index}  {name}"), *parts,
                            id=anchor))
        head = Html('<head><meta charset="utf-8"><meta name="viewport" '
                    'content="width=device-width, initial-scale=1">'
                    f"<title>{html.escape(self.title)}</title>"
                    f"<style>{STYLE}</style></head>")
        return "<!DOCTYPE html>\n" + tag(
            "html", head,
            tag("body", tag("h1", self.title),
                paragraph(self.subtitle, kind="sub"), *self.lead,
                tag("nav", *links), *body), lang="en") + "\n"


def write_page(folder, text):
    """Writes report.html; the old one stays until the new one is whole.
    Prints its path."""
    path = os.path.join(folder, "report.html")
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".new", path)
    print(path)
